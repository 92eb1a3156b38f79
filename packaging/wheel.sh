#!/usr/bin/env bash
# The wheel with the library inside, tagged with the oldest glibc that it runs with. The binding's tests run against
# it in a new virtual environment: among them that arrays of numpy are taken and filled in place.
source "$(dirname "$0")/common.sh"
native_library

python=/usr/bin/python3
GAMEPHYS_LIBRARY=$native/lib/libgamephys.so.1 "$python" -m pip wheel --quiet --no-index --no-deps --wheel-dir made \
    "$SOURCE/bindings/python"
wheel=$(echo made/gamephys-*.whl)
[[ $wheel == made/gamephys-$version-py3-none-manylinux_2_*.whl ]] || fail "the wheel runs on this system only: $wheel"
rm -f "$PACKAGES"/gamephys-*.whl
cp "$wheel" "$PACKAGES"

"$python" -m venv --system-site-packages environment # numpy is the system's
empty environment/bin/pip install --quiet --no-index --no-deps "$PACKAGES"/gamephys-*.whl
mkdir client
cp -r "$SOURCE/bindings/python/"{examples,tests} client
cd client
for example in scene step pick; do empty ../environment/bin/python examples/$example.py; done
empty GAMEPHYS_HEADERS="$SOURCE/include" ../environment/bin/python -m unittest discover -s tests
empty ../environment/bin/python -c '
import gamephys, sys
assert gamephys.__file__.startswith(sys.prefix), gamephys.__file__'
