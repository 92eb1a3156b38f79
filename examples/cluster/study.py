"""The study of study.c in Python: the same units, the same records, the same bits."""
import functools

import gamephys as gp
import numpy as np

BLOCK, BUILDINGS, VEHICLES = 25, 4000, 1000
RECORD = np.dtype([("done", "<u4"), ("time", "<u4"), ("pose", "<u4"), ("hits", "<u4"), ("range", "<u8"), ("hash", "<u8"),
                   ("histogram", "<u4", 8)])


class Random:
    def __init__(self, state):
        self.state = state & 0xFFFFFFFF

    def below(self, n):
        self.state = (self.state * 1664525 + 1013904223) & 0xFFFFFFFF
        return (self.state >> 8) % n


def town():
    """The town, built in one process: the words of its snapshot, as bytes, and which of its models are vehicles."""
    random = Random(1)
    scene = gp.Scene()
    scene.add(gp.Plane((0, 1, 0), 0))
    for _ in range(BUILDINGS):
        x, z = random.below(2000) - 1000, random.below(2000) - 1000
        w, h, d = 4 + random.below(12), 3 + random.below(30), 4 + random.below(12)
        scene.add(gp.Aabb((x - w, 0, z - d), (x + w, h, z + d)))
    vehicles = np.array([scene.add(gp.Aabb((-1, 0.25, -2), (1, 1.75, 2))) for _ in range(VEHICLES)], np.uint32)
    return scene.get_snapshot(1).tobytes(), vehicles


@functools.lru_cache(1)  # one scene a process, whatever the number of its units
def restored(words):
    scene = gp.Scene()
    scene.restore(None, np.frombuffer(words, np.uint32))
    return scene


def traffic(time):
    """What changes from one time to another: where the vehicles are."""
    i = np.arange(VEHICLES)
    along, across = (i * 7919 + time * (4 + i % 23)) % 2000 - 1000, i * 104729 % 2000 - 1000
    places = np.zeros(VEHICLES, gp.transform_dtype)
    odd = i % 2 == 1
    places["position"][:, 0] = np.where(odd, across, along)
    places["position"][:, 2] = np.where(odd, along, across)
    places["rotation"][:] = np.where(odd[:, None], (0, 0, 0, 1), (0, 0.70710678, 0, 0.70710678))
    places["scale"] = 1
    return places


def aim(side, pose):
    random = Random(77 + pose * 2654435761)
    at = np.array([random.below(1800) - 900, 2 + random.below(64) / 8, random.below(1800) - 900], np.float32)
    i = np.arange(side * side)
    turn = np.float32(8) * (i % side).astype(np.float32) / np.float32(side)
    down = np.float32(-0.5) + np.float32(0.625) * (i // side).astype(np.float32) / np.float32(side)
    quarters = [turn < 2, turn < 4, turn < 6]
    rays = np.zeros(side * side, gp.ray_dtype)
    rays["origin"] = at
    rays["direction"][:, 0] = 256 * np.select(quarters, [turn - 1, 1, 5 - turn], -1)
    rays["direction"][:, 1] = 256 * down
    rays["direction"][:, 2] = 256 * np.select(quarters, [-1, turn - 3, 1], 7 - turn)
    rays["t_max"] = 1
    return rays


def units(poses, times):
    """(time, first pose, number of poses) of each unit."""
    return [(time, first, min(BLOCK, poses - first)) for time in range(times) for first in range(0, poses, BLOCK)]


def do(unit, places, town, side):
    """The records of a unit, as bytes, with the vehicles at their places."""
    time, first, count = unit
    words, vehicles = town
    scene = restored(words)
    scene.set_transforms(vehicles, places)
    records = np.zeros(count, RECORD)
    odd = 2 * np.arange(side * side, dtype=np.uint64) + np.uint64(1)
    for k, r in enumerate(records):
        hits = scene.raycast_batch(aim(side, first + k))
        met = hits["model"] != 0
        t = hits["t"][met]
        r["done"], r["time"], r["pose"], r["hits"] = 1, time, first + k, met.sum()
        r["range"] = (np.float32(1024) * t).astype(np.uint64).sum()
        words = hits["model"][met].astype(np.uint64) << np.uint64(32) | t.view(np.uint32).astype(np.uint64)
        r["hash"] = (words * odd[met]).sum()
        r["histogram"] = np.bincount(np.minimum((np.float32(16) * t).astype(np.int64), 7), minlength=8)
    return records.tobytes()
