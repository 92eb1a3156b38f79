#!/usr/bin/env python3
"""Whether the tests of a language called every C function: check.py API.json LANGUAGE CALLS

CALLS is the folder with what recorded.sh wrote, LANGUAGE/TEST. A function that a language leaves out
on purpose is listed in left_out.json beside this file, with the reason.
"""
import json
import sys
from pathlib import Path


def called(folder, language):
    """The C functions that the tests of a language called."""
    return {name for file in (Path(folder) / language).glob("*") for name in file.read_text().split()}


def left_out():
    """language -> function -> reason"""
    return json.loads(Path(__file__).with_name("left_out.json").read_text())


def main():
    with open(sys.argv[1]) as file:
        functions = [f["name"] for f in json.load(file)["functions"]]
    language = sys.argv[2]
    reached, excused = called(sys.argv[3], language), left_out().get(language, {})
    wrong = [f"{name}: called by no test" for name in functions if name not in reached and name not in excused]
    wrong += [f"{name}: said to be left out, but called" for name in functions if name in reached and name in excused]
    wrong += [f"{name}: no function of the library" for name in [*reached, *excused] if name not in functions]
    print("\n".join(wrong) or f"{language}: {len(reached)} functions of {len(functions)} called")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
