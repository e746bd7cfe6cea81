# SPDX-License-Identifier: MIT
"""What tools/check_portability.py finds, and what guards it."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from check_portability import findings  # noqa: E402


def found(text):
    return list(findings(text))


class PortabilityTest(unittest.TestCase):
    def test_constructs_without_a_guard_are_found_with_their_lines(self):
        self.assertEqual(found("int a;\nusing F = float __attribute__((vector_size(16)));\n"), [(2, "an attribute of GCC")])
        self.assertEqual(found("__builtin_unreachable();\n"), [(1, "a builtin of GCC")])
        self.assertEqual(found("#include <unistd.h>\n"), [(1, "a header of POSIX")])
        self.assertEqual(found("#include <windows.h>\n"), [(1, "a header of Windows")])
        self.assertEqual(found("#pragma GCC unroll 3\n"), [(1, "a pragma of GCC")])
        self.assertEqual(found("ssize_t n;\npy::ssize_t m;\n"), [(1, "a type of POSIX")])

    def test_what_is_inside_a_guard_is_not(self):
        for condition in ("ifdef __GNUC__", "if defined(__clang__) && defined(X)", "ifdef GRAZE_HAS_LANES",
                          "if __has_include(<unistd.h>)", "ifndef _WIN32"):
            self.assertEqual(found(f"#{condition}\n#ifdef OTHER\n__builtin_trap();\n#endif\n#endif\n"), [], condition)
        self.assertEqual(found("#ifdef _WIN32\n#include <windows.h>\n#else\n#include <unistd.h>\n#endif\n"), [])

    def test_the_other_branch_of_a_guard_is_found(self):
        self.assertEqual(found("#ifdef __GNUC__\n#else\n__builtin_trap();\n#endif\n"), [(3, "a builtin of GCC")])
        self.assertEqual(found("#ifndef __GNUC__\n__builtin_trap();\n#endif\n"), [(2, "a builtin of GCC")])
        self.assertEqual(found("#if !defined(__GNUC__)\n__builtin_trap();\n#endif\n"), [(2, "a builtin of GCC")])
        self.assertEqual(found("#ifdef _WIN32\n#include <unistd.h>\n#endif\n"), [(2, "a header of POSIX")])
        self.assertEqual(found("#ifdef _WIN32\n#else\n#include <windows.h>\n#endif\n"), [(3, "a header of Windows")])

    def test_a_guard_ends_with_its_block(self):
        self.assertEqual(found("#ifdef __GNUC__\n#endif\n__builtin_trap();\n"), [(3, "a builtin of GCC")])

    def test_comments_and_texts_are_not_code(self):
        self.assertEqual(found('// __builtin_trap\nauto text = "__attribute__";\n'), [])

    def test_lines_are_counted_across_continued_directives(self):
        self.assertEqual(found("#if defined(A) && \\\n    defined(B)\n__builtin_trap();\n#endif\n"), [(3, "a builtin of GCC")])
        self.assertEqual(found("#if defined(A) && \\\n    defined(__GNUC__)\n__builtin_trap();\n#endif\n"), [])


if __name__ == "__main__":
    unittest.main()
