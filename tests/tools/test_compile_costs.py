# SPDX-License-Identifier: MIT
"""tools/compile_costs.py with a compiler that only writes down how it was called."""

import subprocess
import sys
import unittest

from project_tree import ROOT, TreeTest


class CompileCostsTest(TreeTest):
    def test_each_file_is_compiled_as_a_user_of_the_library_would(self):
        self.write("compiler", "#!/bin/sh\n"
                               'echo "$*" >> "$(dirname "$0")/calls"\n'
                               'for word; do case $word in *.cpp) cat "$word" >> "$(dirname "$0")/sources" ;; esac; done\n')
        (self.tree / "compiler").chmod(0o755)
        done = subprocess.run([sys.executable, "-B", ROOT / "tools/compile_costs.py", "--files-only", "--compiler",
                               self.tree / "compiler"], capture_output=True, text=True, check=True)
        lines = done.stdout.splitlines()
        self.assertEqual(lines[:2], ["| user CPU or size | |", "|---|--:|"])
        self.assertRegex(lines[2], r"^\| `#include <graze/graze.hpp>` alone \| 0\.\d s \|$")
        self.assertEqual(len(lines), 9)
        calls = (self.tree / "calls").read_text(encoding="utf-8")
        self.assertEqual(calls.count("-DGRAZE_COMPILED_QUERIES"), 21)
        self.assertIn("time_of_impact(a, {}, b, {})", (self.tree / "sources").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
