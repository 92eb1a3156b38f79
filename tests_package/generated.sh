# Sourced by scripts that look at what is generated from the header.
advice="run cmake/interface/record.sh"

# bindings_current API.json BINDINGS: the generated files there are those of this description.
bindings_current() {
    local file
    rm -rf made
    mkdir made
    python3 "$SOURCE/bindings/generate.py" "$1" made
    (cd made && find . -type f) >generated.txt
    [ -s generated.txt ] || fail "nothing was generated"
    while read -r file; do
        cmp "made/$file" "$2/$file" || fail "bindings/$file is not that of the header: $advice"
        grep -qxF "bindings/${file#./} linguist-generated" "$SOURCE/.gitattributes" ||
            fail "bindings/${file#./} is generated: say so in .gitattributes"
    done <generated.txt
}

# symbols_current FILE: it is the symbols file of the header and of the recorded ones.
symbols_current() {
    python3 "$SOURCE/cmake/interface/releases.py" symbols "$SOURCE/include/gamephys_c.h" "$SOURCE/cmake/interface" >symbols.txt
    diff symbols.txt "$1" || fail "cmake/gamephys.symbols is not that of the header: $advice"
}
