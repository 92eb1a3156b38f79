#!/usr/bin/env bash
# The checks of the interface can fail: each change below, which would break clients, is refused by
# the check that it names.
source "$SOURCE/tests_package/common.sh"
source "$here/binaries.sh"
source "$here/headers.sh"
interface=$SOURCE/cmake/interface
header=$SOURCE/include/gamephys_c.h
python3 "$interface/describe.py" "$header" >present.json
cp "$header" gamephys_c.h
python3 "$interface/compare.py" --compatible present.json present.json || fail "the header differs from itself"

# broken NAME EXPECTED SED: the header changed by SED is refused with a message that has EXPECTED.
broken() {
    mkdir "$1"
    sed "$3" "$header" >"$1/gamephys_c.h"
    ! cmp -s "$1/gamephys_c.h" "$header" || fail "$1: the header was not changed"
    python3 "$interface/describe.py" "$1/gamephys_c.h" >"$1/api.json"
    if python3 "$interface/compare.py" present.json "$1/api.json" >"$1/any.txt"; then fail "$1: not seen as a change"; fi
    if python3 "$interface/compare.py" --compatible present.json "$1/api.json" >"$1/found.txt"; then
        fail "$1: not seen as a break"
    fi
    grep -q "$2" "$1/found.txt" || fail "$1: another reason: $(cat "$1/found.txt")"
}
broken append 'gphys_nearest is frozen and has the new field extra' '/^} gphys_nearest;/i float extra;'
broken reorder 'gphys_sphere.center was' '/^typedef struct gphys_sphere {/,/^}/{/center;/d;/radius;/a gphys_vec3 center;
}'
broken desc_front 'gphys_model_desc.struct_size was' '/^typedef struct gphys_model_desc {/a uint32_t first;'
broken desc_shrink 'gphys_body_desc.layers was' '/^typedef struct gphys_body_desc {/,/^}/{/ layers;/d}'
broken narrower 'gphys_sphere.radius was' '/^typedef struct gphys_sphere {/,/^}/s/float radius/int16_t radius/'
broken enum_value 'GPHYS_SHAPE_CAPSULE was' 's/GPHYS_SHAPE_CAPSULE = 2/GPHYS_SHAPE_CAPSULE = 9/'
broken constant 'GPHYS_MAX_COORDINATE was' 's/1e15f/1e16f/'
broken function_dropped 'gphys_scene_clear is gone' '/gphys_scene_clear(/d'
broken parameter 'gphys_scene_has was' '/gphys_scene_has(/s/model)/model, int32_t deep)/'
broken return_type 'gphys_version was' '/gphys_version(void)/s/uint32_t/uint64_t/'
broken callback 'gphys_task was' 's/(\*gphys_task)(void\* context, uint32_t index)/(*gphys_task)(void* context, uint64_t index)/'

# What a minor release may do is not refused, but still has to be recorded.
mkdir grown
sed '/^} gphys_model_desc;/i float extra;' "$header" |
    sed 's/^GPHYS_API uint32_t gphys_version(void);/&\nGPHYS_API uint32_t gphys_extra(void);/' >grown/gamephys_c.h
python3 "$interface/describe.py" grown/gamephys_c.h >grown/api.json
python3 "$interface/compare.py" --compatible present.json grown/api.json || fail "a release cannot grow"
if python3 "$interface/compare.py" present.json grown/api.json; then fail "growth is not seen as a change"; fi

# The list of exports: a function that is missing, and what comes out without a version script.
exported() { (exports_match "$1") >exported.txt 2>&1; }
stub present.json gamephys_c.h good.so
exported good.so || fail "a good list is refused: $(cat exported.txt)"
sed '/gphys_scene_clear;/d' "$SOURCE/cmake/gamephys.map" >short.map
stub present.json gamephys_c.h short.so "$PWD/short.map"
if exported short.so; then fail "a missing function is not noticed"; fi
"$CC" -w -shared -fPIC good.so.c -o bare.so
if exported bare.so; then fail "a missing version script is not noticed"; fi

# refused NAME REASON CHECK...: the check fails, for this reason.
refused() {
    local name=$1 reason=$2
    shift 2
    if ("$@") >"$name.txt" 2>&1; then fail "$name is not noticed"; fi
    grep -q "$reason" "$name.txt" || fail "$name: another reason: $(cat "$name.txt")"
}

# The binary: another library that it needs, a name, a search path, and an object of gcc's that
# flushes denormals, which -ffast-math links in.
link() { "$CC" -w -shared -fPIC -Wl,-soname,libgamephys.so.1 "$@"; }
well_behaved good.so
link good.so.c -Wl,--no-as-needed -lresolv -o needs_more.so
refused needs_more 'unexpected dependency.*libresolv' well_behaved needs_more.so
link good.so.c -Wl,-rpath,/opt -o search_path.so
refused search_path 'search path' well_behaved search_path.so
link good.so.c -Wl,-soname,libgamephys.so.2 -o other_name.so
refused other_name 'SONAME' well_behaved other_name.so
link good.so.c -Wl,-z,execstack -o stack.so
refused stack 'executable stack' well_behaved stack.so
fast_math=$(gcc -print-file-name=crtfastmath.o)
if [ -f "$fast_math" ]; then
    link good.so.c "$fast_math" -o fast_math.so
    refused fast_math 'floating-point mode' well_behaved fast_math.so
fi

# A function that the C library computes, found in the binary, and in sources where the compiler computes it.
no_function_of_libm good.so
{ cat good.so.c && echo 'double exp(double); double gphys_decay(double z) { return exp(-z); }'; } >takes_exp.so.c
link takes_exp.so.c -lm -o takes_exp.so
refused takes_exp '^functions of the C library that differ by machine: exp$' no_function_of_libm takes_exp.so
for call in 'std::sin(0.1)' '__builtin_tan(0.1)' 'pow(2, 0.5f)' '::cbrt(2)' 'std::expf(x)'; do
    rm -rf sources
    mkdir sources
    sed "s/^double cbrt(double x) {/&\n    static const double value = $call;/" "$SOURCE/src/foundation/elementary_cbrt.cpp" >sources/changed.cpp
    refused call 'changed.cpp: .*value = ' no_call_of_libm "$PWD/sources"
done

# The header: what only C++ takes, only C, only later standards, or only once.
# extended NAME COMPILER LINE: the line is refused by the compiler.
extended() {
    mkdir "$1"
    sed "/^#endif.*GAMEPHYS_C_H/i $3" "$header" >"$1/gamephys_c.h"
    refused "$1" "^$2 -std" header_compiles "$PWD/$1"
}
extended only_cpp gcc 'struct gphys_extra { int value = 1; };'
extended only_c 'g++' 'typedef struct gphys_extra { int size; int values[]; } gphys_extra;'
extended only_later gcc 'typedef struct gphys_extra { struct { int value; }; } gphys_extra;'
mkdir unguarded
sed '/GAMEPHYS_C_H/d' "$header" >unguarded/gamephys_c.h
refused unguarded '^gcc -std=c99' header_compiles "$PWD/unguarded"

command -v abidiff >/dev/null || exit 0
binary_compatible good.so good.so || fail "a library differs from itself"
stub grown/api.json grown/gamephys_c.h grown.so
binary_compatible good.so grown.so >abidiff.txt || fail "abidiff refuses growth: $(cat abidiff.txt)"
for name in append reorder function_dropped parameter return_type; do
    stub $name/api.json $name/gamephys_c.h $name.so
    if binary_compatible good.so $name.so >abidiff.txt; then fail "abidiff does not notice $name"; fi
done
"$CC" -g -w -shared -fPIC -Wl,-soname,libgamephys.so.2 -Wl,--version-script="$SOURCE/cmake/gamephys.map" good.so.c -o soname.so
if binary_compatible good.so soname.so >abidiff.txt; then fail "abidiff does not notice another SONAME"; fi
