# SPDX-License-Identifier: MIT
"""Scenes, meshes and files."""

import os
import pathlib
import tempfile
import threading
import types
import unittest

import graze
import numpy as np
from test_shapes import CUBE, FACES

ROOT = pathlib.Path(__file__).resolve().parents[3]


class SceneTest(unittest.TestCase):
    def test_events_follow_moves(self):
        scene = graze.Scene()
        ball = scene.add(graze.Sphere([0, 0, 1], 1), name="ball")
        floor = scene.add(graze.HalfSpace([0, 0, 1], 0), name="floor", layer="ground", fixed=True)
        events = scene.update()
        self.assertEqual(events.began.tolist(), [[ball, floor]])
        self.assertEqual(scene.pairs().tolist(), [[ball, floor]])
        scene.move(ball, graze.Sphere([0, 0, 3], 1))
        self.assertEqual(scene.update().ended.tolist(), [[ball, floor]])
        self.assertEqual((scene.find("ball"), scene.object(floor).layer, len(scene)), (ball, 0, 2))
        self.assertEqual(scene.layer_names, ["ground"])

    def test_stale_and_foreign_ids_are_errors(self):
        scene = graze.Scene()
        ball = scene.add(graze.Sphere([0, 0, 0], 1))
        scene.remove(ball)
        for number in (ball, 0, 2**40, -1, 2**70):
            with self.subTest(number), self.assertRaises(IndexError):
                scene.object(number)
        self.assertNotIn(ball, scene)
        with self.assertRaises(TypeError):
            scene.object("ball")
        index = graze.Bvh()
        key = index.insert([0, 0, 0, 1, 1, 1])
        index.erase(key)
        with self.assertRaises(IndexError):
            index.box(key)
        other = graze.Scene()
        scene.add(graze.Sphere([0, 0, 0], 1))
        with self.assertRaisesRegex(IndexError, "belongs to another scene"):
            scene.object(other.add(graze.Sphere([0, 0, 0], 1)))
        with self.assertRaisesRegex(IndexError, "was removed"):
            scene.object(ball)
        scenes = [graze.Scene(), graze.Scene()]
        ids = [each.add(graze.Sphere([0, 0, 0], 1)) for each in scenes]
        self.assertTrue(0 < ids[0] < 2**63 and 0 < ids[1] < 2**63 and ids[0] != ids[1])
        with self.assertRaises(IndexError):
            scenes[0].object(ids[1])
        with self.assertRaises(IndexError):
            scenes[1].move_many([ids[0]], [graze.Sphere([1, 0, 0], 1)])
        indexes = [graze.Grid(), graze.Orthtree()]
        keys = [each.insert([0, 0, 0, 1, 1, 1]) for each in indexes]
        with self.assertRaises(IndexError):
            indexes[0].erase(keys[1])

    def test_an_index_finds_the_nearest_of_many_points(self):
        random = np.random.default_rng(8)
        corners = random.random((500, 3)) * 10
        boxes, points = np.hstack([corners, corners + 0.5]), random.random((700, 3)) * 10
        for index in (graze.Bvh(), graze.Orthtree(), graze.Grid()):
            self.assertEqual([found.shape for found in index.nearest_many(points, 3)], [(700, 0), (700, 0)])
            index.assign(boxes)
            keys, distances = index.nearest_many(points, 3, threads=2)
            self.assertEqual((keys.shape, distances.shape), ((700, 3), (700, 3)))
            for i in range(0, 700, 50):
                near, squares = index.nearest(points[i], 3)
                np.testing.assert_array_equal(keys[i], near)
                np.testing.assert_array_equal(distances[i], squares)
            with self.assertRaisesRegex(ValueError, "row 1"):
                index.nearest_many([[0, 0, 0], [0, np.inf, 0]])

    def test_arrays_move_many_objects_or_none(self):
        centers = np.random.default_rng(2).random((200, 3)) * 20
        scene = graze.Scene()
        ids = scene.add_many(graze.Sphere.many(centers, np.ones(200)))
        scene.move_many(ids, graze.Sphere.many(centers + 1, np.ones(200)))
        np.testing.assert_array_equal(scene.object(int(ids[7])).shape.center, centers[7] + 1)
        boxes = np.hstack([centers, centers + 1])
        scene.move_many(ids, boxes)
        np.testing.assert_array_equal(np.searchsorted(ids, scene.pairs()), graze.overlapping_pairs(boxes))
        boxes[9, 0] = np.nan
        with self.assertRaises(ValueError):
            scene.move_many(ids, boxes)
        self.assertEqual(scene.object(int(ids[0])).shape, graze.Aabb(centers[0], centers[0] + 1))

    def test_queries_agree_with_those_on_two_shapes(self):
        scene = graze.Scene()
        near = graze.Sphere([3, 0, 0], 1)
        ids = [scene.add(near), scene.add(graze.Capsule([9, 0, 0], [9, 5, 0], 1), layer=1)]
        ray = graze.Ray([0, 0, 0], [1, 0, 0])
        self.assertEqual(scene.ray_cast(ray), graze._results.ObjectHit(ids[0], graze.ray_cast(near, ray)))
        self.assertEqual([hit.id for hit in scene.ray_cast_all(ray)], ids)
        self.assertEqual(scene.ray_cast(ray, layers=[1]).id, ids[1])
        self.assertEqual(scene.ray_cast(ray, excluding=[ids[0]]).id, ids[1])
        self.assertIsNone(scene.ray_cast(ray, 1.5))
        ball = graze.Sphere([0, 0, 0], 1)
        self.assertEqual(scene.shape_cast(ball, [4, 0, 0]).impact, graze.shape_cast(ball, [4, 0, 0], near))
        self.assertEqual(scene.nearest(ball, 5)[0].distance, graze.distance(ball, near))
        self.assertEqual(scene.contacts_with(graze.Sphere([2, 0, 0], 1))[0].manifold,
                         graze.manifold(graze.Sphere([2, 0, 0], 1), near))
        snapshot = scene.snapshot()
        scene.remove(ids[0])
        self.assertEqual(snapshot.ray_cast(ray).id, ids[0])
        self.assertEqual(len(scene.slide(ball, [20, 0, 0]).touches) > 0, True)

    def test_records_its_calls_for_replay(self):
        for dimension, dtype in ((2, np.float32), (3, np.float64)):
            scene = graze.Scene(dimension, dtype)
            first = scene.add(graze.Sphere([0] * dimension, 1, dtype=dtype), name="first")
            with tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder, "world.log")
                scene.record(path)
                with self.assertRaisesRegex(RuntimeError, "recorded already"):
                    scene.record(path)
                centers = np.arange(8 * dimension, dtype=dtype).reshape(8, dimension)
                spheres = graze.Sphere.many(centers, np.full(8, 1.5), dtype=dtype)
                ids = scene.add_many(spheres, layer="crowd")
                scene.update()
                scene.move_many(ids, graze.Sphere.many(centers + dtype(0.5), np.full(8, 1.5), dtype=dtype))
                scene.move_many(ids[:2], np.hstack([centers[:2], centers[:2] + dtype(1)]))
                scene.move(first, spheres[0])
                scene.except_pair(ids[0], ids[1])
                self.assertEqual(len(scene.update().began), len(scene.events.began))
                ray = graze.Ray([-9] * dimension, [1] * dimension, dtype=dtype)
                self.assertEqual(scene.ray_cast(ray, excluding=[first, ids[0], ids[1]]).id, ids[2])
                self.assertNotIn(ids[2], scene.overlapping(spheres[2], layers=["crowd"], excluding=[ids[2]]))
                scene.cull(spheres[1])
                scene.nearest([0] * dimension, 3, excluding=[first])
                scene.ray_cast_all(ray, 5)
                scene.shape_cast(spheres[0], [1] * dimension)
                scene.contacts(), scene.contacts_with(spheres[3]), scene.closest_pairs(1), scene.candidates(0.5)
                scene.slide(spheres[0], [1] * dimension)  # is no call on a scene, so it is not recorded
                with self.assertRaises(IndexError):
                    scene.remove(int(ids[0]) + 2**40)
                scene.stop_recording()
                scene.stop_recording()
                scene.remove(first)
                text = path.read_text()
                self.assertEqual(graze.replay(path), graze.replay(text))
                self.assertEqual(len(graze.scene_after(path)), len(graze.scene_after(text)))
            report = graze.replay(text)
            with self.assertRaisesRegex(FileNotFoundError, "world.log"):
                graze.replay(path)
            with self.assertRaisesRegex(TypeError, "replay: log"):
                graze.replay(7)
            with self.assertRaises(UnicodeEncodeError):
                graze.replay("\ud800")
            self.assertEqual(report.differing, 0)
            self.assertEqual(report.calls, text.count('"call"'))
            self.assertEqual(text.count('{"refused"'), 1)
            self.assertEqual(text.count('"remove"'), 1)  # that of the stale id
            after = graze.scene_after(text)
            self.assertEqual((len(after), after.dtype), (9, np.float64))
            self.assertEqual(after.object(after.find("first")).shape, spheres[0].astype(np.float64))

    def test_a_log_that_cannot_be_written_is_an_error(self):
        scene = graze.Scene()
        with self.assertRaisesRegex(graze.OutputError, "cannot be opened"):
            scene.record("/no such folder/world.log")
        ball = scene.add(graze.Sphere([0, 0, 0], 1))
        scene.add(graze.Sphere([1, 0, 0], 1))
        scene.update()
        scene.move(ball, graze.Sphere([9, 0, 0], 1))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "world.log")
            path.write_text("kept")
            with self.assertRaisesRegex(RuntimeError, "since its last update"):
                scene.record(path)
            self.assertEqual(path.read_text(), "kept")
        if not pathlib.Path("/dev/full").exists():
            return
        with self.assertRaisesRegex(graze.OutputError, "/dev/full"):
            scene.update()
            scene.record("/dev/full")
            scene.update()
        self.assertEqual(len(scene), 2)

    def test_a_log_may_go_to_another_thread(self):
        if not hasattr(os, "mkfifo"):
            return
        scene = graze.Scene()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "pipe")
            os.mkfifo(path)
            texts = []
            reader = threading.Thread(target=lambda: texts.append(pathlib.Path(path).read_text()))
            reader.start()
            scene.record(path)
            for i in range(2000):
                scene.add(graze.Sphere([i, 0, 0], 1))
            scene.stop_recording()
            reader.join()
        self.assertEqual(len(graze.scene_after(texts[0])), 2000)

    def test_what_belongs_to_no_scene_is_told(self):
        scene = graze.Scene()
        floats = graze.Sphere.many([[0, 0, 0]], 1, dtype=np.float32)
        for error, text, call in [
            (TypeError, "add_many: the shapes are in 3D of float32, the scene in 3D of float64", lambda: scene.add_many(floats)),
            (ValueError, "in 2D", lambda: scene.add_many([graze.Sphere([0, 0], 1)])),
            (TypeError, "query: region is a Sphere in 3D of float32, the index", lambda: graze.Bvh().query(floats[0])),
            (ValueError, "add: mask names 'snow', which is no layer", lambda: scene.add(graze.Point([0, 0, 0]), mask=["snow"])),
            (ValueError, "an aabb, has a min above its max", lambda: scene.move_many(scene.ids(), np.array([[1.0] * 3 + [0.0] * 3]))),
        ]:
            with self.subTest(text), self.assertRaisesRegex(error, text):
                scene.add(graze.Point([0, 0, 0])) if not len(scene) else None
                call()
        self.assertEqual(len(scene.add_many([])), 0)
        self.assertFalse(-1 in scene or 2**70 in scene or 2**63 in graze.Bvh())
        snow = scene.add(graze.Point([0, 0, 0]), layer="snow", mask=["snow"])
        self.assertEqual(scene.object(snow).mask, 1 << scene.object(snow).layer)
        self.assertEqual(repr(scene), "<graze.Scene: 2 objects in 3D, float64>")

    def test_contacts_are_the_same_as_a_list_and_as_arrays(self):
        random = np.random.default_rng(11)
        for dimension, dtype in ((2, np.float32), (3, np.float64)):
            scene = graze.Scene(dimension, dtype)
            self.assertEqual(scene.contact_arrays().pairs.shape, (0, 2))
            half = random.uniform(0.2, 0.6, (60, dimension)).astype(dtype)
            middle = random.uniform(0, 4, (60, dimension)).astype(dtype)
            scene.add_many(graze.Aabb.many(middle - half, middle + half, dtype=dtype))
            arrays, contacts = scene.contact_arrays(), scene.contacts()
            self.assertGreater(len(contacts), 5)
            self.assertEqual(arrays.pairs.tolist(), scene.pairs().tolist())
            self.assertEqual(arrays.pairs.tolist(), [[each.a, each.b] for each in contacts])
            self.assertEqual(arrays.normals.tolist(), [each.manifold.normal.tolist() for each in contacts])
            points = [point for each in contacts for point in each.manifold.points]
            self.assertEqual(arrays.depths.tolist(), [point.depth for point in points])
            self.assertEqual(arrays.points.tolist(), [point.point.tolist() for point in points])
            counts = [len(each.manifold.points) for each in contacts]
            self.assertEqual(np.diff(arrays.offsets).tolist(), counts)
            self.assertEqual(arrays.points.dtype, dtype)

    def test_threads_share_a_scene(self):
        scene = graze.Scene()
        ids = scene.add_many(graze.Sphere.many(np.zeros((50, 3)), np.ones(50)))
        errors = []

        def work(seed):
            try:
                for step in range(50):
                    if seed == 0:
                        scene.move_many(ids, graze.Sphere.many(np.full((50, 3), step), np.ones(50)))
                        scene.update()
                    elif len(scene.pairs()) != 50 * 49 // 2:
                        errors.append("pairs")
            except Exception as error:  # noqa: BLE001
                errors.append(error)

        workers = [threading.Thread(target=work, args=(seed,)) for seed in range(4)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        self.assertEqual(errors, [])

    def test_scene_files_are_read_and_written(self):
        file = graze.read_scene(ROOT / "data/workshop.json")
        again = graze.parse_scene(graze.scene_json(file.scene)).scene
        np.testing.assert_array_equal(again.pairs() & 0xFFFFFFFF, file.scene.pairs() & 0xFFFFFFFF)
        self.assertIn("<svg", file.scene._repr_svg_())
        with self.assertRaises(graze.InputError):
            graze.parse_scene("{", "broken.json")
        with self.assertRaises(ValueError):
            graze.read_scene("no such file")


class MeshTest(unittest.TestCase):
    def setUp(self):
        self.cube = graze.Mesh(CUBE, FACES, kind="solid")

    def test_batches_equal_single_queries(self):
        points = np.random.default_rng(4).random((300, 3)) * 2 - 0.5
        inside = ((points > 0) & (points < 1)).all(axis=1)
        distances = graze.signed_distances(self.cube, points)
        np.testing.assert_array_equal(distances < 0, inside)
        np.testing.assert_array_equal(graze.contains(self.cube, points), inside)
        np.testing.assert_array_equal(np.rint(graze.winding_numbers(self.cube, points)), inside)
        nearest = graze.closest_points(self.cube, points, threads=1)
        for i in range(20):
            self.assertEqual(distances[i], graze.signed_distance(self.cube, points[i]))
            np.testing.assert_array_equal(nearest[i], graze.closest_point(self.cube, points[i]))

    def test_rays_of_a_batch_hit_as_single_ones_do(self):
        random = np.random.default_rng(5)
        rays = np.hstack([random.random((100, 3)) * 4 - 2, random.random((100, 3)) - 0.5])
        hits = graze.ray_casts(self.cube, rays)
        self.assertTrue(np.isfinite(hits.t).any() and np.isinf(hits.t).any())
        for i, ray in enumerate(rays):
            single = graze.ray_cast(self.cube, graze.Ray(ray[:3], ray[3:]))
            self.assertEqual(single is None, np.isinf(hits.t[i]))
            if single is None:
                continue
            self.assertEqual((single.t, -1 if single.face is None else single.face), (hits.t[i], hits.face[i]))
            np.testing.assert_array_equal(hits.point[i], single.point)

    def test_rays_in_a_scene_hit_faces(self):
        scene = graze.Scene()
        scene.add(self.cube)
        scene.add(graze.Sphere([0.3, 0.4, 9], 1))
        ray = graze.Ray([0.3, 0.4, -5], [0, 0, 1])
        on_cube, on_sphere = (hit.hit for hit in scene.ray_cast_all(ray))
        self.assertEqual(on_cube, graze.ray_cast(self.cube, ray))
        self.assertIsInstance(on_cube, graze.MeshHit)
        self.assertIsInstance(on_sphere, graze.RayHit)

    def test_contacts_of_many_pairs_are_those_of_some_at_a_time(self):
        centers = np.random.default_rng(3).random((3000, 3)) * 8
        spheres = graze.Sphere.many(centers, np.full(len(centers), 0.5))
        pairs = graze.overlapping_pairs(graze.bounds(spheres))
        self.assertGreater(len(pairs), 20_000)
        found = graze.contacts(spheres, pairs)
        some = [graze.contacts(spheres, pairs[first : first + 1000]) for first in range(0, len(pairs), 1000)]
        for field in ("pairs", "normals", "points", "depths"):
            np.testing.assert_array_equal(getattr(found, field), np.concatenate([getattr(each, field) for each in some]))
        np.testing.assert_array_equal(np.diff(found.offsets), np.concatenate([np.diff(each.offsets) for each in some]))

    def test_wrong_arrays_are_errors(self):
        points = np.zeros((4, 3))
        for error, text, call in [
            (TypeError, "dtype float32", lambda: graze.signed_distances(self.cube, points.astype("float32"))),
            (TypeError, "dtype int64", lambda: graze.overlapping_pairs(np.zeros((4, 6), dtype=int))),
            (ValueError, "shape", lambda: graze.overlapping_pairs(np.zeros((4, 5)))),
            (ValueError, "row 2", lambda: graze.signed_distances(self.cube, [[0, 0, 0], [0, 0, 0], [0, 0, np.nan]])),
            (ValueError, "box", lambda: graze.overlapping_pairs(np.full((2, 6), np.nan))),
            (IndexError, "", lambda: graze.touching_pairs([self.cube], [[0, 1]])),
            (IndexError, "contacts: pair 20000 names shape 9,", lambda: graze.contacts([self.cube] * 2, [[0, 1]] * 20_000 + [[0, 9]])),
            (ValueError, "same dimension", lambda: graze.intersects(self.cube, graze.Sphere([0, 0], 1))),
            (TypeError, "same dtype", lambda: graze.intersects(self.cube, self.cube.astype("float32"))),
            (TypeError, "a graze.Shape is needed, not a int: make one by", lambda: graze.intersects(self.cube, 5)),
            (TypeError, r"graze\.Point makes one", lambda: graze.distance(self.cube, [0, 0, 0])),
            (TypeError, r"not a graze\.Shape: graze\.Point", lambda: graze.closest_points(graze.Sphere([0, 0, 0], 1), [0, 0, 0])),
            (TypeError, r"graze\.Compound makes one", lambda: graze.contact(graze.Shapes([self.cube]), self.cube)),
            (TypeError, r"graze\.Mesh\(mesh\.vertices", lambda: graze.distance(types.SimpleNamespace(vertices=[], faces=[]), self.cube)),
            (TypeError, r"a graze\.Scene is needed", lambda: graze.Scene.pairs(self.cube)),
            (ValueError, "threads", lambda: graze.signed_distances(self.cube, points, threads=0)),
        ]:
            with self.subTest(text), self.assertRaisesRegex(error, text):
                call()

    def test_reports_and_copies(self):
        self.assertEqual(graze.report(self.cube).open_edges, 0)
        self.assertEqual(graze.winding_number(self.cube, [0.5, 0.5, 0.5]), 1)
        self.assertEqual(graze.mass_properties(self.cube).volume, 1)
        moved = graze.moved(self.cube, np.array(CUBE) + 0.5)
        self.assertGreater(len(graze.touching_faces(self.cube, moved)), 0)
        self.assertEqual(len(graze.self_intersections(self.cube)), 0)
        self.assertEqual(graze.transformed(self.cube, graze.Pose(np.eye(3), [0.5, 0.5, 0.5])), moved)
        matrix = np.eye(4)
        matrix[:3, 3] = 0.5
        self.assertEqual(graze.transformed(self.cube, matrix), moved)


if __name__ == "__main__":
    unittest.main()
