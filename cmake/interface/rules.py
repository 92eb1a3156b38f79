#!/usr/bin/env python3
"""Whether a description of the header keeps to the rules of its interface: rules.py API.json [TEST ...]

Of the tests, the statuses that a function is seen to return are taken, and of the C tests its name.
Prints what does not, and fails if there is anything. The rules let every language call every
function, and let structs grow: docs/releasing.md has their reasons.
"""
import json
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
from compare import version  # noqa: E402

NUMBERS = ("float", "int32_t", "uint32_t")
POINTERS = ("const gphys_allocator *", "const gphys_task_runner *", "const gphys_model_id *")
# Structs of function pointers, which a desc points to.
HOOKS = ("gphys_allocator", "gphys_task_runner")
RETURNS = ("gphys_status", "uint32_t", "const char *", "void")


class Types:
    def __init__(self, api):
        self.aliases = {t["name"]: t["type"] for t in api["types"]}
        self.structs = {s["name"] for s in api["structs"]}

    def is_number(self, of):
        return self.aliases.get(of, of) in NUMBERS

    def is_value(self, of):
        return self.is_number(of) or of in self.structs and not of.endswith("_desc") and of not in HOOKS


def type_rules(api, types):
    for t in api["types"]:
        if t["type"] not in NUMBERS:
            yield f"{t['name']} is {t['type']}: numbers are float, int32_t or uint32_t"
    for enum in api["enums"]:
        if enum["name"] and not types.is_number(enum["name"]):
            yield f"{enum['name']} is no int32_t"
        for value in enum["values"]:
            if not value["name"].startswith("GPHYS_"):
                yield f"{value['name']} does not begin with GPHYS_"
            if value["name"].startswith("GPHYS_ERROR_") != (enum["name"] == "gphys_status" and value["value"] < 0):
                yield f"{value['name']} = {value['value']}: errors, and only they, are statuses below 0"


def struct_rules(struct, types):
    name, fields = struct["name"], struct["fields"]
    if name in HOOKS:
        return
    desc = name.endswith("_desc")
    for field in fields:
        if not types.is_value(field["type"]) and not (desc and field["type"] in POINTERS):
            yield f"{name}.{field['name']} is {field['type']}: fields are of 4 bytes each, float, int32_t or uint32_t"
    if not desc:
        return
    first, last = fields[0], fields[-1]
    if (first["name"], first["type"]) != ("struct_size", "uint32_t"):
        yield f"{name} does not begin with uint32_t struct_size"
    if [at + size for at, size in zip(last["offset"], last["size"])] != struct["size"]:
        yield f"{name} ends in padding behind {last['name']}: a reserved field goes there"


def function_rules(function, types):
    name = function["name"]
    if function["returns"] not in RETURNS:
        yield f"{name} returns {function['returns']}, not one of {', '.join(RETURNS)}"
    for p in function["parameters"]:
        of = p["type"]
        if not of.endswith("*") and not types.is_number(of):
            yield f"{name}: {p['name']} is {of}: numbers are float, int32_t or uint32_t, all else goes by pointer"
        if p["role"].startswith("out") and of.startswith("const "):
            yield f"{name}: {p['name']} is no output"


def comment_rules(api):
    """Each function has a comment of its own, that names its numbers and what it refuses beyond the conventions."""
    owners = {}
    for function in api["functions"]:
        name, doc = function["name"], function["doc"]
        if not doc:
            yield f"{name} has no comment of its own"
            continue
        if doc in owners:
            yield f"{name} has the comment of {owners[doc]}"
        owners[doc] = name
        for p in function["parameters"]:
            if p["role"] == "scalar" and p["type"] in ("float", "int32_t") and not re.search(rf"\b{p['name']}\b", doc):
                yield f"{name}: the comment does not say what {p['name']} is, in which unit and range"
            if p["role"] in ("in", "array") and p["type"].endswith("double *") and p["name"] not in doc:
                yield f"{name}: the comment does not say what {p['name']} is, in which unit and range"
        if not re.search(r"\bCost\b", doc):
            yield f"{name}: the comment does not say what it costs"


# Stated once for all functions, at the header's top.
COMMON = {"OK", "INCOMPLETE", "ERROR_INVALID_ARGUMENT", "ERROR_INVALID_ID", "ERROR_STRUCT_SIZE", "ERROR_OUT_OF_MEMORY"}


def test_rules(api, tests):
    """Each function is called by name in a C test, and a status that it is seen to return is in its comment."""
    text = {test: Path(test).read_text() for test in tests}
    called = {name for test in tests if test.endswith(".c") for name in re.findall(r"\bgphys_\w+", text[test])}
    every = "\n".join(text.values())
    seen = {}
    forms = (r"\bassert_int_equal\(\s*(gphys_\w+)\([^;]*?,\s*GPHYS_(\w+)\);", r"\b(gphys_\w+)\([^;=]*\)\s*==\s*GPHYS_(\w+)\b")
    for name, status in (found for form in forms for found in re.findall(form, every)):
        seen.setdefault(name, set()).add(status)
    for function in api["functions"]:
        name = function["name"]
        if name not in called:
            yield f"{name} is named by no test in tests_c"
        for status in sorted(seen.get(name, set()) - COMMON):
            if f"GPHYS_{status}" not in function["doc"] and not re.search(r"@return as gphys_", function["doc"]):
                yield f"{name}: the comment does not name GPHYS_{status}, which a test expects of it"


def found(api, tests):
    types = Types(api)
    yield from type_rules(api, types)
    for struct in api["structs"]:
        yield from struct_rules(struct, types)
    for function in api["functions"]:
        yield from function_rules(function, types)
    yield from comment_rules(api)
    if tests:
        yield from test_rules(api, tests)
    if len(version(api)) != 3:
        yield f"the version is {api['version']}: major, minor and patch are one number each"


def main():
    with open(sys.argv[1]) as file:
        wrong = list(found(json.load(file), sys.argv[2:]))
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
