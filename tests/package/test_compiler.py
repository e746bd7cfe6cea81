# SPDX-License-Identifier: MIT
"""graze::geometry with other compilers and flags than its own: it works, or one error states the reason and the
solution."""

import os
import re
import shutil
import signal
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(os.environ.get("GRAZE_ROOT", Path(__file__).resolve().parents[2]))
PROGRAMS = ROOT / "tests" / "package" / "compiler"
COMPILER = os.environ.get("GRAZE_COMPILER", "g++")
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"]


def said_by(*command):
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout


IS_CLANG = "__clang__" in said_by(COMPILER, "-dM", "-E", "-x", "c++", "/dev/null")
IS_X86 = "__x86_64__" in said_by(COMPILER, "-dM", "-E", "-x", "c++", "/dev/null")


def compile_text(text, *flags, compiler=COMPILER, standard="-std=c++20"):
    """The compiler's messages for a program; empty if it compiles."""
    done = subprocess.run([compiler, standard, "-fsyntax-only", f"-I{ROOT}", *flags, "-x", "c++", "-"], input=text, text=True,
                          capture_output=True, check=False)
    return done.stderr if done.returncode else ""


class Refused(unittest.TestCase):
    def assert_refused(self, reason, *flags, header="graze/shape/sphere.hpp", **options):
        said = compile_text(f"#include <{header}>\n", *flags, **options)
        self.assertIn(reason, said, flags)
        self.assertEqual(len(re.findall(r"error: (?:#error )?graze needs", said)), 1, said)
        self.assertLessEqual(said.count("error: "), 2, said)  # the second is "compilation terminated"

    def test_fast_math(self):
        for flags in (["-ffast-math"], ["-Ofast"], ["-O2", "-ffinite-math-only"]):
            self.assert_refused("exact arithmetic: compile without -ffast-math, -Ofast", *flags)

    def test_parts_of_fast_math(self):
        for flag in ("-fno-signed-zeros", "-freciprocal-math", "-funsafe-math-optimizations"):
            said = compile_text("#include <graze/shape/sphere.hpp>\n", "-O2", flag)
            self.assertIn("graze needs exact arithmetic: compile without all parts of -ffast-math", said, flag)
            self.assertEqual(len(re.findall(r"\berror: ", said)), 1 if IS_CLANG else 2, said)

    @unittest.skipUnless(IS_X86, "flags of x86")
    def test_the_x87_unit(self):
        flags = ["-m32", "-mno-sse"] if IS_CLANG else ["-mfpmath=387"]
        said = subprocess.run([COMPILER, "-std=c++20", "-fsyntax-only", f"-I{ROOT}", *flags, "-x", "c++", "-"], text=True,
                              input="#include <graze/math/platform/compiler.hpp>\n", capture_output=True, check=False).stderr
        self.assertIn("compile with -msse2 -mfpmath=sse", said)

    @unittest.skipUnless(IS_X86, "flags of x86")
    def test_fma_without_a_word_about_contraction(self):
        for flags in (["-mfma"], ["-march=haswell"], ["-mavx512f"], ["-march=haswell", "-ffp-contract=off"]):
            self.assert_refused("-ffp-contract=off -DGRAZE_NO_CONTRACTION", *flags)
        self.assertEqual(compile_text("#include <graze/shape/sphere.hpp>\n", "-mfma", "-DGRAZE_NO_CONTRACTION"), "")

    def test_older_standards(self):
        for header in ("math/vec", "math/pose", "shape/any_shape", "shape/frustum", "query/relation", "query/time_of_impact"):
            self.assert_refused("C++20: compile with -std=c++20", header=f"graze/{header}.hpp", standard="-std=c++17")
        self.assert_refused("C++20: compile with -std=c++20", standard="-std=c++11")

    def test_macros_of_glm_that_change_what_a_vector_is(self):
        for name in ("GLM_FORCE_CXX98", "GLM_FORCE_CXX03", "GLM_FORCE_CXX_UNKNOWN", "GLM_FORCE_CTOR_INIT"):
            self.assert_refused(name, f"-D{name}")

    def test_macros_of_windows(self):
        # If no standard header comes first: GCC's headers undefine the macros.
        self.assert_refused("define NOMINMAX before including windows.h", "-Dmin(a,b)=((a)<(b)?(a):(b))",
                            header="graze/math/platform/compiler.hpp")


class EveryQuery(unittest.TestCase):
    """Every header and every query, so that each template is instantiated as for a user's call."""

    text = (PROGRAMS / "every_query.cpp").read_text(encoding="utf-8")

    def test_with_the_oldest_compiler(self):
        if IS_CLANG or not shutil.which("g++-11"):
            self.skipTest("left to the tests with GCC" if IS_CLANG else "there is no g++-11")
        headers = sorted(path for layer in ("math", "shape", "query") for path in (ROOT / "graze" / layer).glob("*.hpp"))
        includes = "".join(f"#include <{path.relative_to(ROOT)}>\n" for path in headers)
        self.assertEqual(compile_text(includes + self.text, *WARNINGS, "-DGLM_FORCE_XYZW_ONLY", compiler="g++-11"), "")

    # Options that do not affect each other are tried together: each compilation makes every query of every two shapes.

    def test_without_vectors_exceptions_and_type_information_and_with_the_macros_of_glm(self):
        macros = [f"-DGLM_FORCE_{name}" for name in (
            "INTRINSICS", "DEFAULT_ALIGNED_GENTYPES", "SWIZZLE", "SIZE_T_LENGTH", "EXPLICIT_CTOR", "UNRESTRICTED_GENTYPE",
            "LEFT_HANDED", "DEPTH_ZERO_TO_ONE", "QUAT_DATA_XYZW", "PRECISION_MEDIUMP_FLOAT", "INLINE", "SILENT_WARNINGS")]
        self.assertEqual(compile_text(self.text, "-DGRAZE_NO_LANES", "-fno-exceptions", "-fno-rtti", *macros), "")


class Run(unittest.TestCase):
    def run_program(self, name, *flags):
        with tempfile.TemporaryDirectory() as folder:
            program = Path(folder) / "program"
            subprocess.run([COMPILER, "-std=c++20", f"-I{ROOT}", *flags, PROGRAMS / name, "-o", program], check=True)
            return subprocess.run([program], capture_output=True, text=True, check=False)

    def test_hulls_do_not_depend_on_flags(self):
        expected = self.run_program("hulls.cpp", "-ffp-contract=off", "-DGRAZE_NO_CONTRACTION").stdout
        self.assertEqual(len(expected.splitlines()), 200)
        for flags in (["-O2"], ["-O2", "-march=native", "-ffp-contract=off", "-DGRAZE_NO_CONTRACTION"],
                      ["-O1", "-DGRAZE_NO_LANES"]):
            self.assertEqual(self.run_program("hulls.cpp", *flags).stdout, expected, flags)

    def test_an_error_without_exceptions_is_said_and_ends_the_program(self):
        done = self.run_program("no_points.cpp", "-fno-exceptions")
        self.assertEqual(done.stderr, "graze: convex_hull: there are no points\n")
        self.assertEqual(done.returncode, -signal.SIGABRT)

    def test_an_error_goes_where_the_program_wants_it(self):
        done = self.run_program("no_points.cpp", "-fno-exceptions", "-DOWN_THROW")
        self.assertEqual((done.stdout, done.returncode), ("own: convex_hull: there are no points\n", 3))


if __name__ == "__main__":
    unittest.main()
