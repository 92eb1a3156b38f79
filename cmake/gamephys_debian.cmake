# The Debian packages libgamephys<major> and libgamephys-dev, which cpack makes of any build of the
# shared library: components of their own, as Debian keeps libraries in a folder of the architecture
# and licences in files named copyright.

find_program(DPKG_DEB dpkg-deb)
find_program(GZIP gzip)
if(NOT DPKG_DEB OR NOT GZIP OR NOT GAMEPHYS_SHARED OR NOT CMAKE_LIBRARY_ARCHITECTURE)
  return()
endif()

set(runtime libgamephys${PROJECT_VERSION_MAJOR})
set(development libgamephys-dev)
set(revision 0gamephys1) # older than any that Debian itself would make of this version
set(generated ${PROJECT_BINARY_DIR}/debian)
gamephys_install(lib/${CMAKE_LIBRARY_ARCHITECTURE} ${generated} debian_runtime debian_development EXCLUDE_FROM_ALL)

# The packager as Debian's tools know him; .invalid is a domain that nobody has.
set(maintainer "The gamephys authors <gamephys@gamephys.invalid>")
if(DEFINED ENV{DEBEMAIL})
  set(maintainer "$ENV{DEBEMAIL}")
  if(DEFINED ENV{DEBFULLNAME})
    set(maintainer "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
  endif()
endif()

# LICENSE is a title, a line "Copyright (c) ...", and the terms.
file(READ LICENSE licence)
string(FIND "${licence}" "Permission " terms)
string(SUBSTRING "${licence}" 0 ${terms} copyright)
string(SUBSTRING "${licence}" ${terms} -1 licence)
string(REGEX REPLACE ".*Copyright .c. ([^\n]*).*" "\\1" copyright "${copyright}")
string(REGEX REPLACE "\n+$" "" licence "${licence}")
string(REPLACE "\n\n" "\n.\n" licence "${licence}")
string(REPLACE "\n" "\n " licence "${licence}")
file(
  CONFIGURE
  OUTPUT ${generated}/copyright
  CONTENT
    "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: gamephys

Files: *
Copyright: @copyright@
License: Expat

License: Expat
 @licence@
"
  @ONLY)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(
  CONFIGURE
  OUTPUT ${generated}/changelog.Debian
  CONTENT "gamephys (@PROJECT_VERSION@-@revision@) unstable; urgency=medium

  * Release @PROJECT_VERSION@; CHANGELOG.md lists the changes.

 -- @maintainer@  @date@
"
  @ONLY)
configure_file(cmake/gamephys.3.in ${generated}/gamephys.3 @ONLY)
execute_process(COMMAND ${GZIP} -9nf ${generated}/changelog.Debian ${generated}/gamephys.3 COMMAND_ERROR_IS_FATAL ANY)
install(
  FILES ${generated}/gamephys.3.gz
  DESTINATION share/man/man3
  COMPONENT debian_development EXCLUDE_FROM_ALL)
foreach(component runtime development)
  install(
    FILES ${generated}/copyright ${generated}/changelog.Debian.gz
    DESTINATION share/doc/${${component}}
    COMPONENT debian_${component} EXCLUDE_FROM_ALL)
endforeach()

set(about
    "Shapes and meshes in a scene that answers rays, overlaps, nearest points and
sweeps, a camera that culls and picks, and particles, ropes and cloth that move
through it: the same bits on every processor, behind a stable C interface.
")
set(CPACK_COMPONENTS_ALL debian_runtime debian_development)
set(CPACK_PACKAGE_CONTACT ${maintainer})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE gzip) # until gamephys_debian_finish.cmake writes them again
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${revision})
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_DEBIAN_RUNTIME_PACKAGE_NAME ${runtime})
set(CPACK_DEBIAN_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_DEBIAN_RUNTIME_DESCRIPTION "3D scene queries, camera, ropes and cloth (shared library)
${about}.
This package holds the shared library.")
set(CPACK_DEBIAN_DEBIAN_DEVELOPMENT_PACKAGE_NAME ${development})
set(CPACK_DEBIAN_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${runtime} (= ${PROJECT_VERSION}-${revision})")
set(CPACK_DEBIAN_DEBIAN_DEVELOPMENT_DESCRIPTION "3D scene queries, camera, ropes and cloth (development files)
${about}.
This package holds the headers for C and C++, the archive, and the files for
pkg-config and CMake.")

# What tells other packages which version of this one they need.
set(CPACK_GAMEPHYS_CONTROL ${generated}/control)
file(WRITE ${CPACK_GAMEPHYS_CONTROL}/shlibs "libgamephys ${PROJECT_VERSION_MAJOR} ${runtime} (>= ${PROJECT_VERSION})\n")
file(WRITE ${CPACK_GAMEPHYS_CONTROL}/triggers "activate-noawait ldconfig\n")
configure_file(cmake/gamephys.symbols ${CPACK_GAMEPHYS_CONTROL}/symbols COPYONLY) # by function
set(CPACK_POST_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/gamephys_debian_finish.cmake)
include(CPack)
