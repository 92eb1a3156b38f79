#!/usr/bin/env bash
# Packages refuse a library that is too old for what was built with this one: dpkg by the symbols that a
# program uses, pkg-config by Requires, CMake by find_package.
source "$SOURCE/tests_package/common.sh"
minor=$(sed -n 's/^#define GPHYS_VERSION_\(MAJOR\|MINOR\) //p' "$SOURCE/include/gamephys_c.h" | paste -sd.)

# needs PROGRAM: what dpkg makes of a program that is linked with the library.
mkdir -p package/DEBIAN "package/usr/$LIBDIR" debian
cp -a "$INSTALLED/$LIBDIR"/libgamephys.so.* "package/usr/$LIBDIR"
cp "$SOURCE/cmake/gamephys.symbols" package/DEBIAN/symbols
printf 'Package: libgamephys1\nVersion: 99\nArchitecture: any\n' >package/DEBIAN/control
printf 'Source: program\n\nPackage: program\nArchitecture: any\n' >debian/control
needs() {
    dpkg-shlibdeps -O --ignore-missing-info -Spackage "-lpackage/usr/$LIBDIR" "-e$1" 2>shlibdeps.txt ||
        fail "dpkg-shlibdeps: $(cat shlibdeps.txt)"
}
program() {
    echo "#include <gamephys_c.h>
          int main(void) { $2; return 0; }" >"$1.c"
    "$CC" -w -I"$INSTALLED/include" "$1.c" "$INSTALLED/$LIBDIR/libgamephys.so.1" -o "$1"
}
if command -v dpkg-shlibdeps >/dev/null; then
    program old 'gphys_mesh_destroy(0)'
    program new_function 'gphys_scene_get_origin(0, 0)'
    program new_desc 'gphys_solver_desc_init(0, 0)'
    needs old | grep -q 'libgamephys1 (>= 1\.0\.0)' || fail "a program of release 1.0 needs $(needs old)"
    for name in new_function new_desc; do
        needs $name | grep -q 'libgamephys1 (>= 1\.1\.0)' || fail "$name needs $(needs $name)"
    done
fi

# An installation of release 1.0, as far as packages see it.
cp -a "$INSTALLED" older
sed -i 's/^Version: .*/Version: 1.0.0/' "older/$LIBDIR/pkgconfig/gamephys.pc"
sed -i "s/^set(PACKAGE_VERSION .*/set(PACKAGE_VERSION \"1.0.0\")/" "older/$LIBDIR/cmake/gamephys/gamephysConfigVersion.cmake"

printf 'Name: engine\nDescription: uses gamephys\nVersion: 1\nRequires: gamephys >= %s\n' "$minor" >engine.pc
# known FOLDER: whether a package that requires this release finds it.
known() { PKG_CONFIG_PATH=$WORK:$1/$LIBDIR/pkgconfig pkg-config --print-errors --exists engine; }
known "$INSTALLED" || fail "Requires refuses this release"
if known "$WORK/older" 2>pkg-config.txt; then fail "Requires takes an older release"; fi
grep -q '1\.0\.0' pkg-config.txt || fail "another reason: $(cat pkg-config.txt)"

configure() {
    "$CMAKE" -S "$here/consumer" -B "build-$1" -DHOW=find_package -DTARGET=gamephys::gamephys -DWANTED="$minor" \
        -DCMAKE_PREFIX_PATH="$2" >"$1.log" 2>&1
}
configure present "$INSTALLED" || fail "find_package refuses this release: $(cat present.log)"
if configure old "$WORK/older"; then fail "find_package takes an older release"; fi
grep -q 'version: 1.0.0' old.log || fail "another reason than the version: $(cat old.log)"

# Packages that load the library themselves say so at once, not at the first function that is missing.
source "$here/binaries.sh"
cp "$SOURCE/cmake/interface/released_1.0.h" gamephys_c.h
python3 "$SOURCE/cmake/interface/describe.py" gamephys_c.h --quick >released.json
map_until GAMEPHYS_1.0 >released.map
stub released.json gamephys_c.h stub.so released.map
# says_so COMMAND...: it fails with the two versions.
says_so() {
    if GAMEPHYS_LIBRARY=$WORK/stub.so "$@" >older.txt 2>&1; then fail "taken: $*"; fi
    grep -q "the library is gamephys 1\.0, this package needs $minor" older.txt || fail "another reason: $(cat older.txt)"
}
if command -v luajit >/dev/null; then
    LUA_PATH="$SOURCE/bindings/lua/?.lua" says_so luajit -e "require 'gamephys'"
fi
for python in /usr/bin/python3 python3; do
    if $python -c 'import numpy' 2>/dev/null; then
        PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$SOURCE/bindings/python says_so $python -c 'import gamephys'
        break
    fi
done
