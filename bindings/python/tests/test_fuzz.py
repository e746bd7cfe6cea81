# SPDX-License-Identifier: MIT
"""No call from Python ends the process, whatever its arguments are: random ones for everything that can be called."""

import random
import time
import unittest
import warnings

import graze
import numpy as np
from test_shapes import shapes

SECONDS = 4


def junk(chance):
    """Values that calls accept, and some that none does."""
    number = chance.choice([0, 1, -1, 2, 3, 0.5, 1e-300, 1e300, float("nan"), float("inf"), 2**70, -(2**40), True, None])
    return chance.choice(
        [
            number,
            [number] * chance.randrange(5),
            tuple(chance.random() for _ in range(chance.randrange(5))),
            chance.choice(["", "float32", "solid", "exit", "tree", b"bytes", object(), {}, {1, 2}, type, len, np.float32]),
            chance.choice(["obj", "stl", "ply", "off", "glb", b"solid x\nfacet", b"OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2", "v 0 0 0\nf 1 1 1"]),
            np.array([chance.choice([0.0, 1.0, float("nan"), float("inf"), -1e308]) for _ in range(chance.randrange(8))]),
            np.random.default_rng(chance.randrange(99)).random((chance.randrange(4), chance.choice([1, 2, 3, 4, 6]))),
            np.random.default_rng(3).integers(-2, 9, (chance.randrange(4), chance.choice([2, 3]))),
            np.zeros((3, 6), dtype=chance.choice(["float32", "int8", "complex64", ">f8", "bool", "O"])),
            np.array([[0, 1], [1, 2]], dtype=np.uint32),
            np.eye(chance.choice([2, 3, 4])),
            chance.choice(SHAPES),
            [chance.choice(SHAPES) for _ in range(chance.randrange(4))],
            graze.Shapes([graze.Sphere([i, 0, 0], 1) for i in range(3)]),
            graze.MeshPart("part", chance.choice(SHAPES)),
            chance.choice([graze.Pose.identity(3), graze.Motion([1, 0, 0]), graze.Motion(1, 2, 3)]),
        ]
    )


SHAPES = shapes(np.float64) + shapes(np.float32)
WORDS = ["meshes", "format", "dtype", "dimension", "threads", "margin", "center", "radius", "layers", "excluding", "name", "kind", "count", "k"]
# Those that every object has and ours replace.
SPECIAL = {"__new__", "__eq__", "__hash__", "__repr__", "__reduce__"}
# They wait for files, write them, or are not calls about graze.
LEFT_OUT = {"read_scene", "read_meshes", "record", "InputError", "OutputError"}


def callables(chance):
    """All functions and types of the module, and the methods of some objects."""
    found = [getattr(graze, name) for name in graze.__all__ if name not in LEFT_OUT]
    scene = graze.Scene(chance.choice([2, 3]), chance.choice(["float32", "float64"]))
    owners = [scene, scene.snapshot(), graze.PairFinder(), graze.Bvh(), graze.Orthtree(2), graze.Grid(), *SHAPES[:17]]
    owners += [graze.Shapes(SHAPES[:2]), graze.Sphere, graze.Obb, graze.Mesh, graze.Scene, graze.Bvh]
    for owner in owners:
        found += [getattr(owner, name) for name in dir(owner) if name in SPECIAL or name not in [*dir(type), *LEFT_OUT]]
    return [thing for thing in found if callable(thing)]


class FuzzTest(unittest.TestCase):
    def test_methods_refuse_what_is_not_of_their_type(self):
        others = [object(), 1.5, 7, b"\xff" * 100, np.full(100, -1), None, SHAPES[0], graze.Shapes(SHAPES[:1]), graze.Scene()]
        types = [each for each in map(graze.__dict__.get, graze.__all__) if isinstance(each, type)]
        called = 0
        for owner in types:
            for name in [name for name in vars(owner) if name in SPECIAL or name not in dir(type)]:
                method = vars(owner)[name]
                method = method.fget if isinstance(method, property) else method
                if not callable(method):
                    continue
                for other in others:
                    for arguments in ((), (0,), (None,)):
                        called += 1
                        try:
                            method(other, *arguments)
                        except Exception:  # of any kind, but the process goes on
                            pass
        self.assertGreater(called, 1000)

    def test_every_call_returns_or_raises_an_exception(self):
        seed = random.randrange(10**9)
        chance = random.Random(seed)
        warnings.simplefilter("ignore")  # NumPy's about comparisons of junk
        calls, end = 0, time.monotonic() + SECONDS
        while calls < 2000 or time.monotonic() < end:  # a busy machine takes longer
            targets = callables(chance)
            for _ in range(500):
                arguments = [junk(chance) for _ in range(chance.randrange(5))]
                keywords = {chance.choice(WORDS): junk(chance) for _ in range(chance.choice([0, 0, 1]))}
                try:
                    chance.choice(targets)(*arguments, **keywords)
                except (Exception, SystemExit) as error:  # noqa: BLE001
                    self.assertNotIsInstance(error, (SystemError, MemoryError), f"seed {seed}")
                calls += 1


if __name__ == "__main__":
    unittest.main()
