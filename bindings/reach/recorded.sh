#!/usr/bin/env bash
# Runs a test of a binding and records the C functions that it calls: recorded.sh FILE COMMAND...
set -euo pipefail
export GAMEPHYS_CALLS=$1
mkdir -p "$(dirname "$1")"
: >"$1"
shift
exec "$@"
