#!/usr/bin/env bash
# Tests the library: ./test.sh [--long | --bindings | --platforms | --fuzz MINUTES | --soak | --coverage [--write]]
# Installs what is missing, builds and runs the whole suite as users get the library, then again
# under the address and undefined-behaviour sanitizers, without long simulations and with fewer random cases
# (GAMEPHYS_SHORT_TESTS). Prints which lines and branches of each file these reach
# (fuzz/coverage.py). --long adds a build with clang, tests of
# minutes, such as a million queries of each kind against a linear scan, hours of tests against
# exact arithmetic, their short form with each compiler, unoptimised and for Haswell, on each
# instruction set, all tests under the sanitizers, and the workers under the thread sanitizer. --bindings instead tests the packages
# in bindings/, --platforms runs the C tests on 32-bit x86, 64-bit ARM (qemu), Windows (Wine) and
# WebAssembly (Node); both install what they need. --fuzz runs random programs on each instruction set
# and libFuzzer under sanitizers for so many minutes (fuzz/campaign.py). --soak runs a million frames of
# a game's main loop (fuzz/soak.cpp). --coverage says which lines and branches the tests reach, file by
# file, and with --write puts that into docs/reliability.md (fuzz/coverage.py).
# The last line is "N passed, N failed", then what was skipped because something is not installed; a
# build that fails counts as one failed test.
set -uo pipefail
cd "$(dirname "$0")"
source cmake/install_packages.sh
source cmake/test_summary.sh

presets=(release asan-ubsan)
packages=(cmake ninja-build g++ clang pkg-config dpkg-dev lintian file locales catch2 libcmocka-dev libcgal-dev libassimp-dev libstb-dev
    libbenchmark-dev valgrind python3 python3-cffi luajit abigail-tools libmpfr-dev python3-sphinx python3-myst-parser furo python3-numpy python3-matplotlib
    libsdl2-dev libgl-dev libgl1-mesa-dri xvfb xdotool libopenmpi-dev openmpi-bin llvm lld libclang-rt-14-dev)
configuration=()
options=()
usage() {
    echo "usage: ./test.sh [--long | --bindings | --platforms | --fuzz MINUTES | --soak | --coverage [--write]]" >&2
    exit 2
}
case ${1:-} in
    '') ;;
    --help | -h) sed -n '2,/^set /s/^# //p' "${0##*/}" && exit ;;
    --long)
        presets=(release clang exact-gcc-O0 exact-gcc-haswell exact-clang-O0 exact-clang-haswell asan-ubsan tsan)
        configuration=(-C Long)
        options=(-DGAMEPHYS_EXACT_TESTS=ON -DGAMEPHYS_SHORT_TESTS=OFF -DGAMEPHYS_EXACT_OPTIMISATION=-O1)
        ;;
    --bindings)
        presets=(bindings)
        configuration=(-C Bindings)
        packages+=(python3-numpy python3-pip nodejs emscripten chromium ruby ruby-ffi openjdk-17-jdk-headless
            libjna-java junit4 mono-mcs mono-runtime libmono-system-core4.0-cil nunit-console libnunit-cil-dev ldc php-cli mypy)
        command -v npm >/dev/null || packages+=(npm)
        command -v cargo >/dev/null || packages+=(cargo)
        command -v go >/dev/null || packages+=(golang-go)
        ;;
    --platforms)
        presets=(i686 aarch64 windows wasm32)
        packages+=(g++-i686-linux-gnu g++-aarch64-linux-gnu qemu-user-static g++-mingw-w64-x86-64 wine64 emscripten)
        ;;
    --fuzz)
        [[ ${2:-} =~ ^[1-9][0-9]*$ ]] || usage
        ;;
    --soak) ;;
    --coverage)
        [[ ${2:-} =~ ^(--write|--missing)?$ ]] || usage
        ;;
    *)
        usage
        ;;
esac

passed=0
failed=0
builds=()
finish() {
    closing_line "$passed" "$failed" "${builds[@]}"
    [ "$failed" -eq 0 ]
    exit
}

install_packages "${packages[@]}" || {
    failed=1
    finish
}
# A script in front of python that looks for the one to run, as pyenv has, takes longer than most checks do.
if python=$(python3 -c 'import sys; print(sys.executable)'); then export PATH=${python%/*}:$PATH; fi

if [ "${1:-}" = --bindings ]; then
    fetch=(npm install --no-package-lock --no-audit --no-fund)
    (cd bindings/javascript && "${fetch[@]}" && ./build_wasm.sh) || failed=$((failed + 1))
    (cd examples/web && "${fetch[@]}") || failed=$((failed + 1))
fi

jobs=$(nproc)
build_targets() { cmake --preset "$1" && cmake --build "build/$1" --parallel "$jobs" --target "${@:2}"; }

if [ "${1:-}" = --fuzz ]; then
    build_targets release fuzz_targets && build_targets fuzz fuzz_targets || {
        failed=1
        finish
    }
    exec fuzz/campaign.py "$2" build/release build/fuzz build/fuzz-work
fi

if [ "${1:-}" = --coverage ]; then
    build_targets coverage tests_cpp tests_c/all fuzz_targets soak || {
        failed=1
        finish
    }
    exec fuzz/coverage.py build/coverage "${@:2}"
fi

if [ "${1:-}" = --soak ]; then
    build_targets release soak || {
        failed=1
        finish
    }
    exec build/release/fuzz/soak 1000000
fi

for preset in "${presets[@]}"; do
    echo "== $preset"
    build=build/${preset/bindings/release}
    builds+=("$build")
    if ! { cmake --preset "${preset/bindings/release}" "${options[@]}" && cmake --build --preset "$preset" --parallel "$jobs"; }; then
        failed=$((failed + 1))
        continue
    fi
    log=$build.log
    export LLVM_PROFILE_FILE=$PWD/$build/profiles/%4m.profraw # for builds that count lines
    rm -rf "$build/profiles"
    ctest --preset "$preset" --parallel "$jobs" "${configuration[@]}" | tee "$log"
    configuration=() # the first build only
    if ! count_tests "$log"; then
        failed=$((failed + 1))
        continue
    fi
    passed=$((passed + ran_well))
    failed=$((failed + ran_badly))
    if [ -d "$build/profiles" ]; then
        fuzz/coverage.py "$build" --ctest | tee "$build/coverage.log"
        read -r ran_well _ ran_badly _ < <(tail -n 1 "$build/coverage.log")
        passed=$((passed + ${ran_well:-0}))
        failed=$((failed + ${ran_badly:-1}))
    fi
done
finish
