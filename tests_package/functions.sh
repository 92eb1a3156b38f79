#!/usr/bin/env bash
# The names of the header's functions, one a line, as the preprocessor leaves them.
set -euo pipefail
"${CC:-cc}" -E -P -DGPHYS_API=EXPORTED "$SOURCE/include/gamephys_c.h" | tr '\n' ' ' |
    grep -oE 'EXPORTED [^(;]*gphys_[a-z0-9_]+\(' | grep -oE 'gphys_[a-z0-9_]+\($' | tr -d '('
