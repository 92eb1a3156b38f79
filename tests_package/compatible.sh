#!/usr/bin/env bash
# Programs made for the last release run with this library: the header took nothing away, the
# binary interface neither, and a client compiled with the released header finds every field.
source "$SOURCE/tests_package/common.sh"
interface=$SOURCE/cmake/interface
released=$(echo "$interface"/released_*.h)

mkdir released
cp "$released" released/gamephys_c.h
python3 "$interface/describe.py" released/gamephys_c.h >released.json
python3 "$interface/describe.py" "$SOURCE/include/gamephys_c.h" >present.json
python3 "$interface/compare.py" --compatible released.json present.json || fail "the header breaks clients of $released"

for client in client old_client; do
    "$CC" -std=c99 -Ireleased "$here/$client.c" "$INSTALLED/$LIBDIR/libgamephys.so.1" -o $client
    LD_LIBRARY_PATH=$INSTALLED/$LIBDIR ./$client
done

# libabigail compares the binaries where it is installed. A released library without code stands
# for the old one; only the C interface of the new one is compiled, with debugging information.
command -v abidiff >/dev/null || exit 0
source "$here/binaries.sh"
stub released.json released/gamephys_c.h released.so
for file in "$SOURCE"/src/c_api/*.cpp; do
    echo "$file"
done | xargs -P 2 -I{} sh -c '"$CXX" -std=c++17 -g -fPIC -fvisibility=hidden -DGAMEPHYS_BUILD \
    -I"$SOURCE/include" -I"$SOURCE/src" -c "$1" -o "$(basename "$1").o"' - {}
"$CXX" -shared -Wl,-soname,libgamephys.so.1 -Wl,--version-script="$SOURCE/cmake/gamephys.map" *.cpp.o -o present.so
binary_compatible released.so present.so || fail "the binary interface breaks clients of $released"
