#!/usr/bin/env python3
"""The comparison in docs/solver.md from the measurements of a report: solver_comparison.py DIRECTORY PAGE

Reads each solver.csv and machine.txt in DIRECTORY, and replaces what is between the marks in PAGE. Every number there
comes from those files.
"""
import csv
import pathlib
import re
import sys

from report import number, put_between, rough, table

MARKS = ("<!-- comparison: written by ./bench.sh --report -->\n", "<!-- end of comparison -->\n")
# What a row shows: its words, the case, and the settings of gamephys.
ROWS = [
    ("rope of 1000 links, weight 10^3", "rope_1e3", ["4"]),
    ("the same, 10^6", "rope_1e6", ["4"]),
    ("1000 ropes of 30 links", "ropes_1000x30", ["1", "2"]),
    ("cloth of 100 x 100, two corners", "cloth_100", ["20"]),
    ("the same with bending", "cloth_100_bend", ["20"]),
    ("2000 balls poured into a pit: overlap", "ball_pit", ["4", "8"]),
    ("rope over a post, 1 kg against 3 kg: error of the fall", "rope_over_post", ["4", "8"]),
]
CLOTH = ("cloth_100", "cloth_100_bend")
TEXT = """
The largest stretch of links, and the processor time of a 60 Hz frame, on one core of {processor}; over ten seconds, or five for the many ropes. Where a row says so, the error is another one: the largest overlap of two balls or of a ball and the pit in four seconds; and how far from the exact place the heavier end of a rope without friction is, after it has fallen for 0.6 s. [solver_figures.md](solver_figures.md) has every row of the run.

{rows}Links of the cloth are also compressed, by up to {own}; Bullet's by up to {other}.

{rain}"""
RAIN = """{many:,} free particles in clouds of a thousand rain on 1000 boxes. A particle costs {flying} ns a frame in flight, {landing} ns while most land, {lying} ns at rest; {steady} ns at rest in steps of equal length.{bullet}
"""
BULLET_RAIN = " Bullet's soft bodies without links cost {flying}, {landing} and {lying} ns for 100,000 particles, some of which fall through the ground."


def percent(text):
    return f"{rough(100 * float(text))} %"


def error(row):
    if row["position_error"]:
        return f"{rough(1000 * float(row['position_error']))} mm"
    return "unstable" if row["strain_max"] == "inf" else percent(row["strain_max"])


def cell(found, settings):
    """settings: of the rows, with what is said of each."""
    return ", ".join(f"{error(found[key])} in {number(float(found[key]['ms']))} ms{said}" for key, said in settings if key in found)


def rain(found, method, count, many):
    """{when: ns a particle} of the rows of a rain, or None."""
    rows = {when: found.get((f"free_{many}_{when}", method, "1")) for when in ("flying", "landing", "lying", "steady")}
    return {when: number(1e6 * float(row["ms"]) / count) for when, row in rows.items()} if all(rows.values()) else None


def comparison(rows, machine):
    found = {(row["case"], row["method"], row["substeps"]): row for row in rows}
    lines = []
    for words, case, settings in ROWS:
        own = [((case, "gamephys", n), f" ({n} substep{'s' if n != '1' else ''})") for n in settings]
        steps = [((case, "bullet_substeps", n), f" ({n} substeps)") for n in settings]
        others = [[((case, "bullet", n), "")] + (steps if n == "50" else []) for n in ("10", "50")]
        if any(key in found for key, _ in own):
            lines.append([words, cell(found, own), *(cell(found, other) for other in others)])
    compressed = {method: max(float(row["compression_max"]) for row in rows if row["case"] in CLOTH and row["method"] == method)
                  for method in ("gamephys", "bullet")}
    own, other = rain(found, "gamephys", 1e6, "1M"), rain(found, "bullet", 1e5, "100k")
    falling = RAIN.format(many=1000000, **own, bullet=BULLET_RAIN.format(**other) if other else "") if own else ""
    processor = re.search("^Processor: (.*), [0-9]+ cores", machine, re.M)[1]
    return TEXT.format(processor=processor, rain=falling, own=percent(compressed["gamephys"]), other=percent(compressed["bullet"]),
                       rows=table(["case", "gamephys", "Bullet, 10 iterations", "50 iterations"], lines))


def main():
    directory, page = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    rows = []
    for path in sorted(directory.glob("*/solver.csv")):
        with path.open(newline="") as file:
            rows += csv.DictReader(file)
    put_between(page, MARKS, comparison(rows, (directory / "machine.txt").read_text()))


if __name__ == "__main__":
    main()
