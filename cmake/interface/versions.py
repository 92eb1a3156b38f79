#!/usr/bin/env python3
"""Whether every place that states the version states that of the header: versions.py ROOT [INSTALLED LIBDIR]

ROOT is the source tree; INSTALLED, below which the library was installed, is looked at too if it is
given. Prints what differs, and fails if anything does.
"""
import ctypes
import re
import sys
from pathlib import Path

# file: what stands before the version in it
SOURCES = {
    "bindings/gamephys_api.json": r'^ "version": "',
    "bindings/rust/Cargo.toml": r'^\[package\]\nname = "gamephys"\nversion = "',
    "bindings/rust/Cargo.lock": r'^name = "gamephys"\nversion = "',
    "bindings/javascript/package.json": r'^  "version": "',
    "bindings/go/README.md": r"^require gamephys v",
    "CHANGELOG.md": r"\A# Changelog\n(?:(?!## ).*\n)*## \[",
    "packaging/vcpkg/vcpkg.json": r'^  "version": "',
}
INSTALLED = {
    "share/gamephys/gamephys_api.json": r'^ "version": "',
    "{libdir}/cmake/gamephys/gamephysConfigVersion.cmake": r'^set\(PACKAGE_VERSION "',
    "{libdir}/pkgconfig/gamephys.pc": r"^Version: ",
}


def stated(path, before):
    match = re.search(before + r"(\d+\.\d+\.\d+)\b", path.read_text(), re.M) if path.exists() else None
    return match[1] if match else "none"


def header_version(path):
    return ".".join(re.findall(r"^#define GPHYS_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", path.read_text(), re.M))


def of_sources(root):
    for name, before in SOURCES.items():
        yield name, stated(root / name, before)


def of_installed(installed, libdir):
    yield "include/gamephys_c.h", header_version(installed / "include/gamephys_c.h")
    for name, before in INSTALLED.items():
        name = name.format(libdir=libdir)
        yield name, stated(installed / name, before)
    library = (installed / libdir / "libgamephys.so").resolve()
    yield library.name, library.name.partition(".so.")[2]
    number = ctypes.CDLL(str(library)).gphys_version()
    yield "gphys_version()", f"{number >> 16}.{number >> 8 & 255}.{number & 255}"


def main():
    root = Path(sys.argv[1])
    version = header_version(root / "include/gamephys_c.h")
    places = [*of_sources(root), *(of_installed(Path(sys.argv[2]), sys.argv[3]) if len(sys.argv) > 2 else [])]
    wrong = [f"{place} states version {found}, the header {version}" for place, found in places if found != version]
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
