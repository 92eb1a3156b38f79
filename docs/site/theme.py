"""Files of the theme in the form that a page needs which is opened from a disk, without a server.

Debian's copies refer to further files: furo.js imports one, which a page from a file may not do, and furo.css names
one by its place on Debian's web servers. Each gets what it refers to. Copies from elsewhere stay as they are."""
from pathlib import Path

import furo

IMPORT = 'import Gumshoe from "./gumshoe-patched.js";\n'
STYLE = "/javascript/normalize.css/normalize.css"

# The search shows the text around what it finds by reading the pages, which a page from a file may not do either.
SEARCH = 'if (location.protocol === "file:") DOCUMENTATION_OPTIONS.SHOW_SEARCH_SUMMARY = false;\n'


def write_theme_files(static):
    theme = Path(furo.__file__).parent / "theme/furo/static"
    script = (theme / "scripts/furo.js").read_text()
    if IMPORT in script:
        script = (theme / "scripts/gumshoe-patched.js").read_text() + f"(() => {{{script.replace(IMPORT, '')}}})();\n"
    style = (theme / "styles/furo.css").read_text()
    if STYLE in style:
        style = style.replace(f"@import url({STYLE});", Path("/usr/share" + STYLE).read_text())
    for name, text in (("scripts/furo.js", script), ("styles/furo.css", style), ("search_of_files.js", SEARCH)):
        (static / name).parent.mkdir(parents=True, exist_ok=True)
        (static / name).write_text(text)
