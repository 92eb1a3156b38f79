#!/usr/bin/env bash
# Runs the README. A ```c block with a main is a program, all others together are one; then the sh
# blocks and the cmake block build the first program in their own way.
source "$SOURCE/tests_package/common.sh"

awk -v prologue='#include <gamephys_c.h>\n#include <math.h>\n#include <stdio.h>\nint main(void) {' '
    /^```c$/ { inside = 1; block = ""; next }
    /^```sh$/ { inside = 2; next }
    /^```cmake$/ { inside = 3; next }
    /^```/ { if (inside == 1) { if (block ~ /int main/) printf "%s", block > "client.c"; else walk = walk block }
             inside = 0; next }
    inside == 1 { block = block $0 "\n" }
    inside == 2 { print > "commands.sh" }
    inside == 3 { print > "CMakeLists.txt" }
    END { print prologue; printf "%s", walk; print "return 0;\n}" }
' "$SOURCE/README.md" >walk.c

export PKG_CONFIG_PATH=$INSTALLED/$LIBDIR/pkgconfig LD_LIBRARY_PATH=$INSTALLED/$LIBDIR
"$CC" -std=c99 -Wall -Wextra -Werror walk.c $(pkg-config --cflags --libs gamephys) -o walk
./walk | tee walk.txt
[ "$(wc -l <walk.txt)" -eq 4 ] || fail "the walk should print four lines"

bash -e commands.sh >client.txt
"$CMAKE" -S . -B build -DCMAKE_PREFIX_PATH="$INSTALLED" >/dev/null
"$CMAKE" --build build
build/client >>client.txt
[ "$(sort -u client.txt)" = "hit at 4" ] || fail "the first program says: $(cat client.txt)"
