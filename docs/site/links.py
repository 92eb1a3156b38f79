#!/usr/bin/env python3
"""Checks the links of the Markdown pages: links.py SOURCE

Every relative link and picture must lead to a file or folder of the repository, every #anchor to a heading of
its page, and every `tests_cpp "name"` to a test of that name. Addresses of other sites are not fetched. Headings get anchors as GitHub makes them: lower case, spaces to
hyphens, other signs dropped, a number behind those that come again.
"""
import re
import sys
from pathlib import Path

FENCE = re.compile(r"^(```|~~~).*?^\1\s*$", re.M | re.S)
LINK = re.compile(r"!?\[(?:[^\[\]]|!?\[[^\]]*\]\([^)]*\))*\]\(([^)\s]+)(?:\s+\"[^\"]*\")?\)")
INNER = re.compile(r"!\[[^\]]*\]\(([^)\s]+)\)")


def without_code(text):
    """A text as long, with blanks for code blocks and spans, so that what looks like a link there is none."""
    text = FENCE.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)
    return re.sub(r"`[^`\n]*`", lambda match: "x" * len(match.group()), text)


def slug(heading):
    heading = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", heading).replace(" ", "-")


def anchors(path):
    found, seen = set(), {}
    for heading in re.findall(r"^#{1,6} +(.*)$", FENCE.sub("", path.read_text()), re.M):
        name = slug(heading)
        seen[name] = seen.get(name, -1) + 1
        found.add(f"{name}-{seen[name]}" if seen[name] else name)
    return found


def links(text):
    """(line, target) of each link and picture."""
    text = without_code(text)
    for pattern in (LINK, INNER):
        for match in pattern.finditer(text):
            yield text.count("\n", 0, match.start()) + 1, match.group(1)


def pages(source):
    skip = {"node_modules", "target", "build", ".git"}
    return [path for path in sorted(source.rglob("*.md"))
            if not any(part in skip or part.startswith("build-") for part in path.relative_to(source).parts)]


def main():
    source = Path(sys.argv[1]).resolve()
    wrong, count = [], 0
    tests = "\n".join(path.read_text() for path in source.glob("tests_cpp/**/*.cpp"))
    for page in pages(source):
        for line, target in sorted(set(links(page.read_text()))):
            if re.match(r"[a-z]+:", target):
                continue
            count += 1
            name, _, anchor = target.partition("#")
            where = (page.parent / name).resolve() if name else page
            place = f"{page.relative_to(source)}:{line}: {target}"
            if source not in where.parents and where != source:
                wrong.append(f"{place}: outside of the repository")
            elif not where.exists():
                wrong.append(f"{place}: no such file")
            elif anchor and (where.suffix != ".md" or anchor not in anchors(where)):
                wrong.append(f"{place}: no such heading")
        for name in re.findall(r"`tests_cpp \"([^\"`]*)\"`", page.read_text()):
            if f'"{name.rstrip("*")}' not in tests:
                wrong.append(f"{page.relative_to(source)}: no test is named {name}")
    print("\n".join(wrong) or f"{count} links, all of them lead somewhere")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
