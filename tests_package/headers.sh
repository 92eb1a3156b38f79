# Sourced by scripts that look at the header.

# header_compiles DIRECTORY: gamephys_c.h there compiles alone, twice, under every standard of both
# compilers, without a warning. Each @param names one parameter, which is what clang understands.
header_compiles() {
    local compiler standard options
    printf '#include <gamephys_c.h>\n#include <gamephys_c.h>\nint gphys_unit;\n' >twice.c
    cp twice.c twice.cpp
    options=(-I"$1" -pedantic-errors -Wall -Wextra -Wstrict-prototypes -Werror -fsyntax-only)
    for compiler in gcc "clang -Wdocumentation"; do
        for standard in c99 c11 c17 c2x; do
            $compiler -std=$standard "${options[@]}" twice.c || fail "$compiler -std=$standard"
        done
    done
    options=("${options[@]/-Wstrict-prototypes/-Wold-style-cast}")
    for compiler in g++ "clang++ -Wdocumentation"; do
        for standard in c++98 c++11 c++14 c++17 c++20; do
            $compiler -std=$standard "${options[@]}" twice.cpp || fail "$compiler -std=$standard"
        done
    done
}

# links_as_c DIRECTORY: C++ calls the functions of gamephys_c.h there by their C names.
links_as_c() {
    printf '#include <gamephys_c.h>\nunsigned version() { return gphys_version(); }\n' >linkage.cpp
    g++ -I"$1" -c linkage.cpp -o linkage.o || fail "g++ does not take it"
    nm linkage.o | grep -q ' U gphys_version$' || fail "C++ does not call gphys_version by its C name"
}

# plain_c HEADER: its own lines, and what it includes, suit foreign-function parsers.
plain_c() {
    # Only this header's own lines: the standard ones hold attributes.
    gcc -E "$1" | awk '/^# [0-9]+ "/ { ours = index($0, "gamephys_c.h") > 0; next } ours' >plain.txt
    grep -q gphys_version plain.txt || fail "the header's own lines were not found"
    expect_no_match "not plain C for a parser" -wE '__attribute__|__declspec|__extension__|inline|static|_Alignas|_Pragma|#pragma' plain.txt
    grep '^#include' "$1" >includes.txt
    expect_no_match "more than stddef.h and stdint.h" -vE '<(stddef|stdint)\.h>' includes.txt
    grep -oE '^ *# *define +[A-Za-z_0-9]+' "$1" | awk '{ print $NF }' >macros.txt
    expect_no_match "a macro of another name" -vE '^(GPHYS|GAMEPHYS)_' macros.txt
}

# preprocessed HEADER: as a parser of plain C takes it, which knows the types of stddef.h and stdint.h.
preprocessed() {
    mkdir -p known
    touch known/stddef.h known/stdint.h
    gcc -E -P -nostdinc -isystem known "$1"
}
