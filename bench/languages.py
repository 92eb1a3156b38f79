"""What a call costs from each language: a table, a figure, and which languages could not be measured."""
import csv
import sys
from pathlib import Path

import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter

sys.path.insert(0, str(Path(__file__).parent.parent / "bindings"))
from document import CASES, LANGUAGES
from report import number, table

TEXT = """Nanoseconds per call through the package of the language, the fastest of the rounds, with the library's own work: a boolean for a number, a vector, one ray that hits, and each ray of a batch of 1000. [bindings.md](bindings.md) describes the packages.

![Time of a call from each language](images/report_languages.png)

{table}{missing}"""
NOTHING = "Not measured here: the packages of languages are not built. After `./test.sh --bindings` the report has them.\n"
COLOURS = ("#56B4E9", "#0072B2", "#D55E00", "#E69F00")  # of the cases; Okabe and Ito


def figure(times, path):
    languages = [language for language in LANGUAGES if language in times][::-1]
    drawing, axes = plt.subplots(figsize=(12, 0.45 * len(languages) + 1.4), layout="constrained")
    for y, language in enumerate(languages):
        found = times[language]
        axes.plot([min(found.values()), max(found.values())], [y, y], color="#bbbbbb", zorder=1)
        for case, marker, colour in zip(CASES, "sD^o", COLOURS):
            axes.plot([found[case]], [y], marker, color=colour, markeredgecolor="white", label=CASES[case] if y == 0 else None)
    axes.set_xscale("log")
    axes.set_yticks(range(len(languages)), [LANGUAGES[language][0] for language in languages])
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,g}"))
    axes.set_xlabel("ns per call, and per ray of a batch")
    axes.set_title("A call from each language", loc="left")
    axes.legend(loc="center left", bbox_to_anchor=(1, 0.5))
    drawing.savefig(path.with_suffix(".svg"), metadata={"Date": None})
    drawing.savefig(path.with_suffix(".png"))
    plt.close(drawing)


def languages(directory, images):
    """The text of the report from overhead/overhead.csv in the directory, with a figure, if there are measurements."""
    times = {}
    measured = directory / "overhead/overhead.csv"
    if measured.exists():
        with measured.open(newline="") as file:
            for row in csv.DictReader(file):
                times.setdefault(row["language"], {})[row["case"]] = float(row["ns"])
    if not times:
        return NOTHING
    figure(times, images / "report_languages")
    missing = [name for language, (name, *_) in LANGUAGES.items() if language not in times]
    note = f"Not measured here, as the language or its package is not installed: {', '.join(missing)}.\n" if missing else ""
    rows = [[LANGUAGES[language][0], *(f"{number(times[language][case])} ns" for case in CASES)] for language in LANGUAGES if language in times]
    return TEXT.format(table=table(["language", *CASES.values()], rows), missing=note)
