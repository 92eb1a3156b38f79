#!/usr/bin/env bash
# The gates of the interface can fail: each change below, which would break clients, is refused by the
# gate that it names, for the reason that it names. Each runs in a folder of its own, some at a time.
# A change takes a second or two, so without the argument "all" each tenth one is tried.
source "$SOURCE/tests_package/common.sh"
for helpers in binaries headers generated documented; do source "$here/$helpers.sh"; done
interface=$SOURCE/cmake/interface
header=$SOURCE/include/gamephys_c.h
map=$SOURCE/cmake/gamephys.map
count=0 tried=0
every=10
[ "${1:-}" != all ] || every=1
mkdir failed

# refused NAME REASON GATE...: the gate fails, for this reason (an extended regular expression).
refused() {
    local name=$1 reason=$2
    shift 2
    count=$((count + 1))
    [ $((count % every)) -eq 0 ] || return 0
    tried=$((tried + 1))
    while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n || true; done
    {
        mkdir "$name" && cd "$name"
        if ("$@") >found.txt 2>&1; then
            echo "$name is not refused by: $*"
        elif ! grep -qE -e "$reason" found.txt; then
            echo "$name: another reason: $(cat found.txt)"
        fi >"$WORK/failed/$name"
    } &
}

# changed FILE SED COPY: the file changed by SED, as COPY.
changed() {
    sed "$2" "$1" >"$3"
    ! cmp -s "$1" "$3" || fail "$1 was not changed by $2"
}

# The gates of a header, for one that is changed by SED.
described() { changed "$header" "$1" gamephys_c.h && python3 "$interface/describe.py" gamephys_c.h --quick >api.json; }
compatible() { described "$1" && python3 "$interface/compare.py" --compatible "$WORK/present.json" api.json; }
recorded() { described "$1" && python3 "$interface/compare.py" "$WORK/present.json" api.json; }
ruled() { described "$1" && python3 "$interface/rules.py" api.json "$SOURCE"/tests_c/*.c "$SOURCE"/tests_cpp/*.cpp; }
described_for_all() {
    changed "$header" "$1" gamephys_c.h
    python3 "$interface/describe.py" gamephys_c.h
}
compiled() {
    changed "$header" "$1" gamephys_c.h
    header_compiles "$PWD"
    links_as_c "$PWD"
    plain_c gamephys_c.h
}
mapped() {
    changed "$map" "$1" gamephys.map
    python3 "$interface/releases.py" check-map "$header" "$interface" gamephys.map
}
# A header that adds a function, beside the present map.
unmapped() {
    changed "$header" "$1" gamephys_c.h
    python3 "$interface/releases.py" check-map gamephys_c.h "$interface" "$map"
}

python3 "$interface/describe.py" "$header" >present.json
cp "$header" gamephys_c.h
python3 "$interface/compare.py" --compatible present.json present.json || fail "the header differs from itself"
python3 "$interface/rules.py" present.json "$SOURCE"/tests_c/*.c "$SOURCE"/tests_cpp/*.cpp || fail "the header breaks its own rules"

# Layouts, values and functions that programs were compiled with.
refused append 'gphys_nearest is frozen and has the new field extra' compatible '/^} gphys_nearest;/i float extra;'
refused insert 'gphys_hit.t was' compatible '/^typedef struct gphys_hit {/,/^}/s/^ *float t;/float extra, t;/'
refused reorder 'gphys_sphere.center was' compatible '/^typedef struct gphys_sphere {/,/^}/{/center;/d;/radius;/a gphys_vec3 center;
}'
refused narrower 'gphys_sphere.radius was' compatible '/^typedef struct gphys_sphere {/,/^}/s/float radius/int16_t radius/'
refused wider 'gphys_sphere.radius was' compatible '/^typedef struct gphys_sphere {/,/^}/s/float radius/double radius/'
refused field_name 'gphys_plane.distance was' compatible '/^typedef struct gphys_plane {/,/^}/s/float distance/float offset/'
refused array_length 'gphys_mat4.m was' compatible '/^typedef struct gphys_mat4 {/,/^}/s/m\[16\]/m[12]/'
refused packed 'gphys_vec3: alignment was' compatible '/^typedef struct gphys_vec3 {/i #pragma pack(push, 1)
/^} gphys_vec3;/a #pragma pack(pop)'
refused aligned 'gphys_quat: alignment was' compatible 's/^} gphys_quat;/} __attribute__((aligned(16))) gphys_quat;/'
refused desc_front 'gphys_model_desc.struct_size was' compatible '/^typedef struct gphys_model_desc {/a uint32_t first;'
refused desc_middle 'gphys_solver_desc.fixed_step was' compatible '/^typedef struct gphys_solver_desc {/,/^}/s/^ *float fixed_step;/float extra, fixed_step;/'
refused desc_shrink 'gphys_body_desc.layers was' compatible '/^typedef struct gphys_body_desc {/,/^}/{/ layers;/d}'
refused desc_type 'gphys_solver_desc.substeps was' compatible '/^typedef struct gphys_solver_desc {/,/^}/s/uint32_t substeps/float substeps/'
refused hooks 'gphys_allocator.allocate was' compatible '/^typedef struct gphys_allocator {/,/^}/{s/(\*allocate)/(*taken)/}'
refused enum_value 'GPHYS_SHAPE_CAPSULE was' compatible 's/GPHYS_SHAPE_CAPSULE = 2/GPHYS_SHAPE_CAPSULE = 9/'
refused enum_removed 'GPHYS_SHAPE_SEGMENT is gone' compatible '/GPHYS_SHAPE_SEGMENT = 17/d'
refused enum_renamed 'GPHYS_FRUSTUM_FAR is gone' compatible 's/GPHYS_FRUSTUM_FAR = 1/GPHYS_FRUSTUM_BACK = 1/'
refused constant 'GPHYS_MAX_COORDINATE was' compatible 's/1e15f/1e16f/'
refused constant_type 'GPHYS_NO_TRIANGLE was' compatible 's/GPHYS_NO_TRIANGLE 0xffffffffu/GPHYS_NO_TRIANGLE (-1)/'
refused constant_removed 'GPHYS_ALL_LAYERS is gone' compatible '/^#define GPHYS_ALL_LAYERS/d'
refused id_type 'gphys_model_id was' compatible 's/^typedef uint32_t gphys_model_id;/typedef int32_t gphys_model_id;/'
refused function_dropped 'gphys_scene_clear is gone' compatible '/gphys_scene_clear(/d'
refused function_renamed 'gphys_scene_has is gone' compatible 's/gphys_scene_has(/gphys_scene_contains(/'
refused parameter 'gphys_scene_has was' compatible '/gphys_scene_has(/s/model)/model, int32_t deep)/'
refused parameter_dropped 'gphys_scene_set_tag was' compatible '/gphys_scene_set_tag(/s/, uint32_t tag)/)/'
refused parameter_order 'gphys_camera_set_viewport was' compatible '/gphys_camera_set_viewport(/s/float width, float height/float height, float width/'
refused parameter_type 'gphys_scene_set_layers was' compatible '/gphys_scene_set_layers(/s/uint32_t layers/int32_t layers/'
refused constness 'gphys_scene_raycast was' compatible '/gphys_scene_raycast(/s/const gphys_ray\*/gphys_ray*/'
refused parameter_length 'gphys_frustum_corners was' compatible '/gphys_frustum_corners(/s/\[8\]/[6]/'
refused return_type 'gphys_version was' compatible '/gphys_version(void)/s/uint32_t/int32_t/'
refused callback 'gphys_task was' compatible 's/(\*gphys_task)(void\* context, uint32_t index)/(*gphys_task)(void* context, uint64_t index)/'

# Additions and versions.
new_function='s/^GPHYS_API uint32_t gphys_version(void);/&\nGPHYS_API uint32_t gphys_extra(void);/'
refused new_function 'new since .* must be raised: gphys_extra' compatible "$new_function"
refused new_field 'must be raised: gphys_model_desc.extra' compatible '/^} gphys_model_desc;/i float extra;'
refused new_value 'must be raised: GPHYS_SHAPE_TORUS' compatible 's/GPHYS_SHAPE_RAY = 16,/GPHYS_SHAPE_TORUS = 9, &/'
refused new_struct 'must be raised: gphys_extra' compatible 's/^GPHYS_API uint32_t gphys_version/typedef struct gphys_extra { float a; } gphys_extra;\n&/'
refused new_patch 'must be raised: gphys_extra' compatible "$new_function;s/VERSION_PATCH [0-9]*/VERSION_PATCH 99/"
refused major_alone 'the major version was' compatible 's/VERSION_MAJOR 1/VERSION_MAJOR 2/'
refused version_back 'the version was' compatible 's/VERSION_MINOR [0-9]*/VERSION_MINOR 0/'
refused unrecorded 'changed: gphys_scene_clear' recorded 's/^\/\*\* Remove all models\./\/** Remove each model./'

# Types that some languages cannot pass, and structs that cannot grow.
refused bool_field 'gphys_camera_desc.reverse_z is _Bool' ruled '/^typedef struct gphys_camera_desc {/,/^}/s/int32_t reverse_z/_Bool reverse_z/'
refused long_field 'gphys_body_desc.cloth_flags is long' ruled 's/uint32_t cloth_flags/long cloth_flags/'
refused targets_differ 'differs from other 64-bit targets' described_for_all '/^typedef struct gphys_hit {/,/^}/s/uint32_t flags/long flags/'
refused wide_field 'gphys_hit.flags is uint64_t' ruled '/^typedef struct gphys_hit {/,/^}/s/uint32_t flags/uint64_t flags/'
refused bit_field 'gphys_hit.flags is a bit-field' ruled '/^typedef struct gphys_hit {/,/^}/s/uint32_t flags;/uint32_t flags : 8;/'
refused pointer_field 'gphys_hit.name is const char' ruled '/^} gphys_hit;/i const char* name;'
refused size_parameter 'capacity is size_t' ruled '/gphys_mesh_get_indices(/,/;/s/uint32_t capacity/size_t capacity/'
refused double_parameter 'tolerance is double' ruled '/gphys_shape_contains(/,/;/s/float tolerance/double tolerance/'
refused enum_type 'gphys_side is enum' ruled 's/^typedef int32_t gphys_side;/typedef enum gphys_side { GPHYS_SIDE_NONE = 5 } gphys_side;/'
refused by_value 'ray is gphys_ray' ruled '/gphys_scene_raycast(/s/const gphys_ray\* ray/gphys_ray ray/'
refused returned_by_value 'returns gphys_vec3' ruled '/gphys_shape_validate(/s/gphys_status/gphys_vec3/'
refused variadic 'gphys_orbit_init takes any number' ruled 's/gphys_orbit_init(gphys_orbit\* orbit)/gphys_orbit_init(gphys_orbit* orbit, ...)/'
refused inline 'gphys_twice is defined in the header' ruled 's/^GPHYS_API uint32_t gphys_version/static int32_t gphys_twice(int32_t a) { return 2 * a; }\n&/'
refused variable 'gphys_count is a variable' ruled 's/^GPHYS_API uint32_t gphys_version/GPHYS_API extern int32_t gphys_count;\n&/'
refused function_prefix 'version does not begin with gphys_' ruled 's/ gphys_version(void)/ version(void)/'
refused value_prefix 'SIDE_OUTSIDE does not begin with GPHYS_' ruled 's/ GPHYS_SIDE_OUTSIDE = -1/ SIDE_OUTSIDE = -1/'
refused status_sign 'GPHYS_ERROR_CYCLE = 6: errors' ruled 's/GPHYS_ERROR_CYCLE = -6/GPHYS_ERROR_CYCLE = 6/'
refused desc_padding 'gphys_scene_desc ends in padding' ruled '/^typedef struct gphys_scene_desc {/,/^}/{/reserved;/d}'
refused desc_odd 'gphys_solver_desc ends in padding' ruled '/^} gphys_solver_desc;/i float extra;'
refused desc_size 'gphys_body_desc does not begin with' ruled '/^typedef struct gphys_body_desc {/,/^}/s/uint32_t struct_size/int32_t struct_size/'

# Comments.
refused comment_missing 'gphys_scene_clear has no comment of its own' ruled '/^\/\*\* Remove all models\./d'
refused comment_shared 'gphys_scene_destroy has the comment of gphys_scene_clear|gphys_camera_destroy has the comment' ruled \
    's/^\/\*\* Destroy a camera;.*/\/** Remove all models. Ids given out before stay invalid. Cost: O(n). *\//'
refused comment_unit 'does not say what fov_y is' ruled '/@param fov_y/d'
refused comment_cost 'gphys_scene_clear: the comment does not say what it costs' ruled '/^\/\*\* Remove all models\./s/ Cost: O(n)\.//'
refused comment_error 'gphys_scene_set_parent: the comment does not name GPHYS_ERROR_CYCLE' ruled 's/@return GPHYS_ERROR_CYCLE if/@return an error if/'
refused untested 'gphys_untested is named by no test' ruled 's/gphys_scene_validate(/gphys_untested(/'

# The header as compilers and parsers take it.
at_end() { echo "/^#endif.*GAMEPHYS_C_H/i $1"; }
refused only_cpp '^gcc -std=c99' compiled "$(at_end 'struct gphys_extra { int value = 1; };')"
refused only_c '^g\+\+ -std' compiled "$(at_end 'typedef struct gphys_extra { int size; int values[]; } gphys_extra;')"
refused only_later '^gcc -std' compiled "$(at_end 'typedef struct gphys_extra { struct { int value; }; } gphys_extra;')"
refused only_gcc '^gcc -std' compiled "$(at_end 'typedef struct gphys_extra { int values[0]; } gphys_extra;')"
refused unguarded '^gcc -std=c99' compiled '/GAMEPHYS_C_H/d'
refused needs_another '^gcc -std=c99' compiled "$(at_end 'GPHYS_API FILE* gphys_log(void);')"
refused comment_of_two '^clang -Wdocumentation -std=c99' compiled 's/@param fov_y /@param fov_y, near_distance /'
refused includes 'more than stddef.h' compiled '/^#include <stdint.h>/a #include <string.h>'
refused cpp_linkage 'by its C name' compiled '/^#ifdef __cplusplus/,/^#endif/d'
refused attribute 'not plain C' compiled 's/^GPHYS_API uint32_t gphys_version/GPHYS_API __attribute__((const)) uint32_t gphys_version/'
refused macro 'a macro of another name' compiled '/^#define GPHYS_VERSION_PATCH/a #define VERSION 1'

# The version script.
refused map_short 'gphys_scene_clear is not in the map' mapped '/gphys_scene_clear;/d'
refused map_long 'gphys_gone is in the map and not in the header' mapped 's/gphys_scene_clear;/&\n    gphys_gone;/'
refused map_wildcard 'gphys_\* is in the map' mapped 's/gphys_scene_clear;/gphys_*;/'
refused map_one_node 'the nodes are GAMEPHYS_1.0, not' mapped '/^};/,/^global:/d;s/^} GAMEPHYS_1.0;/};/'
refused map_moved 'gphys_scene_clear is in GAMEPHYS_1.1, it came with GAMEPHYS_1.0' mapped '/gphys_scene_clear;/d;s/^    gphys_scene_set_origin;/&\n    gphys_scene_clear;/'
refused map_late 'gphys_solver_join is in GAMEPHYS_1.0, it came with GAMEPHYS_1.1' mapped '/gphys_solver_join;/d;s/^    gphys_scene_clear;/&\n    gphys_solver_join;/'
refused map_order 'GAMEPHYS_1.1 follows nothing' mapped 's/^} GAMEPHYS_1.0;/};/'
refused map_open 'local: \*' mapped '/^local:/,/\*;/d'
refused map_minor 'the nodes are .*, not .*GAMEPHYS_1.99' unmapped 's/VERSION_MINOR [0-9]*/VERSION_MINOR 99/'
refused map_function 'gphys_extra is not in the map' unmapped "$new_function"

# The exports of a library, and the library itself. A stub has the interface and does nothing.
stub present.json gamephys_c.h good.so
exported() { exports_match "$1"; }
(mkdir control && cd control && exported ../good.so && well_behaved ../good.so) || fail "a good library is refused"
linked() { "$CC" -w -shared -fPIC -Wl,-soname,libgamephys.so.1 "$@" -o changed.so; }
# Sources, options: a library of the stub and of these, before the gate sees it.
exported_with() { linked "$WORK/good.so.c" "$@" && exported changed.so; }
behaved_with() { linked "$WORK/good.so.c" -Wl,--version-script="$map" "$@" && well_behaved changed.so; }
# The stub with its source changed by SED.
behaved_as() {
    changed "$WORK/good.so.c" "$1" changed.c
    linked changed.c -Wl,--version-script="$map" && well_behaved changed.so
}
echo 'void helper(void) {}' >helper.c
echo '__attribute__((weak)) void _ZNSt6vectorIiSaIiEE4growEv(void) {}' >weak.c
echo 'int gphys_counter = 1;' >data.c
sed '/^local:/,/\*;/d' "$map" >open.map
sed 's/gphys_scene_clear;//' "$map" >short.map
sed '/^};/,/^global:/{/^}/d;/^$/d;/^GAMEPHYS/d;/^global/d};s/^} GAMEPHYS_1.0;/};/;/^local:/d;/^ *\*;/d' "$map" >one_node.map
refused export_bare 'the exports differ' exported_with
refused export_short 'the exports differ' exported_with -Wl,--version-script="$WORK/short.map"
refused export_node 'the exports differ' exported_with -Wl,--version-script="$WORK/one_node.map"
refused export_helper 'exported without being in the list.* helper' exported_with "$WORK/helper.c" -Wl,--version-script="$WORK/open.map"
refused export_weak 'exported without being in the list.* W _ZNSt' exported_with "$WORK/weak.c" -Wl,--version-script="$WORK/open.map"
refused export_data 'exported without being in the list.* D gphys_counter' exported_with "$WORK/data.c" -Wl,--version-script="$WORK/open.map"

refused needs_more 'unexpected dependency.*libresolv' behaved_with -Wl,--no-as-needed -lresolv
refused search_path 'search path' behaved_with -Wl,-rpath,/opt
refused old_search_path 'search path' behaved_with -Wl,--disable-new-dtags -Wl,-rpath,/opt
refused other_name 'SONAME' behaved_with -Wl,-soname,libgamephys.so.2
refused executable_stack 'executable stack' behaved_with -Wl,-z,execstack
fast_math=$(gcc -print-file-name=crtfastmath.o)
[ ! -f "$fast_math" ] || refused fast_math 'floating-point mode' behaved_with "$fast_math"
printing='#include <stdio.h>'
echo "$printing
__attribute__((constructor)) static void load(void) { puts(\"gamephys\"); }" >print_at_load.c
echo "$printing
__attribute__((destructor)) static void unload(void) { fputs(\"gamephys\", stderr); }" >print_at_unload.c
refused print_at_load 'the library prints: gamephys' behaved_with "$WORK/print_at_load.c"
refused print_at_unload 'the library prints: gamephys' behaved_with "$WORK/print_at_unload.c"
refused print_at_call 'the library prints: bad shape' behaved_as '1i #include <stdio.h>
/gphys_shape_validate(/s/{/{ fputs("bad shape", stderr);/'
refused status_renamed 'a status has another name' behaved_as 's/"GPHYS_NO_HIT"/"GPHYS_MISS"/'
refused status_unnamed 'a status has another name' behaved_as '/gphys_status_name(/s/{.*/{ return 0; }/'
refused aborts 'ends with 134' behaved_as '1i #include <stdlib.h>
/gphys_shape_validate(/s/{/{ abort();/'

# A function that the C library computes, found in the binary, and in sources where the compiler computes it.
(mkdir libm && cd libm && no_function_of_libm ../good.so) || fail "a library without libm is refused"
echo 'double exp(double); double gphys_decay(double z) { return exp(-z); }' >takes_exp.c
takes_of_libm() { linked "$WORK/good.so.c" "$WORK/takes_exp.c" -lm && no_function_of_libm changed.so; }
refused takes_exp '^functions of the C library that differ by machine: exp$' takes_of_libm
calls_of_libm() {
    mkdir sources
    changed "$SOURCE/src/foundation/elementary_cbrt.cpp" "s/^double cbrt(double x) {/&\n    static const double value = $1;/" sources/changed.cpp
    no_call_of_libm "$PWD/sources"
}
number=0
for call in 'std::sin(0.1)' '__builtin_tan(0.1)' 'pow(2, 0.5f)' '::cbrt(2)' 'std::expf(x)'; do
    refused "calls_libm_$((++number))" 'changed.cpp: .*value = ' calls_of_libm "$call"
done

# The version in each place: in the sources, and in what is installed.
tree() {
    local file
    for file in include/gamephys_c.h bindings/{gamephys_api.json,rust/Cargo.toml,rust/Cargo.lock,javascript/package.json,go/README.md} CHANGELOG.md packaging/vcpkg/vcpkg.json; do
        mkdir -p "tree/$(dirname "$file")"
        cp "$SOURCE/$file" "tree/$file"
    done
    for file in include/gamephys_c.h share/gamephys/gamephys_api.json "$LIBDIR"/{cmake/gamephys/gamephysConfigVersion.cmake,pkgconfig/gamephys.pc}; do
        mkdir -p "installed/$(dirname "$file")"
        cp "$INSTALLED/$file" "installed/$file"
    done
    cp "$WORK/good.so" "installed/$LIBDIR/libgamephys.so.$version"
    ln -s "libgamephys.so.$version" "installed/$LIBDIR/libgamephys.so"
}
version=$(sed -n 's/^#define GPHYS_VERSION_[A-Z]* //p' "$header" | paste -sd.)
versions() { python3 "$interface/versions.py" tree installed "$LIBDIR"; }
(mkdir trees && cd trees && tree && versions) || fail "the versions differ"
# versions_with FILE SED, and with a library that is another.
versions_with() {
    tree
    changed "$1" "$2" other
    mv other "$1"
    versions
}
versions_named() {
    tree
    (cd "installed/$LIBDIR" && mv "libgamephys.so.$version" libgamephys.so.1.0.9 && ln -sf libgamephys.so.1.0.9 libgamephys.so)
    versions
}
versions_at_run_time() {
    tree
    changed "$WORK/good.so.c" '/gphys_version(/s/return 1/return 3/' changed.c
    linked changed.c -Wl,--version-script="$map"
    cp changed.so "installed/$LIBDIR/libgamephys.so.$version"
    versions
}
other="s/${version//./\\.}/9.8.7/"
for file in bindings/{gamephys_api.json,rust/Cargo.toml,rust/Cargo.lock,javascript/package.json,go/README.md} CHANGELOG.md packaging/vcpkg/vcpkg.json; do
    refused "version_$(basename "$file")" "$file states version 9.8.7" versions_with "tree/$file" "$other"
done
for file in share/gamephys/gamephys_api.json "$LIBDIR"/{cmake/gamephys/gamephysConfigVersion.cmake,pkgconfig/gamephys.pc}; do
    refused "installed_$(basename "$file")" "$file states version 9.8.7" versions_with "installed/$file" "$other"
done
refused version_header 'states version .*, the header .*\.77' versions_with tree/include/gamephys_c.h 's/VERSION_PATCH .*/VERSION_PATCH 77/'
refused version_installed 'include/gamephys_c.h states' versions_with installed/include/gamephys_c.h 's/VERSION_MINOR .*/VERSION_MINOR 77/'
refused version_soname 'libgamephys.so.1.0.9 states version 1.0.9' versions_named
refused version_run_time 'gphys_version\(\) states version 3' versions_at_run_time

# What is generated from the header, and its comments in other languages.
symbols_with() {
    changed "$SOURCE/cmake/gamephys.symbols" "$1" symbols
    symbols_current symbols
}
refused symbol_missing 'gamephys.symbols is not' symbols_with '/ gphys_solver_join@/d'
refused symbol_too_early 'gamephys.symbols is not' symbols_with '/ gphys_solver_join@/s/1\.1\.0$/1.0.0/'
refused symbol_of_desc 'gamephys.symbols is not' symbols_with '/ gphys_solver_create@/s/1\.1\.0$/1.0.0/'
(mkdir generated && cd generated && bindings_current ../present.json "$SOURCE/bindings") || fail "the bindings are not up to date"
# stale FILE SED: a binding's file was changed by hand, or not written again.
stale() {
    cp -r "$WORK/generated/made" bindings
    changed "bindings/$1" "$2" other
    mv other "bindings/$1"
    bindings_current "$WORK/present.json" bindings
}
refused stale_python 'bindings/.*_low.py is not that of the header' stale python/gamephys/_low.py 's/SHAPE_CAPSULE = 2/SHAPE_CAPSULE = 9/'
refused stale_rust 'bindings/.*sys.rs is not that of the header' stale rust/src/sys.rs '/gphys_scene_clear/d'
refused stale_java 'bindings/.*Scene.java is not that of the header' stale java/src/main/java/gamephys/Scene.java 's/Remove all models/Remove all/'
(mkdir comments && cd comments && comments_in_own_terms ../generated/made) || fail "the comments are not in their own terms"
spoken() {
    cp -r "$WORK/generated/made" bindings
    changed "bindings/$1" "$2" other
    mv other "bindings/$1"
    comments_in_own_terms bindings
}
refused speaks_of_null '_objects.py speaks C' spoken python/gamephys/_objects.py 's/None: the defaults/NULL: the defaults/'
refused speaks_of_stride 'objects.go speaks C' spoken go/objects.go 's/^\/\/ Remove all models/\/\/ A stride of 0: remove all models/'
refused speaks_of_status 'Objects.cs speaks C' spoken csharp/src/Objects.cs 's/Status\.ErrorCycle:/GPHYS_ERROR_CYCLE:/'
refused loses_errors 'methods.rb does not say: @raise' spoken ruby/lib/gamephys/methods.rb '/@raise \[Error\] if parent is/d'

# What a minor release may do is not refused: it has to be recorded, and to be in a node of its own.
mkdir grown
(
    cd grown
    sed '/^} gphys_model_desc;/i float extra;' "$header" | sed "$new_function;s/VERSION_MINOR [0-9]*/VERSION_MINOR 99/" >gamephys_c.h
    python3 "$interface/describe.py" gamephys_c.h --quick >api.json
    python3 "$interface/compare.py" --compatible ../present.json api.json || fail "a release cannot grow"
    if python3 "$interface/compare.py" ../present.json api.json; then fail "growth is not seen as a change"; fi
    { cat "$map" && printf 'GAMEPHYS_1.99 {\nglobal:\n    gphys_extra;\n} GAMEPHYS_1.1;\n'; } >gamephys.map
    stub api.json gamephys_c.h grown.so gamephys.map
) || fail "growth is refused"

# abi NAME SED...: the binary of a changed header, as libabigail sees it.
abi() {
    changed "$header" "$1" gamephys_c.h
    python3 "$interface/describe.py" gamephys_c.h --quick >api.json
    stub api.json gamephys_c.h changed.so
    binary_compatible "$WORK/good.so" changed.so
}
abi_named() {
    "$CC" -g -w -shared -fPIC -Wl,-soname,libgamephys.so.2 -Wl,--version-script="$map" "$WORK/good.so.c" -o changed.so
    binary_compatible "$WORK/good.so" changed.so
}
if command -v abidiff >/dev/null; then
    (mkdir same && cd same && binary_compatible ../good.so ../good.so && binary_compatible ../good.so ../grown/grown.so) >abidiff.txt ||
        fail "abidiff refuses growth: $(cat abidiff.txt)"
    refused abi_append 'gphys_nearest' abi '/^} gphys_nearest;/i float extra;'
    refused abi_reorder 'gphys_sphere' abi '/^typedef struct gphys_sphere {/,/^}/{/center;/d;/radius;/a gphys_vec3 center;
}'
    refused abi_dropped 'gphys_scene_clear' abi '/gphys_scene_clear(/d'
    refused abi_parameter 'gphys_scene_has' abi '/gphys_scene_has(/s/model)/model, int32_t deep)/'
    refused abi_return_type 'gphys_version' abi '/gphys_version(void)/s/uint32_t/uint64_t/'
    refused abi_soname 'SONAME' abi_named
fi

wait
cat failed/* >failures.txt
[ ! -s failures.txt ] || fail "$(cat failures.txt)"
[ $tried -ge $((100 / every)) ] || fail "only $tried changes were tried"
echo "$tried of $count changes refused"
