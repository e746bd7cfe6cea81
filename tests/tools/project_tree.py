# SPDX-License-Identifier: MIT
"""A small project in a temporary folder, and the project's tools run on it."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(os.environ.get("GRAZE_ROOT", Path(__file__).resolve().parents[2]))
LICENSE = "// SPDX-License-Identifier: MIT\n"

sys.path.insert(0, str(ROOT / "tools"))


class TreeTest(unittest.TestCase):
    """A test with a project tree of its own, initially empty."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="graze tools ")
        self.addCleanup(holder.cleanup)
        self.tree = Path(holder.name)

    def write(self, path, text):
        """Writes a file of the tree, creating its folders."""
        (self.tree / path).parent.mkdir(parents=True, exist_ok=True)
        (self.tree / path).write_text(text, encoding="utf-8")

    def write_header(self, path, body=""):
        """Writes a valid header and its mirror test."""
        self.write(path, f"{LICENSE}#pragma once\n{body}")
        self.write(path.replace("graze/", "tests/", 1).replace(".hpp", "_test.cpp"), LICENSE)

    def run_tool(self, name, *arguments):
        """Runs a tool on the tree; returns its exit status and its output."""
        done = subprocess.run([sys.executable, "-B", ROOT / "tools" / name, "--root", self.tree, *arguments],
                              capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr
