#!/usr/bin/env bash
# The header compiles alone, twice, under every standard of both compilers, without a warning; and
# what it hands to foreign-function parsers is plain C.
source "$SOURCE/tests_package/common.sh"
source "$here/headers.sh"
header=$INSTALLED/include/gamephys_c.h

header_compiles "$INSTALLED/include"
links_as_c "$INSTALLED/include"
plain_c "$header"
