# Sourced by scripts that look at the header.

# header_compiles DIRECTORY: gamephys_c.h there compiles alone, twice, under every standard of both
# compilers, without a warning.
header_compiles() {
    local compiler standard options
    printf '#include <gamephys_c.h>\n#include <gamephys_c.h>\nint gphys_unit;\n' >twice.c
    cp twice.c twice.cpp
    options=(-I"$1" -pedantic-errors -Wall -Wextra -Wstrict-prototypes -Werror -fsyntax-only)
    for compiler in gcc clang; do
        for standard in c99 c11 c17 c2x; do
            $compiler -std=$standard "${options[@]}" twice.c || fail "$compiler -std=$standard"
        done
    done
    options=("${options[@]/-Wstrict-prototypes/-Wold-style-cast}")
    for compiler in g++ clang++; do
        for standard in c++98 c++11 c++14 c++17 c++20; do
            $compiler -std=$standard "${options[@]}" twice.cpp || fail "$compiler -std=$standard"
        done
    done
}

# preprocessed HEADER: as a parser of plain C takes it, which knows the types of stddef.h and stdint.h.
preprocessed() {
    mkdir -p known
    touch known/stddef.h known/stdint.h
    gcc -E -P -nostdinc -isystem known "$1"
}
