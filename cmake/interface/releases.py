#!/usr/bin/env python3
"""Which release each function came with, by the recorded headers: releases.py COMMAND HEADER RELEASED ...

RELEASED is the folder of the recorded headers, released_MAJOR.MINOR.h, one for each minor release.
A function belongs to the first of them that has it, else to the release that HEADER is for.

    nodes            "function node" for each function of HEADER, in its order
    check-map MAP    whether the version script MAP has these nodes and functions: prints what is wrong
    symbols          the symbols file of the Debian package: the release that each function needs
"""
import re
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
from describe import describe  # noqa: E402


def version_of(header):
    numbers = dict(re.findall(r"^#define GPHYS_VERSION_(\w+) (\d+)$", header.read_text(), re.M))
    return int(numbers["MAJOR"]), int(numbers["MINOR"])


def functions_of(header):
    text = subprocess.run(["clang", "-E", "-P", "-DGPHYS_API=EXPORTED", "-x", "c", header],
                          stdout=subprocess.PIPE, text=True, check=True).stdout
    return re.findall(r"\bEXPORTED\b[^(;]*?(\w+)\(", text)


def recorded(released):
    """The recorded headers, oldest first."""
    return sorted(released.glob("released_*.h"), key=version_of)


def node(version):
    return f"GAMEPHYS_{version[0]}.{version[1]}"


def origins(header, released):
    """function -> (major, minor) of its first release, in the order of HEADER; and all those versions."""
    headers = [*recorded(released), header]
    first = {}
    for known in headers:
        for name in functions_of(known):
            first.setdefault(name, version_of(known))
    return {name: first[name] for name in functions_of(header)}, sorted({version_of(h) for h in headers})


def wrong_in_map(path, header, released):
    since, versions = origins(header, released)
    nodes = re.findall(r"(\w[\w.]*)\s*\{([^}]*)\}\s*([\w.]*);", path.read_text())
    wanted = [node(v) for v in versions]
    if [name for name, _, _ in nodes] != wanted:
        yield f"the nodes are {', '.join(name for name, _, _ in nodes)}, not {', '.join(wanted)}"
    inherited = ""
    listed = {}
    for name, body, parent in nodes:
        if parent != inherited:
            yield f"{name} follows {parent or 'nothing'}, not {inherited or 'nothing'}"
        inherited = name
        visible, _, hidden = body.partition("local:")
        if (hidden.strip() == "*;") != (name == nodes[0][0]):
            yield f"{name}: `local: *;` is in the first node, and only there"
        for function in re.findall(r"([\w*?]+);", visible):
            if function in listed:
                yield f"{function} is in {listed[function]} and in {name}"
            listed[function] = name
    for function, version in since.items():
        if function not in listed:
            yield f"{function} is not in the map"
        elif listed[function] != node(version):
            yield f"{function} is in {listed[function]}, it came with {node(version)}"
    yield from (f"{function} is in the map and not in the header" for function in listed if function not in since)


def growth(header, released):
    """desc -> (major, minor) of the release that it last grew in."""
    grown, fields = {}, {}
    for known in [*recorded(released), header]:
        for struct in describe(known, quick=True)["structs"]:
            if struct["name"].endswith("_desc") and fields.get(struct["name"]) != len(struct["fields"]):
                fields[struct["name"]] = len(struct["fields"])
                grown[struct["name"]] = version_of(known)
    return grown


def symbols(header, released):
    """A program needs the release of the last field of a desc that it may fill in, not only that of the function."""
    since, versions = origins(header, released)
    grown = growth(header, released)
    major = versions[-1][0]
    yield f"libgamephys.so.{major} libgamephys{major} #MINVER#"
    yield from (f" {node(v)}@{node(v)} {v[0]}.{v[1]}.0" for v in versions)
    for function in sorted(describe(header, quick=True)["functions"], key=lambda f: f["name"]):
        name = function["name"]
        descs = [p["type"].replace("const ", "").rstrip("* ") for p in function["parameters"]]
        needed = max([since[name], *(grown[d] for d in descs if d in grown)])
        yield f" {name}@{node(since[name])} {needed[0]}.{needed[1]}.0"


def main():
    command, header, released = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    if command == "nodes":
        lines = [f"{name} {node(v)}" for name, v in origins(header, released)[0].items()]
    elif command == "check-map":
        lines = list(wrong_in_map(Path(sys.argv[4]), header, released))
    else:
        lines = list(symbols(header, released))
    print("\n".join(lines))
    sys.exit(1 if command == "check-map" and lines else 0)


if __name__ == "__main__":
    main()
