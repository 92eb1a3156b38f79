"""How libraries look in all figures: Okabe and Ito's colours, which the colour-blind tell apart, and a marker each."""

LOOKS = {
    "gamephys": ("#D55E00", "o"),
    "gamephys_float": ("#D55E00", "P"),
    "gamephys_distance": ("#D55E00", "p"),
    "gamephys_2_threads": ("#D55E00", "h"),
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
    "gamephys_float": "gamephys, float tests", "gamephys_2_threads": "gamephys, two threads", "embree": "Embree", "embree_robust": "Embree robust",
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
