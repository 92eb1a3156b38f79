# Installation in two components, runtime (the shared library) and development (the rest).

include(CMakePackageConfigHelpers)

# gamephys_install(LIBDIR GENERATED RUNTIME DEVELOPMENT [EXCLUDE_FROM_ALL]): the library's binaries,
# headers and package files as two components. What is generated for them goes to GENERATED.
function(gamephys_install libdir generated runtime development)
  set(targets gamephys_static)
  if(GAMEPHYS_SHARED)
    list(APPEND targets gamephys)
  endif()
  install(
    TARGETS ${targets}
    EXPORT gamephys_${development}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${runtime} ${ARGN}
    LIBRARY DESTINATION ${libdir} COMPONENT ${runtime} NAMELINK_COMPONENT ${development} ${ARGN}
    ARCHIVE DESTINATION ${libdir} COMPONENT ${development} ${ARGN})
  # The C header, and over it the one for C++.
  install(
    FILES include/gamephys_c.h bindings/cpp/gamephys/gamephys.hpp bindings/cpp/gamephys/gamephys_support.hpp
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    COMPONENT ${development} ${ARGN})

  # The header as data, for those who generate bindings.
  install(
    FILES bindings/gamephys_api.json
    DESTINATION ${CMAKE_INSTALL_DATADIR}/gamephys
    COMPONENT ${development} ${ARGN})

  set(package_dir ${libdir}/cmake/gamephys)
  install(
    EXPORT gamephys_${development}
    NAMESPACE gamephys::
    FILE gamephysTargets.cmake
    DESTINATION ${package_dir}
    COMPONENT ${development} ${ARGN})
  configure_package_config_file(cmake/gamephysConfig.cmake.in ${generated}/gamephysConfig.cmake
                                INSTALL_DESTINATION ${package_dir})
  write_basic_package_version_file(${generated}/gamephysConfigVersion.cmake COMPATIBILITY SameMajorVersion)
  install(
    FILES ${generated}/gamephysConfig.cmake ${generated}/gamephysConfigVersion.cmake
    DESTINATION ${package_dir}
    COMPONENT ${development} ${ARGN})

  # gamephys.pc finds everything from its own place, so an installed tree can be moved; directories
  # that were given as absolute paths stay where they are.
  file(RELATIVE_PATH GAMEPHYS_PC_PREFIX /${libdir}/pkgconfig /)
  set(GAMEPHYS_PC_PREFIX "\${pcfiledir}/${GAMEPHYS_PC_PREFIX}")
  if(IS_ABSOLUTE "${libdir}")
    set(GAMEPHYS_PC_PREFIX ${CMAKE_INSTALL_PREFIX})
  endif()
  set(directory_LIBDIR ${libdir})
  set(directory_INCLUDEDIR ${CMAKE_INSTALL_INCLUDEDIR})
  foreach(kind LIBDIR INCLUDEDIR)
    set(GAMEPHYS_PC_${kind} "\${prefix}/${directory_${kind}}")
    if(IS_ABSOLUTE "${directory_${kind}}")
      set(GAMEPHYS_PC_${kind} ${directory_${kind}})
    endif()
  endforeach()
  list(TRANSFORM GAMEPHYS_CXX_RUNTIME PREPEND -l OUTPUT_VARIABLE GAMEPHYS_PC_RUNTIME)
  if(CMAKE_USE_PTHREADS_INIT)
    list(APPEND GAMEPHYS_PC_RUNTIME -pthread)
  endif()
  list(JOIN GAMEPHYS_PC_RUNTIME " " GAMEPHYS_PC_RUNTIME)
  # Only users of the archive need the C++ runtime and threads; without a shared library that is everybody.
  if(GAMEPHYS_SHARED)
    set(GAMEPHYS_PC_LIBS_PRIVATE ${GAMEPHYS_PC_RUNTIME})
  else()
    set(GAMEPHYS_PC_LIBS ${GAMEPHYS_PC_RUNTIME})
  endif()
  configure_file(pkgconfig/gamephys.pc.in ${generated}/gamephys.pc @ONLY)
  install(
    FILES ${generated}/gamephys.pc
    DESTINATION ${libdir}/pkgconfig
    COMPONENT ${development} ${ARGN})
endfunction()

gamephys_install(${CMAKE_INSTALL_LIBDIR} ${PROJECT_BINARY_DIR} runtime development)
configure_file(cmake/gamephys.3.in ${PROJECT_BINARY_DIR}/gamephys.3 @ONLY)
install(
  FILES ${PROJECT_BINARY_DIR}/gamephys.3
  DESTINATION ${CMAKE_INSTALL_MANDIR}/man3
  COMPONENT development)
foreach(component runtime development)
  install(
    FILES LICENSE
    DESTINATION ${CMAKE_INSTALL_DATADIR}/licenses/gamephys
    COMPONENT ${component})
endforeach()
