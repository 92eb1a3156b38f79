#!/usr/bin/env python3
"""A C file that defines every function of a description, to do nothing: stub.py API.json HEADER

Compiled, it is a library with that interface and nothing else, for tools that compare binaries. Only
its version and the names of statuses are those of a library.
"""
import json
import sys

with open(sys.argv[1]) as file:
    api = json.load(file)
print(f'#include "{sys.argv[2]}"')
statuses = next(enum["values"] for enum in api["enums"] if enum["name"] == "gphys_status")
names = " ".join(f'case {v["value"]}: return "{v["name"]}";' for v in statuses)
bodies = {
    "gphys_version": "return {} << 16 | {} << 8 | {};".format(*api["version"].split(".")),
    "gphys_status_name": f'switch (status) {{ {names} }} return "unknown";',
    "gphys_last_error": 'return "";',
}
for function in api["functions"]:
    parameters = ", ".join(f'{p["type"]} {p["name"]}' for p in function["parameters"]) or "void"
    body = bodies.get(function["name"], "" if function["returns"] == "void" else "return 0;")
    print(f'{function["returns"]} {function["name"]}({parameters}) {{ {body} }}')
