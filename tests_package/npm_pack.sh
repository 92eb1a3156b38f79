#!/usr/bin/env bash
# The npm package is packed with its WebAssembly and its licence, or not at all. A stand-in for CMake
# builds a module, or does not.
source "$SOURCE/tests_package/common.sh"
export npm_config_cache=$WORK/cache npm_config_update_notifier=false

mkdir -p root/bindings bin
cp "$SOURCE/LICENSE" root
(cd "$SOURCE/bindings" && tar -c --exclude=node_modules --exclude='*.wasm' javascript) | tar -x -C root/bindings
printf '#!/bin/sh\n' >bin/ninja
chmod +x bin/ninja

# pack: into packed.json, with the CMake of bin
pack() {
    (cd root/bindings/javascript && PATH="$WORK/bin:$PATH" npm pack --json --pack-destination "$WORK") >packed.json 2>packed.log
}
printf '#!/bin/sh\necho Emscripten is not there >&2\nexit 1\n' >bin/cmake
chmod +x bin/cmake
if pack; then fail "packed without WebAssembly: $(cat packed.json)"; fi
grep -q 'Emscripten is not there' packed.log packed.json || fail "the reason is not said: $(cat packed.log)"
if ls ./*.tgz 2>/dev/null; then fail "a package was written"; fi

printf '#!/bin/sh\ntouch bindings/javascript/gamephys.wasm\n' >bin/cmake
pack || fail "$(cat packed.log)"
tar -tf gamephys-*.tgz >files.txt
for file in gamephys.wasm wasm.js native.js node.js init.js init.d.ts index.d.ts LICENSE package.json; do
    grep -qx "package/$file" files.txt || fail "$file is not in the package: $(cat files.txt)"
done
[ ! -e root/bindings/javascript/LICENSE ] || fail "the licence was left behind"
