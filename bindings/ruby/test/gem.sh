#!/usr/bin/env bash
# The gem can be built and installed from the tree without a network, and is enough alone: gem.sh RUBY
set -euo pipefail
work=$BINARY_DIR/ruby-gem
rm -rf "$work"
mkdir -p "$work"
gem build --quiet gamephys.gemspec --output "$work/gamephys.gem"
cd "$work"
gem install --quiet --local --ignore-dependencies --no-document --install-dir gems gamephys.gem
GEM_PATH=$work/gems:$(gem env gempath) "$1" -e '
require "gamephys"
raise unless $LOADED_FEATURES.grep(/gamephys\.rb/) == [Dir["#{Dir.pwd}/gems/gems/*/lib/gamephys.rb"].first]
Gamephys::Scene.open { |scene| scene.add(Gamephys::Sphere.new([0, 0, 5], 1)) }'
