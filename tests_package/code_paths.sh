#!/usr/bin/env bash
# docs/code_paths.md names files and functions in the order of a call: each file must exist, each function be in it, and
# each table have at most twelve files.
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
long=$(awk -F'`' '/^##/ { table = $0 }
    /^\| `/ && !seen[table, $2]++ && ++files[table] == 13 { print table }' "$page")
[ -z "$long" ] || {
    echo "$page: more than twelve files in $long"
    wrong=1
}
[ "$rows" -ge 40 ] || {
    echo "$page: only $rows rows are read"
    wrong=1
}
exit $wrong
