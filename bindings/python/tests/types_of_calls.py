"""What mypy must take, and what it must refuse: an `ignore` that is not needed is an error."""
from __future__ import annotations

import numpy as np

import gamephys as gp

scene = gp.Scene(gp.SceneDesc(worker_count=2))
ball: int = scene.add(gp.Sphere((0, 0, 5), 1))
hit: gp.Hit | None = scene.raycast(gp.Ray((0, 0, 0), (0, 0, 1), 100))
same: gp.Hit | None = scene.raycast(((0, 0, 0), (0, 0, 1), 100), gp.ALL_LAYERS)
hits: np.ndarray = scene.raycast_batch(np.zeros((10, 7), np.float32))
there: bool = scene.has(ball) and ball in scene
radius: float = scene.get_shape(ball).radius
with gp.Solver() as solver:
    steps, leftover = solver.advance(scene, 0.1)
    whole: int = steps
lists: tuple[np.ndarray, np.ndarray] = scene.overlap_batch([gp.Sphere((0, 0, 0), 1)])
described: np.ndarray = scene.add_described_batch([], None, [gp.ModelDesc(tag=1)])
scene.add_described_batch([], descs=gp.ModelDesc.array(2, tag=[1, 2]))
scene.add_described_batch([], descs=gp.ModelDesc())

scene.add_described_batch([], descs=[gp.SceneDesc()])  # type: ignore[list-item]
scene.raycast(3)  # type: ignore[arg-type]
scene.raycast(gp.Ray((0, 0, 0), (0, 0, 1), 100)).t  # type: ignore[union-attr]
gp.Solver().step(gp.Camera(), 0.1)  # type: ignore[arg-type]
scene.weigh(ball)  # type: ignore[attr-defined]
name: str = scene.add(gp.Sphere((0, 0, 5), 1))  # type: ignore[assignment]
