#!/usr/bin/env bash
# The Debian packages, in which lintian finds nothing, installed into an empty root and used from there; the manual
# page is rendered without a warning.
source "$(dirname "$0")/common.sh"

build=$SOURCE/build/deb
cmake -S "$SOURCE" -B "$build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr -DGAMEPHYS_TESTS=OFF -DGAMEPHYS_EXAMPLES=OFF \
    -DGAMEPHYS_BENCH=OFF >/dev/null
cmake --build "$build" --parallel "$(nproc)" | tail -n 1
(cd "$build" && cpack -G DEB -B "$WORK/made" >cpack.txt) || fail "$(<"$build/cpack.txt")"
rm -f "$PACKAGES"/*.deb
cp made/*.deb "$PACKAGES"
lintian --allow-root --fail-on error,warning "$PACKAGES"/libgamephys*.deb

for package in "$PACKAGES"/libgamephys*.deb; do dpkg-deb --extract "$package" root; done
multiarch=$(cc -print-multiarch)
dpkg-deb --ctrl-tarfile "$PACKAGES"/libgamephys1_*.deb | tar -tf - | grep -qx ./symbols || fail "there is no symbols file"
zcat root/usr/share/man/man3/gamephys.3.gz >gamephys.3
LC_ALL=C.UTF-8 MANROFFSEQ= MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z gamephys.3 2>warnings.txt >/dev/null
[ ! -s warnings.txt ] || fail "$(<warnings.txt)"
cp "$SOURCE/examples/"{03_pick.c,check.h} .
cc -std=c99 03_pick.c -Iroot/usr/include -L"root/usr/lib/$multiarch" -lgamephys -lm -o pick
empty LD_LIBRARY_PATH="$WORK/root/usr/lib/$multiarch" ./pick
