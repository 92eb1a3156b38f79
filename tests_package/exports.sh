#!/usr/bin/env bash
# The header's functions, the version script's list and the binary's exports are the same set.
source "$SOURCE/tests_package/common.sh"
library=$INSTALLED/$LIBDIR/libgamephys.so

"$here/functions.sh" | sort >header.txt
sed -n 's/^ *\(gphys_[a-z0-9_]*\);$/\1/p' "$SOURCE/cmake/gamephys.map" | sort >map.txt
# T: functions. Anything else, such as a weak or unique symbol of the C++ library, is a leak.
nm -D --defined-only --with-symbol-versions "$library" | grep -v ' A GAMEPHYS_' >nm.txt
sed -n 's/^[0-9a-f]* T \(gphys_[a-z0-9_]*\)@@GAMEPHYS_1\.0$/\1/p' nm.txt | sort >binary.txt
diff header.txt map.txt || fail "cmake/gamephys.map differs from the header"
diff header.txt binary.txt || fail "the exports differ from the header"
expect_no_match "exported without being in the list" -v ' T gphys_' nm.txt

# A shared object that takes the archive in must not pass the interface on.
"$CC" -shared -fPIC -I"$INSTALLED/include" "$here/client.c" "$INSTALLED/$LIBDIR/libgamephys.a" -lstdc++ -lm -o plugin.so
nm -D --defined-only plugin.so >plugin.txt
expect_no_match "re-exported by a plugin that holds the archive" gphys plugin.txt
