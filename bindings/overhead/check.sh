#!/usr/bin/env bash
# A program that measures prints its four lines: check.sh LANGUAGE COMMAND...
set -euo pipefail
language=$1
shift
"$@" 1 | tee /dev/stderr | grep -cE "^$language,(scalar|vec3|raycast|raycast_batch),[0-9]+(\.[0-9]+)?$" | grep -qx 4
