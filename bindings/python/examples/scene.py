"""A scene and questions to it: rays, boxes, nearest points, one by one and in a batch."""
import math

import gamephys as gp
import numpy as np

LAYER_WORLD, LAYER_ROBOT = 1, 2

with gp.Scene() as scene:
    ground = scene.add(gp.Plane((0, 1, 0), 0))

    # A row of 100 pyramids, five metres apart, that share one mesh.
    vertices = np.float32([[-1, 0, -1], [1, 0, -1], [1, 0, 1], [-1, 0, 1], [0, 2, 0]])
    triangles = np.uint32([[0, 1, 2], [0, 2, 3], [1, 0, 4], [2, 1, 4], [3, 2, 4], [0, 3, 4]])
    places = np.zeros(100, gp.transform_dtype)
    places["position"][:, 0] = 5 * np.arange(100)
    places["position"][:, 2] = 10
    places["rotation"][:, 3] = 1
    places["scale"] = 1
    with gp.Mesh(vertices, triangles) as mesh:
        assert mesh.get_report().open_edge_count == 0
        pyramids = scene.add_batch(mesh, places)

    # A robot's arm, and a hand two metres above it that follows.
    arm = scene.add(gp.Capsule((0, 0, 0), (0, 1, 0), 0.2), gp.Transform((0, 1, -5), (0, 0, 0, 1), 1),
                    gp.ModelDesc(layers=LAYER_ROBOT))
    hand = scene.add(gp.Sphere((0, 0, 0), 0.5), gp.Transform((0, 2, 0), (0, 0, 0, 1), 1),
                     gp.ModelDesc(layers=LAYER_ROBOT, parent=arm))

    hit = scene.raycast(gp.Ray((25, 1, 0), (0, 0, 1), math.inf))
    print(f"ray: a pyramid, triangle {hit.triangle}, {hit.t:g} m away")
    assert hit.model == pyramids[5] and abs(hit.t - 9.5) < 1e-6

    sight = gp.Segment((0, 3, -10), (0, 3, 0))
    assert scene.segment_test(sight).model == hand
    assert scene.segment_test(sight, LAYER_WORLD) is None
    scene.set_transform(arm, gp.Transform((0, 1, -50), (0, 0, 0, 1), 1))
    assert scene.segment_test(sight) is None
    assert scene.nearest((0, 10, -50), layers=LAYER_ROBOT).distance == 6.5

    found = scene.overlap(gp.Aabb((-1, 0.5, 8), (21, 1, 12)), LAYER_WORLD)
    print(f"box: {len(found)} models")
    assert list(found) == sorted(pyramids[:5])

    rays = np.zeros(1000, gp.ray_dtype)
    rays["origin"] = [0, 5, 10]
    rays["origin"][:, 0] = 0.5 * np.arange(1000)
    rays["direction"] = [0, -1, 0]
    rays["t_max"] = 10
    hits = scene.raycast_batch(rays, LAYER_WORLD)
    on_pyramid = np.count_nonzero(hits["t"] < 5)
    print(f"batch: {on_pyramid} of 1000 rays end on a pyramid")
    assert on_pyramid == 299 and np.all(hits["model"] != 0)
