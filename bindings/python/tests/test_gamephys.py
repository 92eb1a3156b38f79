"""The Python package: arrays without copies, errors, ownership, and agreement of batch and single."""
import ctypes
import gc
import math
import threading
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

    def test_empty_and_single_batches(self):
        scene, _, _ = scene_of_balls()
        self.assertEqual(len(scene.raycast_batch(random_rays()[:0])), 0)
        self.assertEqual(len(scene.raycast_batch(random_rays()[3:4])), 1)
        self.assertEqual(len(gp.Scene().get_models()), 0)

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
