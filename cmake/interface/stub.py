#!/usr/bin/env python3
"""A C file that defines every function of a description, to do nothing: stub.py API.json HEADER

Compiled, it is a library with that interface and nothing else, for tools that compare binaries.
"""
import json
import sys

with open(sys.argv[1]) as file:
    api = json.load(file)
print(f'#include "{sys.argv[2]}"')
for function in api["functions"]:
    parameters = ", ".join(f'{p["type"]} {p["name"]}' for p in function["parameters"]) or "void"
    body = "" if function["returns"] == "void" else "return 0;"
    print(f'{function["returns"]} {function["name"]}({parameters}) {{ {body} }}')
