# SPDX-License-Identifier: MIT
"""The answers of C++, from the program graze_answers (GRAZE_ANSWERS names it), and ours as numbers in the same order."""

import atexit
import functools
import os
import pathlib
import re
import subprocess
import tempfile

import graze
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = os.environ.get("GRAZE_ANSWERS", str(ROOT / "build/gcc/bin/graze_answers"))
TYPES = {"point": "Point", "segment": "Segment", "ray": "Ray", "sphere": "Sphere", "aabb": "Aabb", "obb": "Obb",
         "plane": "Plane", "half_space": "HalfSpace", "triangle": "Triangle", "capsule": "Capsule",
         "polytope": "Polytope", "compound": "Compound", "mesh": "Mesh"}
RELATIONS = ["apart", "touching", "overlapping"]
KINDS = ["vertex", "edge", "face"]
ROW = re.compile(r'\{\s*((?:"(?:[^"\\]|\\.)*"\s*,?\s*)+)[^{}"]*\}')
CELL = re.compile(r'((?:"(?:[^"\\]|\\.)*"\s*)+)')


@functools.cache
def published_cases():
    """The rows of tests/query/published_*_test.cpp: source, what is asked, two shapes, the answer."""
    cases = []
    for path in sorted((ROOT / "tests/query").glob("published_*_test.cpp")):
        text = path.read_text()
        rows = [["".join(re.findall(r'"([^"]*)"', cell)) for cell in CELL.findall(row)] for row in ROW.findall(text)]
        declared = sum(map(int, re.findall(r"std::array<PublishedCase, (\d+)>", text)))
        if len(rows) != declared or any(len(row) != 5 for row in rows):
            raise ValueError(f"{path} declares {declared} cases, but {len(rows)} were found")
        cases += rows
    return cases


@functools.cache
def answers():
    """The folder with all answers."""
    folder = tempfile.TemporaryDirectory()
    atexit.register(folder.cleanup)
    path = pathlib.Path(folder.name)
    lines = ["\t".join([asked[:2], asked[3:], a, b or "-"]) for _, asked, a, b, _ in published_cases()]
    (path / "cases.tsv").write_text("\n".join(lines) + "\n")
    subprocess.run([PROGRAM, folder.name, path / "cases.tsv"], check=True)
    return path


def shape_of(text, dimension, dtype="float64"):
    """A shape of a scene file, where axes are a list of vectors."""
    fields = {name: value for name, value in text.items() if name != "type"}
    if "axes" in fields:
        fields["axes"] = np.transpose(fields["axes"])
    if text["type"] == "compound":
        parts = [shape_of(part, dimension, dtype) for part in fields["parts"]]
        return graze.Compound(parts, dimension=dimension, dtype=None if parts else dtype)
    if text["type"] == "mesh":
        fields["dimension"] = dimension
    return getattr(graze, TYPES[text["type"]])(**fields, dtype=dtype)


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


def motions_of(numbers, dimension):
    """Two motions: displacement, rotation and center of each."""
    turn = 1 if dimension == 2 else 3
    for half in np.array(numbers, dtype=float).reshape(2, -1):
        linear, angular, center = np.split(half, [dimension, dimension + turn])
        yield graze.Motion(linear, angular if dimension == 3 else angular[0], center)


def cast_numbers(a, b, way, motions):
    first, second = motions
    return hit_numbers(graze.shape_cast(a, way, b)) + hit_numbers(graze.time_of_impact(a, first, b, second))


def option_numbers(a, b, way):
    numbers = []
    for ignore, target in ((True, 0), (False, 0.25), (True, 0.25)):
        numbers += hit_numbers(graze.shape_cast(a, way, b, ignore_initial_touch=ignore, target_distance=target))
    return numbers + contact_numbers(graze.contact(a, b, 2)) + manifold_numbers(graze.manifold(a, b, 2))


def construction_numbers(points, dtype):
    """What is made of points: their hull, spheres and boxes around them."""
    numbers = [*graze.convex_hull(points, dtype=dtype).points.ravel()]
    for around in (graze.bounding_sphere, graze.bounding_sphere_fast):
        sphere = around(points, dtype=dtype)
        numbers += [*sphere.center, sphere.radius]
    box, turned = graze.bounding_box(points, dtype=dtype), graze.bounding_obb(points, dtype=dtype)
    return [*numbers, *box.min, *box.max, *turned.center, *turned.half_extents, *turned.axes.T.ravel()]


def mass_numbers(shape):
    found = graze.mass_properties(shape)
    return [found.volume, *found.centroid, *np.ravel(found.inertia)]


def assert_same_bits(test, ours, native, about):
    a, b = np.array(ours, dtype=float), np.array(native, dtype=float)
    test.assertEqual(a.shape, b.shape, about)
    same = (a.view(np.uint64) == b.view(np.uint64)) | (np.isnan(a) & np.isnan(b))
    test.assertTrue(same.all(), f"{about}\n{a[~same]}\n{b[~same]}")
