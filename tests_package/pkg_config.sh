#!/usr/bin/env bash
# A C client compiled with what pkg-config says of the moved tree: pkg_config.sh shared|static
source "$SOURCE/tests_package/common.sh"

prefix=$WORK/prefix
cp -a "$INSTALLED" "$prefix"
export PKG_CONFIG_PATH=$prefix/$LIBDIR/pkgconfig
pkg-config --validate gamephys
if [ "$1" = shared ]; then
    "$CC" "$here/client.c" $(pkg-config --cflags --libs gamephys) -o client
    LD_LIBRARY_PATH=$prefix/$LIBDIR ./client
else
    # The linker takes a shared library wherever it finds one, so there must be none.
    rm "$prefix/$LIBDIR"/libgamephys.so*
    "$CC" "$here/client.c" $(pkg-config --cflags --libs --static gamephys) -o client
    ./client
    readelf -d client >dynamic.txt
    expect_no_match "the static client needs the shared library" 'NEEDED.*gamephys' dynamic.txt
fi
