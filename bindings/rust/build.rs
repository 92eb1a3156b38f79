//! Finds libgamephys: beside $GAMEPHYS_LIBRARY, else by pkg-config, else builds it of the sources in the packaged crate,
//! else leaves it to the linker.
use std::path::Path;
use std::process::Command;

fn main() {
    println!("cargo:rerun-if-env-changed=GAMEPHYS_LIBRARY");
    println!("cargo:rerun-if-env-changed=PKG_CONFIG_PATH");
    if let Ok(library) = std::env::var("GAMEPHYS_LIBRARY") {
        let folder = Path::new(&library).parent().expect("GAMEPHYS_LIBRARY is the path of a file");
        println!("cargo:rustc-link-search=native={}", folder.display());
        return;
    }
    let found = Command::new("pkg-config").args(["--libs-only-L", "gamephys"]).output();
    match found {
        Ok(output) if output.status.success() => {
            for word in String::from_utf8_lossy(&output.stdout).split_whitespace() {
                println!("cargo:rustc-link-search=native={}", word.trim_start_matches("-L"));
            }
        }
        _ if Path::new("native/CMakeLists.txt").exists() => build_packaged(),
        _ => println!("cargo:warning=pkg-config does not find gamephys: set PKG_CONFIG_PATH or GAMEPHYS_LIBRARY"),
    }
}

/// Builds the sources that lie in the packaged crate, with CMake.
fn build_packaged() {
    let out = std::env::var("OUT_DIR").unwrap();
    let jobs = std::env::var("NUM_JOBS").unwrap();
    let run = |arguments: &[&str]| {
        let status = Command::new("cmake").args(arguments).status().expect("gamephys is built with CMake, which is not found");
        assert!(status.success(), "cmake {} failed", arguments.join(" "));
    };
    let prefix = format!("-DCMAKE_INSTALL_PREFIX={out}");
    let options = ["-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_INSTALL_LIBDIR=lib", "-DGAMEPHYS_SHARED=OFF"];
    let parts = ["-DGAMEPHYS_TESTS=OFF", "-DGAMEPHYS_EXAMPLES=OFF", "-DGAMEPHYS_BENCH=OFF"];
    run(&[&["-S", "native", "-B", &format!("{out}/build"), &prefix], &options[..], &parts[..]].concat());
    run(&["--build", &format!("{out}/build"), "--target", "install", "--parallel", &jobs]);
    println!("cargo:rustc-link-search=native={out}/lib");
    let runtime = if std::env::var("CARGO_CFG_TARGET_OS").unwrap() == "macos" { "c++" } else { "stdc++" };
    println!("cargo:rustc-link-lib=static=gamephys");
    println!("cargo:rustc-link-lib={runtime}");
}
