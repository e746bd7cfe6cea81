# SPDX-License-Identifier: MIT
"""The headers compile alone as C99 and as C++ with every compiler that is installed, and the tests in C call every function."""

import re
import shutil
import subprocess
import unittest
from pathlib import Path

import c_header

_WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror", "-fsyntax-only"]
_LANGUAGES = [(compiler, ["-x", "c", f"-std={standard}", "-Wstrict-prototypes"])
              for compiler in ("gcc", "clang") for standard in ("c99", "c11")]
_LANGUAGES += [(compiler, ["-x", "c++", f"-std={standard}"]) for compiler in ("g++", "clang++") for standard in ("c++11", "c++20")]


class Headers(unittest.TestCase):
    def test_they_compile_alone_and_twice(self):
        compiled = 0
        for compiler, options in _LANGUAGES:
            if not shutil.which(compiler):
                continue
            for header in c_header.HEADERS:
                include = f"#include <{header.name}>\n"
                done = subprocess.run([compiler, *options, *_WARNINGS, f"-I{header.parent}", "-"], input=include + include,
                                      capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, f"{compiler} {options} {header}:\n{done.stderr}")
                compiled += 1
        self.assertGreater(compiled, 0)

    def test_every_function_is_called_from_c(self):
        folder = Path(__file__).resolve().parent
        code = "\n".join(path.read_text(encoding="utf-8") for path in folder.glob("*_test.c"))
        called = set(re.findall(r"\b(graze_\w+)\(", code))
        self.assertEqual(set(c_header.functions()) - called, set())

    def test_lines_are_short_enough_to_read(self):
        for header in c_header.HEADERS:
            for number, line in enumerate(header.read_text(encoding="utf-8").splitlines(), 1):
                self.assertLessEqual(len(line), 120, f"{header}:{number}")


if __name__ == "__main__":
    unittest.main()
