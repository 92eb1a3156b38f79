#!/usr/bin/env bash
# The Conan recipe, with its test package. Conan comes from PyPI; Debian does not have it.
source "$(dirname "$0")/common.sh"

tar -C "$SOURCE/packaging" -czf "$PACKAGES/gamephys-$version-conan.tar.gz" conan
if ! command -v conan >/dev/null; then
    for recipe in "$SOURCE"/packaging/conan/{,test_package/}conanfile.py; do
        python3 -c 'import sys; compile(open(sys.argv[1]).read(), sys.argv[1], "exec")' "$recipe"
    done
    skip "conan is not installed and Debian does not have it: the recipe was packed, not run"
fi
export CONAN_HOME=$WORK/home
conan profile detect
conan create "$SOURCE/packaging/conan"
