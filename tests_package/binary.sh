#!/usr/bin/env bash
# What the shared object says of itself, and that it leaves its host's floating point alone.
source "$SOURCE/tests_package/common.sh"
library=$INSTALLED/$LIBDIR/libgamephys.so

readelf -d "$library" >dynamic.txt
grep -q 'SONAME.*\[libgamephys\.so\.1\]' dynamic.txt || fail "SONAME is not libgamephys.so.1"
grep NEEDED dynamic.txt >needed.txt
expect_no_match "unexpected dependency" -vE '\[(libc|libm|libstdc\+\+|libgcc_s|libpthread|ld-linux[-a-z0-9_]*)\.so\.[0-9]+\]' needed.txt
expect_no_match "search path in an installed library" -E 'RPATH|RUNPATH' dynamic.txt
readelf -W -l "$library" >segments.txt
expect_no_match "executable stack" 'GNU_STACK.*RWE' segments.txt
# -ffast-math at link time adds a constructor that flushes the host's denormals to zero.
objdump -d "$library" >code.txt
expect_no_match "instruction that changes the floating-point mode" ldmxcsr code.txt
