#!/usr/bin/env bash
# A foreign-function interface reads the preprocessed header as it is: parser.sh luajit|cffi COMMAND
# It refuses what is not plain C.
source "$SOURCE/tests_package/common.sh"
source "$here/headers.sh"

cat >luajit.txt <<'END'
local ffi = require 'ffi'
ffi.cdef(io.open(arg[1]):read '*a')
local library = ffi.load(arg[2])
assert(bit.rshift(library.gphys_version(), 16) == 1 and ffi.C.GPHYS_SHAPE_MESH == 8)
assert(ffi.sizeof 'gphys_hit' == 52 and ffi.string(library.gphys_status_name(1)) == 'GPHYS_NO_HIT')
END
cat >cffi.txt <<'END'
import sys
from cffi import FFI
ffi = FFI()
ffi.cdef(open(sys.argv[1]).read())
library = ffi.dlopen(sys.argv[2])
assert library.gphys_version() >> 16 == 1 and library.GPHYS_SHAPE_MESH == 8
assert ffi.sizeof("gphys_hit") == 52 and ffi.string(library.gphys_status_name(1)) == b"GPHYS_NO_HIT"
END

library=$INSTALLED/$LIBDIR/libgamephys.so.1
preprocessed "$INSTALLED/include/gamephys_c.h" >header.txt
"$2" "$1.txt" header.txt "$library"

(cat header.txt && echo 'struct gphys_extra { int value = 1; };') >extended.txt
if "$2" "$1.txt" extended.txt "$library" 2>refused.txt; then fail "$1 takes what is not C"; fi
grep -q "near '='\|int value = 1" refused.txt || fail "$1 refuses something else: $(cat refused.txt)"
