#!/usr/bin/env bash
# The README's program runs in a module of its own: readme.sh GO
set -euo pipefail
package=$PWD
work=$BINARY_DIR/go-readme
rm -rf "$work"
mkdir -p "$work"
sed -n '/^```go$/,/^```$/p' README.md | sed '/^```/d' >"$work/main.go"
{
    printf 'module app\n\ngo 1.18\n\n'
    sed -n '/^require/p' README.md
    sed -n "s|^\(replace gamephys =>\).*|\1 $package|p" README.md
} >"$work/go.mod"
cd "$work"
"$1" run . | tee output.txt
[ "$(cat output.txt)" = $'true true 4\n4 <nil>' ]
