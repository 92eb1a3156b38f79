#!/usr/bin/env bash
# Runs the program of the README in this folder: readme.sh BLOCK FILE COMMAND...
# The first ```BLOCK is written to FILE in a folder of its own, where COMMAND runs.
set -euo pipefail
work=$BINARY_DIR/readme-$1
mkdir -p "$work"
awk -v start="\`\`\`$1" '/^```/ && inside { exit } inside; $0 == start { inside = 1 }' README.md >"$work/$2"
[ -s "$work/$2" ] || exit 1
cd "$work"
"${@:3}"
