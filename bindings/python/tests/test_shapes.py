# SPDX-License-Identifier: MIT
"""Shapes are immutable values that evaluate, compare, hash and pickle."""

import math
import pickle
import unittest

import graze
import numpy as np

CUBE = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
FACES = [[1, 2, 0], [3, 2, 1], [6, 5, 4], [6, 7, 5], [4, 1, 0], [4, 5, 1], [3, 6, 2], [7, 6, 3], [2, 4, 0], [6, 4, 2],
         [5, 3, 1], [5, 7, 3]]


def shapes(dtype):
    """One of each type in 3D, and some in 2D."""
    return [
        graze.Point([1, 2, 3], dtype=dtype),
        graze.Segment([0, 0, 0], [0.1, 0.2, 0.3], dtype=dtype),
        graze.Ray([0, 0, 0], [1, 0, 0], dtype=dtype),
        graze.Sphere([0, 0, 0], 0.1, dtype=dtype),
        graze.Aabb([0, 0, 0], [1, 2, 3], dtype=dtype),
        graze.Obb([0, 0, 0], [1, 2, 3], graze.Pose.from_axis_angle([0, 0, 0], [0, 0, 1], 0.5).rotation, dtype=dtype),
        graze.Plane([0, 1, 0], 2, dtype=dtype),
        graze.HalfSpace([0, 0, 1], -1, dtype=dtype),
        graze.Triangle([0, 0, 0], [1, 0, 0], [0, 1, 0], dtype=dtype),
        graze.Capsule([0, 0, 0], [0, 0, 1], 0.3, dtype=dtype),
        graze.Polytope(CUBE, dtype=dtype),
        graze.Compound([graze.Sphere([5, 0, 0], 1, dtype=dtype), graze.Point([0, 0, 0], dtype=dtype)]),
        graze.Mesh(CUBE, FACES, kind="solid", dtype=dtype),
        graze.Sphere([1, 2], 3, dtype=dtype),
        graze.Obb([1, 2], [3, 4], dtype=dtype),
        graze.Compound([], dimension=2, dtype=dtype),
        graze.Mesh([], [], dimension=2, dtype=dtype),
    ]


class ShapesTest(unittest.TestCase):
    def test_repr_and_pickle_give_an_equal_shape_of_equal_hash(self):
        for dtype in (np.float32, np.float64):
            for shape in shapes(dtype):
                for again in (eval(repr(shape)), pickle.loads(pickle.dumps(shape))):
                    self.assertEqual(again, shape)
                    self.assertEqual(hash(again), hash(shape))
                    self.assertEqual(again.dtype, np.dtype(dtype))
                    self.assertIs(type(again), type(shape))

    def test_different_shapes_differ(self):
        every = shapes(np.float64) + shapes(np.float32)
        for i, a in enumerate(every):
            for j, b in enumerate(every):
                self.assertEqual(a == b, i == j, (a, b))
        self.assertNotEqual(every[0], 5)

    def test_zeros_of_both_signs_are_equal_and_have_one_hash(self):
        a, b = graze.Point([0.0, 0.0]), graze.Point([-0.0, 0.0])
        self.assertEqual(a, b)
        self.assertEqual(hash(a), hash(b))

    def test_fields_are_read_only(self):
        sphere = graze.Sphere([1, 2, 3], 4)
        np.testing.assert_array_equal(sphere.center, [1, 2, 3])
        self.assertEqual((sphere.radius, sphere.dimension), (4, 3))
        with self.assertRaises(AttributeError):
            sphere.radius = 5
        with self.assertRaises(AttributeError):
            sphere.other = 5
        with self.assertRaises(ValueError):
            sphere.center[0] = 5
        with self.assertRaises(TypeError):
            graze.Sphere.radius = 5
        mesh = shapes(np.float64)[12]
        with self.assertRaises(ValueError):
            mesh.vertices[0] = 5

    def test_views_of_a_mesh_outlive_it(self):
        vertices = graze.Mesh(CUBE, FACES).vertices
        np.testing.assert_array_equal(vertices, CUBE)

    def test_the_columns_of_axes_are_the_axes(self):
        pose = graze.Pose.from_axis_angle([0, 0, 0], [0, 0, 1], math.pi / 6)
        box = graze.Obb([0, 0, 0], [2, 1, 1], pose.rotation)
        self.assertTrue(graze.contains(box, pose.rotation @ [1.99, 0, 0]))
        self.assertFalse(graze.contains(box, pose.rotation @ [0, 1.99, 0]))
        self.assertEqual(box.axes.tolist(), pose.rotation.tolist())

    def test_wrong_arguments_are_named(self):
        for error, text, make in [
            (TypeError, "missing radius", lambda: graze.Sphere([0, 0, 0])),
            (TypeError, "no argument size", lambda: graze.Sphere([0, 0, 0], 1, size=2)),
            (TypeError, "two values for center", lambda: graze.Sphere([0, 0], 1, center=[0, 0])),
            (ValueError, "4 elements", lambda: graze.Sphere([0, 0, 0, 0], 1)),
            (ValueError, "end has 2 elements", lambda: graze.Segment([0, 0, 0], [1, 1])),
            (ValueError, "negative radius", lambda: graze.Sphere([0, 0, 0], -1)),
            (ValueError, "NaN", lambda: graze.Sphere([0, 0, float("nan")], 1)),
            (ValueError, "not finite", lambda: graze.Sphere([0, 0, float("inf")], 1)),
            (ValueError, "not finite", lambda: graze.Sphere([0, 0, 1e300], 1, dtype=np.float32)),
            (TypeError, "float32 or float64", lambda: graze.Sphere([0, 0, 0], 1, dtype=np.int32)),
            (TypeError, "a str", lambda: graze.Sphere("abc", 1)),
            (ValueError, "orthonormal", lambda: graze.Obb([0, 0], [1, 1], [[1, 1], [0, 1]])),
            (ValueError, "'surface' or 'solid'", lambda: graze.Mesh(CUBE, FACES, kind="hollow")),
            (ValueError, "vertex 8", lambda: graze.Mesh(CUBE, [[0, 1, 8]])),
            (IndexError, "row 0", lambda: graze.Mesh(CUBE, [[0, 1, -1]])),
            (ValueError, "dimension", lambda: graze.Compound([])),
            (ValueError, "in 2D", lambda: graze.Compound([graze.Sphere([0, 0, 0], 1), graze.Sphere([0, 0], 1)])),
            (TypeError, "float32", lambda: graze.Compound([graze.Point([0, 0]), graze.Point([0, 0], dtype="float32")])),
            (TypeError, "base", lambda: graze.Shape()),
        ]:
            with self.subTest(text), self.assertRaisesRegex(error, text):
                make()

    def test_astype_rounds(self):
        shape = graze.Sphere([0.1, 0, 0], 1)
        self.assertEqual(shape.astype("float32").center[0], np.float32(0.1))
        self.assertEqual(shape.astype("float32").astype("float64").center[0], float(np.float32(0.1)))

    def test_arrays_make_many_shapes(self):
        centers, radii = np.random.default_rng(1).random((50, 3)), np.arange(1.0, 51.0)
        many = graze.Sphere.many(centers, radius=radii)
        self.assertEqual(len(many), 50)
        self.assertEqual(many[7], graze.Sphere(centers[7], radii[7]))
        self.assertEqual(many[-1], list(many)[-1])
        axes = np.stack([np.eye(2)] * 3)
        self.assertEqual(graze.Obb.many(np.zeros((3, 2)), np.ones((3, 2)), axes)[2], graze.Obb([0, 0], [1, 1]))
        with self.assertRaisesRegex(ValueError, "row 3"):
            graze.Sphere.many(centers, np.where(np.arange(50) == 3, -1.0, 1.0))

    def test_one_value_serves_many_shapes(self):
        centers = np.arange(12.0).reshape(4, 3)
        self.assertEqual(list(graze.Sphere.many(centers, 0.5)), [graze.Sphere(center, 0.5) for center in centers])
        axes = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
        boxes = graze.Obb.many(centers, [1, 2, 3], axes, dtype=np.float32)
        self.assertEqual(boxes[3], graze.Obb(centers[3], [1, 2, 3], axes, dtype=np.float32))
        for radius in ([1, 2], [[1], [2], [3], [4]], "1", None):
            with self.subTest(radius), self.assertRaises((TypeError, ValueError)):
                graze.Sphere.many(centers, radius)

    def test_many_shapes_are_pickled(self):
        for shapes in (
            graze.Sphere.many(np.zeros((0, 2)), [], dtype=np.float32),
            graze.Aabb.many(np.zeros((3, 3)), np.ones((3, 3))),
            graze.Shapes([graze.Point([1, 2]), graze.Sphere([0, 0], 1)]),
        ):
            again = pickle.loads(pickle.dumps(shapes))
            self.assertEqual((list(again), again.dimension, again.dtype), (list(shapes), shapes.dimension, shapes.dtype))
            self.assertEqual((again, hash(again)), (shapes, hash(shapes)))
        self.assertEqual(len(graze.Shapes([], dimension=2)), 0)
        with self.assertRaisesRegex(ValueError, "dimension"):
            graze.Shapes([])

    def test_many_shapes_are_a_sequence(self):
        spheres = graze.Sphere.many(np.arange(12.0).reshape(4, 3), [1, 2, 3, 4])
        every = list(spheres)
        for part in (slice(None), slice(1, 3), slice(None, None, -1), slice(-2, None), slice(3, 0, -2), slice(9, 20)):
            with self.subTest(part):
                self.assertIsInstance(spheres[part], graze.Shapes)
                self.assertEqual(list(spheres[part]), every[part])
        self.assertEqual(spheres[np.int32(-1)], every[3])
        self.assertEqual(spheres[1:3], graze.Shapes(every[1:3]))
        self.assertEqual(len({spheres[:2], graze.Shapes(every[:2]), spheres[1:3]}), 2)
        self.assertNotEqual(spheres[:2], spheres[:1])
        self.assertNotEqual(spheres[:0], graze.Sphere.many(np.zeros((0, 3)), [], dtype=np.float32))
        self.assertNotEqual(spheres, every)
        for index, error in ((4, IndexError), (2**80, IndexError), (1.0, TypeError), ("0", TypeError)):
            with self.subTest(index), self.assertRaises(error):
                spheres[index]
        with self.assertRaises(ValueError):
            spheres[::0]
        for method in (graze.Shapes.__reduce__, graze.Shapes.__len__, graze.Shapes.__hash__):
            with self.assertRaises(TypeError):
                method(object())

    def test_reflections_are_no_poses(self):
        cube = graze.Mesh(CUBE, FACES, kind="solid")
        with self.assertRaisesRegex(ValueError, "reflection"):
            graze.transformed(cube, np.diag([1.0, 1, -1, 1]))
        with self.assertRaisesRegex(ValueError, "reflection"):
            graze.transformed(graze.Sphere([0, 0], 1), graze.Pose(np.diag([1.0, -1]), np.zeros(2)))

    def test_lists_of_points_are_as_good_as_arrays(self):
        ball, points = graze.Sphere([0, 0, 0], 1), [[0, 0, 0], [2, 0, 0], [0, 0.5, 0]]
        self.assertEqual(graze.contains(ball, points).tolist(), [True, False, True])
        self.assertEqual(graze.contains(ball, np.array(points)).tolist(), [True, False, True])
        self.assertIs(graze.contains(ball, [0, 0, 0]), True)

    def test_shapes_draw_themselves(self):
        for shape in shapes(np.float64):
            self.assertIn("<svg", shape._repr_svg_())
        contact = graze.contact(graze.Sphere([0, 0, 0], 1), graze.Sphere([1.5, 0, 0], 1))
        self.assertIn("<svg", contact._repr_svg_())


if __name__ == "__main__":
    unittest.main()
