# SPDX-License-Identifier: MIT
"""data/workshop.json is what tools/make_workshop.py writes."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(os.environ.get("GRAZE_ROOT", Path(__file__).resolve().parents[2]))


class MakeWorkshop(unittest.TestCase):
    def test_the_bundled_scene_is_what_the_script_writes(self):
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder) / "workshop.json"
            script = ROOT / "tools" / "make_workshop.py"
            subprocess.run([sys.executable, "-B", str(script), "--output", str(output)], check=True)
            self.assertEqual(output.read_text(encoding="utf-8"),
                             (ROOT / "data" / "workshop.json").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
