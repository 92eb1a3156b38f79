#!/usr/bin/env bash
# Installs below DESTDIR and moves the tree: nothing in it may remember where it was.
source "$SOURCE/tests_package/common.sh"

DESTDIR=$WORK/destdir "$CMAKE" --install "$BUILD" --config "$CONFIG" --prefix /opt/gamephys >/dev/null
mv destdir/opt/gamephys moved
expect_no_match "files that name a directory of the build" -rlE "$SOURCE|$BUILD|/opt/gamephys" moved
for file in include/gamephys_c.h "$LIBDIR"/libgamephys.{a,so,so.1} "$LIBDIR/pkgconfig/gamephys.pc"; do
    [ -e "moved/$file" ] || fail "$file is not installed"
done
[ "$(find moved/include -type f | wc -l)" = 1 ] || fail "more than one header is installed"
