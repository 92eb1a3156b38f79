#!/usr/bin/env python3
"""Runs the programs of the manual: programs.py [--write] SOURCE WORK LANGUAGE COMMAND...

A program is a code block of LANGUAGE (c, python or js) on a page below docs/guide or docs/coming_from. What it prints
must be the next block of the page, a text block; --write puts it there. COMMAND runs a file that is given as its last
argument; for C it compiles it: the file and "-o PROGRAM" come behind the compiler, and before the other arguments.
The numbers printed are the same on every machine, so they are compared as they are.
"""
import re
import subprocess
import sys
from pathlib import Path

SUFFIX = {"c": "c", "python": "py", "js": "mjs"}


def run(language, command, file):
    if language == "c":
        program = file.with_suffix("")
        subprocess.run([command[0], str(file), "-o", str(program), *command[1:]], check=True)
        command = [str(program)]
    else:
        command = [*command, str(file)]
    return subprocess.run(command, cwd=file.parent, check=True, stdout=subprocess.PIPE, text=True, timeout=60).stdout


def main():
    arguments = sys.argv[1:]
    write = arguments[:1] == ["--write"]
    source, work, language, *command = arguments[write:]
    block = re.compile(rf"^```{language}\n(.*?)^```\n(?:\n```text\n(.*?)^```\n)?", re.M | re.S)
    count, wrong = 0, []
    for page in sorted([*Path(source).glob("docs/guide/*.md"), *Path(source).glob("docs/coming_from/*.md")]):
        text = page.read_text()
        place, parts = 0, []
        for match in block.finditer(text):
            name = f"{page.stem}_{count}"
            count += 1
            file = Path(work).resolve() / f"{name}.{SUFFIX[language]}"
            file.write_text(match.group(1))
            said = run(language, command, file)
            if said != match.group(2):
                wrong.append(f"{page.relative_to(source)}: program {count} prints\n{said}not\n{match.group(2)}")
            parts += [text[place:match.start()], f"```{language}\n{match.group(1)}```\n\n```text\n{said}```\n"]
            place = match.end()
        if write and parts:
            page.write_text("".join(parts) + text[place:])
    if not count:
        sys.exit(f"no page has a program in {language}")
    if wrong and not write:
        sys.exit("\n".join(wrong))
    print(f"{count} programs print what the pages say" if not write else f"{count} programs run, {len(wrong)} pages changed")


main()
