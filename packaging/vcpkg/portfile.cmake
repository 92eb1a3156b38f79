# An overlay port: GAMEPHYS_SOURCE in the environment is the folder of the sources.
#   GAMEPHYS_SOURCE=/path/to/gamephys vcpkg install gamephys --overlay-ports=/path/to/gamephys/packaging/vcpkg
if(NOT DEFINED ENV{GAMEPHYS_SOURCE})
  message(FATAL_ERROR "set GAMEPHYS_SOURCE to the folder of gamephys, and keep it by --x-keep-env-vars or VCPKG_KEEP_ENV_VARS")
endif()
set(SOURCE_PATH "$ENV{GAMEPHYS_SOURCE}")
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS -DGAMEPHYS_TESTS=OFF -DGAMEPHYS_EXAMPLES=OFF -DGAMEPHYS_BENCH=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/gamephys)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
