#!/usr/bin/env bash
# What the shared object says of itself, and that it leaves its host's floating point alone.
source "$SOURCE/tests_package/common.sh"
source "$here/binaries.sh"
well_behaved "$INSTALLED/$LIBDIR/libgamephys.so"
