# SPDX-License-Identifier: MIT
"""The type stubs name everything in the module, and mypy accepts them and the examples with them."""

import ast
import importlib.util
import os
import pathlib
import subprocess
import sys
import unittest

import graze

PACKAGE = pathlib.Path(graze.__file__).parent
EXAMPLES = pathlib.Path(__file__).resolve().parents[1] / "examples"


def stubs():
    return ast.parse((PACKAGE / "__init__.pyi").read_text()).body


class TypesTest(unittest.TestCase):
    def test_everything_public_has_a_stub_and_nothing_else_has(self):
        named = {node.name for node in stubs() if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        self.assertEqual(named, set(graze.__all__))

    def test_methods_of_stubs_exist(self):
        for node in stubs():
            if not isinstance(node, ast.ClassDef):
                continue
            for member in node.body:
                if isinstance(member, ast.FunctionDef) and member.name != "__iter__":
                    self.assertTrue(hasattr(getattr(graze, node.name), member.name), f"{node.name}.{member.name}")

    @unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy is not installed")
    def test_mypy_accepts_stubs_and_examples(self):
        files = [PACKAGE / "__init__.pyi", *sorted(EXAMPLES.glob("*.py"))]
        done = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", os.devnull, "--scripts-are-modules",
                               *files], capture_output=True, text=True, check=False, cwd=PACKAGE.parent)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
