#!/usr/bin/env bash
# manual.sh links: every link of the pages leads somewhere. manual.sh site: the manual builds without a warning, the
# site has a page for each function's section, and its theme needs no server. The status 77 says that Sphinx is not
# installed.
source "$SOURCE/tests_package/common.sh"
if [ "$1" = links ]; then
    exec python3 "$SOURCE/docs/site/links.py" "$SOURCE"
fi
for python in /usr/bin/python3 python3; do
    "$python" -c 'import sphinx, myst_parser, furo' 2>/dev/null || continue
    PYTHONDONTWRITEBYTECODE=1 "$python" "$SOURCE/docs/site/build.py" "$SOURCE" .
    grep -q 'id="c.gphys_scene_raycast"' html/reference/scene.html || fail "the reference has no gphys_scene_raycast"
    grep -q 'gphys_scene_raycast' html/searchindex.js || fail "the search knows no gphys_scene_raycast"
    ! grep -E '^import |url\(/' html/_static/scripts/furo.js html/_static/styles/furo.css ||
        fail "the theme refers to a file that a page without a server cannot read"
    exit
done
echo "python3-sphinx, python3-myst-parser or furo is not installed"
exit 77
