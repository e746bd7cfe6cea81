# SPDX-License-Identifier: MIT
"""graze from a language without a binding, by its foreign function interface: here Python's ctypes, with no other package.

usage: python3 from_python.py libgraze_c.so
"""

import ctypes
import sys


class Vec(ctypes.Structure):
    _fields_ = [("x", ctypes.c_double), ("y", ctypes.c_double), ("z", ctypes.c_double)]


class Sphere(ctypes.Structure):
    _fields_ = [("center", Vec), ("radius", ctypes.c_double)]


class Kinds(ctypes.Union):  # only those that are used, and the numbers, which give the union its size
    _fields_ = [("sphere", Sphere), ("numbers", ctypes.c_double * 15)]


class Shape(ctypes.Structure):
    _fields_ = [("kind", ctypes.c_int32), ("world", ctypes.c_int32), ("as_", Kinds)]


SPHERE, WORLD_3D = 3, 0  # GRAZE_SPHERE, GRAZE_3D

graze = ctypes.CDLL(sys.argv[1])
graze.graze_error_message.restype = ctypes.c_char_p
graze.graze_layout.restype = ctypes.c_char_p
assert f"graze_shape {ctypes.sizeof(Shape)}\n" in graze.graze_layout().decode()


def distance(a, b):
    result = ctypes.c_double()
    if graze.graze_distance(ctypes.byref(a), ctypes.byref(b), ctypes.byref(result)) < 0:
        raise ValueError(graze.graze_error_message().decode())
    return result.value


def ball(x, radius):
    return Shape(SPHERE, WORLD_3D, Kinds(sphere=Sphere(Vec(x, 0, 0), radius)))


print("distance:", distance(ball(0, 1), ball(5, 1)))
try:
    distance(ball(0, 1), ball(5, -1))
except ValueError as error:
    print("refused:", error)
