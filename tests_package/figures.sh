#!/usr/bin/env bash
# The figures of the report: labels do not overlap, and none is lost silently. 77: matplotlib is not installed.
source "$SOURCE/tests_package/common.sh"
python=/usr/bin/python3
[ -x $python ] || python=python3
PYTHONDONTWRITEBYTECODE=1 exec $python "$SOURCE/bench/figures/test_figures.py"
