# SPDX-License-Identifier: MIT
"""The library as other languages load it: by ctypes, with types that are made from the headers."""

import ctypes
import os
import random
import subprocess
import sys
import threading
import unittest

import c_header

_PLAIN = {"double": ctypes.c_double, "bool": ctypes.c_bool, "size_t": ctypes.c_size_t, "uint32_t": ctypes.c_uint32,
          "uint64_t": ctypes.c_uint64, "int32_t": ctypes.c_int32, "graze_layers": ctypes.c_uint64, "constchar*": ctypes.c_char_p,
          "const char*": ctypes.c_char_p}
_STRUCTS = {}


def type_named(name):
    """The ctypes type of a C type."""
    if name in _PLAIN:
        return _PLAIN[name]
    if name.endswith("*") or "(*)" in name or name == "graze_pair_visitor":
        return ctypes.c_void_p
    return _STRUCTS.get(name, ctypes.c_int32)  # what is not a struct is a list of constants


class _Kinds(ctypes.Union):
    """`as` of graze_shape; the other members are shorter."""


def make_structs():
    for name, fields in c_header.structs().items():
        if name == "graze_shape":
            of_kind = [(kind, _STRUCTS[f"graze_{kind}"]) for kind in ("segment", "ray", "sphere", "obb", "triangle", "capsule")]
            _Kinds._fields_ = [("geometry", _STRUCTS["graze_geometry"]), ("aabb", _STRUCTS["graze_box"]), *of_kind,
                               ("numbers", ctypes.c_double * 15)]
            fields = [("union" if kind == "union" else kind, field, length) for kind, field, length in fields]
        listed = [(field, _Kinds if kind == "union" else type_named(kind) * length if length else type_named(kind))
                  for kind, field, length in fields]
        _STRUCTS[name] = type(name, (ctypes.Structure,), {"_fields_": listed})


make_structs()
LIBRARY = ctypes.CDLL(os.environ["GRAZE_C_LIBRARY"])
FUNCTIONS = c_header.functions()
for _name, (_result, _parameters) in FUNCTIONS.items():
    _function = getattr(LIBRARY, _name)
    _function.restype = type_named(_result)
    _function.argtypes = [type_named(parameter) for parameter in _parameters]
CONSTANTS = c_header.constants()
OK, SPHERE, WORLD = CONSTANTS["GRAZE_OK"], CONSTANTS["GRAZE_SPHERE"], CONSTANTS["GRAZE_3D"]
Vec, Shape, Rows, Pair = (_STRUCTS[f"graze_{name}"] for name in ("vec", "shape", "rows", "pair"))


def message():
    return LIBRARY.graze_error_message().decode()


def ball(x, radius=1.0, world=WORLD):
    return LIBRARY.graze_make_sphere(world, Vec(x, 0, 0), radius)


def rows_of(numbers, columns, world=WORLD):
    array = (ctypes.c_double * len(numbers))(*numbers)
    rows = Rows(ctypes.addressof(array), len(numbers) // columns, 0, world)
    rows.keep = array  # lives as long as the rows
    return rows


class Layout(unittest.TestCase):
    def test_structs_lie_as_the_headers_declare_them(self):
        expected = []
        for name, fields in c_header.structs().items():
            struct = _STRUCTS[name]
            expected.append(f"{name} {ctypes.sizeof(struct)}")
            for _, field, _ in fields:
                place = getattr(struct, field)
                expected.append(f"{name}.{field} {place.offset} {place.size}")
        self.assertEqual(LIBRARY.graze_layout().decode().splitlines(), expected)
        self.assertGreater(len(expected), 150)

    def test_the_library_exports_the_functions_of_the_headers_and_nothing_else(self):
        if sys.platform != "linux":
            self.skipTest("readelf is for ELF")
        listing = subprocess.run(["readelf", "--dyn-syms", "--wide", os.environ["GRAZE_C_LIBRARY"]], capture_output=True,
                                 text=True, check=True).stdout
        symbols = [line.split() for line in listing.splitlines() if " GLOBAL " in line or " WEAK " in line or " UNIQUE " in line]
        exported = {symbol[7].split("@")[0] for symbol in symbols if symbol[6] != "UND"}
        self.assertEqual(exported, set(FUNCTIONS))

    def test_the_version_is_that_of_the_header(self):
        defined = (c_header.ROOT / "bindings/c/graze.h").read_text(encoding="utf-8")
        self.assertIn(f"#define GRAZE_VERSION {LIBRARY.graze_version()}\n", defined)

    def test_each_status_has_its_name(self):
        names = [name for name in CONSTANTS if name in ("GRAZE_OK", "GRAZE_NONE", "GRAZE_TRUNCATED") or CONSTANTS[name] < 0]
        self.assertEqual(len(names), 10)
        self.assertEqual([LIBRARY.graze_status_name(CONSTANTS[name]).decode() for name in names], names)


class Calls(unittest.TestCase):
    def test_a_distance(self):
        result = ctypes.c_double()
        a, b = ball(0), ball(5)
        self.assertEqual(LIBRARY.graze_distance(ctypes.byref(a), ctypes.byref(b), ctypes.byref(result)), OK, message())
        self.assertEqual(result.value, 3.0)

    def test_a_hull_lives_until_it_is_destroyed(self):
        cube = [c for x in (0, 1) for y in (0, 1) for z in (0, 1) for c in (x, y, z)]
        hull, mass = Shape(), _STRUCTS["graze_mass"]()
        self.assertEqual(LIBRARY.graze_create_hull(rows_of(cube, 3), ctypes.byref(hull)), OK, message())
        self.assertEqual(LIBRARY.graze_mass_properties(ctypes.byref(hull), ctypes.byref(mass)), OK, message())
        self.assertAlmostEqual(mass.volume, 1)
        self.assertEqual(LIBRARY.graze_destroy_geometry(getattr(hull, "as").geometry), OK)
        status = LIBRARY.graze_mass_properties(ctypes.byref(hull), ctypes.byref(mass))
        self.assertEqual(status, CONSTANTS["GRAZE_OUT_OF_RANGE"])
        self.assertIn("it was destroyed", message())

    def test_pairs_fill_a_buffer_or_visit_a_function(self):
        boxes = rows_of([c for i in range(1000) for c in (i, 0, 0, i + 1, 1, 1)], 6)
        count = ctypes.c_size_t()
        status = LIBRARY.graze_overlapping_pairs(boxes, None, None, 0, ctypes.byref(count))
        self.assertEqual((status, count.value), (CONSTANTS["GRAZE_TRUNCATED"], 999))
        pairs = (Pair * count.value)()
        status = LIBRARY.graze_overlapping_pairs(boxes, None, ctypes.byref(pairs), count.value, ctypes.byref(count))
        self.assertEqual((status, pairs[998].a, pairs[998].b), (OK, 998, 999))
        found = []
        visitor_type = ctypes.CFUNCTYPE(ctypes.c_bool, ctypes.POINTER(Pair), ctypes.c_size_t, ctypes.c_void_p)
        visitor = visitor_type(lambda block, size, _: found.extend((block[i].a, block[i].b) for i in range(size)) or True)
        status = LIBRARY.graze_visit_overlapping_pairs(boxes, None, ctypes.cast(visitor, ctypes.c_void_p), None)
        self.assertEqual(status, OK, message())
        self.assertEqual(sorted(found), [(i, i + 1) for i in range(999)])
        stops = visitor_type(lambda *_: False)
        self.assertEqual(LIBRARY.graze_visit_overlapping_pairs(boxes, None, ctypes.cast(stops, ctypes.c_void_p), None), OK)

    def test_threads_have_their_own_messages(self):
        bad, messages = ball(0, -1.0), []

        def fail():
            messages.append(message())
            LIBRARY.graze_check(ctypes.byref(bad))
            messages.append(message())

        LIBRARY.graze_check(None)
        before = message()
        thread = threading.Thread(target=fail)
        thread.start()
        thread.join()
        self.assertEqual(messages, ["", "graze_check: shape, a sphere, has a negative radius"])
        self.assertEqual(message(), before)

    def test_geometries_are_shared_by_threads_that_destroy_and_create(self):
        def work(results):
            for _ in range(300):
                hull, is_inside = Shape(), ctypes.c_bool()
                LIBRARY.graze_create_hull(rows_of([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], 3), ctypes.byref(hull))
                LIBRARY.graze_contains(ctypes.byref(hull), Vec(0.1, 0.1, 0.1), ctypes.byref(is_inside))
                results.append(is_inside.value and LIBRARY.graze_destroy_geometry(getattr(hull, "as").geometry) == OK)

        results = []
        threads = [threading.Thread(target=work, args=(results,)) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(results, [True] * 1200)


class Refusals(unittest.TestCase):
    def test_every_function_survives_zeros_for_all_arguments(self):
        """Null pointers are refused, and so are the handles of nothing."""
        for name, (result, parameters) in FUNCTIONS.items():
            if result != "graze_status" or name.startswith("graze_destroy_"):
                continue
            with self.subTest(name=name):
                zeros = [type_named(parameter)() for parameter in parameters]
                self.assertLess(getattr(LIBRARY, name)(*zeros), 0)
                self.assertTrue(message().startswith(f"{name}: "), message())
        self.assertEqual(LIBRARY.graze_destroy_geometry(_STRUCTS["graze_geometry"]()), OK)
        self.assertEqual(LIBRARY.graze_destroy_scene(_STRUCTS["graze_scene"]()), OK)

    def test_shapes_of_random_numbers_are_answered_or_refused(self):
        choose = random.Random(7)
        numbers = [0.0, 1.0, -1.0, 0.5, 1e300, -1e-300, 5e-324, float("inf"), float("nan")]
        a, b, seen = Shape(), Shape(), set()
        questions = ["graze_relation_of", "graze_intersects", "graze_distance", "graze_closest_points", "graze_separation"]
        out = ctypes.create_string_buffer(1024)
        for _ in range(3000):
            world = choose.randrange(-1, 5)
            for shape in (a, b):
                shape.kind, shape.world = choose.randrange(-1, 14), world
                share = choose.choice((3, 9))
                getattr(shape, "as").numbers[:] = [choose.choice(numbers[:share]) for _ in range(15)]
            status = getattr(LIBRARY, choose.choice(questions))(ctypes.byref(a), ctypes.byref(b), ctypes.byref(out))
            seen.add(status)
            self.assertIn(status, (OK, CONSTANTS["GRAZE_INVALID_ARGUMENT"], CONSTANTS["GRAZE_OUT_OF_RANGE"]), message())
        self.assertEqual(len(seen), 3)


class Example(unittest.TestCase):
    def test_the_example_runs(self):
        path = c_header.ROOT / "bindings/c/examples/from_python.py"
        done = subprocess.run([sys.executable, path, os.environ["GRAZE_C_LIBRARY"]], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout, "distance: 3.0\nrefused: graze_distance: b, a sphere, has a negative radius\n")


if __name__ == "__main__":
    unittest.main()
