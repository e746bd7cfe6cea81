# SPDX-License-Identifier: MIT
"""./dev in a tree of its own, with programs in place of CMake and what it builds that only say how they were called."""

import os
import shutil
import subprocess
import unittest

from project_tree import ROOT, TreeTest


class DevTest(TreeTest):
    def setUp(self):
        super().setUp()
        shutil.copy(ROOT / "dev", self.tree / "dev")
        self.write_program("bin/cmake", 'echo "cmake $*" >&2')

    def write_program(self, path, body):
        self.write(path, f"#!/bin/sh\n{body}\n")
        (self.tree / path).chmod(0o755)

    def dev(self, *arguments):
        environment = dict(os.environ, GRAZE_NO_INSTALL="1", PATH=f"{self.tree / 'bin'}:{os.environ['PATH']}")
        return subprocess.run([self.tree / "dev", *arguments], capture_output=True, text=True, check=False, env=environment)

    def test_help_names_every_command(self):
        done = self.dev("help")
        self.assertEqual(done.returncode, 0)
        for command in ("demo", "test", "lint", "bench", "exam", "clean", "help"):
            self.assertRegex(done.stdout, rf"(?m)^  {command}\b")

    def test_an_unknown_command_is_told_the_known_ones(self):
        done = self.dev("exma")
        self.assertEqual(done.returncode, 2)
        self.assertIn("there is no command 'exma'", done.stderr)
        self.assertIn("exam", done.stderr)

    def test_commands_without_arguments_refuse_them(self):
        done = self.dev("clean", "all")
        self.assertEqual(done.returncode, 2)
        self.assertIn("clean takes no arguments, but was given: all", done.stderr)

    def test_one_benchmark_runs_with_its_options_and_an_unknown_one_is_told_the_known_ones(self):
        self.write("bench/bounding.cpp", "")
        for name in ("bounding", "graze_peers"):
            self.write_program(f"build/bench/bench/{name}", 'echo "$(basename "$0"): $*"')
        done = self.dev("bench", "fast")
        self.assertEqual(done.returncode, 2)
        self.assertIn("there is no benchmark 'fast'; they are: bounding graze_peers", done.stderr)
        self.assertEqual(self.dev("bench", "bounding", "--quick").stdout, "bounding: --quick\n")
        everything = self.dev("bench").stdout
        self.assertIn("bounding: \n", everything)
        self.assertIn("--markdown docs/benchmarks.md", everything)

    def test_the_exam_is_built_alone_and_gets_the_options_after_the_number_of_jobs(self):
        self.write_program("build/exam/bin/graze_exam", 'for word in "$@"; do echo "[$word]"; done')
        done = self.dev("exam", "--cases", "20", "--pairs", "3D float obb, triangle")
        self.assertEqual(done.returncode, 0)
        words = done.stdout.splitlines()
        self.assertEqual(words[0], "[--jobs]")
        self.assertEqual(words[2:], ["[--cases]", "[20]", "[--pairs]", "[3D float obb, triangle]"])
        self.assertIn("cmake --build --preset exam", done.stderr)
        self.assertIn("--target graze_exam", done.stderr)

    def test_the_exam_fails_when_an_answer_was_wrong(self):
        self.write_program("build/exam/bin/graze_exam", "exit 1")
        self.assertEqual(self.dev("exam").returncode, 1)


if __name__ == "__main__":
    unittest.main()
