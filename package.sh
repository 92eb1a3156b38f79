#!/usr/bin/env bash
# Builds packages as users find them, into build/packages, and tests each from its file in an empty environment:
#   ./package.sh NAME...   of npm page wheel crate go nuget maven rock gem deb vcpkg conan; all: every one
# Installs the tools that Debian has (packaging/tools.txt). The last line is "N passed, N failed", then what was skipped
# or tested in part, with the reason.
set -uo pipefail
cd "$(dirname "$0")"
source cmake/install_packages.sh

known=(npm page wheel crate go nuget maven rock gem deb vcpkg conan)
usage="usage: ./package.sh NAME... of ${known[*]}, or all"
case ${1:-} in
    '') echo "$usage" >&2 && exit 2 ;;
    --help | -h) sed -n '2,/^set /s/^# //p' "${0##*/}" && exit ;;
    all) set -- "${known[@]}" ;;
esac
for name in "$@"; do
    [[ " ${known[*]} " == *" $name "* ]] || { echo "no package is named $name; $usage" >&2 && exit 2; }
done

passed=0 failed=0 notes=()
for name in "$@"; do
    echo "== $name"
    export SOURCE=$PWD PACKAGES=$PWD/build/packages WORK=$PWD/build/package-work/$name
    rm -rf "$WORK"
    mkdir -p "$PACKAGES" "$WORK"
    read -ra tools < <(sed -n "s/^$name: //p" packaging/tools.txt)
    install_packages "${tools[@]}" && packaging/"$name".sh
    case $? in
        0) passed=$((passed + 1)) ;;
        77) ;;
        *) failed=$((failed + 1)) && echo "$name: failed" >&2 ;;
    esac
    [ ! -f "$WORK/note" ] || notes+=("$name: $(<"$WORK/note")")
done
ls -l build/packages
line="$passed passed, $failed failed"
for note in "${notes[@]}"; do
    [[ $line == *skipped* ]] && line+="; $note" || line+=", skipped: $note"
done
echo "$line"
[ "$failed" -eq 0 ]
