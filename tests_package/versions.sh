#!/usr/bin/env bash
# The version is one number: the header's, that of the installed library and its packages' files, and
# that of the bindings.
source "$SOURCE/tests_package/common.sh"
python3 "$SOURCE/cmake/interface/versions.py" "$SOURCE" "$INSTALLED" "$LIBDIR" >wrong.txt || fail "$(cat wrong.txt)"
