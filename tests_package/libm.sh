#!/usr/bin/env bash
# The library takes no function of the C library whose results differ by version and processor:
# src/foundation/elementary.h has its own.
source "$SOURCE/tests_package/common.sh"
source "$here/binaries.sh"
no_function_of_libm "$INSTALLED/$LIBDIR/libgamephys.so"
no_function_of_libm "$INSTALLED/$LIBDIR/libgamephys.a"
no_call_of_libm "$SOURCE/src"
