#!/usr/bin/env bash
# What is generated from the header is up to date, and is what gets installed.
source "$SOURCE/tests_package/common.sh"
source "$here/generated.sh"

python3 "$SOURCE/cmake/interface/describe.py" "$SOURCE/include/gamephys_c.h" >gamephys_api.json
python3 "$SOURCE/cmake/interface/compare.py" "$SOURCE/bindings/gamephys_api.json" gamephys_api.json ||
    fail "bindings/gamephys_api.json is not that of the header: $advice"
cmp gamephys_api.json "$INSTALLED/share/gamephys/gamephys_api.json"
bindings_current gamephys_api.json "$SOURCE/bindings"
symbols_current "$SOURCE/cmake/gamephys.symbols"
