"""A rope with a weight, and a cloth that falls over a ball."""
import gamephys as gp
import numpy as np

with gp.Scene() as scene, gp.Solver() as solver:
    scene.add(gp.Plane((0, 1, 0), 0))
    scene.add(gp.Sphere((0, 1, 0), 1))

    line = np.zeros((41, 3), np.float32)
    line[:] = [5, 3, 0]
    line[:, 0] += 0.05 * np.arange(41)
    rope = solver.add_rope(line, desc=gp.BodyDesc(damping=2))
    solver.set_pinned(rope, 0, 1, True)
    solver.set_masses(rope, 40, np.float32([5]))

    cloth = solver.add_cloth((-1.5, 3, -1.5), (3, 0, 0), (0, 0, 3), 31, 31,
                             gp.BodyDesc(damping=2, radius=0.02, cloth_flags=gp.CLOTH_BEND))
    count = solver.get_body_info(cloth).particle_count
    positions = np.empty((count, 3), np.float32)
    for frame in range(6 * 60):
        solver.advance(scene, 1 / 60)
        solver.get_positions(cloth, 0, count, out=positions)     # the same memory each frame

    weight = solver.get_positions(rope, 40, 1)[0]
    height = np.linalg.norm(positions - np.float32([0, 1, 0]), axis=1).min() - 1
    print(f"weight {3 - weight[1]:.3f} m below the nail, cloth {height:.4f} m above the ball")
    assert weight[1] < 1.02 and 0.015 < height < 0.03
