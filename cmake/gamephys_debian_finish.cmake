# Run by cpack when the Debian packages are written. It adds what CPack (3.25) cannot: the field
# Multi-Arch, and for the shared library the control files in CPACK_GAMEPHYS_CONTROL. A trigger among
# these is Debian's way to have ldconfig run; the scripts that CPack writes for it go.

find_program(DPKG_DEB dpkg-deb REQUIRED)
foreach(package IN LISTS CPACK_PACKAGE_FILES)
  set(tree ${CPACK_TEMPORARY_DIRECTORY}/finish)
  file(REMOVE_RECURSE ${tree})
  execute_process(COMMAND ${DPKG_DEB} --raw-extract ${package} ${tree} COMMAND_ERROR_IS_FATAL ANY)
  file(READ ${tree}/DEBIAN/control control)
  if(NOT control MATCHES "\nMulti-Arch:")
    string(REGEX REPLACE "\n+$" "\nMulti-Arch: same\n" control "${control}")
    file(WRITE ${tree}/DEBIAN/control "${control}")
  endif()
  if(NOT control MATCHES "\nPackage: [^\n]*-dev\n")
    file(REMOVE ${tree}/DEBIAN/postinst ${tree}/DEBIAN/postrm)
    file(GLOB files ${CPACK_GAMEPHYS_CONTROL}/*)
    file(INSTALL ${files} DESTINATION ${tree}/DEBIAN PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
  endif()
  execute_process(COMMAND ${DPKG_DEB} --root-owner-group --build ${tree} ${package} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
