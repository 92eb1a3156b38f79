#!/usr/bin/env bash
# Runs the program of a language in the README of the whole project: main_readme.sh LANGUAGE COMMAND...
# It is the first block of this language, put where COMMAND finds it, and prints the answer that the README tells.
set -euo pipefail
language=$1
here=$(cd "$(dirname "$0")" && pwd)
work=$BINARY_DIR/main-readme-$language
mkdir -p "$work/src"
case $language in
    python) file=pick.py ;;
    js) file=pick.mjs ;;
    rust) file=src/main.rs ;;
    csharp) file=pick.cs ;;
esac
awk -v start="\`\`\`$language" '/^```/ && inside { exit } inside; $0 == start { inside = 1 }' "$here/../README.md" >"$work/$file"
[ -s "$work/$file" ] || exit 1
cd "$work"
case $language in
    js) mkdir -p node_modules && ln -sfn "$here/javascript" node_modules/gamephys ;;
    rust) printf '[package]\nname = "pick"\nversion = "0.0.0"\nedition = "2021"\n[dependencies]\ngamephys = { path = "%s" }\n' "$here/rust" >Cargo.toml ;;
esac
"${@:2}" | tee output.txt
grep -qx 'hit at 4' output.txt
