"""A lidar that turns on a vehicle: a million rays a frame from numpy, answers as arrays.

lidar.py [frames] [columns]: 64 beams for each column, 15625 columns are a million rays.
"""
import sys
import time

import gamephys as gp
import numpy as np

frames = int(sys.argv[1]) if len(sys.argv) > 1 else 3
columns = int(sys.argv[2]) if len(sys.argv) > 2 else 15625
BEAMS, RANGE = 64, 120.0
random = np.random.default_rng(1)

# A street: ground, 60 houses, 500 posts.
scene = gp.Scene()
scene.add(gp.Plane((0, 1, 0), 0))
boxes = np.zeros(60, gp.obb_dtype)
boxes["half_extents"] = random.uniform(1, 4, (60, 3))
boxes["center"] = random.uniform(-100, 100, (60, 3))
boxes["center"][:, 1] = boxes["half_extents"][:, 1]
angle = random.uniform(0, np.pi, 60)
boxes["rotation"][:, 1], boxes["rotation"][:, 3] = np.sin(angle / 2), np.cos(angle / 2)
boxes = boxes[np.hypot(boxes["center"][:, 0], boxes["center"][:, 2]) > 10]
scene.add_batch(boxes)
posts = np.zeros(500, gp.capsule_dtype)
posts["a"] = random.uniform(-100, 100, (500, 3))
posts["a"][:, 1] = 0
posts["b"] = posts["a"] + np.float32([0, 6, 0])
posts["radius"] = 0.15
scene.add_batch(posts[np.hypot(posts["a"][:, 0], posts["a"][:, 2]) > 10])

turn = np.linspace(0, 2 * np.pi, columns, endpoint=False, dtype=np.float32)[:, None]
tilt = np.linspace(-0.43, 0.03, BEAMS, dtype=np.float32)[None, :]
rays = np.zeros(columns * BEAMS, gp.ray_dtype)
direction = rays["direction"].reshape(columns, BEAMS, 3)
direction[..., 0], direction[..., 1], direction[..., 2] = np.cos(turn) * np.cos(tilt), np.sin(tilt), np.sin(turn) * np.cos(tilt)
rays["t_max"] = RANGE
hits = np.empty(len(rays), gp.hit_dtype)                         # filled again by every frame

for frame in range(frames):
    rays["origin"] = [0.5 * frame, 1.8, 0]                       # the vehicle drives on
    start = time.perf_counter()
    scene.raycast_batch(rays, out=hits)
    seconds = time.perf_counter() - start
    seen = hits["model"] != 0
    cloud = hits["point"][seen]
    print(f"frame {frame}: {len(rays)} rays in {1e3 * seconds:.0f} ms, {len(cloud)} points, "
          f"{np.count_nonzero(cloud[:, 1] > 0.01)} above the ground")
    assert np.all(np.isinf(hits["t"][~seen])) and np.all(hits["t"][seen] <= RANGE)
    ends = rays["origin"][seen] + rays["direction"][seen] * hits["t"][seen][:, None]
    assert np.abs(ends - cloud).max() < 1e-4
