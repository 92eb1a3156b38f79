"""The Python package: arrays without copies, errors, ownership, and agreement of batch and single."""
import copy
import ctypes
import gc
import inspect
import math
import pickle
import threading
import time
import unittest

import gamephys as gp
import numpy as np
from gamephys import _low


def scene_of_balls(count=50):
    scene = gp.Scene()
    balls = np.zeros(count, gp.sphere_dtype)
    balls["center"] = np.random.default_rng(2).uniform(-10, 10, (count, 3))
    balls["radius"] = 1
    return scene, balls, scene.add_batch(balls)


def random_rays(count=500):
    random = np.random.default_rng(3)
    rays = np.zeros(count, gp.ray_dtype)
    rays["origin"] = random.uniform(-20, 20, (count, 3))
    rays["direction"] = random.normal(size=(count, 3))
    rays["t_max"] = np.inf
    return rays


class Structs(unittest.TestCase):
    def test_dtypes_lay_fields_out_as_the_structs_do(self):
        checked = 0
        for name, kind in vars(_low).items():
            if isinstance(kind, type) and hasattr(kind, "dtype") and kind.dtype.names:
                for field, *_ in kind._fields_:
                    self.assertEqual(getattr(kind, field).offset, kind.dtype.fields[field][1], (name, field))
                    checked += 1
                self.assertEqual(kind.dtype.itemsize, ctypes.sizeof(kind))
        self.assertGreater(checked, 80)

    def test_descs_start_from_the_librarys_defaults(self):
        self.assertEqual(gp.BodyDesc().friction, 0.5)
        self.assertEqual(gp.CameraDesc(viewport_width=100).viewport_height, 600)
        with self.assertRaises(TypeError):
            gp.CameraDesc(viewport_widht=100)


    def test_vectors_are_taken_from_whatever_has_numbers(self):
        ball = gp.Sphere((0, 0, 5), 1)
        for center in ([0, 0, 5], np.array([0, 0, 5]), np.float32([0, 0, 5]), gp.Vec3(0, 0, 5), np.arange(15)[0::3][:3] * 0 + [0, 0, 5]):
            self.assertEqual(gp.Sphere(center, 1), ball)
            self.assertEqual(gp.Sphere(center=center, radius=np.float64(1)), ball)
        ball.center = np.array([1.0, 2, 3])
        self.assertEqual(ball.center, (1, 2, 3))
        turned = gp.Transform(np.zeros(3), np.array([0, 0, 0, 1]), np.float32(2))
        self.assertEqual(turned, gp.Transform((0, 0, 0), (0, 0, 0, 1), 2))
        self.assertEqual(gp.SolverDesc(gravity=np.array([0, -1, 0])).gravity.y, -1)
        scene = gp.Scene()
        scene.add(gp.Sphere([0, 0, 5], 1))
        for ray in (gp.Ray(np.zeros(3), np.array([0, 0, 1]), 100), ([0, 0, 0], np.array([0, 0, 1]), 100),
                    np.array([0, 0, 0, 0, 0, 1, 100]), gp.Ray((0, 0, 0), (0, 0, 1))):
            self.assertEqual(scene.raycast(ray).t, 4)

    def test_vectors_are_arrays_and_tuples(self):
        scene = gp.Scene()
        scene.add(gp.Sphere((0, 0, 5), 1))
        hit = scene.raycast(gp.Ray((0, 0, 0), (0, 0, 1), 100))
        self.assertEqual((hit.point[2], hit.point[-1], len(hit.point), tuple(hit.point)), (4, 4, 3, (0, 0, 4)))
        self.assertTrue(hit.point == (0, 0, 4) and hit.point == [0, 0, 4] and hit.point != (0, 0, 5))
        for dtype in (None, "f4", "f8"):
            np.testing.assert_array_equal(np.asarray(hit.point, dtype), [0, 0, 4])
        self.assertEqual(np.asarray(hit.point).dtype, np.float32)
        np.testing.assert_array_equal(hit.point == np.array([0, 0, 4]), [True] * 3)
        np.testing.assert_array_equal(hit.point + hit.normal, [0, 0, 3])
        np.testing.assert_array_equal(np.ones(3) + 2 * hit.point - (1, 1, 1), [0, 0, 8])
        np.asarray(hit.point)[2] = 7
        self.assertEqual(hit.point.z, 7)

    def test_what_is_not_given_is_the_identity(self):
        self.assertEqual(gp.Transform(), gp.Transform((0, 0, 0), (0, 0, 0, 1), 1))
        self.assertEqual(gp.Quat(), (0, 0, 0, 1))
        scene = gp.Scene()
        model = scene.add(gp.Obb((0, 0, 0), (1, 1, 1)), gp.Transform(position=(1, 2, 3)))
        self.assertEqual(scene.get_transforms([model])["position"].tolist(), [[1, 2, 3]])

    def test_fields_that_do_not_exist_are_refused(self):
        for kind, name in ((gp.Ray, "orgin"), (gp.Sphere, "rad"), (gp.CameraDesc, "viewport_widht"), (gp.Vec3, "w")):
            with self.assertRaisesRegex(TypeError, name):
                kind(**{name: 1})
            with self.assertRaisesRegex(AttributeError, name):
                setattr(kind(), name, 1)
        with self.assertRaises(AttributeError):
            gp.default_orbit().tagret = (0, 0, 0)

    def test_errors_name_the_field(self):
        for error, message, make in (
            (ValueError, "Sphere.center has 3 numbers, got 2", lambda: gp.Sphere((0, 0), 1)),
            (TypeError, "Sphere.radius: expected a number, got str", lambda: gp.Sphere((0, 0, 0), "1")),
            (TypeError, "Sphere.center: expected 3 numbers, got int", lambda: gp.Sphere(1, 1)),
            (ValueError, "ModelDesc.tag 4294967296 is not in 0", lambda: gp.ModelDesc(tag=2**32)),
            (TypeError, "ModelDesc.tag: expected a whole number, got float", lambda: gp.ModelDesc(tag=1.5)),
        ):
            with self.assertRaisesRegex(error, message):
                make()
        self.assertEqual(gp.ModelDesc(layers=~1).layers, 2**32 - 2)
        self.assertEqual(gp.ModelDesc.array(2, layers=[~1, 3])["layers"].tolist(), [2**32 - 2, 3])

    def test_values_are_copied_and_pickled(self):
        for value in (gp.Sphere((0, 0, 5), 1), gp.Vec3(1, 2, 3), gp.BodyDesc(mass=3), gp.Hit(t=3)):
            self.assertEqual(copy.deepcopy(value), value)
            self.assertEqual(pickle.loads(pickle.dumps(value)), value)

    def test_help_says_what_a_struct_is_made_of(self):
        self.assertEqual(list(inspect.signature(gp.Sphere).parameters), ["center", "radius"])
        self.assertEqual(inspect.signature(gp.Transform).parameters["scale"].default, 1)
        self.assertIn("tag", inspect.signature(gp.ModelDesc).parameters)
        self.assertIn("radius: >= 0", gp.Sphere.__doc__)


class Matrices(unittest.TestCase):
    MOVED = np.array([[0, 0, 1, 5], [0, 1, 0, 6], [-1, 0, 0, 7], [0, 0, 0, 1]])  # a quarter turn about y

    def test_the_rows_of_a_matrix_are_those_of_numpy(self):
        camera = gp.Camera()
        for world in (self.MOVED, self.MOVED.tolist(), np.asfortranarray(self.MOVED, "f4"), self.MOVED.T.ravel(),
                      tuple(self.MOVED.T.ravel()), gp.Mat4(tuple(self.MOVED.T.ravel()))):
            camera.set_transform((0, 0, 0), (0, 0, 0, 1))
            camera.set_world_matrix(world)
            np.testing.assert_allclose(camera.get_world_matrix(), self.MOVED, atol=1e-6)
            self.assertEqual(camera.get_transform()[0], (5, 6, 7))
        forward = camera.get_world_matrix() @ (0, 0, 1, 0)
        ray = camera.pick_ray(400, 300)
        np.testing.assert_allclose(forward[:3], ray.direction / np.linalg.norm(ray.direction), atol=1e-6)
        np.testing.assert_allclose(camera.get_view_matrix() @ camera.get_world_matrix(), np.eye(4), atol=1e-6)
        for transposed in (self.MOVED.T, self.MOVED.ravel()):
            with self.assertRaisesRegex(ValueError, "last row"):
                camera.set_world_matrix(transposed)

    def test_a_projection_is_taken_as_it_is_given(self):
        camera = gp.Camera()
        camera.set_perspective(1, 0.5, 50)
        projection = camera.get_projection_matrix()
        self.assertEqual(projection[3].tolist(), [0, 0, 1, 0])
        point = camera.get_view_projection_matrix() @ (1, 2, 10, 1)
        pixel = camera.project((1, 2, 10))
        np.testing.assert_allclose(point[:3] / point[3] * (400, -300, 1) + (400, 300, 0), np.asarray(pixel), rtol=1e-5)
        other = gp.Camera()
        other.set_projection(projection)
        np.testing.assert_allclose(np.asarray(other.project((1, 2, 10))), np.asarray(pixel), rtol=1e-5)

    def test_what_is_no_matrix_is_refused(self):
        camera = gp.Camera()
        for bad in (np.eye(3), np.zeros(15), [[1, 2], [3, 4]]):
            with self.assertRaisesRegex(ValueError, "world: expected 4 rows"):
                camera.set_world_matrix(bad)


class Batches(unittest.TestCase):
    def test_a_batch_answers_as_single_calls_do(self):
        scene, _, _ = scene_of_balls()
        rays = random_rays()
        hits = scene.raycast_batch(rays)
        for ray, hit in zip(rays, hits):
            single = scene.raycast(ray)
            if single is None:
                self.assertEqual(hit["model"], 0)
            else:
                self.assertEqual(bytes(single), hit.tobytes())
        self.assertTrue(0 < np.count_nonzero(hits["model"]) < len(rays))

    def test_any_step_between_elements_is_taken_without_a_copy(self):
        scene, _, _ = scene_of_balls()
        rays = random_rays()
        expected = scene.raycast_batch(rays)
        wide = np.zeros(len(rays), [("id", "<u4"), ("ray", gp.ray_dtype), ("more", "<f8")])
        wide["ray"] = rays
        out = np.zeros(len(rays), [("hit", gp.hit_dtype), ("mark", "<u4")])
        result = scene.raycast_batch(wide["ray"], out=out["hit"])
        self.assertTrue(np.shares_memory(result, out))
        np.testing.assert_array_equal(out["hit"], expected)
        self.assertFalse(out["mark"].any())
        rows = rays.view("<f4").reshape(-1, 7)
        np.testing.assert_array_equal(scene.raycast_batch(rows), expected)
        np.testing.assert_array_equal(scene.raycast_batch(rays[::-2]), expected[::-2])
        np.testing.assert_array_equal(scene.raycast_batch(rows.astype("f8")), expected)

    def test_ids_with_other_fields_between_them(self):
        solver = gp.Solver()
        rope = solver.add_rope([(x, 0, 0) for x in range(5)])
        ids = solver.get_constraints(rope)["id"]
        self.assertFalse(ids.flags.contiguous)
        solver.set_breaking_forces(rope, ids, [1, 2, 3, 4])
        self.assertEqual(list(solver.get_breaking_forces(rope, ids[::-1])), [4, 3, 2, 1])
        scene, balls, models = scene_of_balls(8)
        scene.remove_batch(np.array(models, "<u4")[::2])
        self.assertEqual(list(scene.get_models()), sorted(models[1::2]))
        table = np.zeros(8, [("model", "<u4"), ("mark", "<u4")])
        with self.assertRaises(ValueError):
            scene.add_batch(balls, out=table["model"])
        self.assertFalse(table["mark"].any())

    def test_empty_and_single_batches(self):
        scene, _, _ = scene_of_balls()
        self.assertEqual(len(scene.raycast_batch(random_rays()[:0])), 0)
        self.assertEqual(len(scene.raycast_batch(random_rays()[3:4])), 1)
        self.assertEqual(len(gp.Scene().get_models()), 0)
        for empty in ([], (), np.empty((0, 7)), np.empty(0)):
            self.assertEqual(len(scene.raycast_batch(empty)), 0)
        self.assertEqual(len(scene.add_batch([])), 0)
        self.assertEqual(len(scene.get_transforms([])), 0)
        self.assertEqual([len(part) for part in scene.overlap_batch([])], [0, 1])
        scene.remove_batch([])

    def test_wrong_arrays_are_refused(self):
        scene, _, _ = scene_of_balls()
        rays = random_rays(8)
        for bad in (np.zeros((8, 6), "f4"), np.zeros(8, gp.segment_dtype), np.zeros(7, "f4")):
            with self.assertRaises(ValueError):
                scene.raycast_batch(bad)
        read_only = np.zeros(8, gp.hit_dtype)
        read_only.flags.writeable = False
        for out in (np.zeros(7, gp.hit_dtype), np.zeros(8, "f4"), read_only, np.zeros(8, gp.hit_dtype)[::-1]):
            with self.assertRaises(ValueError):
                scene.raycast_batch(rays, out=out)

    def test_lists_of_any_length(self):
        scene, balls, models = scene_of_balls(1000)
        self.assertEqual(list(scene.get_models()), sorted(models))
        boxes = np.zeros(3, gp.aabb_dtype)
        boxes["min"], boxes["max"] = -20, [[20] * 3, [-19] * 3, [0] * 3]
        found, offsets = scene.overlap_batch(boxes)
        self.assertEqual(offsets[1], 1000)
        self.assertEqual(offsets[2], 1000)
        np.testing.assert_array_equal(found[offsets[2]:offsets[3]], scene.overlap(gp.Aabb((-20,) * 3, (0,) * 3)))

    def test_one_shape_against_many(self):
        contained = gp.contains_batch(gp.Sphere((0, 0, 0), 1), np.float32([[0, 0, 0], [2, 0, 0]]))
        self.assertEqual(list(contained), [1, 0])
        balls = [gp.Sphere((x, 0, 0), 1) for x in range(4)]
        self.assertEqual(list(gp.overlaps_batch(balls, gp.Plane((1, 0, 0), 0))), [1, 1, 0, 0])


class Errors(unittest.TestCase):
    def test_the_librarys_message_is_the_exceptions(self):
        scene = gp.Scene()
        with self.assertRaises(gp.InvalidArgument) as caught:
            scene.add(gp.Sphere((0, 0, 0), -1))
        self.assertIn("radius", str(caught.exception))
        self.assertEqual(caught.exception.status, gp.ERROR_INVALID_ARGUMENT)
        with self.assertRaises(ValueError):
            scene.raycast(gp.Ray((0, 0, 0), (0, 0, 0), 1))
        with self.assertRaises(LookupError):
            scene.remove(12345)
        with self.assertRaises(TypeError):
            scene.add("ball")

    def test_what_is_not_meant_is_refused(self):
        scene, solver = gp.Scene(), gp.Solver()
        scene.add(gp.Sphere((0, 0, 5), 1))
        self.assertEqual(scene.raycast_batch([[0, 0, 0, 0, 0, 1, 9]])["t"].tolist(), [4])
        for error, call in (
            (TypeError, lambda: solver.step(gp.Camera(), 0.1)),
            (TypeError, lambda: gp.Scene(gp.SolverDesc())),
            (TypeError, lambda: scene.raycast(gp.Segment((0, 0, 0), (0, 0, 9)))),
            (TypeError, lambda: scene.raycast_batch(np.ones((2, 7), complex))),
            (TypeError, lambda: scene.raycast_batch(np.ones((1, 7), "f4"), out=[None])),
            (TypeError, lambda: scene.get_transforms([1.5])),
            (ValueError, lambda: scene.get_transforms([-1])),
            (ValueError, lambda: scene.get_transforms(np.array([2**32 + 1]))),
            (ValueError, lambda: scene.raycast(((0, 0, 0), (0, 0, 1)))),
            (ValueError, lambda: scene.raycast(((0, 0), (0, 0, 1), 9))),
            (ValueError, lambda: gp.Sphere((0, 0), 1)),
            (ValueError, lambda: scene.raycast_batch(np.full((2, 7), np.nan, "f4"))),
        ):
            with self.assertRaises(error):
                call()

    def test_memory_for_results_has_their_shape(self):
        scene = gp.Scene()
        scene.add(gp.Sphere((0, 0, 5), 1))
        rays = gp.rays(4, (0, 0, 0), (0, 0, 1))
        for out in np.zeros((4, 5), "i4"), np.zeros((4, 1), "i4"), np.zeros(3, "i4"), np.zeros(20, "i4")[::-5]:
            with self.assertRaisesRegex(ValueError, "out must"):
                scene.raycast_any_batch(rays, out=out)
            self.assertFalse(out.any())
        self.assertEqual(scene.raycast_any_batch(rays, out=np.zeros((4, 5), "i4")[:, 2]).tolist(), [1] * 4)

    def test_memory_between_multiples_of_4_bytes_is_copied_and_refused_for_results(self):
        scene = gp.Scene()
        scene.add(gp.Sphere((0, 0, 5), 1))
        rays = gp.rays(4, (0, 0, 0), (0, 0, 1))
        inner = np.zeros(rays.nbytes + 1, "u1")[1:].view(rays.dtype)
        inner[:] = rays
        hits = scene.raycast_batch(inner)
        self.assertEqual(hits["t"].tolist(), [4] * 4)
        with self.assertRaisesRegex(ValueError, "out must begin at a multiple of 4 bytes"):
            scene.raycast_batch(rays, out=np.zeros(hits.nbytes + 1, "u1")[1:].view(hits.dtype))

    def test_ids_and_masks_beyond_32_bits_are_refused_by_name(self):
        scene = gp.Scene()
        ball = scene.add(gp.Sphere((0, 0, 5), 1))
        ray = gp.Ray((0, 0, 0), (0, 0, 1), 100)
        solver = gp.Solver()
        for error, message, call in (
            (ValueError, "model .* is not in 0", lambda: scene.remove(2**32 + ball)),
            (ValueError, "model -1 is not in 0", lambda: scene.remove(-1)),
            (TypeError, "model: expected a whole number, got float", lambda: scene.remove(1.5)),
            (TypeError, "model: expected a whole number, got NoneType", lambda: scene.set_tag(None, 1)),
            (ValueError, "tag 4294967296", lambda: scene.set_tag(ball, 1 << 32)),
            (ValueError, "layers 4294967296", lambda: scene.raycast(ray, 1 << 32)),
            (TypeError, "layers: expected a whole number", lambda: scene.raycast(ray, 1.5)),
            (ValueError, "layers", lambda: scene.raycast(ray, -(2**31) - 1)),
            (TypeError, "dt: expected a number, got str", lambda: solver.step(scene, "1")),
            (TypeError, "dt: expected a number, got NoneType", lambda: solver.step(scene, None)),
            (TypeError, "ray: expected Ray, got int", lambda: scene.raycast(3)),
        ):
            with self.assertRaisesRegex(error, message):
                call()
        self.assertIn(ball, scene)
        self.assertIn(np.uint32(ball), scene)
        self.assertEqual(scene.raycast(ray, ~2).t, 4)
        self.assertIsNone(scene.raycast(ray, ~1))
        solver.step(None, np.float32(0.01))

    def test_use_after_close_is_an_exception(self):
        scene = gp.Scene()
        scene.close()
        scene.close()
        with self.assertRaises(ValueError):
            scene.get_models()
        with gp.Mesh(np.float32([[0, 0, 0], [1, 0, 0], [0, 1, 0]]), np.uint32([0, 1, 2])) as mesh:
            pass
        with self.assertRaises(ValueError):
            gp.Scene().add(mesh)

    def test_a_failed_constructor_leaves_nothing(self):
        with self.assertRaises(gp.InvalidArgument):
            gp.Mesh(np.zeros((3, 3), "f4"), np.uint32([0, 1, 7]))
        gc.collect()


class Objects(unittest.TestCase):
    def test_a_mesh_lives_as_long_as_its_models(self):
        scene = gp.Scene()
        mesh = gp.Mesh(np.float32([[-1, -1, 5], [1, -1, 5], [0, 1, 5]]), np.uint32([0, 1, 2]))
        scene.add(mesh)
        del mesh
        gc.collect()
        self.assertEqual(scene.raycast(((0, 0, 0), (0, 0, 1), math.inf)).t, 5)

    def test_shapes_come_back(self):
        scene = gp.Scene()
        capsule = gp.Capsule((0, 0, 0), (0, 1, 0), 0.25)
        model = scene.add(capsule)
        self.assertEqual(scene.get_shape(model), capsule)
        self.assertIn(model, scene)
        moved = gp.transform(gp.Aabb((0, 0, 0), (2, 2, 2)), gp.Transform((1, 0, 0), (0, 0, 0, 1), 1))
        self.assertEqual(tuple(moved.center), (2, 1, 1))

    def test_an_object_cannot_be_copied(self):
        scene = gp.Scene()
        for attempt in (copy.copy, copy.deepcopy, pickle.dumps):
            with self.assertRaisesRegex(TypeError, "Scene cannot be copied"):
                attempt(scene)
        self.assertEqual(len(scene.get_models()), 0)

    def test_objects_say_what_they_hold(self):
        scene, solver = gp.Scene(), gp.Solver()
        models = [scene.add(gp.Sphere((x, 0, 0), 1)) for x in range(3)]
        rope = solver.add_rope([(0, 0, 0), (0, 1, 0)])
        self.assertEqual(repr(scene), "<gamephys.Scene of 3 models>")
        self.assertEqual(repr(solver), "<gamephys.Solver of 1 bodies>")
        self.assertEqual(repr(gp.Mesh(np.eye(3), [0, 1, 2])), "<gamephys.Mesh of 1 triangles>")
        self.assertEqual(repr(gp.Camera()), "<gamephys.Camera>")
        self.assertEqual((len(scene), list(scene), list(solver), rope in solver), (3, models, [rope], True))
        self.assertTrue(gp.Scene())
        scene.close()
        self.assertEqual(repr(scene), "<gamephys.Scene, closed>")
        self.assertRegex(gp.__version__, r"^\d+\.\d+\.\d+$")

    def test_a_whole_body_is_read_and_pinned_by_default(self):
        solver = gp.Solver()
        rope = solver.add_rope([(0, 0, 0), (0, 1, 0), (0, 2, 0)])
        self.assertEqual(solver.get_positions(rope)[:, 1].tolist(), [0, 1, 2])
        self.assertEqual(solver.get_positions(rope, 1)[:, 1].tolist(), [1, 2])
        self.assertEqual(len(solver.get_velocities(rope)), 3)
        solver.set_pinned(rope)
        self.assertEqual(solver.get_pinned(rope).tolist(), [1, 1, 1])
        solver.set_pinned(rope, first=1, pinned=False)
        self.assertEqual(solver.get_pinned(rope).tolist(), [1, 0, 0])
        with self.assertRaises(ValueError):
            solver.get_positions(rope, 4)

    def test_one_id_is_no_list_of_ids(self):
        scene = gp.Scene()
        model = scene.add(gp.Sphere((0, 0, 0), 1))
        for one in (model, np.uint32(model)):
            with self.assertRaisesRegex(TypeError, f"expected an array of numbers, or a list, got {model}"):
                scene.get_world_transforms(one)
        self.assertEqual(len(scene.get_world_transforms([model])), 1)

    def test_yes_and_no_are_no_numbers_of_particles(self):
        scene, solver = gp.Scene(), gp.Solver()
        rope = solver.add_rope([(0, 0, 0), (0, 1, 0), (0, 2, 0)], 0, gp.BodyDesc(self_collision=True))
        for wrong in (lambda: solver.set_pinned(rope, False), lambda: solver.get_positions(rope, True),
                      lambda: scene.has(True), lambda: solver.get_stats(False)):
            with self.assertRaisesRegex(TypeError, "expected a whole number, got bool"):
                wrong()
        self.assertEqual(solver.get_pinned(rope).tolist(), [0, 0, 0])
        self.assertEqual(solver.get_body_settings(rope).self_collision, 1)  # a field may be one

    def test_a_scene_that_is_closed_while_others_ask_stays_until_they_are_done(self):
        rays = random_rays(20000)
        for _ in range(5):
            scene, _, _ = scene_of_balls(2000)
            expected = scene.raycast_batch(rays)
            results = []

            def ask():
                for _ in range(10000):
                    try:
                        results.append(np.array_equal(scene.raycast_batch(rays), expected))
                    except ValueError as error:
                        results.append(str(error))
                        return

            threads = [threading.Thread(target=ask) for _ in range(3)]
            for thread in threads:
                thread.start()
            time.sleep(0.02)
            scene.close()
            for thread in threads:
                thread.join()
            self.assertEqual(set(results) - {True}, {"Scene is closed"})

    def test_threads_may_ask_at_once(self):
        scene, _, _ = scene_of_balls()
        rays = random_rays(5000)
        expected = scene.raycast_batch(rays)
        results = [None] * 4
        threads = [threading.Thread(target=lambda i=i: results.__setitem__(i, scene.raycast_batch(rays))) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for result in results:
            np.testing.assert_array_equal(result, expected)


if __name__ == "__main__":
    unittest.main()
