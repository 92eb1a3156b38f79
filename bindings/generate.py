#!/usr/bin/env python3
"""Write what the bindings take from the header: generate.py gamephys_api.json DIRECTORY

Each module in generators/ makes the files of one language.
"""
import importlib
import json
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is


def main():
    with open(sys.argv[1]) as file:
        api = json.load(file)
    for module in sorted((Path(__file__).parent / "generators").glob("[a-z]*.py")):
        files = importlib.import_module(f"generators.{module.stem}").generate(api)
        for name, text in files.items():
            path = Path(sys.argv[2]) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)


if __name__ == "__main__":
    main()
