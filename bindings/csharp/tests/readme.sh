#!/usr/bin/env bash
# The README's commands make its program from the sources alone: readme.sh MONO
set -euo pipefail
readme=$PWD/README.md
tree=$(cd ../.. && pwd)
work=$BINARY_DIR/csharp-readme
rm -rf "$work"
mkdir -p "$work"
cd "$work"
ln -s "$tree" gamephys
sed -n '/^```csharp$/,/^```$/p' "$readme" | sed '/^```/d' >program.cs
sed -n 's/^\$ //p' "$readme" | sed "s|&& mono |\&\& $1 |" >commands.sh
bash -e commands.sh | tee output.txt
grep -qx True output.txt
