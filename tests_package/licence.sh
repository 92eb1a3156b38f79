#!/usr/bin/env bash
# The licence is stated as the REUSE specification asks: REUSE.toml names it for every file, and its text is in LICENSES.
# The installed headers, which are often copied alone, name it themselves.
source "$SOURCE/tests_package/common.sh"

# stated TAG: what REUSE.toml says of every file.
stated() { sed -n "s/^$1 = \"\(.*\)\"$/\1/p" "$SOURCE/REUSE.toml"; }
licence=$(stated SPDX-License-Identifier)
[ "$(ls "$SOURCE/LICENSES")" = "$licence.txt" ] || fail "LICENSES should have the text of $licence and no other"
cmp "$SOURCE/LICENSE" "$SOURCE/LICENSES/$licence.txt" || fail "LICENSE and LICENSES/$licence.txt differ"
for header in "$INSTALLED"/include/*; do
    head -n 2 "$header" >top.txt
    for tag in SPDX-FileCopyrightText SPDX-License-Identifier; do
        grep -qF "$tag: $(stated $tag)" top.txt || fail "the first lines of ${header##*/} have no $tag as in REUSE.toml"
    done
done
