# Sourced by every script here. CMakeLists.txt sets the variables in the environment.
set -euo pipefail
here=$SOURCE/tests_package
rm -rf "$WORK"
mkdir -p "$WORK"
cd "$WORK"

fail() {
    echo "$*" >&2
    exit 1
}

# expect_no_match MESSAGE GREP_ARGUMENT...: fail and show it if grep finds something or cannot look.
expect_no_match() {
    local message=$1 found status=0
    shift
    found=$(grep "$@") || status=$?
    [ $status -eq 1 ] || fail "$message: $found"
}
