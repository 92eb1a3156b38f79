#!/usr/bin/env bash
# After any change of include/gamephys_c.h: writes again what is made from it, which is
# bindings/gamephys_api.json, the low level of every binding, the version of the bindings' packages
# and the symbols file of the Debian package. The tests tell when it is due.
#   record.sh --release   at a release (docs/releasing.md): the header also becomes one that later
#                         headers must be compatible with
set -euo pipefail
cd "$(dirname "$0")/../.."
here=cmake/interface
header=include/gamephys_c.h

if [ "${1:-}" = --release ]; then
    cp $header "$here/released_$(sed -n 's/^#define GPHYS_VERSION_\(MAJOR\|MINOR\) //p' $header | paste -sd.).h"
fi
python3 $here/describe.py $header >bindings/gamephys_api.json.new
mv bindings/gamephys_api.json.new bindings/gamephys_api.json
python3 bindings/generate.py bindings/gamephys_api.json bindings
python3 $here/releases.py symbols $header $here >cmake/gamephys.symbols.new
mv cmake/gamephys.symbols.new cmake/gamephys.symbols

version=$(sed -n 's/^#define GPHYS_VERSION_[A-Z]* //p' $header | paste -sd.)
sed -i "/^name = \"gamephys\"$/{n;s/^version = .*/version = \"$version\"/}" bindings/rust/Cargo.{toml,lock}
sed -i "s/^  \"version\": .*/  \"version\": \"$version\",/" bindings/javascript/package.json packaging/vcpkg/vcpkg.json
sed -i "s/^require gamephys v.*/require gamephys v$version/" bindings/go/README.md
