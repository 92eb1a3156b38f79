"""Settings of Sphinx for the manual. build.py makes the tree of pages that this reads."""
project = "gamephys"
author = "the gamephys authors"
extensions = ["myst_parser"]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
root_doc = "index"
html_theme = "furo"
html_title = "gamephys"
html_copy_source = False
html_show_sphinx = False
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_js_files = ["search_of_files.js"]
html_theme_options = {"navigation_with_keys": True}
primary_domain = "c"
highlight_language = "text"
c_id_attributes = ["GPHYS_API"]
# Names of every type and function in a comment must exist; these are C's own.
nitpicky = True
nitpick_ignore = [("c:identifier", name) for name in ("int32_t", "uint32_t", "size_t")]
# A heading has the anchor that Git hosts give it, so that a link works there and here.
myst_heading_anchors = 4
myst_all_links_external = False
