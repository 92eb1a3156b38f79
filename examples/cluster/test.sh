#!/usr/bin/env bash
# A small study gives the same file with one process and with two, and when it is gone on with: test.sh PROGRAM MPIEXEC
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mpi=("$2" --oversubscribe)
[ "$(id -u)" -ne 0 ] || mpi+=(--allow-run-as-root)
study=(--poses 60 --times 3 --side 8)
for count in 1 2; do "${mpi[@]}" -n $count "$1" "$work/$count" "${study[@]}" 2>/dev/null; done
[ "$(stat -c %s "$work/1")" -eq $((60 * 3 * 64)) ]
cmp "$work/1" "$work/2"

# A part of the file is lost: only that is done again.
cp "$work/1" "$work/cut"
dd if=/dev/zero of="$work/cut" bs=64 seek=70 count=5 conv=notrunc 2>/dev/null
"${mpi[@]}" -n 1 "$1" "$work/cut" "${study[@]}" 2>/dev/null | tee "$work/said"
grep -q ': 1 of 9 units' "$work/said"
cmp "$work/1" "$work/cut"
