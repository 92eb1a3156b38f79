#!/usr/bin/env python3
"""entry_points.py SOURCE: every function that the library exports goes through the one guard.

A definition in src/c_api of a function of the header is one statement: `return guarded(__func__, ...)`, which is
noexcept, converts exceptions to a status and puts the function's name before messages (src/c_api/api.h), or the
same without a value. Prints each function that is not, and fails.
"""
import pathlib
import re
import sys

# They return constants and the text of the last error, which has its place already.
CONSTANTS = {"gphys_version", "gphys_status_name", "gphys_last_error"}


def closing(text, opening):
    """Where the bracket that opens there is closed; strings and comments in our code hold none."""
    depth = 0
    for at in range(opening, len(text)):
        depth += (text[at] in "({") - (text[at] in ")}")
        if depth == 0:
            return at
    sys.exit("unbalanced brackets")


def is_guarded(body):
    """Whether the body of a function is that one statement."""
    call = re.match(r"(return )?guarded\(\s*__func__,\s", body)
    return bool(call) and body[closing(body, body.index("(")) + 1 :] == ";"


def definitions(text):
    """(name, body) of the exported functions that a source file defines."""
    for found in re.finditer(r"^[a-z][\w ]*[ *](gphys_\w+)\(", text, re.M):
        behind = closing(text, found.end() - 1) + 1
        if text[behind : behind + 2] == " {":
            yield found[1], text[behind + 2 : closing(text, behind + 1)].strip()


def main():
    source = pathlib.Path(sys.argv[1])
    header = (source / "include/gamephys_c.h").read_text()
    declared = set(re.findall(r"^GPHYS_API [\w ]*[ *](gphys_\w+)\(", header, re.M))
    wrong, defined = [], set()
    for path in sorted((source / "src/c_api").glob("*.cpp")):
        for name, body in definitions(path.read_text()):
            defined.add(name)
            if name not in CONSTANTS and not is_guarded(body):
                wrong.append(f"{path.name}: {name} is more than its guard")
    wrong += [f"{name}: no definition found in src/c_api" for name in sorted(declared - defined)]
    if not declared or wrong:
        sys.exit("\n".join(wrong) or "no declarations found")


main()
