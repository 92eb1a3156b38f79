#!/usr/bin/env bash
# What kernels (src/foundation/isa.h) define for other files lies in the namespace of their
# instruction set. A function outside of it, compiled for a processor with AVX2 and taken by the
# linker for its namesake in an ordinary file, would crash processors without; AVX-512 alike.
source "$SOURCE/tests_package/common.sh"

case $CONFIG in
    Release | RelWithDebInfo) ;;
    *) echo "without optimisation, functions of headers are kept as they are: nothing to see"; exit 0 ;;
esac

cd "$WORK"
find "$BUILD/CMakeFiles" -path '*/src/*' -name '*_kernels.cpp.o' >objects.txt
[ -s objects.txt ] || fail "no kernels found"
xargs -d '\n' -a objects.txt nm -C -g --defined-only | sed -n 's/^[0-9a-f]\+ . //p' >defined.txt
[ -s defined.txt ] || fail "no symbols found"
expect_no_match "defined by kernels for all" -vE '^([a-z]+ )*gphys::(scalar|sse2|avx2|avx512|neon|wasm)::' defined.txt
