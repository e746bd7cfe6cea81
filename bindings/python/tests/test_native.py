# SPDX-License-Identifier: MIT
"""Answers equal those of C++ bit for bit: queries of the catalogue and of the published cases, pairs and indexes."""

import json
import unittest

import graze
import numpy as np
from native import (
    answers,
    assert_same_bits,
    cast_numbers,
    construction_numbers,
    mass_numbers,
    motions_of,
    option_numbers,
    pair_numbers,
    published_cases,
    shape_numbers,
    shape_of,
)


class NativeTest(unittest.TestCase):
    def assert_answers(self, case, dtype):
        point = np.array(case["point"]["position"], dtype=dtype)
        dimension = len(point)
        a, b, ray = (shape_of(case[name], dimension, dtype) for name in ("a", "b", "ray"))
        about = f"a = {a}\nb = {b}\npoint = {point}\nray = {ray}\nmotions = {case['motions']}"
        self.assertEqual(graze.intersects(a, b), graze.relation(a, b) != "apart", about)
        motions = motions_of(case["motions"], dimension)
        assert_same_bits(self, pair_numbers(a, b) + shape_numbers(a, point, ray), case["answers"], about)
        assert_same_bits(self, cast_numbers(a, b, ray.direction, motions), case["casts"], about)
        assert_same_bits(self, option_numbers(a, b, ray.direction), case["options"], about)
        if "points" in case:
            points = np.array(case["points"]).reshape(-1, dimension)
            assert_same_bits(self, construction_numbers(points, dtype), case["constructions"], about)
        if "mass" in case:
            assert_same_bits(self, mass_numbers(a), case["mass"], about)

    def test_every_query_of_every_two_types(self):
        for name, dtype in (("queries.ndjson", "float64"), ("queries_float.ndjson", "float32")):
            lines = (answers() / name).read_text().splitlines()
            self.assertEqual(len(lines), 2 * 13 * 13 * 8)
            for line in lines:
                self.assert_answers(json.loads(line), dtype)

    def test_every_published_case(self):
        lines = [json.loads(line) for line in (answers() / "cases.ndjson").read_text().splitlines()]
        asked = [words.split()[1:] for _, words, _, _, _ in published_cases()]
        self.assertGreater(len(asked), 700)
        self.assertEqual(len(lines), sum(2 if len(words) == 1 else 1 for words in asked))
        self.assertTrue(all(sum(name in line for line in lines) > 20 for name in ("constructions", "mass")))
        for line in lines:
            self.assert_answers(line, line["number"])

    def test_published_verdicts(self):
        """The first lines of each case, of which those about relations come last."""
        cases = [case for case in published_cases() if case[1].endswith("relation")]
        lines = (answers() / "cases.ndjson").read_text().splitlines()
        rows = [case for case in published_cases() for _ in range(1 if len(case[1].split()) == 3 else 2)]
        compared = 0
        for row, line in zip(rows, lines):
            if row not in cases:
                continue
            case = json.loads(line)
            dimension = len(case["point"]["position"])
            verdict = graze.relation(*(shape_of(case[side], dimension, case["number"]) for side in "ab"))
            self.assertIn(verdict, ["touching", "overlapping"] if row[4] == "meet" else [row[4]], row)
            compared += 1
        self.assertGreater(compared, 250)

    def test_touching_pairs_of_every_two_types(self):
        for dimension in (2, 3):
            case = json.loads((answers() / f"touching_{dimension}d.json").read_text())
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
                boxes = np.fromfile(answers() / f"{name}.boxes", dtype=dtype).reshape(-1, 2 * dimension)
                pairs = np.fromfile(answers() / f"{name}.pairs", dtype=np.uint32).reshape(-1, 2)
                np.testing.assert_array_equal(graze.overlapping_pairs(boxes), pairs)
                finder = graze.PairFinder(dimension, dtype)
                np.testing.assert_array_equal(finder.find(boxes, threads=1), pairs)
                np.testing.assert_array_equal(finder.find(boxes), pairs)

    def test_indexes_find_the_same_boxes(self):
        for name, case in json.loads((answers() / "indexes.json").read_text()).items():
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
                assert_same_bits(self, times, case["hits"][1::2], name)
                near, distances = index.nearest(case["center"]["position"], 20)
                assert_same_bits(self, distances, case["near"][1::2], name)
                rows, met = index.query_many(moved[:100])
                np.testing.assert_array_equal(
                    np.column_stack([rows, [places[int(key)] for key in met]]).tolist(),
                    np.array(sorted(graze.overlapping_pairs(moved[:100].copy(), moved).tolist())))


if __name__ == "__main__":
    unittest.main()
