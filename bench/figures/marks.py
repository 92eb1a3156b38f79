"""How libraries look in all figures: Okabe and Ito's colours, which the colour-blind tell apart, and a marker each."""
import re

LOOKS = {
    "gamephys": ("#D55E00", "o"),
    "gamephys_float": ("#D55E00", "P"),
    "gamephys_distance": ("#D55E00", "p"),
    "gamephys_threads": ("#D55E00", "h"),
    "embree": ("#0072B2", "s"),
    "embree_robust": ("#0072B2", "D"),
    "embree_packets": ("#56B4E9", "s"),
    "embree_packets_robust": ("#56B4E9", "D"),
    "bullet": ("#009E73", "^"),
    "bullet_substeps": ("#009E73", "<"),
    "fcl": ("#CC79A7", "v"),
    "nanoflann": ("#E69F00", "X"),
    "simd_sweep": ("#666666", "<"),
    "simd_blocks": ("#666666", ">"),
    "xpbd": ("#0072B2", "D"),
    "jakobsen": ("#CC79A7", "v"),
    "explicit_euler": ("#E69F00", "X"),
    "semi_implicit_euler": ("#56B4E9", "s"),
}
NAMES = {
    "gamephys_float": "gamephys, float tests", "embree": "Embree", "embree_robust": "Embree robust",
    "embree_packets": "Embree packets", "embree_packets_robust": "Embree robust packets", "bullet": "Bullet",
    "bullet_substeps": "Bullet, substeps",
    "gamephys_fresh": "built anew", "gamephys_plain": "without a filter", "gamephys_multiplied": "multiplied vertices",
    "gamephys_mesh": "as a mesh", "1_thread": "gamephys, one thread",
    "fcl": "FCL", "simd_sweep": "linear scan", "simd_blocks": "linear scan of blocks", "xpbd": "XPBD", "jakobsen": "Jakobsen",
    "explicit_euler": "explicit Euler", "semi_implicit_euler": "semi-implicit Euler",
}


THREADS = re.compile("(gamephys_)?([0-9]+)_(threads|apart)")


def look(name):
    return LOOKS["gamephys_threads"] if THREADS.fullmatch(name) else LOOKS.get(name, ("#000000", "o"))


def shown(name):
    threads = THREADS.fullmatch(name)
    if threads:
        return f"gamephys, {threads[2]} {'independent ' if threads[3] == 'apart' else ''}threads"
    return NAMES.get(name, name)
