#!/usr/bin/env bash
# Every file of src that computes includes foundation/floating_point.h, which refuses -ffast-math, its
# parts, and the x87, which rounds twice, and says why.
source "$SOURCE/tests_package/common.sh"

cat >without.py <<'END'
import re
import sys
from pathlib import Path

root = Path(sys.argv[1])
def included(path, seen):
    for name in re.findall(r'^#include "(.*)"$', path.read_text(), re.M):
        if name not in seen and (root / name).exists():
            seen.add(name)
            included(root / name, seen)
    return seen

computing = [path for path in root.rglob("*.cpp") if re.search(r"\b(double|float|Vec3|Double8)\b", path.read_text())]
assert len(computing) > 50, "the files were not found"
for path in computing:
    if "foundation/floating_point.h" not in included(path, set()):
        print(path)
END
python3 without.py "$SOURCE/src" >without.txt || fail "the files could not be read"
[ ! -s without.txt ] || fail "these do not include foundation/floating_point.h: $(cat without.txt)"

# refused FLAGS REASON: for exact.cpp
refused() {
    if "$CXX" -std=c++17 $1 -I"$SOURCE/src" -I"$SOURCE/include" -M "$SOURCE/src/foundation/exact.cpp" >/dev/null 2>refused.txt; then
        fail "compiled with $1"
    fi
    grep -q "$2" refused.txt || fail "$1 is refused for another reason: $(cat refused.txt)"
}
for flags in -ffast-math -Ofast -ffinite-math-only; do refused $flags 'must not be compiled with -ffast-math'; done
"$CXX" --version >version.txt
if ! grep -qi clang version.txt; then # clang has no macros for these
    for flags in -freciprocal-math -fno-signed-zeros '-fassociative-math -fno-signed-zeros -fno-trapping-math'; do
        refused "$flags" 'must not be compiled with -ffast-math'
    done
fi

# The header alone: the C++ library for another processor need not be here.
if [ "$(uname -m)" = x86_64 ]; then
    if "$CXX" -m32 -march=i686 -mfpmath=387 -E -x c++ "$SOURCE/src/foundation/floating_point.h" >/dev/null 2>x87.txt; then
        fail "the x87 is taken"
    fi
    grep -q 'rounds once' x87.txt || fail "the x87 is refused for another reason: $(cat x87.txt)"
fi
