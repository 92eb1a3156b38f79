# Sourced by scripts that look at binaries.

# stub API.json HEADER OUTPUT [MAP]: a library with this interface and nothing else.
stub() {
    python3 "$SOURCE/cmake/interface/stub.py" "$1" "$PWD/$2" >"$3.c"
    "$CC" -g -w -shared -fPIC -Wl,-soname,libgamephys.so.1 -Wl,--version-script="${4:-$SOURCE/cmake/gamephys.map}" \
        "$3.c" -o "$3"
}

# map_until NODE: the version script up to that node, as it was when the release of that node was made.
map_until() {
    sed "/^$1 {/,/^}/!b; /^}/q" "$SOURCE/cmake/gamephys.map"
}

# binary_compatible OLD NEW: functions may be added and descs may grow.
binary_compatible() {
    cat >suppressions.ini <<'END'
[suppress_type]
name_regexp = ^gphys_.*_desc$
has_data_member_inserted_at = end
[suppress_function]
change_kind = added-function
END
    abidiff --no-added-syms --suppressions suppressions.ini "$1" "$2"
}

# exports_match LIBRARY [HEADER [MAP]]: the header's functions, the version script's list and the
# library's exports are the same set, each function in the node of the release that it came with.
exports_match() {
    local header=${2:-$SOURCE/include/gamephys_c.h} map=${3:-$SOURCE/cmake/gamephys.map}
    local released=$SOURCE/cmake/interface
    python3 "$released/releases.py" check-map "$header" "$released" "$map" || fail "cmake/gamephys.map differs from the header"
    python3 "$released/releases.py" nodes "$header" "$released" | sort >expected.txt
    # A: the nodes. T: functions. Anything else, such as a weak or unique symbol of the C++ library, is a leak.
    nm -D --defined-only --with-symbol-versions "$1" | grep -v ' A GAMEPHYS_' >nm.txt
    expect_no_match "exported without being in the list" -vE ' T gphys_[a-z0-9_]+(@@GAMEPHYS_[0-9.]+)?$' nm.txt
    sed -E 's/^[0-9a-f]* T //; s/@@/ /' nm.txt | sort >binary.txt
    diff expected.txt binary.txt || fail "the exports differ from the header: < expected, > found"
}

# The libraries that a program with gamephys needs, by the names of their present major versions.
needed='libc\.so\.6|libm\.so\.6|libstdc\+\+\.so\.6|libgcc_s\.so\.1|libpthread\.so\.0|ld-linux[-a-z0-9_]*\.so\.[0-9]+'

# well_behaved LIBRARY: named as clients expect, without unexpected dependencies, search paths or an
# executable stack; it leaves the floating-point mode of its host alone, says nothing on its host's
# standard output and error, and knows the statuses by their names.
well_behaved() {
    local major status=0
    major=$(sed -n 's/^#define GPHYS_VERSION_MAJOR //p' "$SOURCE/include/gamephys_c.h")
    readelf -d "$1" >dynamic.txt
    grep -q "SONAME.*\[libgamephys\.so\.$major\]" dynamic.txt || fail "SONAME is not libgamephys.so.$major"
    sed -n '/NEEDED/p' dynamic.txt >needed.txt
    expect_no_match "unexpected dependency" -vE "\[($needed)\]" needed.txt
    expect_no_match "search path in an installed library" -E 'RPATH|RUNPATH' dynamic.txt
    expect_no_match "code that has to be changed when it is loaded" TEXTREL dynamic.txt
    readelf -W -l "$1" >segments.txt
    expect_no_match "executable stack" 'GNU_STACK.*RWE' segments.txt
    # "value NAME" of each status, which load.c compares.
    sed -nE 's/^ *(GPHYS_[A-Z_]+) = (-?[0-9]+),?( .*)?$/\2 \1/p; /GPHYS_ERROR_INTERNAL/q' "$SOURCE/include/gamephys_c.h" >statuses.txt
    [ "$(wc -l <statuses.txt)" -ge 13 ] || fail "the statuses were not found in the header"
    "$CC" -std=c99 -D_POSIX_C_SOURCE=200809L -I"$SOURCE/include" "$here/load.c" -ldl -o load
    ./load "$(realpath "$1")" $(cat statuses.txt) >output.txt 2>&1 || status=$?
    [ ! -s output.txt ] || fail "the library prints: $(cat output.txt)"
    [ $status -ne 3 ] || fail "a status has another name than in the header"
    # -ffast-math at link time adds a constructor that flushes the host's denormals to zero.
    [ $status -ne 6 ] || fail "loading and using the library changes the floating-point mode"
    [ $status -eq 0 ] || fail "loading, using and unloading the library ends with $status"
}

# What C libraries compute alike: what IEEE 754 wants correctly rounded, and what is exact.
exact_functions='(ceil|copysign|fabs|floor|fma|fmax|fmin|fmod|frexp|ilogb|ldexp|l?lrint|l?lround|logb|modf|nan|nearbyint|nextafter|remainder|rint|round|scalbl?n|sqrt|trunc)f?'

# no_function_of_libm LIBRARY: none, that is, whose results differ by C library or by processor.
no_function_of_libm() {
    local libm
    libm=$("$CC" -print-file-name=libm.so.6)
    nm -D --defined-only "$libm" | sed -n 's/.* [TiW] \([a-z0-9_]*\)@.*/\1/p' | sort -u >libm.txt
    grep -qx exp libm.txt || fail "no functions found in $libm"
    { nm -u "$1"; nm -D -u "$1" 2>no_dynamic.txt || true; } | sed -n 's/^ *[Uw] \([a-z0-9_]*\).*/\1/p' | sort -u >needed.txt
    [ -s needed.txt ] || fail "$1 needs nothing: it cannot be looked at"
    comm -12 libm.txt needed.txt >of_libm.txt
    expect_no_match "functions of the C library that differ by machine" -vxE "$exact_functions" of_libm.txt
}

# no_call_of_libm FOLDER: nor do sources call one; a compiler that knows the argument computes it itself.
no_call_of_libm() {
    local ours='tan|cbrt' others='exp|exp2|expm1|log|log2|log10|log1p|sin|cos|sincos|asin|acos|atan|atan2|sinh|cosh|tanh|asinh|acosh|atanh|pow|hypot|erf|erfc|tgamma|lgamma'
    find "$1" -name '*.cpp' -o -name '*.h' | sort >sources.txt
    [ -s sources.txt ] || fail "no sources in $1"
    while read -r file; do sed "s|//.*||; s|^|${file#"$1"/}: |" "$file"; done <sources.txt >code_lines.txt
    expect_no_match "calls of functions that differ by machine" -E \
        "(std::|[^A-Za-z0-9_:]::|__builtin_)($ours|$others)[fl]?\(|[^A-Za-z0-9_.>:]($others)[fl]?\(" code_lines.txt
}
