#!/usr/bin/env bash
# Programs made for a release run with this library: the header took nothing away, the binary
# interface neither, and clients that were compiled and linked for the release find every field.
# Programs made for this release, which call what it added, are not started with an older library.
# compatible.sh [all]: with "all" libabigail looks at the compiled interface itself; otherwise at a library without code
# that has the header's functions, which are those of the sources, as their declarations are the header's.
source "$SOURCE/tests_package/common.sh"
source "$here/binaries.sh"
interface=$SOURCE/cmake/interface
present=$SOURCE/include/gamephys_c.h
python3 "$interface/describe.py" "$present" >present.json
python3 "$interface/releases.py" nodes "$present" "$interface" >nodes.txt

shopt -s nullglob
for header in "$interface"/released_*.h; do
    release=$(basename "$header" .h) version=${header##*released_}
    node=GAMEPHYS_${version%.h}
    mkdir -p "$release/lib"
    cp "$header" "$release/gamephys_c.h"
    python3 "$interface/describe.py" "$release/gamephys_c.h" >"$release.json"
    python3 "$interface/compare.py" --compatible "$release.json" present.json || fail "the header breaks clients of $release"

    # A released library without code stands for the old one, which clients were linked with.
    old=$release/lib/libgamephys.so.1
    map_until "$node" >"$release.map"
    stub "$release.json" "$release/gamephys_c.h" "$old" "$release.map"
    for client in client old_client; do
        "$CC" -std=c99 -I"$release" "$here/$client.c" "$old" -o "$release/$client"
        readelf -V "$release/$client" | grep -q "Name: $node" || fail "$client does not ask for $node"
        LD_LIBRARY_PATH=$INSTALLED/$LIBDIR "$release/$client" || fail "$client of $release does not run"
    done

    # A function that this release added: the dynamic linker says which version it misses.
    sed -n 's/^ *\(gphys_[a-z0-9_]*\);$/\1/p' "$release.map" >known.txt
    added=$(cut -d' ' -f1 nodes.txt | grep -vxFf known.txt | head -1 || true)
    if [ -n "$added" ]; then
        needed_node=$(awk -v name="$added" '$1 == name { print $2 }' nodes.txt)
        echo "#include <gamephys_c.h>
              #include <stdio.h>
              void* volatile called = (void*)&$added;
              int main(void) { return puts(\"started\") < 0; }" >"$release/new_client.c"
        "$CC" -w -I"$INSTALLED/include" "$release/new_client.c" "$INSTALLED/$LIBDIR/libgamephys.so.1" -o "$release/new_client"
        LD_LIBRARY_PATH=$INSTALLED/$LIBDIR "$release/new_client" >started.txt
        grep -qx started started.txt || fail "a new client does not start with this library"
        if LD_LIBRARY_PATH=$release/lib "$release/new_client" >refusal.txt 2>&1; then fail "a new client starts with $release"; fi
        grep -q "version .$needed_node. not found (required by" refusal.txt || fail "refused without a clear message: $(cat refusal.txt)"
        expect_no_match "a new client started before it was refused" -x started refusal.txt
    fi

    # libabigail compares the binaries where it is installed; of the new one only the C interface is
    # compiled, with debugging information.
    command -v abidiff >/dev/null || continue
    if [ ! -f present.so ] && [ "${1:-}" != all ]; then
        cp "$present" gamephys_c.h
        stub present.json gamephys_c.h present.so
    elif [ ! -f present.so ]; then
        for file in "$SOURCE"/src/c_api/*.cpp; do
            echo "$file"
        done | xargs -P 2 -I{} sh -c '"$CXX" -std=c++17 -g -fPIC -fvisibility=hidden -DGAMEPHYS_BUILD \
            -I"$SOURCE/include" -I"$SOURCE/src" -c "$1" -o "$(basename "$1").o"' - {}
        "$CXX" -shared -Wl,-soname,libgamephys.so.1 -Wl,--version-script="$SOURCE/cmake/gamephys.map" *.cpp.o -o present.so
    fi
    binary_compatible "$old" present.so || fail "the binary interface breaks clients of $release"
done
# Only a first release of a major version has none to be compatible with.
[ -n "${release:-}" ] || grep -q '^ "version": "[0-9]*\.0\.0"' present.json || fail "no released header"
