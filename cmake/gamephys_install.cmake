# Installation in two components, runtime (the shared library) and development (the rest), and
# the Debian packages made of them.

include(CMakePackageConfigHelpers)

set(targets gamephys_static)
if(BUILD_SHARED_LIBS)
  list(APPEND targets gamephys)
endif()
install(
  TARGETS ${targets}
  EXPORT gamephys
  RUNTIME COMPONENT runtime
  LIBRARY COMPONENT runtime NAMELINK_COMPONENT development
  ARCHIVE COMPONENT development)
install(
  FILES include/gamephys_c.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  COMPONENT development)

# The header as data, for those who generate bindings.
install(
  FILES bindings/gamephys_api.json
  DESTINATION ${CMAKE_INSTALL_DATADIR}/gamephys
  COMPONENT development)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/gamephys)
install(
  EXPORT gamephys
  NAMESPACE gamephys::
  FILE gamephysTargets.cmake
  DESTINATION ${package_dir}
  COMPONENT development)
configure_package_config_file(cmake/gamephysConfig.cmake.in gamephysConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(gamephysConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(
  FILES ${PROJECT_BINARY_DIR}/gamephysConfig.cmake ${PROJECT_BINARY_DIR}/gamephysConfigVersion.cmake
  DESTINATION ${package_dir}
  COMPONENT development)

# gamephys.pc finds everything from its own place, so an installed tree can be moved; directories
# that were given as absolute paths stay where they are.
file(RELATIVE_PATH GAMEPHYS_PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
set(GAMEPHYS_PC_PREFIX "\${pcfiledir}/${GAMEPHYS_PC_PREFIX}")
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
  set(GAMEPHYS_PC_PREFIX ${CMAKE_INSTALL_PREFIX})
endif()
foreach(kind LIBDIR INCLUDEDIR)
  set(GAMEPHYS_PC_${kind} "\${prefix}/${CMAKE_INSTALL_${kind}}")
  if(IS_ABSOLUTE "${CMAKE_INSTALL_${kind}}")
    set(GAMEPHYS_PC_${kind} ${CMAKE_INSTALL_${kind}})
  endif()
endforeach()
list(TRANSFORM GAMEPHYS_CXX_RUNTIME PREPEND -l OUTPUT_VARIABLE GAMEPHYS_PC_RUNTIME)
if(CMAKE_USE_PTHREADS_INIT)
  list(APPEND GAMEPHYS_PC_RUNTIME -pthread)
endif()
list(JOIN GAMEPHYS_PC_RUNTIME " " GAMEPHYS_PC_RUNTIME)
# Only users of the archive need the C++ runtime and threads; without a shared library that is everybody.
if(BUILD_SHARED_LIBS)
  set(GAMEPHYS_PC_LIBS_PRIVATE ${GAMEPHYS_PC_RUNTIME})
else()
  set(GAMEPHYS_PC_LIBS ${GAMEPHYS_PC_RUNTIME})
endif()
configure_file(pkgconfig/gamephys.pc.in gamephys.pc @ONLY)
install(
  FILES ${PROJECT_BINARY_DIR}/gamephys.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT development)

if(PROJECT_IS_TOP_LEVEL)
  set(CPACK_PACKAGE_VENDOR gamephys)
  set(CPACK_PACKAGE_CONTACT "gamephys maintainers <gamephys@localhost>")
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
  set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_STRIP_FILES ON)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libgamephys${PROJECT_VERSION_MAJOR})
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_GENERATE_SHLIBS ON)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libgamephys-dev)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libgamephys${PROJECT_VERSION_MAJOR} (= ${PROJECT_VERSION})")
  include(CPack)
endif()
