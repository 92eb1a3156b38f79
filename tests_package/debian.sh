#!/usr/bin/env bash
# CPack's Debian packages, unpacked into an empty root and used from there.
source "$SOURCE/tests_package/common.sh"

(cd "$BUILD" && cpack -G DEB -C "$CONFIG" -B "$WORK/packages") >/dev/null
runtime=$(echo packages/libgamephys1_*.deb) development=$(echo packages/libgamephys-dev_*.deb)
dpkg-deb --field "$runtime" Depends | grep -q 'libc6.*libstdc++6' || fail "the runtime package does not state what it needs"
dpkg-deb --contents "$runtime" >runtime.txt
expect_no_match "development files in the runtime package" -E '\.h$|\.a$|\.so( |$)' runtime.txt

root=$WORK/root
for package in "$runtime" "$development"; do dpkg-deb --extract "$package" "$root"; done
export PKG_CONFIG_PATH=$root/usr/$LIBDIR/pkgconfig
"$CC" "$here/client.c" $(pkg-config --cflags --libs gamephys) -o client
LD_LIBRARY_PATH=$root/usr/$LIBDIR ./client
