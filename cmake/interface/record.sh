#!/usr/bin/env bash
# After any change of include/gamephys_c.h: writes again what is made from it, which is
# bindings/gamephys_api.json and the low level of every binding. The tests tell when it is due.
#   record.sh --release   at a release: the header also becomes the one that later headers must be
#                         compatible with
set -euo pipefail
cd "$(dirname "$0")/../.."

python3 cmake/interface/describe.py include/gamephys_c.h >bindings/gamephys_api.json.new
mv bindings/gamephys_api.json.new bindings/gamephys_api.json
python3 bindings/generate.py bindings/gamephys_api.json bindings
if [ "${1:-}" = --release ]; then
    rm -f cmake/interface/released_*.h
    version=$(sed -n 's/^#define GPHYS_VERSION_\(MAJOR\|MINOR\) //p' include/gamephys_c.h | paste -sd.)
    cp include/gamephys_c.h "cmake/interface/released_$version.h"
fi
