#!/usr/bin/env python3
"""Describe the C header as data: describe.py HEADER [--quick] > gamephys_api.json

clang parses the header and lays out its structs for 64-bit and 32-bit targets; the comments are
taken from the text. What each parameter is for follows from the header's own naming rules
(roles.py). Needs clang, no library of a target. --quick lays out for one target of each width only.
"""
import json
import re
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
from roles import with_roles  # noqa: E402

# All targets of a width must agree, so that one number stands for them.
TARGETS = {
    64: ["x86_64-linux-gnu", "aarch64-linux-gnu", "x86_64-pc-windows-msvc", "wasm64-unknown-unknown"],
    32: ["i686-linux-gnu", "armv7-linux-gnueabihf", "i686-pc-windows-msvc", "wasm32-unknown-unknown"],
}


def clang(*arguments, source=None):
    command = ["clang", "-ffreestanding", "-std=c99", "-x", "c", *arguments]
    return subprocess.run(command, input=source, stdout=subprocess.PIPE, text=True, check=True).stdout


class Comments:
    """The header's text, asked for the comment of a place."""

    def __init__(self, text):
        self.text = text
        self.lines = text.split("\n")
        self.starts = [0]
        for line in self.lines:
            self.starts.append(self.starts[-1] + len(line) + 1)

    def line_of(self, offset):
        return self.text.count("\n", 0, offset)

    @staticmethod
    def plain(comment):
        lines = re.sub(r"^/\*+|\*/$", "", comment.strip()).split("\n")
        return "\n".join(re.sub(r"^\s*\*? {0,2}", "", line).rstrip() for line in lines).strip()

    def above(self, offset):
        """The /** */ that ends on the line above the declaration: a neighbour's is not its own."""
        line = self.line_of(offset) - 1
        if not self.lines[line].rstrip().endswith("*/"):
            return ""
        end = self.starts[line + 1] - 1
        start = self.text.rfind("/*", 0, end)
        comment = self.text[start:end]
        return self.plain(comment) if comment.startswith("/**") else ""

    def beside(self, offset):
        """The /* */ that begins behind the declaration, on its line."""
        end = self.starts[self.line_of(offset) + 1]
        start = self.text.find("/*", offset, end)
        return self.plain(self.text[start:self.text.index("*/", start) + 2]) if start >= 0 else ""


def numbers(target, header, expressions):
    """The values of constant expressions for a target."""
    source = f'#include "{header}"\nconst unsigned long long numbers[] = {{{",".join(expressions)}}};\n'
    module = clang("-S", "-emit-llvm", "-o", "-", "-target", target, "-", source=source)
    values = re.search(r"@numbers = .*\[(i64.*?)\]", module)
    return [int(value) for value in re.findall(r"i64 (-?\d+)", values[1])] if values else [0] * len(expressions)


def sized(expressions, header, quick):
    """[value for 64-bit targets, value for 32-bit targets] of each expression."""
    found = []
    for width, targets in TARGETS.items():
        targets = targets[:1] if quick else targets
        results = {target: numbers(target, header, expressions) for target in targets}
        first = next(iter(results.values()))
        for target, values in results.items():
            wrong = [e for e, a, b in zip(expressions, first, values) if a != b]
            if wrong:
                sys.exit(f"{target} differs from other {width}-bit targets in {wrong}")
        found.append(first)
    return [list(pair) for pair in zip(*found)]


def split_type(text):
    """'float[16]' is 16 times 'float'."""
    array = re.fullmatch(r"(.*?)\s*\[(\d+)\]", text)
    return (array[1], int(array[2])) if array else (text, 1)


def describe(header, quick=False):
    text = header.read_text()
    comments = Comments(text)
    tree = json.loads(clang("-fsyntax-only", "-Xclang", "-ast-dump=json", str(header)))

    api = {
        "library": "gamephys",
        "version": ".".join(re.findall(r"#define GPHYS_VERSION_\w+ (\d+)", text)),
        "widths": list(TARGETS),
        "constants": {},
        "types": [],
        "enums": [],
        "handles": [],
        "callbacks": [],
        "structs": [],
        "functions": [],
    }
    for name, value in re.findall(r"^#define (GPHYS_\w+) (\S+)$", text, re.M):
        if name != "GPHYS_API":
            api["constants"][name] = value

    def place(node):
        location = node["loc"]
        return location.get("expansionLoc", location)["offset"]

    def begin(node):
        location = node["range"]["begin"]
        return location.get("expansionLoc", location)["offset"]

    previous = None
    defined = set()
    for node in tree["inner"]:
        kind, name = node["kind"], node.get("name", "")
        if kind == "EnumDecl":
            values = []
            for constant in node["inner"]:
                if constant["kind"] != "EnumConstantDecl":
                    continue
                values.append({
                    "name": constant["name"],
                    "value": int(constant["inner"][0]["value"]),
                    "doc": comments.beside(place(constant)),
                })
            named = previous and previous["kind"] == "TypedefDecl" and previous["type"]["qualType"] == "int32_t"
            api["enums"].append({"name": previous["name"] if named else None, "values": values})
        elif kind == "VarDecl":
            sys.exit(f"{name} is a variable: foreign-function interfaces call functions only")
        elif not name.startswith("gphys_"):
            if kind == "FunctionDecl":
                sys.exit(f"{name} does not begin with gphys_")
        elif kind == "TypedefDecl":
            of = node["type"]["qualType"]
            if "(*)" in of:
                api["callbacks"].append({"name": name, "type": of, "doc": comments.above(begin(node))})
            elif not of.startswith("struct "):
                api["types"].append({"name": name, "type": of, "doc": comments.above(begin(node))})
        elif kind == "RecordDecl":
            if node.get("completeDefinition"):
                defined.add(name)
                fields = []
                for field in node["inner"]:
                    if field["kind"] != "FieldDecl":
                        continue
                    of, count = split_type(field["type"]["qualType"])
                    if field.get("isBitfield"):
                        sys.exit(f"{name}.{field['name']} is a bit-field: its place is up to the compiler")
                    fields.append({"name": field["name"], "type": of, "count": count,
                                   "doc": comments.beside(place(field))})
                api["structs"].append({"name": name, "doc": comments.above(begin(node)), "fields": fields})
            elif name not in api["handles"]:
                api["handles"].append(name)
        elif kind == "FunctionDecl":
            if "storageClass" in node or node.get("inline"):
                sys.exit(f"{name} is defined in the header: foreign-function interfaces cannot call it")
            if node.get("variadic"):
                sys.exit(f"{name} takes any number of arguments: foreign-function interfaces cannot call it")
            parameters = []
            for parameter in node.get("inner", []):
                if parameter["kind"] != "ParmVarDecl":
                    continue
                array = re.match(r"\w+\[(\d+)\]", text[place(parameter):])
                parameters.append({"name": parameter["name"], "type": parameter["type"]["qualType"],
                                   **({"count": int(array[1])} if array else {})})
            api["functions"].append({
                "name": name,
                "doc": comments.above(begin(node)),
                "returns": node["type"]["qualType"].split("(")[0].strip(),
                "parameters": parameters,
            })
        previous = node

    api["handles"] = [name for name in api["handles"] if name not in defined]
    places = [(struct, None) for struct in api["structs"]]
    places += [(struct, field) for struct in api["structs"] for field in struct["fields"]]
    # Of a field its offset and size, of a struct its size and alignment.
    asked = []
    for struct, field in places:
        name = struct["name"]
        asked += ([f'offsetof({name},{field["name"]})', f'sizeof((({name}*)0)->{field["name"]})'] if field else
                  [f"sizeof({name})", f"_Alignof({name})"])
    values = sized(asked, header.resolve(), quick)
    for (struct, field), first, second in zip(places, values[::2], values[1::2]):
        if field:
            field["offset"], field["size"] = first, second
        else:
            struct["size"], struct["align"] = first, second
    return with_roles(api)


def main():
    header = Path(sys.argv[1])
    json.dump(describe(header, "--quick" in sys.argv), sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    main()
