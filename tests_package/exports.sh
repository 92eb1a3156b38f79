#!/usr/bin/env bash
# The library exports the header's functions and nothing else.
source "$SOURCE/tests_package/common.sh"
source "$here/binaries.sh"
exports_match "$INSTALLED/$LIBDIR/libgamephys.so"

# A shared object that takes the archive in must not pass the interface on.
"$CC" -shared -fPIC -I"$INSTALLED/include" "$here/client.c" "$INSTALLED/$LIBDIR/libgamephys.a" -lstdc++ -lm -o plugin.so
nm -D --defined-only plugin.so >plugin.txt
expect_no_match "re-exported by a plugin that holds the archive" gphys plugin.txt
