#!/usr/bin/env bash
# The programs of the manual's pages print what the pages say: guide.sh c | guide.sh python | guide.sh js.
# guide.sh reference: the examples of the reference give the answers that they say, and each function has one.
# The status 77 says that what runs them is not installed.
source "$SOURCE/tests_package/common.sh"
library=$INSTALLED/$LIBDIR
export PKG_CONFIG_PATH=$library/pkgconfig LD_LIBRARY_PATH=$library GAMEPHYS_LIBRARY=$library/libgamephys.so.1
run() { python3 "$SOURCE/docs/site/programs.py" "$SOURCE" . "$@"; }
case $1 in
    c) run c "$CC" -std=c99 -Wall -Wextra -Werror $(pkg-config --cflags --libs gamephys) -lm ;;
    reference)
        for program in "$SOURCE"/docs/examples/*.c; do
            "$CC" -std=c99 -Wall -Wextra -pedantic -Werror -I"$SOURCE/examples" "$program" $(pkg-config --cflags --libs gamephys) -lm -o example
            ./example >example.log 2>&1 || fail "$program: $(cat example.log)"
        done
        PYTHONDONTWRITEBYTECODE=1 python3 "$SOURCE/docs/site/reference.py" "$SOURCE"
        ;;
    python)
        export PYTHONPATH=$SOURCE/bindings/python PYTHONDONTWRITEBYTECODE=1
        for python in /usr/bin/python3 python3; do
            if "$python" -c 'import numpy' 2>/dev/null; then
                run python "$python"
                exit
            fi
        done
        echo "numpy is not installed"
        exit 77
        ;;
    js)
        if [ ! -d "$SOURCE/bindings/javascript/node_modules" ] || ! command -v node >/dev/null; then
            echo "Node, or what the package for JavaScript needs, is not installed"
            exit 77
        fi
        mkdir node_modules
        ln -s "$SOURCE/bindings/javascript" node_modules/gamephys
        run js node
        ;;
esac
