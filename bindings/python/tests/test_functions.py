"""Every function of the library with an answer that is known."""
import gc
import math
import pickle
import unittest

import gamephys as gp
import numpy as np

UP, STILL = (0, 1, 0), (0, 0, 0, 1)
IDENTITY = gp.Transform((0, 0, 0), STILL, 1)
BALL = gp.Sphere((0, 0, 5), 1)
AHEAD = gp.Ray((0, 0, 0), (0, 0, 1), 100)


def pyramid(desc=None):
    return gp.Mesh(np.float32([[-1, 0, -1], [1, 0, -1], [1, 0, 1], [-1, 0, 1], [0, 2, 0]]),
                   np.uint32([0, 1, 2, 0, 2, 3, 1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4]), desc)


class Functions(unittest.TestCase):
    def assert_near(self, value, expected, tolerance=1e-5):
        np.testing.assert_allclose(list(value), expected, atol=tolerance)

    def test_shapes(self):
        gp.validate(BALL)
        self.assertEqual(gp.bounds(BALL), gp.Aabb((-1, -1, 4), (1, 1, 6)))
        self.assertIsNone(gp.bounds(gp.Plane(UP, 0)))
        self.assertTrue(gp.contains(BALL, (0, 0, 4)))
        self.assertFalse(gp.contains(BALL, (0, 0, 3.5)))
        self.assertEqual(gp.closest_point(BALL, (0, 0, 0)).distance, 4)
        self.assertEqual(gp.closest_point_batch(BALL, np.float32([[0, 0, 0], [0, 0, 9]]))["distance"].tolist(), [4, 3])
        a, b, distance = gp.segment_closest_points(((0, 0, 0), (2, 0, 0)), ((1, 3, -1), (1, 3, 1)))
        self.assertEqual((tuple(a), tuple(b), distance), ((1, 0, 0), (1, 3, 0), 3))
        self.assertTrue(gp.overlaps(BALL, gp.Aabb((0, 0, 0), (1, 1, 4))))
        self.assertFalse(gp.overlaps(BALL, gp.Aabb((0, 0, 0), (1, 1, 3))))
        self.assertEqual(gp.classify_plane(BALL, ((0, 0, 1), 0)), (gp.SIDE_INSIDE, 4))
        self.assertEqual(gp.raycast(BALL, AHEAD).t, 4)
        self.assertEqual(gp.raycast_batch(BALL, np.float32([[0, 0, 0, 0, 0, 1, 9], [0, 3, 0, 0, 0, 1, 9]]))["t"].tolist(),
                         [4, math.inf])
        self.assertEqual(gp.segment_test(BALL, ((0, 0, 0), (0, 0, 8))).t, 0.5)
        self.assertAlmostEqual(gp.sweep_sphere(BALL, ((0, 0, 0), 1), (0, 0, 10)).t, 0.3, 6)

    def test_frusta(self):
        camera = gp.Camera()
        frustum = camera.get_frustum()
        self.assertEqual(gp.classify_frustum(BALL, frustum), gp.SIDE_INSIDE)
        corners = gp.frustum_corners(frustum)
        self.assert_near(corners[3], camera.get_corners()[3])
        again = gp.frustum_from_matrix(camera.get_view_projection_matrix(), gp.DEPTH_ZERO_TO_ONE, False)
        self.assertEqual(gp.classify_frustum(gp.Sphere((0, 0, -5), 1), again), gp.SIDE_OUTSIDE)

    def test_meshes(self):
        report = gp.mesh_check(np.float32([[0, 0, 0], [1, 0, 0], [0, 1, 0]]), np.uint32([0, 1, 7]))
        self.assertEqual(report.out_of_range_count, 1)
        mesh = pyramid(gp.MeshDesc())
        self.assertEqual(mesh.get_vertices()[4].tolist(), [0, 2, 0])
        self.assertEqual(mesh.get_indices()[15:].tolist(), [0, 3, 4])
        loaded = gp.Mesh.from_snapshot(mesh.get_snapshot())
        self.assertIsInstance(loaded, gp.Mesh)
        self.assertEqual(loaded.get_indices().tolist(), mesh.get_indices().tolist())
        down = gp.Ray((0.3, 5, 0.2), (0, -1, 0), 10)
        hits = mesh.raycast_all(down)
        self.assertEqual(len(hits), 2)
        self.assertEqual(hits["t"][1], 5)
        self.assertTrue(mesh.raycast_any(down))
        twice = np.frombuffer(bytes(down) * 2, gp.ray_dtype)
        self.assertEqual(mesh.raycast_any_batch(twice).tolist(), [1, 1])
        self.assertEqual(mesh.raycast_distance_batch(twice)["t"][1], mesh.raycast_all(down)["t"][0])
        self.assertEqual(len(mesh.overlap(gp.Sphere((0, 2, 0), 0.1))), 4)
        self.assertEqual(mesh.get_octree_stats().item_count, 6)
        self.assertEqual(mesh.get_octree_boxes()["depth"][0], 0)

    def test_models(self):
        scene = gp.Scene(gp.SceneDesc(worker_count=2))
        model = scene.add(BALL, desc=gp.ModelDesc(tag=7))
        two = scene.add_batch([gp.Sphere((9, 0, 0), 1), gp.Sphere((9, 5, 0), 2)])
        self.assertTrue(scene.has(model))
        self.assertFalse(scene.has(12345))
        self.assertEqual(scene.get_info(model).tag, 7)
        self.assertEqual(scene.get_bounds(two[0]).max.x, 10)
        self.assertEqual(scene.get_scene_bounds().max.y, 7)
        scene.set_layers(model, 4)
        scene.set_tag(model, 8)
        self.assertIsNone(scene.raycast(AHEAD, 3))
        self.assertEqual(scene.raycast(AHEAD, 4).tag, 8)
        scene.set_parent(two[0], model, True)
        scene.set_transform(model, (UP, STILL, 1))
        ids = np.uint32([model, two[0]])
        self.assertEqual(scene.get_transforms(ids)["position"][:, 1].tolist(), [1, 0])
        self.assertEqual(scene.get_world_transforms(ids)["position"][:, 1].tolist(), [1, 1])
        scene.set_transforms(ids, np.frombuffer(bytes(IDENTITY) * 2, gp.transform_dtype))
        self.assertEqual(scene.get_world_transforms(ids)["position"][1, 1], 0)
        scene.validate()
        scene.remove_subtree(model)
        self.assertNotIn(two[0], scene)
        scene.remove(two[1])
        scene.remove_batch(scene.add_batch([BALL] * 3))
        self.assertIsNone(scene.get_scene_bounds())
        scene.add(BALL)
        scene.rebuild_octree()
        assert scene.maintain_octree(1000)
        scene.set_worker_count(2)
        self.assertEqual(scene.get_worker_count(), 2)
        scene.clear()
        self.assertEqual(len(scene.get_models()), 0)
        scene.set_origin((1e9 + 0.5, 0, 0))
        self.assertEqual(scene.get_origin().tolist(), [1e9 + 0.5, 0, 0])

    def test_models_with_descs_of_their_own(self):
        scene = gp.Scene()
        root = scene.add(BALL)

        def read_back(models):
            return [(info.parent, info.layers, info.tag) for info in map(scene.get_info, models)]

        some = [gp.ModelDesc(parent=root, layers=2, tag=5), gp.ModelDesc(tag=6), gp.ModelDesc()]
        known = [(root, 2, 5), (0, 1, 6), (0, 1, 0)]
        self.assertEqual(read_back(scene.add_described_batch([BALL] * 3, None, some)), known)
        self.assertEqual(read_back(scene.add_described_batch(BALL, descs=some)), known)
        array = gp.ModelDesc.array(3, tag=[5, 6, 0])
        array["parent"][0], array["layers"][0] = root, 2
        self.assertEqual(read_back(scene.add_described_batch([BALL] * 3, descs=array)), known)
        self.assertEqual(read_back(scene.add_described_batch([BALL] * 2, descs=array[::2])), known[::2])
        self.assertEqual(read_back(scene.add_described_batch([BALL] * 2, [IDENTITY] * 2, some[0])), known[:1] * 2)
        self.assertEqual(read_back(scene.add_described_batch([BALL] * 2)), [(0, 1, 0)] * 2)
        self.assertEqual(len(scene.add_described_batch(BALL, descs=gp.ModelDesc.array(0))), 0)
        count = len(scene.get_models())
        with self.assertRaisesRegex(ValueError, "different lengths: 2 and 3"):
            scene.add_described_batch([BALL] * 2, descs=some)
        with self.assertRaises(gp.InvalidId):
            scene.add_described_batch([BALL] * 3, descs=gp.ModelDesc.array(3, parent=12345))
        with self.assertRaises(gp.Error):  # no desc: its size is 0
            scene.add_described_batch([BALL] * 3, descs=np.zeros(3, gp.ModelDesc.dtype))
        for wrong in ([{"tag": 1}] * 3, np.zeros((3, 4), np.uint32), 7, gp.SceneDesc()):
            with self.assertRaises(TypeError):
                scene.add_described_batch([BALL] * 3, descs=wrong)
        with self.assertRaisesRegex(TypeError, "no field weight"):
            gp.ModelDesc.array(3, weight=1)
        with self.assertRaises(TypeError):
            gp.ModelDesc.array(3, tag=0.5)
        self.assertEqual(len(scene.get_models()), count)

    def test_batches_of_scenes_answer_as_single_calls_do(self):
        scene = gp.Scene()
        for i in range(30):
            scene.add(gp.Sphere((3 * math.sin(i), 3 * math.cos(2 * i), i / 3), 0.7))
        i = np.arange(200)
        directions = np.float32(np.stack([np.sin(i) / 2, np.cos(3 * i) / 2, np.ones(200)], -1))
        rays = np.zeros(200, gp.ray_dtype)
        rays["origin"], rays["direction"], rays["t_max"] = [0, 0, -5], directions, np.inf
        segments = np.zeros(200, gp.segment_dtype)
        segments["a"], segments["b"] = [0, 0, -5], directions * np.float32([10, 10, 5])
        balls = np.zeros(200, gp.sphere_dtype)
        balls["center"], balls["radius"] = [0, 0, -5], 0.2
        for batch, single in (
                (scene.segment_test_batch(segments), lambda i: scene.segment_test(segments[i])),
                (scene.nearest_batch(directions), lambda i: scene.nearest(directions[i])),
                (scene.sweep_sphere_batch(balls, directions), lambda i: scene.sweep_sphere(balls[i], directions[i]))):
            for i in range(200):
                one = single(i)
                self.assertTrue(batch["model"][i] == 0 if one is None else bytes(one) == batch[i].tobytes())
        any_hit = scene.raycast_any_batch(rays)
        self.assertEqual(any_hit.tolist(), [scene.raycast_any(ray) for ray in rays])
        self.assertTrue(0 < np.count_nonzero(any_hit) < 200)
        distances, full = scene.raycast_distance_batch(rays), scene.raycast_batch(rays)
        for field in ("t", "model", "triangle"):
            np.testing.assert_array_equal(distances[field], full[field])
        hits, offsets = scene.raycast_all_batch(rays)
        for i, ray in enumerate(rays):
            np.testing.assert_array_equal(scene.raycast_all(ray), hits[offsets[i]:offsets[i + 1]])
        self.assertEqual(scene.get_octree_stats().item_count, 30)
        self.assertEqual(scene.get_octree_boxes()["depth"][0], 0)

    def test_filters_leave_out_models(self):
        scene = gp.Scene()
        body = scene.add(BALL)
        head = scene.add(BALL, ((0, 0, 3), STILL, 1), gp.ModelDesc(parent=body))
        target = scene.add(BALL, ((0, 0, 10), STILL, 1), gp.ModelDesc(layers=2))
        ray, segment = gp.Ray((0, 0, 0), (0, 0, 1), np.inf), gp.Segment((0, 0, 0), (0, 0, 20))
        moving, way, origin = gp.Sphere((0, 0, 0), 0.5), (0, 0, 20), (0, 0, 0)
        alone = gp.QueryFilterDesc(ignored_model=body)
        both = gp.QueryFilterDesc(ignored_model=body, flags=gp.FILTER_SUBTREE)
        listed = gp.QueryFilterDesc(ignored_models=[head, target])
        for filter, first in ((None, body), (alone, head), (both, target), (listed, body)):
            self.assertEqual(scene.raycast_filtered(ray, filter).model, first)
            self.assertEqual(scene.segment_test_filtered(segment, filter).model, first)
            self.assertEqual(scene.nearest_filtered(origin, filter=filter).model, first)
            self.assertEqual(scene.sweep_sphere_filtered(moving, way, filter).model, first)
            self.assertEqual(scene.raycast_all_filtered(ray, filter)["model"][0], first)
            self.assertTrue(scene.raycast_any_filtered(ray, filter))
            rays = np.frombuffer(bytes(ray) * 3, gp.ray_dtype)
            segments = np.frombuffer(bytes(segment) * 3, gp.segment_dtype)
            balls = np.frombuffer(bytes(moving) * 3, gp.sphere_dtype)
            points, ways = np.zeros((3, 3), np.float32), np.float32([way] * 3)
            self.assertEqual(scene.raycast_filtered_batch(rays, filter)["model"].tolist(), [first] * 3)
            self.assertEqual(scene.raycast_any_filtered_batch(rays, filter).tolist(), [1] * 3)
            distances = scene.raycast_distance_filtered_batch(rays, filter)
            self.assertEqual(distances["model"].tolist(), [first] * 3)
            self.assertEqual(scene.raycast_all_filtered_batch(rays, filter)[0]["model"][0], first)
            self.assertEqual(scene.segment_test_filtered_batch(segments, filter)["model"].tolist(), [first] * 3)
            self.assertEqual(scene.nearest_filtered_batch(points, filters=filter)["model"].tolist(), [first] * 3)
            self.assertEqual(scene.sweep_sphere_filtered_batch(balls, ways, filter)["model"].tolist(), [first] * 3)
            large = gp.Sphere((0, 0, 0), 50)
            self.assertEqual(scene.overlap_filtered(large, filter)[0], first)
            self.assertEqual(scene.overlap_filtered_batch([large, large], filter)[0][0], first)
        self.assertIsNone(scene.raycast_filtered(ray, gp.QueryFilterDesc(layers=0)))
        camera = gp.Camera()
        camera.look_at((0, 0, -10), (0, 0, 0), UP)
        self.assertEqual(camera.pick_filtered(scene, 400, 300, both).model, target)
        self.assertEqual(camera.pick_filtered_batch(scene, np.float32([[400, 300], [1, 1]]), both)["model"].tolist(), [target, 0])
        self.assertEqual(camera.pick_rectangle_filtered(scene, 0, 0, 800, 600, both).tolist(), [target])
        self.assertEqual(camera.cull_filtered(scene, both).tolist(), [target])
        self.assertEqual(scene.cull_filtered(camera.get_frustum(), both).tolist(), [target])
        views = [camera.get_frustum(), camera.get_frustum()]
        self.assertEqual(scene.cull_batch(views)[1].tolist(), [0, 3, 6])
        self.assertEqual(scene.cull_filtered_batch(views, both)[0].tolist(), [target, target])

    def test_filters_have_lists_of_models(self):
        scene = gp.Scene()
        models = [scene.add(BALL, ((0, 0, 4 * i), STILL, 1)) for i in range(4)]
        ray = gp.Ray((0, 0, -5), (0, 0, 1))
        for ignored in (models[:2], tuple(models[:2]), np.int64(models[:2]), np.uint32(models)[:2], scene.overlap(gp.Sphere((0, 0, 7), 2))):
            filter = gp.QueryFilterDesc(ignored_models=ignored)
            del ignored  # the filter has a copy
            gc.collect()
            self.assertEqual((filter.ignored_models.tolist(), filter.ignored_count), (models[:2], 2))
            self.assertEqual(filter, gp.QueryFilterDesc(ignored_models=models[:2]))
            self.assertNotEqual(filter, gp.QueryFilterDesc(ignored_models=models[1:3]))
            self.assertEqual(scene.raycast_filtered(ray, filter).model, models[2])
            self.assertEqual(scene.raycast_filtered(ray, pickle.loads(pickle.dumps(filter))).model, models[2])
        filter.ignored_models = models
        self.assertIsNone(scene.raycast_filtered(ray, filter))
        for nothing in ([], None):
            filter.ignored_models = nothing
            self.assertEqual(scene.raycast_filtered(ray, filter).model, models[0])
        for wrong in ([0.5], ["a"], {1: 2}):
            with self.assertRaises(TypeError):
                gp.QueryFilterDesc(ignored_models=wrong)
        for wrong in ([-1], [2**32]):
            with self.assertRaises(ValueError):
                gp.QueryFilterDesc(ignored_models=wrong)
        with self.assertRaises(TypeError):
            gp.QueryFilterDesc(ignored_count=2)

    def test_batches_take_a_filter_for_each(self):
        scene = gp.Scene()
        models = [scene.add(BALL, ((0, 0, 4 * i), STILL, 1)) for i in range(4)]
        rays = gp.rays(3, (0, 0, -5), (0, 0, 1))
        each = [gp.QueryFilterDesc(ignored_models=models[:i]) for i in range(3)]
        self.assertEqual(scene.raycast_filtered_batch(rays, each)["model"].tolist(), models[:3])
        array = gp.QueryFilterDesc.array(3, ignored_model=[0, models[0], models[1]])
        first = [models[0], models[1], models[0]]
        self.assertEqual(scene.raycast_filtered_batch(rays, array)["model"].tolist(), first)
        self.assertEqual(scene.raycast_filtered_batch(rays[:2], array[::2])["model"].tolist(), first[::2])
        self.assertEqual(scene.raycast_filtered_batch(rays, each[2])["model"].tolist(), [models[2]] * 3)
        self.assertEqual(scene.raycast_distance_filtered_batch(rays, each)["model"].tolist(), models[:3])
        self.assertEqual(scene.overlap_filtered_batch([gp.Sphere((0, 0, 7), 2)] * 3, each)[1].tolist(), [0, 2, 3, 3])
        self.assertEqual(len(scene.raycast_filtered_batch(rays[:0], [])), 0)
        with self.assertRaisesRegex(ValueError, "different lengths"):
            scene.raycast_filtered_batch(rays, each[:2])
        with self.assertRaisesRegex(TypeError, "ignored_models is a list"):
            gp.QueryFilterDesc.array(2, ignored_models=[[1], [2]])
        for wrong in ([gp.ModelDesc()] * 3, 7, [None] * 3):
            with self.assertRaises(TypeError):
                scene.raycast_filtered_batch(rays, wrong)

    def test_rays_have_no_end_unless_one_is_given(self):
        scene = gp.Scene()
        scene.add(BALL)
        rays = gp.rays(2, direction=(0, 0, 1))
        rays["origin"] = (0, 0, -5)
        self.assertEqual(scene.raycast_batch(rays)["t"].tolist(), [9, 9])
        self.assertEqual(gp.rays(2, t_max=[1, 2])["t_max"].tolist(), [1, 2])

    def test_snapshots_are_restored_from_bytes(self):
        scene = gp.Scene()
        scene.add(BALL)
        saved = scene.get_snapshot(True).tobytes()
        for data in (saved, bytearray(saved)):
            scene.clear()
            scene.restore(None, data)
            self.assertEqual(len(scene), 1)
        with self.assertRaises(ValueError):
            scene.restore(None, saved[:-1])

    def test_solids_move_up_to_what_they_touch_and_out_of_what_they_overlap(self):
        centred = gp.Sphere((0, 0, 0), 1)
        self.assertEqual(gp.sweep(centred, gp.Sphere((0, 4, 0), 1), (0, -4, 0)).t, 0.5)
        self.assertEqual(gp.penetration(centred, gp.Sphere((0, 0, 1.5), 1)).depth, 0.5)
        self.assertIsNone(gp.penetration(centred, gp.Sphere((0, 4, 0), 1)))
        scene = gp.Scene()
        scene.add(centred)
        target = scene.add(centred, ((0, 0, 10), STILL, 1))
        moving, deep, way = gp.Sphere((0, 0, 5), 1), gp.Sphere((0, 0, 8.5), 1), (0, 0, 6)
        others = gp.QueryFilterDesc(ignored_model=target)
        self.assertEqual(scene.sweep(moving, way).model, target)
        self.assertIsNone(scene.sweep_filtered(moving, way, others))
        self.assertEqual(scene.sweep_batch([moving, moving], np.float32([way] * 2))["model"].tolist(), [target] * 2)
        self.assertEqual(scene.sweep_filtered_batch([moving, moving], np.float32([way] * 2), others)["model"].tolist(), [0, 0])
        self.assertEqual(scene.penetration(deep)["depth"].tolist(), [0.5])
        self.assertEqual(len(scene.penetration_filtered(deep, others)), 0)
        ways_out, ends = scene.penetration_batch([deep, moving])
        self.assertEqual((ways_out["model"].tolist(), ends.tolist()), ([target], [0, 1, 1]))
        self.assertEqual(scene.penetration_filtered_batch([deep, moving], others)[1].tolist(), [0, 0, 0])
        solids = [gp.Sphere((0, 4, 0), 1), gp.Sphere((0, 0, 1.5), 1)]
        self.assertEqual(gp.sweep_batch(centred, solids, np.float32([(0, -4, 0)] * 2))["t"].tolist(), [0.5, 0])
        self.assertEqual(gp.penetration_batch(centred, solids)["depth"].tolist(), [-math.inf, 0.5])

    def test_shapes_change_and_trees_and_cameras_are_read(self):
        scene = gp.Scene()
        body = scene.add(BALL)
        head = scene.add(BALL, None, gp.ModelDesc(parent=body))
        scene.set_shape(body, gp.Sphere((0, 0, 0), 5))
        self.assertEqual(scene.get_bounds(body).max.x, 5)
        scene.set_scale(body, (2, 2, 2))
        self.assertEqual((scene.get_bounds(body).max.x, scene.get_scale(body).y), (10, 2))
        self.assertEqual(scene.get_roots().tolist(), [body])
        self.assertEqual(scene.get_children(body).tolist(), [head])
        camera = gp.Camera()
        camera.set_orthographic(10, 1, 100)
        camera.set_viewport(200, 100)
        self.assertEqual(camera.get_projection(), (gp.PROJECTION_ORTHOGRAPHIC, 10, 1, 100))
        self.assertEqual(camera.get_viewport(), (200, 100))

    def test_cameras_see_by_aspect_in_a_window_from_the_near_plane_on(self):
        camera = gp.Camera()
        camera.set_perspective_aspect(1, 2, 1, 100)
        self.assertEqual(camera.get_aspect(), (2, True))
        self.assertEqual(camera.get_conventions(), (gp.LEFT_HANDED, gp.DEPTH_ZERO_TO_ONE, False))
        camera.set_orthographic_size(8, 6, 1, 100)
        self.assertEqual(camera.get_image_size(), (8, 6))
        camera.set_viewport_origin(800, 0)
        self.assertEqual(camera.get_viewport_origin(), (800, 0))
        camera.set_perspective(1, 1, 100)
        self.assertEqual(camera.pick_ray(1200, 300).origin.z, 1)
        camera.set_pick_start(gp.PICK_FROM_CENTRE)
        self.assertEqual(camera.get_pick_start(), gp.PICK_FROM_CENTRE)
        self.assertEqual(camera.pick_ray(1200, 300).origin.z, 0)
        view = camera.get_view_matrix()
        camera.set_view_matrix(view)
        self.assertEqual(gp.mat4_orthonormality(view), 0)
        corners = camera.get_rectangle_corners(800, 0, 1600, 600)
        self.assertEqual([tuple(c) for c in corners], [tuple(c) for c in camera.get_corners()])
        self.assertEqual(tuple(camera.get_rectangle_frustum(800, 0, 1200, 600).origin), (0, 0, 0))
        camera.set_orbit(gp.default_orbit())
        camera.set_orbit_speeds(gp.OrbitSpeeds(0.5, 1, 2, 3, 4))
        self.assertEqual(camera.get_orbit_speeds().pan_y, 4)
        x1, y2, z3 = gp.Plane((1, 0, 0), 1), gp.Plane((0, 1, 0), 2), gp.Plane((0, 0, 1), 3)
        self.assertEqual(tuple(gp.planes_intersection(x1, y2, z3)), (1, 2, 3))
        self.assertIsNone(gp.planes_intersection(x1, y2, y2))
        points = gp.planes_intersection_batch([[1, 0, 0, 1]], [[0, 1, 0, 2]], [[0, 0, 1, 3]])
        self.assertEqual(points.tolist(), [[1, 2, 3]])

    def test_a_mesh_deforms_and_its_models_with_it(self):
        mesh = gp.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [0, 1, 2], gp.MeshDesc(deformable=1))
        scene = gp.Scene()
        model = scene.add(mesh)
        mesh.set_vertices([[0, 0, 7], [1, 0, 7], [0, 1, 7]])
        self.assertAlmostEqual(scene.get_bounds(model).min.z, 7, 3)
        self.assertEqual(mesh.get_info().deformable, 1)
        # The mesh of a restored scene, met from behind, or not.
        copy = gp.Scene()
        copy.restore(None, scene.get_snapshot(True))
        info = gp.Mesh.from_scene(copy, model).get_info()
        self.assertEqual((info.kind, info.vertex_count, info.triangle_count), (gp.MESH_SURFACE, 3, 1))
        from_behind = gp.Ray((0.2, 0.2, 0), (0, 0, 1), math.inf)
        fronts, backs = (gp.QueryFilterDesc(flags=f) for f in (gp.FILTER_NO_BACK_FACES, gp.FILTER_NO_FRONT_FACES))
        self.assertEqual(copy.raycast_filtered(from_behind, backs).flags, gp.HIT_BACK)
        self.assertIsNone(copy.raycast_filtered(from_behind, fronts))

    def test_a_hull_is_a_solid_mesh(self):
        hull = gp.Mesh.hull([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0.1, 0.1, 0.1]])
        self.assertEqual(len(hull.get_vertices()), 4)
        self.assertEqual(len(hull.get_hull_planes()), 4)
        self.assertEqual(hull.get_hull_faces().tolist(), [0, 1, 2, 3])

    def test_a_rope_is_picked_as_a_model_that_follows_it(self):
        solver = gp.Solver()
        rope = solver.add_rope([[0, 0, 0], [1, 0, 0], [2, 0, 0]])
        scene = gp.Scene()
        model = scene.add(gp.Mesh.from_body(solver, rope))
        solver.set_positions(rope, 0, [[0, 0, 7], [1, 0, 7], [2, 0, 7]])
        hit = scene.raycast(gp.Ray((1.8, 0, 0), (0, 0, 1), math.inf))
        self.assertEqual((hit.model, hit.triangle), (model, 1))
        self.assertEqual(solver.get_nearest_particle(rope, hit.triangle, hit.point), 2)

    def test_camera(self):
        camera = gp.Camera()
        camera.look_at((0, 0, -10), (0, 0, 0), UP)
        camera.set_perspective(1, 0.1, 100)
        pixel = camera.project((0, 0, 0))
        self.assert_near([pixel.x, pixel.y], [400, 300], 1e-2)
        self.assertIsNone(camera.project((0, 0, -20)))
        pixels = camera.project_batch(np.float32([[0, 0, 0], [1, 1, 1]]))
        self.assert_near(camera.unproject_batch(pixels)[1], [1, 1, 1], 1e-2)
        self.assert_near(camera.unproject(pixels[1]), [1, 1, 1], 1e-2)
        self.assertEqual(len(camera.pick_rays(0, 0, 4, 3)), 12)
        scene = gp.Scene()
        model = scene.add(BALL)
        self.assertEqual(camera.pick(scene, 400, 300).model, model)
        self.assertIsNone(camera.pick(scene, 1, 1))
        self.assertEqual(scene.cull(camera.get_frustum()).tolist(), [model])
        camera.set_viewport(200, 100)
        camera.set_orthographic(10, 0.1, 100)
        projection = camera.get_projection_matrix()
        self.assertAlmostEqual(projection[1, 1], 0.2, 6)
        camera.set_projection(projection)
        self.assertEqual(camera.get_world_matrix()[2, 3], -10)
        self.assertAlmostEqual(camera.get_view_matrix()[2, 3], 10, 5)
        camera.set_world_matrix((1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 4, 5, 6, 1))
        self.assert_near(camera.get_transform()[0], (4, 5, 6))
        camera.set_transform((1, 2, 3), (0, 1, 0, 0))
        self.assert_near(camera.get_transform()[0], (1, 2, 3))
        camera.set_origin((1, 0, 0))
        self.assertEqual(camera.get_origin().tolist(), [1, 0, 0])

    def test_orbit(self):
        camera = gp.Camera()
        with self.assertRaises(gp.Error):
            camera.get_orbit()
        camera.set_orbit(gp.default_orbit())
        camera.orbit_rotate(0.5, 0.25)
        camera.orbit_zoom(1)
        camera.orbit_pan(2, 0)
        camera.orbit_update()
        orbit = camera.get_orbit()
        self.assert_near((orbit.yaw, orbit.pitch, orbit.distance), (0.5, 0.25, 9))
        self.assertAlmostEqual(abs(orbit.target.x), 2, 3)

    def test_particles(self):
        scene, solver = gp.Scene(), gp.Solver(gp.SolverDesc(substeps=4))
        solver.set_gravity((0, -10, 0))
        solver.set_substeps(5)
        free = solver.add_particles(np.float32([[0, 5, 0], [1, 5, 0]]))
        solver.set_velocities(free, 1, np.float32([[3, 0, 0]]))
        solver.step(scene, 0.1)
        self.assert_near(solver.get_velocities(free, 0, 1)[0], (0, -1, 0))
        self.assert_near(solver.get_positions(free, 1, 1)[0], (1.3, 4.95, 0))
        solver.set_masses(free, 0, np.float32([2, 4]))
        self.assertEqual(solver.get_masses(free, 0, 2).tolist(), [2, 4])
        solver.set_forces(free, 0, np.float32([[0, 20, 0], [0, 40, 0]]))  # weightless
        solver.step(None, 0.1)
        self.assert_near(solver.get_velocities(free, 0, 1)[0], (0, -1, 0))
        plane = scene.add(gp.Plane(UP, 0))
        solver.set_radii(free, 0, np.float32([0.5, 0.5]))
        solver.set_positions(free, 0, np.float32([[0, 0.6, 0], [9, 0.6, 0]]))
        solver.set_forces(free, 0, np.zeros((2, 3), np.float32))
        for _ in range(30):
            solver.step(scene, 0.02)
        self.assertAlmostEqual(solver.get_positions(free, 0, 1)[0][1], 0.5, 3)
        contacts = solver.get_contacts()
        self.assertEqual(contacts["model"].tolist(), [plane] * 2)
        self.assertEqual(contacts["normal"][0].tolist(), list(UP))
        solver.set_origin((0, 1, 0))
        self.assertEqual(solver.get_origin()[1], 1)
        self.assertAlmostEqual(solver.get_positions(free, 0, 1)[0][1], -0.5, 3)

    def test_rope_and_cloth(self):
        scene, solver = gp.Scene(), gp.Solver()
        rope = solver.add_rope(np.float32([[0, 8, 0], [1, 8, 0], [2, 8, 0]]))
        self.assertEqual(solver.get_body_info(rope).kind, gp.BODY_ROPE)
        tie = solver.add_distance(rope, 0, 2, -1)
        constraints = solver.get_constraints(rope)
        self.assertEqual((len(constraints), constraints["id"][2], constraints["rest_length"][2]), (3, tie, 2))
        solver.remove_constraint(rope, tie)
        self.assertEqual(len(solver.get_constraints(rope)), 2)
        hook = scene.add(gp.Sphere((0, 0, 0), 0.1), ((0, 8, 0), STILL, 1), gp.ModelDesc(layers=2))
        solver.attach(scene, rope, 0, hook, (0, 0, 0))
        scene.set_transform(hook, ((0, 9, 0), STILL, 1))
        steps, leftover = solver.advance(scene, 0.025)
        self.assertEqual(steps, 1)
        self.assertAlmostEqual(leftover, 0.5, 5)
        self.assertAlmostEqual(solver.get_positions(rope, 0, 1)[0][1], 8 + 2 / 3, 5)
        self.assertEqual(solver.get_stats(rope).pinned_count, 1)
        solver.detach(rope, 0)
        with self.assertRaises(gp.InvalidArgument):
            solver.detach(rope, 0)
        cloth = solver.add_cloth((0, 3, 0), (1, 0, 0), (0, 0, 1), 3, 3)
        self.assertEqual(len(solver.get_triangles(cloth)), 24)
        shirt = solver.add_cloth_mesh(pyramid(), IDENTITY)
        self.assertEqual(solver.get_body_info(shirt).particle_count, 5)
        solver.remove_body(cloth)
        self.assertEqual(solver.get_bodies().tolist(), [rope, shirt])

        snapshot, past = solver.get_snapshot(), solver.get_hash()
        solver.step(scene, 0.01)
        self.assertNotEqual(solver.get_hash().tolist(), past.tolist())
        solver.restore(snapshot)
        self.assertEqual(solver.get_hash().tolist(), past.tolist())
        copy = gp.Scene()
        copy.restore(None, scene.get_snapshot(True))
        self.assertEqual(copy.get_hash().tolist(), scene.get_hash().tolist())
        copy.restore(scene, scene.get_snapshot(False))
        self.assertEqual(copy.get_models().tolist(), scene.get_models().tolist())
        solver.wake(0)
        self.assertEqual(solver.get_sleeping().tolist(), [])

    def test_substeps(self):
        """As many as asked for, or as a target takes."""
        plain, careful = gp.Solver(), gp.Solver(gp.SolverDesc(max_strain=1e-6))
        for solver in (plain, careful):
            cloth = solver.add_cloth((0, 0, 0), (1, 0, 0), (0, 0, 1), 3, 3)
            solver.set_pinned(cloth, 0, 1, True)
            self.assertEqual(solver.get_substeps(cloth), 0)
            for _ in range(5):
                solver.step(None, 0.01)
        self.assertEqual(plain.get_substeps(cloth), 8)
        self.assertGreater(careful.get_substeps(cloth), 8)

    def test_strings_volumes_impulses(self):
        """A weight of 1 kg and its end of the string hang from a hook; a pyramid keeps its volume."""
        scene, solver = gp.Scene(), gp.Solver()
        hook = scene.add(gp.Sphere((0, 0, 0), 0.1), None, gp.ModelDesc(tag=5))
        weights = solver.add_particles([(0, 0, 0), (0, -1, 0)], gp.BodyDesc(mass=2, layers=0))
        solver.attach(scene, weights, 0, hook, (0, 0, 0))
        string = solver.add_max_distance(weights, 0, 1, 2, 1e-6)
        solver.set_constraint_damping(weights, string, 50)
        self.assertEqual(solver.get_constraint_kinds(weights, [string]).tolist(), [gp.CONSTRAINT_MAX_DISTANCE])
        self.assertEqual(solver.get_attachments(weights)["model"].tolist(), [hook])
        for _ in range(300):
            solver.step(scene, 0.01)
        self.assertAlmostEqual(solver.get_positions(weights, 1, 1)[0][1], -2, 3)
        impulse, = solver.get_impulses()
        self.assertEqual([impulse["model"], impulse["tag"]], [hook, 5])
        self.assertAlmostEqual(impulse["linear"][1], -2 * 9.81 * 0.01, 2)
        ball = solver.add_cloth_mesh(pyramid())
        solver.set_volume(ball, -1)
        volume, pressure = solver.get_volume(ball)
        self.assertAlmostEqual(volume, 8 / 3, 5)
        self.assertEqual(pressure, 0)
        self.assertEqual(solver.get_volume_settings(ball), (volume, 0))
        solver.set_volume(ball, 1, float("inf"))
        with self.assertRaises(gp.Error) as caught:
            solver.get_volume(ball)
        self.assertEqual(caught.exception.status, gp.ERROR_UNSUPPORTED)

    def test_live_settings(self):
        """What is set is read, and acts: a winch, an elastic link, a body that is damped."""
        solver = gp.Solver()
        settings = solver.get_settings()
        settings.substeps = 5
        solver.set_settings(settings)
        self.assertEqual(solver.get_settings().substeps, 5)
        solver.set_worker_count(2)
        self.assertEqual((solver.get_worker_count(), solver.get_leftover()), (2, 0))
        rope = solver.add_rope([(0, 0, 0), (0, -1, 0)], 0)
        solver.set_pinned(rope, 0, 1, True)
        self.assertEqual(solver.get_pinned(rope, 0, 2).tolist(), [1, 0])
        body = solver.get_body_settings(rope)
        body.damping = 0.5
        solver.set_body_settings(rope, body)
        self.assertEqual(solver.get_body_settings(rope).damping, 0.5)
        links = [link["id"] for link in solver.get_constraints(rope)]
        link = solver.get_constraint_settings(rope, links)
        link["rest_length"] = 0.5
        solver.set_constraint_settings(rope, links, link)
        self.assertAlmostEqual(solver.get_radii(rope, 0, 2)[0], 0.01, 6)
        self.assertEqual(solver.get_forces(rope, 0, 2)[1].tolist(), [0, 0, 0])
        for _ in range(10):
            solver.step(None, 0.01)
        self.assertAlmostEqual(solver.get_positions(rope, 1, 1)[0][1], -0.5, 5)

    def test_wind(self):
        """Air carries a ball along; gusts are of single particles."""
        solver = gp.Solver(gp.SolverDesc(gravity=(0, 0, 0)))
        balls = solver.add_particles([(0, 0, 0), (1, 0, 0)])
        wind = gp.Wind((2, 0, 0), 1e4, 0.5, 0)
        solver.set_wind(balls, wind)
        self.assertEqual(solver.get_wind(balls).density, 1e4)
        solver.set_air_velocities(balls, 1, [(0, 3, 0)])
        self.assertEqual(solver.get_air_velocities(balls, 0, 2)[1].tolist(), [0, 3, 0])
        for _ in range(500):
            solver.step(None, 0.01)
        first, second = solver.get_velocities(balls, 0, 2)
        self.assertGreater(first[0], 1.8)
        self.assertGreater(second[1], 2.7)

    def test_a_cluster_holds_out_a_particle_until_it_ends(self):
        solver = gp.Solver()
        plank = solver.add_particles([(0, 0, 0), (1, 0, 0), (2, 0, 0)])
        solver.set_pinned(plank, 0, 2, True)
        cluster = solver.add_cluster(plank, [0, 1, 2])
        self.assertEqual(solver.get_clusters(plank).tolist(), [cluster])
        self.assertEqual(solver.get_cluster_particles(plank, cluster).tolist(), [0, 1, 2])
        for _ in range(30):
            solver.step(None, 0.01)
        place = solver.get_positions(plank, 2, 1)[0]
        self.assertAlmostEqual(place[0], 2, 5)
        self.assertAlmostEqual(place[1], 0, 5)
        solver.remove_cluster(plank, cluster)
        for _ in range(30):
            solver.step(None, 0.01)
        self.assertLess(solver.get_positions(plank, 2, 1)[0][1], -0.4)
        with self.assertRaises(gp.Error) as caught:
            solver.remove_cluster(plank, cluster)
        self.assertEqual(caught.exception.status, gp.ERROR_INVALID_ID)

    def test_a_rope_breaks_under_its_weight_and_cloth_is_cut(self):
        solver = gp.Solver()
        rope = solver.add_rope([(0, 0, 0), (0, -1, 0)], 0)
        solver.set_pinned(rope, 0, 1, True)
        links = [link["id"] for link in solver.get_constraints(rope)]
        solver.set_breaking_forces(rope, links, [3])
        self.assertEqual(solver.get_breaking_forces(rope, links).tolist(), [3])
        self.assertEqual(len(solver.get_breaks()), 0)
        for _ in range(10):
            if len(solver.get_breaks()) == 0:
                solver.step(None, 0.01)
        (broken,) = solver.get_breaks()
        self.assertEqual((broken["body"], broken["constraint"]), (rope, links[0]))
        self.assertEqual(broken["torn_particle"], gp.NO_PARTICLE)
        self.assertGreater(broken["load"], 3)
        with self.assertRaises(gp.Error) as caught:
            solver.break_constraint(rope, links[0])
        self.assertEqual(caught.exception.status, gp.ERROR_INVALID_ID)
        sheet = solver.add_cloth((0, 0, 0), (1, 0, 0), (0, 0, 1), 3, 3)
        cut = solver.break_constraint(sheet, int(solver.get_constraints(sheet)[1]["id"]))
        self.assertEqual(cut.new_particle, 9)

    def test_one_of_two_balls_slides_over_ice(self):
        solver = gp.Solver()
        scene = gp.Scene()
        scene.add(gp.Plane((0, 1, 0), 0))
        balls = solver.add_particles([(0, 0.01, 0), (0, 0.01, 1)])
        solver.set_friction_factors(balls, 1, [0])
        self.assertEqual(solver.get_friction_factors(balls, 0, 2).tolist(), [1, 0])
        solver.set_velocities(balls, 0, [(1, 0, 0), (1, 0, 0)])
        for _ in range(50):
            solver.step(scene, 0.01)
        first, second = solver.get_velocities(balls, 0, 2)
        self.assertEqual(first[0], 0)
        self.assertAlmostEqual(second[0], 1, 5)

    def test_a_ball_presses_the_one_that_it_lies_on(self):
        solver = gp.Solver()
        desc = gp.BodyDesc(mass=2, radius=0.5, body_layers=1)
        lower = solver.add_particles([(0, 0, 0)], desc)
        upper = solver.add_particles([(0, 1, 0)], desc)
        solver.set_pinned(lower, 0, 1, True)
        for _ in range(20):
            solver.step(None, 0.01)
        contacts = solver.get_body_contacts()
        self.assertEqual([contacts["body_a"].tolist(), contacts["body_b"].tolist()], [[lower], [upper]])
        self.assertEqual(contacts["normal"].tolist(), [[0, 1, 0]])
        self.assertAlmostEqual(contacts["impulse"][0], 0.1962, 3)

    def test_a_ball_hangs_below_its_animation_target(self):
        solver = gp.Solver()
        balls = solver.add_particles([(0, 0, 0), (1, 0, 0)])
        targets = solver.get_animation_targets(balls, 1, 1)
        self.assertEqual(targets["max_distance"][0], np.inf)
        targets["position"] = (1, 0, 0)
        targets["max_distance"] = 0.25
        solver.set_animation_targets(balls, 1, targets)
        self.assertEqual(solver.get_animation_targets(balls, 0, 2)["max_distance"].tolist(), [np.inf, 0.25])
        for _ in range(60):
            solver.step(None, 0.01)
        self.assertEqual(solver.get_positions(balls, 1, 1)[0][1], -0.25)

    def test_joints(self):
        """A weight hangs from a nail, which is another body."""
        solver = gp.Solver()
        nail = solver.add_particles([(0, 0, 0)], gp.BodyDesc(mass=2))
        weight = solver.add_particles([(0, -1, 0)], gp.BodyDesc(mass=2))
        solver.set_pinned(nail, 0, 1, True)
        joint = solver.join(nail, 0, weight, 0, -1)
        for _ in range(20):
            solver.step(None, 0.01)
        held, = solver.get_joints(weight)
        self.assertEqual([held["id"], held["body_a"], held["body_b"]], [joint, nail, weight])
        self.assertAlmostEqual(held["force"], 2 * 9.81, 2)
        solver.unjoin(joint)
        self.assertEqual(len(solver.get_joints(0)), 0)
        with self.assertRaises(gp.Error) as caught:
            solver.unjoin(joint)
        self.assertEqual(caught.exception.status, gp.ERROR_INVALID_ID)

    def test_names(self):
        self.assertEqual(gp.status_name(gp.NO_HIT), "GPHYS_NO_HIT")
        self.assertRegex(gp.__version__, r"^\d+\.\d+\.\d+$")


if __name__ == "__main__":
    unittest.main()
