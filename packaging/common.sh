# Sourced by the scripts of this folder, which ./package.sh runs with SOURCE, PACKAGES and WORK, an empty folder.
set -euo pipefail
cd "$WORK"
version=$(sed -n 's/^#define GPHYS_VERSION_[A-Z]* //p' "$SOURCE/include/gamephys_c.h" | paste -sd.)

fail() {
    echo "$*" >&2
    exit 1
}

# skip REASON: this package cannot be built or tested here.
skip() {
    echo "$1" >"$WORK/note"
    exit 77
}

# in_part REASON: something about this package was not tested here.
in_part() { echo "$1" >"$WORK/note"; }

# empty COMMAND...: run it where neither the environment nor the system knows of gamephys.
empty() {
    if ldconfig -p | grep -q libgamephys; then fail "a libgamephys that is installed on this system would hide mistakes"; fi
    mkdir -p "$WORK/home"
    env -i HOME="$WORK/home" PATH="$PATH" LANG=C.UTF-8 "$@"
}

# native_library: the library as packages of other languages hold it, for every Linux of this processor with at least
# the glibc of this machine: the C++ runtime is linked in. Installed into $native, stripped.
native_library() {
    local build=$SOURCE/build/native
    native=$SOURCE/build/native/prefix
    cmake -S "$SOURCE" -B "$build" -DCMAKE_BUILD_TYPE=Release -DGAMEPHYS_TESTS=OFF -DGAMEPHYS_EXAMPLES=OFF -DGAMEPHYS_BENCH=OFF \
        -DCMAKE_SHARED_LINKER_FLAGS=-static-libstdc++ -DCMAKE_INSTALL_PREFIX="$native" -DCMAKE_INSTALL_LIBDIR=lib >/dev/null
    cmake --build "$build" --parallel "$(nproc)" | tail -n 1
    cmake --install "$build" --strip >/dev/null
    ! objdump -p "$native/lib/libgamephys.so.1" | grep -q 'NEEDED.*libstdc++' || fail "the C++ runtime is not linked in"
}
