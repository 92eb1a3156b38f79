#!/usr/bin/env bash
# Installs below DESTDIR and moves the tree: nothing in it may remember where it was.
source "$SOURCE/tests_package/common.sh"

DESTDIR=$WORK/destdir "$CMAKE" --install "$BUILD" --config "$CONFIG" --prefix /opt/gamephys >/dev/null
mv destdir/opt/gamephys moved
expect_no_match "files that name a directory of the build" -rlE "$SOURCE|$BUILD|/opt/gamephys" moved
for file in "$LIBDIR"/libgamephys.{a,so,so.1} "$LIBDIR/pkgconfig/gamephys.pc"; do
    [ -e "moved/$file" ] || fail "$file is not installed"
done
[ "$(cd moved/include && echo *)" = "gamephys.hpp gamephys_c.h gamephys_support.hpp" ] ||
    fail "other headers than those for C and C++ are installed: $(ls moved/include)"
cmp "$SOURCE/LICENSE" moved/share/licenses/gamephys/LICENSE || fail "the licence is not installed"
