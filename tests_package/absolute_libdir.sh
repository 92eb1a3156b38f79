#!/usr/bin/env bash
# Distributions may give absolute directories; gamephys.pc must not put its prefix before them.
source "$SOURCE/tests_package/common.sh"

"$CMAKE" -S "$SOURCE" -B build -DGAMEPHYS_TESTS=OFF -DGAMEPHYS_EXAMPLES=OFF -DGAMEPHYS_BENCH=OFF \
    -DCMAKE_INSTALL_PREFIX=/opt/g -DCMAKE_INSTALL_LIBDIR=/opt/lib64 >/dev/null
export PKG_CONFIG_PATH=$WORK/build
[ "$(pkg-config --variable=libdir gamephys)" = /opt/lib64 ] || fail "libdir: $(pkg-config --variable=libdir gamephys)"
[ "$(pkg-config --variable=includedir gamephys)" = /opt/g/include ] || fail "includedir is not below the prefix"
