#!/usr/bin/env bash
# docs/bindings.md is up to date: documented.sh PYTHON API.json CALLS FILE
set -euo pipefail
cd "$(dirname "$0")"
"$1" document.py "$2" "$3" "$4"
diff ../docs/bindings.md "$4" || {
    echo "docs/bindings.md is not what the tests call: copy $4 there, or measure too, by document_bindings"
    exit 1
}
