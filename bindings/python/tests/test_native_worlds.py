# SPDX-License-Identifier: MIT
"""Meshes and scenes answer as in C++, bit for bit."""

import json
import unittest

import graze
import numpy as np
from native import RELATIONS, answers, assert_same_bits, hit_numbers, manifold_numbers, shape_of


def rows_of(numbers, columns):
    return np.array(numbers, dtype=float).reshape(-1, columns)


def pose_of(numbers):
    if len(numbers) == 3:
        return graze.Pose.from_angle(numbers[:2], numbers[2])
    return graze.Pose.from_quaternion(numbers[:3], numbers[3:])


def hits_of(hits):
    """In the order of mesh_answers.cpp."""
    numbers = []
    for i, t in enumerate(hits.t):
        numbers.append(t)
        if np.isfinite(t):
            numbers += [*hits.point[i], *hits.normal[i], hits.error[i], hits.face[i], *hits.barycentric[i]]
    return numbers


def mesh_answers(case, dimension):
    mesh, unplaced = (shape_of(case[name], dimension) for name in ("mesh", "other"))
    other = graze.transformed(unplaced, pose_of(case["pose"]))
    points = rows_of(case["points"], dimension)
    changed = graze.moved(mesh, rows_of(case["places"], dimension))
    contact = graze.contact(mesh, other)
    pair = [RELATIONS.index(graze.relation(mesh, other)), graze.distance(mesh, other)]
    return {
        "report": [int(value) for value in graze.report(mesh)],
        "windings": graze.winding_numbers(mesh, points),
        "distances": graze.signed_distances(mesh, points),
        "closest": graze.closest_points(mesh, points).ravel(),
        "hits": hits_of(graze.ray_casts(mesh, rows_of(case["rays"], 2 * dimension))),
        "crossings": graze.self_intersections(mesh).ravel(),
        "touching": graze.touching_faces(mesh, other).ravel(),
        "pair": pair if contact is None else [*pair, *contact.point, *contact.normal, contact.depth],
        "placed": other.vertices.ravel(),
        "changedClosest": graze.closest_points(changed, points).ravel(),
    }, graze.welded(changed)


def impact_numbers(found):
    return [found.id & 0xFFFFFFFF, *hit_numbers(found.impact)]


def scene_answers(scene, shape, way, keywords):
    """In the order of scene_answers.cpp; objects by the lower half of their ids."""
    turn = 2 if scene.dimension == 2 else [0, 1, -2]
    ray = graze.Ray(way, -way)
    numbers = [*(scene.overlapping(shape, **keywords) & 0xFFFFFFFF), *(scene.cull(shape, **keywords) & 0xFFFFFFFF)]
    for touch in scene.contacts_with(shape, **keywords):
        numbers += [touch.id & 0xFFFFFFFF, *manifold_numbers(touch.manifold)]
    for near in [*scene.nearest(shape, 4, **keywords), *scene.nearest(way, 4, **keywords)]:
        numbers += [near.id & 0xFFFFFFFF, near.distance]
    for hit in scene.ray_cast_all(ray, **keywords):
        numbers += [hit.id & 0xFFFFFFFF, *hit_numbers(hit.hit)]
    impacts = [scene.time_of_impact(shape, graze.Motion(way, turn), **keywords)]
    for ignore in (False, True):
        impacts.append(scene.shape_cast(shape, way, ignore_initial_touch=ignore, **keywords))
        impacts += scene.shape_cast_all(shape, way, ignore_initial_touch=ignore, **keywords)
    for found in impacts:
        numbers += [] if found is None else impact_numbers(found)
    up = {} if scene.dimension == 2 else {"up": [0, 0, 2]}
    for options in ({}, {"max_slope": 0.8, "step_height": 0.5, "clearance": 0.01, **up}):
        path = scene.slide(shape, way, **options, **keywords)
        numbers += path.motion.tolist()
        for found in path.touches:
            numbers += impact_numbers(found)
    return numbers


class NativeWorldsTest(unittest.TestCase):
    def test_meshes(self):
        for dimension in (2, 3):
            lines = (answers() / f"meshes_{dimension}d.ndjson").read_text().splitlines()
            self.assertEqual(len(lines), 24)
            for line in lines:
                case = json.loads(line)
                ours, welded = mesh_answers(case, dimension)
                for name, numbers in ours.items():
                    assert_same_bits(self, numbers, case[name], name)
                self.assertEqual(welded, shape_of(case["welded"], dimension))

    def test_scenes(self):
        for dimension in (2, 3):
            case = json.loads((answers() / f"scenes_{dimension}d.json").read_text())
            scene = graze.Scene(dimension)
            for i in range(3):
                scene.layer(f"layer {i}")
            ids = [scene.add(shape_of(text, dimension), layer=i % 3) for i, text in enumerate(case["shapes"])]
            some = ids[3:30]
            seventh = [number for number in ids if (number & 0xFFFFFFFF) % 7 == 0]
            layers = ["layer 0", 2]
            filters = [{}, {"layers": layers}, {"excluding": some}, {"layers": layers, "excluding": some + seventh}]
            self.assertEqual(len(case["asked"]), 120)
            for i, asked in enumerate(case["asked"]):
                shape, way = shape_of(asked["shape"], dimension), np.array(asked["motion"], dtype=float)
                assert_same_bits(self, scene_answers(scene, shape, way, filters[i % 4]), asked["answers"], f"question {i}")
            scene.except_pair(ids[0], ids[1])
            for a, b in scene.pairs().tolist():
                if (a & 0xFFFFFFFF) % 2 == 0:
                    scene.except_pair(b, a)
            near = [[pair.a & 0xFFFFFFFF, pair.b & 0xFFFFFFFF, pair.distance] for pair in scene.closest_pairs(0.5)]
            assert_same_bits(self, np.ravel(near), case["near"], "closest pairs")


if __name__ == "__main__":
    unittest.main()
