"""What mypy must take, and what it must refuse: an `ignore` that is not needed is an error."""
from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

import gamephys as gp

scene = gp.Scene(gp.SceneDesc(worker_count=2))
ball: int = scene.add(gp.Sphere((0, 0, 5), 1))
hit: gp.Hit | None = scene.raycast(gp.Ray((0, 0, 0), (0, 0, 1), 100))
same: gp.Hit | None = scene.raycast(((0, 0, 0), (0, 0, 1), 100), gp.ALL_LAYERS)
hits: NDArray[np.void] = scene.raycast_batch(np.zeros((10, 7), np.float32))
there: bool = scene.has(ball) and ball in scene
radius: float = scene.get_shape(ball).radius
with gp.Solver() as solver:
    steps, leftover = solver.advance(scene, 0.1)
    whole: int = steps
lists: tuple[NDArray[np.uint32], NDArray[np.uint32]] = scene.overlap_batch([gp.Sphere((0, 0, 0), 1)])
described: NDArray[np.uint32] = scene.add_described_batch([], None, [gp.ModelDesc(tag=1)])
scene.add_described_batch([], descs=gp.ModelDesc.array(2, tag=[1, 2]))
scene.add_described_batch([], descs=gp.ModelDesc())
listed = gp.QueryFilterDesc(ignored_models=[ball])
listed.ignored_models = scene.get_models()
met: NDArray[np.void] = scene.raycast_filtered_batch(gp.rays(2, direction=(0, 0, 1)), [listed, gp.QueryFilterDesc()])
scene.raycast_filtered_batch(np.zeros((2, 7), np.float32), gp.QueryFilterDesc.array(2, ignored_model=[ball, 0]))
moved = gp.Transform(np.zeros(3), scale=2)
moved.position = (1, 2, 3)
x: float = moved.position.x
scene.set_transform(ball, moved)
scene.set_transform(ball, ((0, 0, 0), (0, 0, 0, 1), 1))
camera = gp.Camera()
view: NDArray[np.float32] = camera.get_view_matrix()
camera.set_view_matrix(view)
camera.set_world_matrix([[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
rope = solver.add_rope([(0, 0, 0), (0, 1, 0)], desc=gp.BodyDesc(mass=2))
solver.set_pinned(rope, pinned=False)
places: NDArray[np.float32] = solver.get_positions(rope)
if hit is not None:
    ahead: NDArray[np.float32] = np.asarray(hit.point)
    z: float = hit.point[2]

scene.add_described_batch([], descs=[gp.SceneDesc()])  # type: ignore[list-item]
scene.raycast(3)  # type: ignore[arg-type]
scene.raycast(gp.Ray((0, 0, 0), (0, 0, 1), 100)).t  # type: ignore[union-attr]
gp.Solver().step(gp.Camera(), 0.1)  # type: ignore[arg-type]
scene.weigh(ball)  # type: ignore[attr-defined]
name: str = scene.add(gp.Sphere((0, 0, 5), 1))  # type: ignore[assignment]
gp.Ray(orgin=(0, 0, 0))  # type: ignore[call-arg]
gp.Sphere(1, 2)  # type: ignore[arg-type]
gp.CameraDesc(viewport_widht=3)  # type: ignore[call-arg]
scene.add(gp.Ray((0, 0, 0), (0, 0, 1)))  # type: ignore[arg-type]
scene.set_parent(ball, 0, 1)  # type: ignore[arg-type]
listed.ignored_models = 3  # type: ignore[assignment]
moved.position = 3  # type: ignore[assignment]
