#!/usr/bin/env bash
# docs/code_paths.md names files and functions in the order of a call: each file must exist, and each function be in it.
# SOURCE is the checkout.
set -euo pipefail
cd "$SOURCE"
page=docs/code_paths.md
rows=0
wrong=0
while IFS=$'\t' read -r file name; do
    rows=$((rows + 1))
    if [ ! -f "$file" ]; then
        echo "$page: there is no $file"
        wrong=1
    elif ! grep -qw -- "$name" "$file"; then
        echo "$page: $file has no $name"
        wrong=1
    fi
done < <(sed -n 's/^| `\([^`]*\)` | `\([^`]*\)` |.*/\1\t\2/p' "$page")
while read -r file; do
    if [ ! -f "$file" ]; then
        echo "$page: there is no $file"
        wrong=1
    fi
done < <(grep -o '`src/[^`]*`' "$page" | tr -d '`' | sort -u)
[ "$rows" -ge 40 ] || {
    echo "$page: only $rows rows are read"
    wrong=1
}
exit $wrong
