#!/usr/bin/env bash
# The gem of this platform with the library inside.
source "$(dirname "$0")/common.sh"
native_library

cp -r "$SOURCE/bindings/ruby" "$SOURCE/LICENSE" .
cp LICENSE ruby
cp "$native/lib/libgamephys.so.1" ruby/lib/gamephys
(cd ruby && gem build --quiet gamephys.gemspec)
rm -f "$PACKAGES"/gamephys-*.gem
cp ruby/gamephys-*.gem "$PACKAGES"

empty gem install --quiet --local --ignore-dependencies --no-document --install-dir gems "$PACKAGES"/gamephys-*.gem
path=$WORK/gems:$(gem env gempath)
mkdir client
cp -r "$SOURCE/bindings/ruby/"{examples,test} client
cd client
for program in examples/scene examples/step examples/pick test/test_gamephys; do empty GEM_PATH="$path" ruby -w $program.rb; done
