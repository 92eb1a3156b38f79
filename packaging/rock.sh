#!/usr/bin/env bash
# The rock of this platform with the library inside, and its rockspec.
source "$(dirname "$0")/common.sh"
native_library

rockspec=gamephys-$version-1.rockspec
cp -r "$SOURCE/bindings/lua" stage
cp "$SOURCE/LICENSE" stage
cp "$native/lib/libgamephys.so.1" stage/native.so
sed -e "s/^version = .*/version = '$version-1'/" \
    -e "s/^    type = 'builtin',$/&\n    install = { lib = { ['gamephys.native'] = 'native.so' } },/" \
    stage/gamephys-scm-1.rockspec >"stage/$rockspec"
rm stage/gamephys-scm-1.rockspec
luarocks="luarocks --lua-version 5.1"
(cd stage && $luarocks make --tree "$WORK/made" --pack-binary-rock "$rockspec") || fail "luarocks does not make the rock"
rm -f "$PACKAGES"/gamephys-*.rock*
cp stage/gamephys-*.rock "stage/$rockspec" "$PACKAGES"

empty $luarocks install --tree "$WORK/tree" "$PACKAGES"/gamephys-*.rock
path="$WORK/tree/share/lua/5.1/?.lua" cpath="$WORK/tree/lib/lua/5.1/?.so"
mkdir client
cp -r "$SOURCE/bindings/lua/"{examples,tests} client
cd client
for program in examples/scene examples/step examples/pick tests/test; do
    empty LUA_PATH="$path" LUA_CPATH="$cpath" luajit $program.lua
done
