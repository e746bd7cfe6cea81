# SPDX-License-Identifier: MIT
"""Answers equal those of the C++ program graze_answers bit for bit. GRAZE_ANSWERS is the program."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import graze
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = os.environ.get("GRAZE_ANSWERS", str(ROOT / "build/gcc/bin/graze_answers"))
TYPES = {"point": "Point", "segment": "Segment", "ray": "Ray", "sphere": "Sphere", "aabb": "Aabb", "obb": "Obb",
         "plane": "Plane", "half_space": "HalfSpace", "triangle": "Triangle", "capsule": "Capsule",
         "polytope": "Polytope", "compound": "Compound", "mesh": "Mesh"}
RELATIONS = ["apart", "touching", "overlapping"]
KINDS = ["vertex", "edge", "face"]


def shape_of(text, dimension):
    """A shape of a scene file, where axes are a list of vectors."""
    fields = {name: value for name, value in text.items() if name != "type"}
    if "axes" in fields:
        fields["axes"] = np.transpose(fields["axes"])
    if text["type"] == "compound":
        fields = {"parts": [shape_of(part, dimension) for part in fields["parts"]], "dimension": dimension}
    if text["type"] == "mesh":
        fields["dimension"] = dimension
    return getattr(graze, TYPES[text["type"]])(**fields)


def contact_numbers(found):
    if found is None:
        return []
    return [*found.point, *found.point_a, *found.point_b, *found.normal, found.depth, found.error]


def hit_numbers(found):
    return [] if found is None else [found.t, *found.point, *found.normal, found.error]


def manifold_numbers(found):
    numbers = [*found.normal, found.error]
    for point in found.points:
        numbers += [*point.point, *point.point_a, *point.point_b, point.depth]
        for feature in (point.id.a, point.id.b):
            numbers += [KINDS.index(feature.kind), feature.index]
        numbers += [point.id.part_a, point.id.part_b]
    return numbers


def pair_numbers(a, b):
    near = graze.closest_points(a, b)
    return [RELATIONS.index(graze.relation(a, b)), graze.distance(a, b), near.distance, *near.point_a, *near.point_b,
            *near.normal, near.error, *contact_numbers(graze.contact(a, b)), *manifold_numbers(graze.manifold(a, b))]


def shape_numbers(shape, point, ray):
    numbers = hit_numbers(graze.ray_cast(shape, ray)) + hit_numbers(graze.ray_cast(shape, ray, side="exit"))
    return numbers + [int(graze.contains(shape, point)), *graze.closest_point(shape, point),
                      *graze.closest_boundary_point(shape, point), graze.signed_distance(shape, point),
                      *graze.bounds(shape)]


def cast_numbers(a, b, point, way):
    turns = (1, way[0]) if len(way) == 2 else ([1, 0, -2], way)
    first, second = graze.Motion(way, turns[0], point), graze.Motion(-way, turns[1], way)
    return hit_numbers(graze.shape_cast(a, way, b)) + hit_numbers(graze.time_of_impact(a, first, b, second))


def option_numbers(a, b, way):
    numbers = []
    for ignore, target in ((True, 0), (False, 0.25), (True, 0.25)):
        numbers += hit_numbers(graze.shape_cast(a, way, b, ignore_initial_touch=ignore, target_distance=target))
    return numbers + contact_numbers(graze.contact(a, b, 2)) + manifold_numbers(graze.manifold(a, b, 2))


class NativeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        subprocess.run([PROGRAM, cls.folder.name], check=True)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def path(self, name):
        return pathlib.Path(self.folder.name) / name

    def assert_same_bits(self, ours, native, about):
        a, b = np.array(ours, dtype=float), np.array(native, dtype=float)
        self.assertEqual(a.shape, b.shape, about)
        same = (a.view(np.uint64) == b.view(np.uint64)) | (np.isnan(a) & np.isnan(b))
        self.assertTrue(same.all(), f"{about}\n{a[~same]}\n{b[~same]}")

    def test_every_query_of_every_two_types(self):
        lines = self.path("queries.ndjson").read_text().splitlines()
        self.assertEqual(len(lines), 2 * 13 * 13 * 8)
        for line in lines:
            case = json.loads(line)
            point = np.array(case["point"]["position"], dtype=float)
            a, b = (shape_of(case[side], len(point)) for side in "ab")
            ray = shape_of(case["ray"], len(point))
            about = f"a = {a}\nb = {b}\npoint = {point}\nray = {ray}"
            self.assertEqual(graze.intersects(a, b), graze.relation(a, b) != "apart", about)
            self.assert_same_bits(pair_numbers(a, b) + shape_numbers(a, point, ray), case["answers"], about)
            self.assert_same_bits(cast_numbers(a, b, point, ray.direction), case["casts"], about)
            self.assert_same_bits(option_numbers(a, b, ray.direction), case["options"], about)

    def test_touching_pairs_of_every_two_types(self):
        for dimension in (2, 3):
            case = json.loads(self.path(f"touching_{dimension}d.json").read_text())
            shapes = graze.Shapes([shape_of(text, dimension) for text in case["shapes"]])
            candidates = np.array(case["candidates"], dtype=np.uint32).reshape(-1, 2)
            touching = graze.touching_pairs(shapes, candidates)
            self.assertEqual(touching.ravel().tolist(), case["touching"])
            np.testing.assert_array_equal(candidates[graze.relations(shapes, candidates) > 0], touching)
            found = graze.contacts(shapes, candidates, threads=1)
            np.testing.assert_array_equal(found.pairs, touching)
            for i, (j, k) in enumerate(touching[:300]):
                single = graze.manifold(shapes[int(j)], shapes[int(k)])
                rows = slice(found.offsets[i], found.offsets[i + 1])
                np.testing.assert_array_equal(found.normals[i], single.normal)
                np.testing.assert_array_equal(found.points[rows], [point.point for point in single.points])
                np.testing.assert_array_equal(found.depths[rows], [point.depth for point in single.points])

    def test_pairs_of_boxes(self):
        for dimension in (2, 3):
            for word, dtype in (("float", np.float32), ("double", np.float64)):
                name = f"pairs_{dimension}d_{word}"
                boxes = np.fromfile(self.path(name + ".boxes"), dtype=dtype).reshape(-1, 2 * dimension)
                pairs = np.fromfile(self.path(name + ".pairs"), dtype=np.uint32).reshape(-1, 2)
                np.testing.assert_array_equal(graze.overlapping_pairs(boxes), pairs)
                finder = graze.PairFinder(dimension, dtype)
                np.testing.assert_array_equal(finder.find(boxes, threads=1), pairs)
                np.testing.assert_array_equal(finder.find(boxes), pairs)

    def test_indexes_find_the_same_boxes(self):
        for name, case in json.loads(self.path("indexes.json").read_text()).items():
            dimension = case["dimension"]
            for index in (graze.Bvh(dimension), graze.Orthtree(dimension), graze.Grid(dimension)):
                boxes, moved = (np.array(case[key], dtype=float).reshape(-1, 2 * dimension) for key in ("boxes", "moved"))
                keys = index.assign(boxes)
                index.update_many(keys, moved)
                places = {int(key): place for place, key in enumerate(keys)}
                found = index.query(shape_of(case["region"], dimension))
                self.assertEqual(sorted(places[int(key)] for key in found), sorted(case["found"]), name)
                hits, times = index.ray_cast(shape_of(case["ray"], dimension))
                self.assertEqual([places[int(key)] for key in hits], case["hits"][::2])
                self.assert_same_bits(times, case["hits"][1::2], name)
                near, distances = index.nearest(case["center"]["position"], 20)
                self.assert_same_bits(distances, case["near"][1::2], name)
                rows, met = index.query_many(moved[:100])
                np.testing.assert_array_equal(
                    np.column_stack([rows, [places[int(key)] for key in met]]).tolist(),
                    np.array(sorted(graze.overlapping_pairs(moved[:100].copy(), moved).tolist())))


if __name__ == "__main__":
    unittest.main()
