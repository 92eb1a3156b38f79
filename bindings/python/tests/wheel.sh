#!/usr/bin/env bash
# pip makes a wheel from the tree without a network, and the wheel alone is enough: wheel.sh PYTHON LIBRARY
set -euo pipefail
export GAMEPHYS_LIBRARY=$2
unset LD_PRELOAD LD_LIBRARY_PATH
source_dir=$PWD
work=$BINARY_DIR/python-wheel
rm -rf "$work"
mkdir -p "$work"
cd "$work"
"$1" -m pip --version >/dev/null 2>&1 || exit 0 # some distributions leave pip out
"$1" -m pip wheel --quiet --no-index --no-deps --wheel-dir . "$source_dir"
"$1" -m pip install --quiet --no-index --no-deps --target installed gamephys-*.whl
unset GAMEPHYS_LIBRARY
PYTHONPATH=$work/installed "$1" -c '
import gamephys, os
assert os.path.dirname(gamephys.__file__) == os.path.join(os.getcwd(), "installed", "gamephys")
scene = gamephys.Scene()
scene.add(gamephys.Sphere((0, 0, 5), 1))
assert scene.raycast(((0, 0, 0), (0, 0, 1), 100)).t == 4

from importlib.metadata import distribution
installed = distribution("gamephys")
about = installed.metadata
assert about["Summary"] and about["Keywords"] and about["License-Expression"] == "MIT", about.items()
assert about.get_payload().startswith("# gamephys for Python\n"), about.get_payload()
assert installed.read_text("licenses/LICENSE").startswith("MIT License"), installed.files
'
