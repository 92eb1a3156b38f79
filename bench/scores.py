#!/usr/bin/env python3
"""Adds up the scores of the exact suite: scores.py FILE... >docs/accuracy_scores.csv

Reads what tests_exact appends to the file that GAMEPHYS_SCORES names, in `./test.sh --long` to
build/*/exact_scores.csv. Parts of one function become one row, with the worst error of all and the
input that gave it.
"""
import csv
import pathlib
import sys

FIELDS = ["function", "build", "isa", "cases", "yes", "false", "worst", "bound", "unit", "input"]


def main():
    total = {}
    for name in sys.argv[1:]:
        with pathlib.Path(name).open(newline="") as file:
            for values in csv.reader(file):
                row = dict(zip(FIELDS, values, strict=True))
                for field in ("cases", "yes", "false"):
                    row[field] = int(row[field])
                key = (row["build"], row["isa"], row["function"])
                sum_of = total.setdefault(key, row)
                if sum_of is row:
                    continue
                # The input of a false answer counts for more than that of an error.
                if (row["false"] > 0, float(row["worst"])) > (sum_of["false"] > 0, float(sum_of["worst"])):
                    sum_of["worst"], sum_of["input"] = row["worst"], row["input"]
                for field in ("cases", "yes", "false"):
                    sum_of[field] += row[field]
    writer = csv.DictWriter(sys.stdout, FIELDS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(total[key] for key in sorted(total))


main()
