#!/usr/bin/env bash
# ./docs.sh: builds the manual as a site, build/docs/html/index.html, which can be searched and needs no server.
# Installs what it needs. A warning is an error, and so is a link that leads nowhere.
# ./docs.sh --write also runs the programs of the guide and puts what they print below them: it builds the library.
set -euo pipefail
cd "$(dirname "$0")"
case ${1:-} in
    '' | --write) ;;
    --help | -h) sed -n '2,/^set /s/^# //p' "${0##*/}" && exit ;;
    *) echo "usage: ./docs.sh [--write]" >&2 && exit 2 ;;
esac
source cmake/install_packages.sh
install_packages python3 python3-sphinx python3-myst-parser furo

if [ "${1:-}" = --write ]; then
    install_packages g++ cmake ninja-build python3-numpy
    cmake -S . -B build/release -G Ninja -DCMAKE_BUILD_TYPE=Release
    cmake --build build/release --target gamephys
    library=$PWD/build/release
    mkdir -p build/docs/programs
    export LD_LIBRARY_PATH=$library GAMEPHYS_LIBRARY=$library/libgamephys.so.1 PYTHONPATH=$PWD/bindings/python
    docs/site/programs.py --write . build/docs/programs c cc -std=c99 -Iinclude -L"$library" -lgamephys -lm
    docs/site/programs.py --write . build/docs/programs python /usr/bin/python3
fi
/usr/bin/python3 docs/site/links.py .
/usr/bin/python3 docs/site/build.py . build/docs
echo "the manual: build/docs/html/index.html"
