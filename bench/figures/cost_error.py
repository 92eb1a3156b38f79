"""Cost against error: a panel for each kind of work, both axes logarithmic, errors of zero on a band of their own."""
import math

import matplotlib.pyplot as plt
from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator, NullFormatter, NullLocator

from labels import place_labels
from marks import look


def front(points):
    """Those that nobody beats in both: sorted by cost, each with less error than all before."""
    best, chosen = math.inf, []
    for cost, error, *rest in sorted(points):
        if error < best:
            chosen.append((cost, error))
            best = error
    return chosen


def power(exponent):
    return f"$10^{{{exponent}}}$"


class ErrorAxis:
    """Where errors are drawn: decades, and zero below them behind a break."""

    def __init__(self, errors, of_shares):
        positive = [error for error in errors if error > 0]
        nothing = (-3, -1) if of_shares else (-8, -4)  # the decades shown where no error is above zero
        self.low = math.floor(math.log10(min(positive))) if positive else nothing[0]
        self.high = math.ceil(math.log10(max(positive))) if positive else nothing[1]
        if of_shares:  # which end at 100 %
            self.high = min(self.high, 0)
            self.low = min(self.low, self.high - 2)
        self.high = max(self.high, self.low + 2)
        self.zero = len(positive) < len(errors)  # whether there is one
        self.gap = 0.42 * (self.high - self.low)

    def __call__(self, error):
        return math.log10(error) if error > 0 else self.low - self.gap

    def dress(self, axes, format_decade):
        """Limits and ticks; returns the height of the break, or None."""
        span = self.high - self.low
        step = max(1, round(span / 5))
        decades = list(range(self.low, self.high + 1, step))
        axes.set_ylim(self.low - (1.7 * self.gap if self.zero else 0.1 * span), self.high + 0.16 * span)
        if not self.zero:
            axes.yaxis.set_major_locator(FixedLocator(decades))
            axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: format_decade(round(value))))
            return None
        axes.yaxis.set_major_locator(FixedLocator([self.low - self.gap, *decades]))
        labels = {self.low - self.gap: "0", **{d: format_decade(d) for d in decades}}
        axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: labels.get(value, "")))
        middle = self.low - 0.3 * self.gap
        axes.axhspan(axes.get_ylim()[0], middle, color="#f1f5f0", zorder=0)
        axes.axhline(middle, color="#888888", linewidth=1, linestyle=(0, (4, 3)))
        # The break of the axis itself.
        for shift in (-0.033, 0.033):
            axes.plot([-0.018, 0.018], [middle + (shift - .02) * self.gap * 2, middle + (shift + .02) * self.gap * 2],
                      color="black", linewidth=1, clip_on=False,
                      transform=axes.get_yaxis_transform())
        return middle


def panel(axes, title, points, cost_label, error_label, percent=False):
    """points: (cost, the ends of its bar or None, error, library, label). Returns what place_labels needs."""
    scale = ErrorAxis([error for _, _, error, _, _ in points], percent)
    axes.set_xscale("log")
    costs = [cost for cost, *_ in points]
    axes.set_xlim(min(costs) / 2.2, max(max(costs) * 2.6, min(costs) * 12))
    # Over many decades, labels of 1, 2 and 5 would touch each other.
    axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5) if max(costs) < 30 * min(costs) else (1,)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.12g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_title(title, loc="left")
    axes.set_xlabel(cost_label)
    axes.set_ylabel(error_label)
    middle = scale.dress(axes, (lambda d: f"{100 * 10.0 ** d:.{max(0, -2 - d)}f} %") if percent else power)
    line = front([(cost, error) for cost, _, error, _, _ in points])
    xs, ys = [line[0][0]], [axes.get_ylim()[1]]
    for cost, error in line:
        xs += [cost, cost]
        ys += [ys[-1], scale(error)]
    xs.append(axes.get_xlim()[1])
    ys.append(ys[-1])
    axes.plot(xs, ys, color="#bbbbbb", linewidth=1.4, zorder=1)
    for cost, bar, error, library, _ in points:
        colour, marker = look(library)
        if bar:
            axes.plot(bar, [scale(error)] * 2, color=colour, linewidth=4, alpha=0.5, solid_capstyle="butt", zorder=2)
            axes.plot([min(cost, bar[0]), max(cost, bar[1])], [scale(error)] * 2, color=colour, linewidth=1, zorder=2)
        axes.plot([cost], [scale(error)], marker=marker, color=colour, markeredgecolor="white", markeredgewidth=0.8,
                  zorder=5 if library == "gamephys" else 3)
    axes.yaxis.set_minor_locator(NullLocator())
    labels = [(cost, scale(error), label, look(library)[0], error == 0) for cost, _, error, library, label in points]
    bars = [(min(cost, bar[0]), scale(error), max(cost, bar[1])) for cost, bar, error, _, _ in points if bar]
    lines = [list(zip(xs, ys))]
    if middle is not None:
        lines.append([(x, middle) for x in axes.get_xlim()])
    return axes, labels, bars, lines


def figure(path, panels, cost_label, error_label, percent=False, columns=2):
    """Writes path.svg and path.png. panels: (title, points). error_label may be one for each panel. Returns the labels
    for which there was no room."""
    rows = -(-len(panels) // columns)
    drawing, grid = plt.subplots(rows, columns, figsize=(6 * columns, 4.4 * rows), squeeze=False, layout="constrained")
    places = [axes for row in grid for axes in row]
    for axes in places[len(panels):]:
        axes.axis("off")
    drawn = [panel(axes, title, points, cost_label, error_label if isinstance(error_label, str) else error_label[i], percent)
             for i, (axes, (title, points)) in enumerate(zip(places, panels))]
    drawing.canvas.draw()  # labels are placed when everything else has its place, and moves no more
    drawing.set_layout_engine("none")
    lost = [f"{path.name}: {title}: {label}" for (title, _), parts in zip(panels, drawn) for label in place_labels(*parts)]
    drawing.savefig(path.with_suffix(".svg"), metadata={"Date": None})
    drawing.savefig(path.with_suffix(".png"))
    plt.close(drawing)
    return lost
