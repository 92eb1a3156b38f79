#!/usr/bin/env bash
# The crate with the library's sources inside, which its build script builds with CMake where no library is installed.
source "$(dirname "$0")/common.sh"
command -v cargo >/dev/null || skip "cargo is not installed"

cp -r "$SOURCE/bindings/rust" crate
rm -rf crate/target
mkdir crate/native
cp "$SOURCE/LICENSE" crate
cp -r "$SOURCE/"{CMakeLists.txt,LICENSE,cmake,include,pkgconfig,src} crate/native
mkdir -p crate/native/bindings/cpp
cp -r "$SOURCE/bindings/cpp/gamephys" crate/native/bindings/cpp
cp "$SOURCE/bindings/gamephys_api.json" crate/native/bindings
# An example of the repository's benchmark lies outside of the crate.
sed -i '/^\[\[example\]\]$/,$d' crate/Cargo.toml
(cd crate && cargo package --offline --quiet --no-verify --allow-dirty --target-dir "$WORK/made")
rm -f "$PACKAGES"/gamephys-*.crate
cp made/package/gamephys-*.crate "$PACKAGES"

# A program of its own that depends on the crate as it was unpacked, as cargo vendor does.
tar -xf "$PACKAGES"/gamephys-*.crate
mkdir -p client/src
cp "$SOURCE/bindings/rust/examples/pick.rs" client/src/main.rs
cat >client/Cargo.toml <<END
[package]
name = "client"
version = "0.1.0"
edition = "2021"
[dependencies]
gamephys = { path = "../gamephys-$version" }
END
export RUSTUP_HOME=${RUSTUP_HOME:-$HOME/.rustup} CARGO_HOME=${CARGO_HOME:-$HOME/.cargo}
cargo_empty() { empty RUSTUP_HOME="$RUSTUP_HOME" CARGO_HOME="$CARGO_HOME" CARGO_TARGET_DIR="$WORK/target" cargo "$@"; }
(cd client && cargo_empty run --offline --quiet)
(cd gamephys-"$version" && cargo_empty test --offline --quiet)
