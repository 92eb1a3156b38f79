#!/usr/bin/env bash
# What is generated from the header is up to date, and is what gets installed.
source "$SOURCE/tests_package/common.sh"

advice="run cmake/interface/record.sh"
python3 "$SOURCE/cmake/interface/describe.py" "$SOURCE/include/gamephys_c.h" >gamephys_api.json
python3 "$SOURCE/cmake/interface/compare.py" "$SOURCE/bindings/gamephys_api.json" gamephys_api.json ||
    fail "bindings/gamephys_api.json is not that of the header: $advice"
cmp gamephys_api.json "$INSTALLED/share/gamephys/gamephys_api.json"

python3 "$SOURCE/cmake/interface/releases.py" symbols "$SOURCE/include/gamephys_c.h" "$SOURCE/cmake/interface" >gamephys.symbols
cmp gamephys.symbols "$SOURCE/cmake/gamephys.symbols" || fail "cmake/gamephys.symbols is not that of the header: $advice"

mkdir bindings
python3 "$SOURCE/bindings/generate.py" gamephys_api.json bindings
(cd bindings && find . -type f) >generated.txt
[ -s generated.txt ] || fail "nothing was generated"
while read -r file; do
    cmp "bindings/$file" "$SOURCE/bindings/$file" || fail "bindings/$file is not that of the header: $advice"
done <generated.txt
