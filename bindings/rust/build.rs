//! Finds libgamephys: beside $GAMEPHYS_LIBRARY, else by pkg-config, else where the linker looks.
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
        _ => println!("cargo:warning=pkg-config does not find gamephys: set PKG_CONFIG_PATH or GAMEPHYS_LIBRARY"),
    }
}
