#!/usr/bin/env bash
# The overlay port, as an archive with the sources. vcpkg itself downloads what it builds with; where it is not
# installed the port's steps are run by CMake with stand-ins for vcpkg's functions, and a client is built on the result.
source "$(dirname "$0")/common.sh"

cp -r "$SOURCE/packaging/vcpkg" port
python3 - port/vcpkg.json "$version" <<'END'
import json, sys
port = json.load(open(sys.argv[1]))
assert port["name"] == "gamephys" and port["version"] == sys.argv[2], port
END
(cd "$SOURCE" && git archive --format=tar.gz --prefix="gamephys-$version/" HEAD) >"$PACKAGES/gamephys-$version.tar.gz"
tar -czf "$PACKAGES/gamephys-$version-vcpkg.tar.gz" port

tar -xf "$PACKAGES/gamephys-$version.tar.gz"
if command -v vcpkg >/dev/null; then
    GAMEPHYS_SOURCE=$WORK/gamephys-$version vcpkg install gamephys --overlay-ports="$WORK/port" --x-install-root="$WORK/installed"
    root=$(echo "$WORK"/installed/*-*)
else
    cmake -DSOURCE_PATH="$WORK/gamephys-$version" -DPORT="$WORK/port" -DWORK="$WORK" -P "$SOURCE/packaging/vcpkg_stand_in.cmake" >log.txt ||
        fail "$(<log.txt)"
    root=$WORK/installed
    in_part "vcpkg is not installed: the port's steps ran with stand-ins for its functions"
fi
[ -f "$root/share/gamephys/copyright" ] || fail "the licence is not installed"
[ -f "$root/share/gamephys/gamephysConfig.cmake" ] || fail "the CMake package is not where vcpkg looks"
[ ! -e "$root/debug/include" ] || fail "headers are there twice"
empty cmake -S "$SOURCE/tests_package/consumer" -B consumer -DHOW=find_package -DTARGET=gamephys::gamephys -DWANTED=1.0 \
    -DCMAKE_PREFIX_PATH="$root" >/dev/null
cmake --build consumer --target client >/dev/null
consumer/client
