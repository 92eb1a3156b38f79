#!/usr/bin/env bash
# The bindings' comments are in the terms of their languages: none speaks of what only a caller of the C
# functions sees, and samples of each say what the C comment says.
source "$SOURCE/tests_package/common.sh"
source "$here/documented.sh"
comments_in_own_terms "$SOURCE/bindings"
