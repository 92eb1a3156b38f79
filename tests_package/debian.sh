#!/usr/bin/env bash
# CPack's Debian packages, unpacked into an empty root and used from there. Debian's own checks, where
# they are installed, find neither errors nor warnings in them.
source "$SOURCE/tests_package/common.sh"

(cd "$BUILD" && cpack -G DEB -C "$CONFIG" -B "$WORK/packages") >cpack.txt || fail "$(cat cpack.txt)"
runtime=$(echo packages/libgamephys1_*.deb) development=$(echo packages/libgamephys-dev_*.deb)
dpkg-deb --field "$runtime" Depends | grep -q 'libc6.*libstdc++6' || fail "the runtime package does not state what it needs"
for package in "$runtime" "$development"; do
    [ "$(dpkg-deb --field "$package" Multi-Arch)" = same ] || fail "$package cannot be installed for two architectures"
done
dpkg-deb --contents "$runtime" >runtime.txt
expect_no_match "development files in the runtime package" -E '\.h$|\.hpp$|\.a$|\.so( |$)' runtime.txt

dpkg-deb --ctrl-tarfile "$runtime" | tar -xO ./symbols | cmp - "$SOURCE/cmake/gamephys.symbols" || fail "the symbols file is another"
version=$(sed -n 's/^#define GPHYS_VERSION_[A-Z]* //p' "$SOURCE/include/gamephys_c.h" | paste -sd.)
for package in "$runtime" "$development"; do
    [[ $(dpkg-deb --field "$package" Version) =~ ^$version(-|$) ]] || fail "$package is not of version $version"
done

root=$WORK/root
for package in "$runtime" "$development"; do dpkg-deb --extract "$package" "$root"; done
libdir=$root/usr/lib/$("$CC" -print-multiarch)
[ -e "$libdir/libgamephys.so.1" ] || fail "the library is not where Debian keeps those of an architecture: $(find "$root" -name '*.so*')"
export PKG_CONFIG_PATH=$libdir/pkgconfig
"$CC" "$here/client.c" $(pkg-config --cflags --libs gamephys) -o client
LD_LIBRARY_PATH=$libdir ./client
"$CMAKE" -S "$here/consumer" -B consumer -DHOW=find_package -DTARGET=gamephys::static -DWANTED=1.0 -DCMAKE_C_COMPILER="$CC" \
    -DCMAKE_PREFIX_PATH="$root/usr" >consumer.txt || fail "$(cat consumer.txt)"
"$CMAKE" --build consumer --target client >consumer.txt || fail "$(cat consumer.txt)"
consumer/client

# A package that uses this one comes to depend on it.
mkdir debian
dpkg-deb --raw-extract "$runtime" debian/libgamephys1
printf 'Source: client\n\nPackage: client\nArchitecture: any\n' >debian/control
dpkg-shlibdeps -O -e client >needed.txt
grep -q 'libgamephys1 (>= 1\.' needed.txt || fail "a client does not depend on the library: $(cat needed.txt)"

command -v lintian >/dev/null || exit 0
lintian --allow-root --fail-on error,warning "$runtime" "$development" || fail "lintian objects"
