#!/usr/bin/env bash
# dlclose really removes the library from the process.
source "$SOURCE/tests_package/common.sh"

"$CC" -std=c99 -D_POSIX_C_SOURCE=200809L -I"$INSTALLED/include" "$here/unload.c" -ldl -o unload
./unload "$INSTALLED/$LIBDIR/libgamephys.so.1"
