# SPDX-License-Identifier: MIT
"""The examples run and print what they claim, and docs/python.md shows them as they are."""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
EXAMPLES = ROOT / "bindings/python/examples"
LAST_LINES = {"hulls.py": r"they meet at 0\.\d+ of the way", "many_boxes.py": r"\d+ pairs",
              "mesh_files.py": r"volume 0\.167",
              "inside.py": r"4 open edges, \d+ points inside", "robot_arm.py": r"touches after \d+\.\d degrees"}


class ExamplesTest(unittest.TestCase):
    def test_every_example_runs(self):
        self.assertEqual(sorted(path.name for path in EXAMPLES.glob("*.py")), sorted(LAST_LINES))
        for name, pattern in LAST_LINES.items():
            with tempfile.TemporaryDirectory() as folder:
                command = [sys.executable, EXAMPLES / name]
                done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stdout.splitlines()[-1], f"^{pattern}$")

    def test_the_page_shows_them(self):
        page = (ROOT / "docs/python.md").read_text()
        shown = dict(re.findall(r"<!-- file: bindings/python/examples/(\S+) -->\n```python\n(.*?)```", page, re.S))
        self.assertEqual(shown, {path.name: path.read_text() for path in EXAMPLES.glob("*.py")})


if __name__ == "__main__":
    unittest.main()
