# SPDX-License-Identifier: MIT
"""The progress line: on a terminal, for work that takes over a second, and erased at the end."""

import json
import os
import subprocess
import time
import unittest

from graze_program import PROGRAM, YARD, CommandLineTest, Terminal, environment

ERASE = "\r\x1b[K"


class Progress(CommandLineTest):
    def check_slow_input(self, seconds, streams, command=("check", "--format", "csv", "-"), **variables):
        """Runs the program on a scene that arrives after this many seconds."""

        def feed(process):
            time.sleep(seconds)
            process.stdin.write(json.dumps(YARD).encode())
            process.stdin.close()

        shown = Terminal([PROGRAM, *command], streams, stdin=subprocess.PIPE, during=feed, env=environment(**variables))
        self.assertEqual(shown.code, 0)
        return shown

    def test_long_work_shows_a_line_and_takes_it_away(self):
        shown = self.check_slow_input(2, ("stderr",))
        self.assertIn("reading the scene ... 1 s", shown.text)
        self.assertIn(ERASE, shown.text)
        self.assertRegex(shown.screen(), r"\Agraze: 3 pairs; 4 objects, 3 candidates, [0-9.]+ seconds\r?\n\Z")
        self.assertNotIn("reading", shown.piped["stdout"])

    def test_short_work_shows_none(self):
        shown = self.check_slow_input(0, ("stderr",))
        self.assertNotIn("reading", shown.text)
        self.assertNotIn("\x1b[K", shown.text)

    def test_pipes_and_dumb_terminals_get_none(self):
        self.assertNotIn("reading", self.check_slow_input(1.5, ("stdout",)).piped["stderr"])
        self.assertNotIn("reading", self.check_slow_input(1.5, ("stderr",), TERM="dumb").text)

    def test_without_colours_the_line_is_there_all_the_same(self):
        self.assertIn("reading the scene", self.check_slow_input(1.5, ("stderr",), NO_COLOR="1").text)

    def test_every_command_that_reads_shows_it(self):
        template = self.write("template.html", '<script type="application/json" id="graze-report"></script>')
        for command in (("check", "-"), ("query", "-", "--point", "0,5"), ("simulate", "-", "--frames", "1"), ("info", "-"),
                        ("view", "-", "--html", str(self.folder / "out.html")), ("bench", "-", "--frames", "1"),
                        ("convert", "-", str(self.folder / "out.json"))):
            with self.subTest(command):
                shown = self.check_slow_input(1.5, ("stderr",), command, GRAZE_REPORT_TEMPLATE=str(template))
                self.assertIn("reading the scene", shown.text)
                self.assertNotIn("reading", shown.screen())

    def test_so_do_those_that_read_a_log(self):
        log = self.folder / "yard.log"
        self.succeed("simulate", self.yard(), "--frames", "1", "--log", log)
        fifo = self.folder / "slow.log"
        os.mkfifo(fifo)

        def feed(_process):
            with fifo.open("wb") as late:
                time.sleep(1.5)
                late.write(log.read_bytes())

        for command in (("replay", str(fifo)), ("query", "--log", str(fifo), "--point", "0,5")):
            with self.subTest(command):
                shown = Terminal([PROGRAM, *command], ("stderr",), during=feed, env=environment())
                self.assertEqual(shown.code, 0)
                self.assertIn("reading the log", shown.text)

    def test_an_error_comes_after_the_line_is_gone(self):
        def feed(process):
            time.sleep(1.5)
            process.stdin.close()

        shown = Terminal([PROGRAM, "check", "-"], ("stderr",), stdin=subprocess.PIPE, during=feed, env=environment())
        self.assertEqual(shown.code, 3)
        self.assertIn("reading the scene", shown.text)
        self.assertTrue(shown.screen().startswith("graze: error: standard input"), shown.screen())

    def test_the_search_shows_how_far_it_is(self):
        # Polytopes that all overlap: many pairs that take long each, more of them for faster builds.
        points = [[x, y, z + 0.1 * x * y] for x in (0, 1, 2) for y in (0, 1, 2) for z in (0, 1, 2)]
        for count in (100, 400, 1600, 6400):
            objects = [{"type": "polytope", "points": points} for _ in range(count)]
            scene = self.write("s.json", {"schema": "graze.scene/1", "dimension": 3, "objects": objects})
            command = [PROGRAM, "check", "--format", "csv", "--output", "/dev/null", str(scene)]
            shown = Terminal(command, ("stderr",), env=environment())
            self.assertEqual(shown.code, 0)
            self.assertIn(f"graze: {count * (count - 1) // 2} pairs;", shown.screen())
            if "testing pairs" in shown.text:
                break
        self.assertRegex(shown.text, r"testing pairs \[=* *\] +\d+ % \d+ s")

    def test_a_simulation_shows_how_far_it_is(self):
        scene = self.write("s.json", {"schema": "graze.scene/1", "dimension": 2, "objects": [
            {"type": "sphere", "center": [0, 0], "radius": 1, "velocity": [1, 0]}]})
        for frames in (50_000, 400_000, 3_200_000):  # the more the faster the program was built
            command = [PROGRAM, "simulate", "--frames", str(frames), "--output", str(self.folder / "out.ndjson"), str(scene)]
            shown = Terminal(command, ("stderr",), env=environment())
            self.assertEqual(shown.code, 0)
            if "simulating" in shown.text:
                break
        self.assertRegex(shown.text, r"simulating \[=* *\] +\d+ % \d+ s")
        self.assertIn(ERASE, shown.text)
        self.assertRegex(shown.screen(), rf"\Agraze: {frames} frames; 1 objects, 1 moving, 0 contacts began")


if __name__ == "__main__":
    unittest.main()
