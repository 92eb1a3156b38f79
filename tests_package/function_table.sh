#!/usr/bin/env bash
# Every function has a fuzz target, tests, bindings and, where it matters, a benchmark; docs/functions.md says which.
source "$SOURCE/tests_package/common.sh"

table=$SOURCE/tests_package/function_table.py
python3 "$table" "$SOURCE" >functions.md || fail "a function is not covered"
cmp functions.md "$SOURCE/docs/functions.md" || fail "docs/functions.md is not up to date: run $table . --write"

# A function that nothing covers is noticed.
mkdir -p copy/include
for folder in bench fuzz tests_c tests_cpp docs bindings tests_package; do ln -s "$SOURCE/$folder" copy/$folder; done
sed 's/^GPHYS_API uint32_t gphys_version(void);/&\nGPHYS_API uint32_t gphys_extra(void);/' \
    "$SOURCE/include/gamephys_c.h" >copy/include/gamephys_c.h
if python3 "$table" copy 2>holes.txt; then fail "an uncovered function is not noticed"; fi
grep -q 'gphys_extra: no fuzz target' holes.txt || fail "another reason: $(cat holes.txt)"
grep -q 'gphys_extra: no C test' holes.txt || fail "another reason: $(cat holes.txt)"
grep -q 'gphys_extra: not bound in Rust' holes.txt || fail "another reason: $(cat holes.txt)"
