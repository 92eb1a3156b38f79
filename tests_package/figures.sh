#!/usr/bin/env bash
# The report: an interrupted run goes on where it was; tables and sentences say what was measured; labels of figures do
# not overlap, and none is lost silently. 77: matplotlib is not installed.
source "$SOURCE/tests_package/common.sh"
python=/usr/bin/python3
[ -x $python ] || python=python3
export PYTHONDONTWRITEBYTECODE=1
$python "$SOURCE/bench/test_run_report.py"
$python "$SOURCE/bench/test_report.py"
exec $python "$SOURCE/bench/figures/test_figures.py"
