"""How libraries look in all figures: Okabe and Ito's colours, which the colour-blind tell apart, and a marker each."""

LOOKS = {
    "gamephys": ("#D55E00", "o"),
    "gamephys_float": ("#D55E00", "P"),
    "embree": ("#0072B2", "s"),
    "embree_robust": ("#0072B2", "D"),
    "embree_packets": ("#56B4E9", "s"),
    "embree_packets_robust": ("#56B4E9", "D"),
    "bullet": ("#009E73", "^"),
    "fcl": ("#CC79A7", "v"),
    "nanoflann": ("#E69F00", "X"),
    "simd_sweep": ("#666666", "<"),
    "simd_blocks": ("#666666", ">"),
    "xpbd": ("#0072B2", "D"),
    "jakobsen": ("#CC79A7", "v"),
}
NAMES = {
    "gamephys_float": "gamephys, plain float tests", "embree": "Embree", "embree_robust": "Embree robust",
    "embree_packets": "Embree packets", "embree_packets_robust": "Embree robust packets", "bullet": "Bullet",
    "gamephys_fresh": "built anew", "gamephys_plain": "without a filter", "gamephys_multiplied": "multiplied vertices",
    "gamephys_mesh": "as a mesh", "1_thread": "gamephys, one thread", "2_threads": "gamephys, two threads",
    "2_apart": "gamephys, two independent threads",
    "fcl": "FCL", "simd_sweep": "linear scan", "simd_blocks": "linear scan of blocks", "xpbd": "XPBD", "jakobsen": "Jakobsen",
}


def look(name):
    return LOOKS.get(name, ("#000000", "o"))


def shown(name):
    return NAMES.get(name, name)


def place_labels(axes, points, bars, lines, size=9.5):
    """Write a label beside each (x, y, text, colour) where it covers neither a point, nor a bar (x, y, other x), nor
    another label, nor the border; nor, if there is room, a line (a list of corners). The figure has been drawn.

    Places are tried from near to far, in eight directions; a label that is far from its point gets a thin line to it.
    Returns the labels for which no free place was found, which is an error of the figure."""
    figure = axes.figure
    renderer = figure.canvas.get_renderer()
    to_pixels = axes.transData.transform
    inside = axes.get_window_extent(renderer)
    taken, crossed = [], []
    for x, y, *end in [(x, y) for x, y, _, _ in points] + bars:
        (px, py), (ex, _) = to_pixels((x, y)), to_pixels((end[0] if end else x, y))
        around = 3 if end else 6
        taken.append((px - around, py - around, ex + around, py + around))
    for line in lines:
        corners = [to_pixels(corner) for corner in line]
        for (ax, ay), (bx, by) in zip(corners, corners[1:]):
            crossed.append((min(ax, bx) - 1, min(ay, by) - 1, max(ax, bx) + 1, max(ay, by) + 1))

    def free(place, boxes):
        return not any(place[0] < b[2] + 2 and b[0] < place[2] + 2 and place[1] < b[3] + 1 and b[1] < place[3] + 1 for b in boxes)

    lost = []
    scale = figure.dpi / 72
    for x, y, text, colour in sorted(points, key=lambda point: -len(point[2])):
        px, py = to_pixels((x, y))
        probe = axes.text(0, 0, text, fontsize=size)
        box = probe.get_window_extent(renderer)
        probe.remove()
        width, height = box.width, box.height
        found = None
        for avoided in (taken + crossed, taken):
            for distance in (9, 14, 22, 32, 44, 58, 74, 92, 112):
                d = distance * scale / 1.4
                for ux, uy in ((1, 0), (-1, 0), (0, 1), (0, -1), (.8, .8), (.8, -.8), (-.8, .8), (-.8, -.8)):
                    left = px + ux * d - (0 if ux > 0 else width if ux < 0 else width / 2)
                    low = py + uy * d - (0 if uy > 0 else height if uy < 0 else height / 2)
                    place = (left, low, left + width, low + height)
                    if place[0] < inside.x0 + 6 or place[2] > inside.x1 or place[1] < inside.y0 + 1 or place[3] > inside.y1:
                        continue
                    if free(place, avoided):
                        found = place, distance
                        break
                if found:
                    break
            if found and (found[1] <= 32 or avoided is taken):
                break
        if not found:
            lost.append(text)
            continue
        place, distance = found
        taken.append(place)
        at = axes.transData.inverted().transform(((place[0] + place[2]) / 2, (place[1] + place[3]) / 2))
        arrow = {"arrowstyle": "-", "color": "#999999", "linewidth": 0.7, "shrinkA": 0, "shrinkB": 4} if distance > 14 else None
        axes.annotate(text, (x, y), xytext=at, ha="center", va="center", fontsize=size, color=colour, arrowprops=arrow,
                      zorder=4,
                      bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.75, "pad": 0.5})
    return lost
