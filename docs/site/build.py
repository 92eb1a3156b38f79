#!/usr/bin/env python3
"""Builds the manual: build.py SOURCE OUTPUT

Puts the pages of the repository and the reference into OUTPUT/source, as they lie in the repository, and has Sphinx
write OUTPUT/html. A warning is an error. Files that pages link to become downloads.
"""
import os
import re
import shutil
import sys
from pathlib import Path

from links import without_code, FENCE, LINK, INNER
from reference import MACROS, Reference

GUIDE = ["first_scene", "queries", "camera", "batches", "large_worlds", "threads", "solver", "saving", "engine", "web",
         "robot", "cluster"]
HOW = ["bvh", "exactness"]
SOLVER = ["ropes", "cloth", "rest", "particles", "features", "performance", "limits", "experiments"]
COMING_FROM = ["bullet", "jolt", "box3d", "embree", "three_raycaster", "trimesh", "cookbook"]
CHAPTERS = [
    ("Guide", [f"docs/guide/{page}" for page in GUIDE]),
    ("Coming from", [f"docs/coming_from/{page}" for page in COMING_FROM]),
    ("Reference", ["reference/index"]),
    ("Languages", ["docs/bindings", *(f"bindings/{name}/README" for name in
                   ("cpp", "python", "javascript", "rust", "go", "csharp", "java", "lua", "ruby"))]),
    ("How it works", ["docs/architecture", *(f"docs/how/{page}" for page in HOW), "docs/limits_of_speed", "docs/code_paths"]),
    ("How the solver works", ["docs/solver", *(f"docs/solver/{page}" for page in SOLVER)]),
    ("Measurements", ["docs/report", "docs/solver_figures", "docs/accuracy"]),
    ("Project", ["docs/reliability", "docs/functions", "docs/releasing", "CHANGELOG", "CONTRIBUTING"]),
]


def place_page(source, tree, name, functions):
    """A page with its links made ready: to the header and to folders where they have a page. Names of functions in
    code spans lead to the reference."""
    page = source / f"{name}.md"
    text = page.read_text()
    here = page.parent

    def lead(target):
        """Where a link leads in the site; None: nowhere."""
        path, _, anchor = target.partition("#")
        if not path or re.match(r"[a-z]+:", path):
            return target
        file = (here / path).resolve()
        if file.is_dir():
            if page_name(file / "README.md") not in PAGES:
                return None  # the site has no listing of folders
            file = file / "README.md"
        elif file == source / "include/gamephys_c.h":
            file = source / "reference/index.rst"
        elif page_name(file) not in PAGES:
            copy = tree / file.relative_to(source)
            copy = copy.with_suffix(".md.txt") if file.suffix == ".md" else copy
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, copy)
            file = source / copy.relative_to(tree)
        return os.path.relpath(file, here) + (f"#{anchor}" if anchor else "")

    def page_name(file):
        return str(file.relative_to(source).with_suffix(""))

    # Links are found where no code is, and replaced from the end.
    for pattern in (INNER, LINK):
        for match in sorted(pattern.finditer(without_code(text)), key=lambda found: -found.start()):
            new = lead(match.group(1))
            if new is None:
                text = text[:match.start()] + text[match.start() + 1:match.start(1) - 2] + text[match.end():]
            else:
                text = text[:match.start(1)] + new + text[match.end(1):]
    text = linked_functions(text, functions)
    target = tree / f"{name}.md"
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(text)


def linked_functions(text, functions):
    def mark(match):
        return f"{{c:func}}`{match.group(1)}`" if match.group(1) in functions else match.group()

    parts, place = [], 0
    for fence in [*FENCE.finditer(text), None]:
        end = fence.start() if fence else len(text)
        parts.append(re.sub(r"(?<![\[`{}])`(gphys_\w+)(?:\(\))?`(?!\])", mark, text[place:end]))
        if fence:
            parts.append(fence.group())
            place = fence.end()
    return "".join(parts)


PAGES = {"README"} | {page for _, pages in CHAPTERS for page in pages}


def index():
    lines = ["gamephys", "========", "", "A 3D scene library that any language can call: build a scene of shapes and meshes, query it, view it",
             "through a camera that culls and picks, and simulate particles, ropes and cloth in it.", "",
             ".. image:: docs/images/scene.png", "   :alt: Copies of a mesh around a statue under a cloth", "",
             "The guide is in the order in which most projects need it. The tests compile and run every program in it,",
             "and compare the output with the block below the program.", "",
             ".. toctree::", "   :caption: Start", "", "   README", ""]
    for caption, pages in CHAPTERS:
        lines += [".. toctree::", f"   :caption: {caption}", "   :maxdepth: 1", "", *(f"   {page}" for page in pages), ""]
    return "\n".join(lines)


def main():
    source, output = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    missing = [page for page in PAGES if page != "reference/index" and not (source / f"{page}.md").exists()]
    unlisted = [path.stem for folder in ("", "guide/", "coming_from/", "how/", "solver/") for path in source.glob(f"docs/{folder}*.md")
                if f"{path.relative_to(source).with_suffix('')}" not in PAGES]
    if missing or unlisted:
        sys.exit(f"missing pages: {missing}; pages that are in no chapter: {unlisted}")
    tree = output / "source"
    shutil.rmtree(tree, ignore_errors=True)
    reference = Reference(source)
    for page in PAGES - {"reference/index"}:
        place_page(source, tree, page, reference.functions)
    shutil.copytree(source / "docs/images", tree / "docs/images", dirs_exist_ok=True)
    (tree / "_static").mkdir()
    shutil.copyfile(source / "docs/site/site.css", tree / "_static/site.css")
    from theme import write_theme_files
    write_theme_files(tree / "_static")
    (tree / "reference").mkdir()
    for name, text in reference.pages().items():
        (tree / "reference" / f"{name}.rst").write_text(text + "\n")
    for path in {MACROS}.union(*reference.programs.values()):
        if not path.endswith(".md"):
            (tree / path).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source / path, tree / path)
    (tree / "index.rst").write_text(index())
    from sphinx.cmd.build import build_main
    version = reference.api["version"]
    status = build_main(["-q", "-W", "--keep-going", "-E", "-b", "html", "-c", str(source / "docs/site"), "-D",
                         f"version={version}", "-D", f"release={version}", "-D", f"html_static_path={tree / '_static'}",
                         "-d", str(output / "doctrees"), str(tree), str(output / "html")])
    sys.exit(status)


main()
