"""Labels beside the points of a panel: readable, apart from one another, and each clearly of its own point."""
import random
from dataclasses import dataclass

from matplotlib.colors import to_hex, to_rgb
from matplotlib.path import Path
from matplotlib.transforms import Bbox

ATTEMPTS = 40  # orders in which the labels of a panel choose their places; up to ten times as many if some find none


@dataclass
class Label:
    text: str
    colour: str
    at: tuple  # the point, in pixels
    size: tuple
    always_led: bool  # a line leads to the point even where the label is next to it


@dataclass
class Place:
    at: tuple  # the point
    box: Bbox
    leader: Path  # or None
    cost: float


def luminance(colour):
    """0 is black, 1 is white (WCAG 2)."""
    return sum(weight * (part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4)
               for weight, part in zip((0.2126, 0.7152, 0.0722), to_rgb(colour)))


def ink(colour):
    """The colour for text on white: so dark that its contrast is 4.5 : 1."""
    rgb = to_rgb(colour)
    while luminance(rgb) > 1.05 / 4.5 - 0.05:
        rgb = [0.95 * part for part in rgb]
    return to_hex(rgb)


def apart(point, box):
    """How far a point is from a box, in pixels."""
    return max(box.x0 - point[0], 0, point[0] - box.x1) + max(box.y0 - point[1], 0, point[1] - box.y1)


def same_place(point, other):
    """Whether nobody can tell the marks of two points apart."""
    return abs(point[0] - other[0]) + abs(point[1] - other[1]) < 4


def leader_from(box, point):
    """From the edge of a label to its point; not from a corner, if the point is above or below."""
    inset = 0 if box.y0 < point[1] < box.y1 else min(10, box.width / 2)
    start = min(max(point[0], box.x0 + inset), box.x1 - inset), min(max(point[1], box.y0), box.y1)
    return Path([start, point])


def padded(box, across, along):
    return Bbox([[box.x0 - across, box.y0 - along], [box.x1 + across, box.y1 + along]])


class Panel:
    """What is in the way of labels, in pixels: points, bars, lines and the border."""

    def __init__(self, inside, points, bars, lines, scale):
        self.inside, self.scale = inside, scale
        self.points = points
        self.marks = [Bbox([[x - 6, y - 6], [x + 6, y + 6]]) for x, y in points]
        self.marks += [Bbox([[x - 3, y - 3], [end + 3, y + 3]]) for x, y, end in bars]
        self.lines = [Path(line) for line in lines]

    def places(self, label):
        """Where a label may be if no other is there: rows above and below the point, the cheapest first. It covers no
        mark. It costs more to be far away, to cover a line, or to be nearer to the point of another label."""
        (x, y), (width, height) = label.at, label.size
        gap, pitch = 9 * self.scale, height + 3 * self.scale
        sideways = [width / 2 + gap + more * self.scale for more in (0, 14, 30, 50, 80, 120)]
        found = []
        for row in range(-9, 10):
            middle = y if row == 0 else y + (1 if row > 0 else -1) * (11 * self.scale + height / 2 + (abs(row) - 1) * pitch)
            offsets = sideways if row == 0 else [0, width / 4, width / 2 - gap, *sideways]
            for offset in sorted({side * offset for offset in offsets for side in (1, -1)}, key=abs):
                box = Bbox.from_bounds(x + offset - width / 2, middle - height / 2, width, height)
                if (box.x0 < self.inside.x0 + 6 or box.x1 > self.inside.x1 or box.y0 < self.inside.y0 + 2 or box.y1 > self.inside.y1
                        or any(padded(box, 2, 0).overlaps(mark) for mark in self.marks)):
                    continue
                found.append(self.judged(label, box))
        return sorted(found, key=lambda place: place.cost)

    def judged(self, label, box):
        own = apart(label.at, box)
        foreign = min((apart(point, box) for point in self.points if point != label.at), default=1e9)
        clear = own < 12 * self.scale and foreign > 1.6 * own
        leader = None if clear and not label.always_led else leader_from(box, label.at)
        cost = own + (0 if clear else 8) + 0.02 * abs(label.at[0] - (box.x0 + box.x1) / 2)
        if foreign < own:
            cost += 50 + own - foreign
        cost += 12 * sum(line.intersects_bbox(padded(box, 1, 1), filled=False) for line in self.lines)
        if leader:
            cost += 60 * sum(leader.intersects_bbox(mark, filled=False) for mark, point in zip(self.marks, self.points)
                             if not same_place(point, label.at))
        return Place(label.at, box, leader, cost)


def fits(place, chosen):
    """Whether a label and its line touch none of those that have their places. Lines to the same place may go behind
    each other's labels: they make a stack."""
    around = padded(place.box, 4, 2)
    for other in chosen:
        if around.overlaps(other.box):
            return False
        if same_place(place.at, other.at):
            continue
        if other.leader and other.leader.intersects_bbox(around):
            return False
        if place.leader and (place.leader.intersects_bbox(padded(other.box, 4, 2))
                             or other.leader and place.leader.intersects_path(other.leader)):
            return False
    return True


def choose(choices):
    """A place of each label, or None, such that all fit together: the cheapest of several attempts, in each of which
    the labels choose one after the other. As long as some find no place, others try places that are not their best."""
    shuffled, best, best_cost = random.Random(1), None, None
    order = sorted(range(len(choices)), key=lambda i: len(choices[i]))
    for attempt in range(10 * ATTEMPTS):
        chosen = {}
        for i in order:
            places = choices[i] if attempt < ATTEMPTS else sorted(choices[i], key=lambda place: place.cost * shuffled.uniform(1, 3))
            chosen[i] = next((place for place in places if fits(place, [other for other in chosen.values() if other])), None)
        cost = (sum(place is None for place in chosen.values()), sum(place.cost for place in chosen.values() if place))
        if best is None or cost < best_cost:
            best, best_cost = chosen, cost
        if cost[0] > 20 or (attempt >= ATTEMPTS and best_cost[0] == 0):
            break  # far too many for any order, or done
        order = shuffled.sample(order, len(order))
    return [best[i] for i in range(len(choices))]


def place_labels(axes, points, bars, lines, size=12):
    """Writes a label beside each (x, y, text, colour, always led) where it covers neither a point, nor a bar (x, y,
    other x), nor another label, nor the border; nor, if there is room, a line (a list of corners). A thin line leads
    from a label to its point wherever the label alone does not tell. The figure has been drawn.

    Returns the labels for which no free place was found, which is an error of the figure."""
    renderer = axes.figure.canvas.get_renderer()
    to_pixels = axes.transData.transform

    def extent(text):
        probe = axes.text(0, 0, text, fontsize=size)
        box = probe.get_window_extent(renderer)
        probe.remove()
        return box.width, box.height

    labels = [Label(text, colour, tuple(to_pixels((x, y))), extent(text), led) for x, y, text, colour, led in points]
    panel = Panel(axes.get_window_extent(renderer), [label.at for label in labels],
                  [(*to_pixels((x, y)), to_pixels((end, y))[0]) for x, y, end in bars],
                  [to_pixels(line) for line in lines], axes.figure.dpi / 72)
    lost = []
    for label, place in zip(labels, choose([panel.places(label) for label in labels])):
        if not place:
            lost.append(label.text)
            continue
        to_data = axes.transData.inverted().transform
        box = place.box
        axes.text(*to_data(((box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2)), label.text, ha="center", va="center", fontsize=size,
                  color=ink(label.colour), zorder=6, bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.75, "pad": 0.5})
        if place.leader:
            axes.plot(*zip(*to_data(place.leader.vertices)), color="#777777", linewidth=0.9, zorder=2.5, gid="leader")
    return lost
