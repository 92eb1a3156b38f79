#!/usr/bin/env bash
# The README's "Install", then "First program", as written: root's lines install into the system, which is
# this one under a layer of its own that is gone afterwards. readme_install.sh [build] builds the library
# anew; otherwise what the tests have built takes the place of the line that builds it.
# The status 77 says that such a layer cannot be had here.
source "$SOURCE/tests_package/common.sh"
LAYER=$WORK/layer

# block HEADING N LANGUAGE: the commands of the Nth block in this language below the heading.
block() {
    awk -v heading="## $1" -v wanted="$2" -v fence="\`\`\`$3" '
        /^## / { below = $0 == heading }
        /^```/ { inside = below && $0 == fence && ++count == wanted; next }
        inside { sub(/^[$#] /, ""); print }
    ' "$SOURCE/README.md"
}
block Install 1 console >from_source.sh
block Install 2 console >packages.sh
block "First program" 1 sh >client.sh
block "First program" 1 c >client.c
block "First program" 1 cmake >CMakeLists.txt
grep -n 'cmake --build build/install' from_source.sh | cut -d: -f1 >line.txt
[ "$(wc -l <line.txt)" = 1 ] || fail "the README builds in another way: $(cat from_source.sh)"
for file in packages.sh client.sh client.c CMakeLists.txt; do
    [ -s $file ] || fail "the README has no $file where it should"
done

# Overlays in memory, seen by nobody else.
cat >layers.sh <<'END'
mkdir -p "$LAYER"
mount -t tmpfs tmpfs "$LAYER"
for directory in usr etc var; do
    mkdir "$LAYER/$directory" "$LAYER/$directory.work"
    mount -t overlay overlay -o "lowerdir=/$directory,upperdir=$LAYER/$directory,workdir=$LAYER/$directory.work" "/$directory"
done
END
export LAYER
in_layer() { unshare --mount env -i LAYER="$LAYER" HOME="$WORK" PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "$@"; }
if [ "$(id -u)" != 0 ] || ! in_layer sh -e layers.sh 2>layers.txt; then
    echo "no layer over the system: $(cat layers.txt)"
    exit 77
fi

mkdir clone
tar -C "$SOURCE" -c --exclude=./build --exclude='./build-*' --exclude=./.git --exclude=node_modules . | tar -x -C clone
built=()
if [ "${1:-}" != build ]; then
    built=(CMAKE_GENERATOR=Ninja) # whose packages are made without building
    sed "$(cat line.txt)s|.*|cp -P \"$BUILD\"/libgamephys.a \"$BUILD\"/libgamephys.so* build/install|" from_source.sh >quick.sh
    mv quick.sh from_source.sh
fi
sed "$(cat line.txt)q" from_source.sh >without_install.sh

# says_hit NAME SCRIPT...: run in the clone in a layer, they make the first program work in both ways.
says_hit() {
    local name=$1
    shift
    {
        cat layers.sh
        echo "cd '$WORK/clone'"
        cat "$@"
        echo "mkdir '$WORK/$name' && cd '$WORK/$name' && cp ../client.c ../CMakeLists.txt ."
        cat client.sh
        echo "cmake -S . -B build && cmake --build build && build/client"
    } >"$name.sh"
    in_layer "${built[@]}" bash -e "$name.sh" >"$name.txt" 2>&1 || fail "$name: $(cat "$name.txt")"
    [ "$(grep -cx 'hit at 4' "$name.txt")" = 2 ] || fail "$name: $(cat "$name.txt")"
}
says_hit installed from_source.sh
says_hit packaged without_install.sh packages.sh
