# SPDX-License-Identifier: MIT
"""Colours: only on a terminal, and only if wanted."""

import unittest

from graze_program import PROGRAM, CommandLineTest, Terminal, environment

ESCAPE = "\x1b"


class Colours(CommandLineTest):
    def on_terminal(self, *arguments, streams=("stdout", "stderr"), **variables):
        shown = Terminal([PROGRAM, *map(str, arguments)], streams, env=environment(**variables))
        return shown

    def test_a_table_on_a_terminal_is_coloured(self):
        shown = self.on_terminal("check", self.yard())
        self.assertEqual(shown.code, 0)
        self.assertIn(f"{ESCAPE}[1mA       B      RELATION{ESCAPE}[0m", shown.text)
        self.assertIn(f"crate   ball   {ESCAPE}[33moverlapping{ESCAPE}[0m", shown.text)
        self.assertIn(f"{ESCAPE}[1mtypes{ESCAPE}[0m", self.on_terminal("info", self.yard()).text)

    def test_colours_can_be_switched_off(self):
        for variables in ({"NO_COLOR": "1"}, {"TERM": "dumb"}):
            with self.subTest(variables):
                for command in ("check", "info"):
                    self.assertNotIn(ESCAPE, self.on_terminal(command, self.yard(), **variables).text)
                self.assertNotIn(ESCAPE, self.on_terminal("check", "missing", **variables).text)

    def test_an_empty_no_color_switches_nothing_off(self):
        self.assertIn(ESCAPE, self.on_terminal("check", self.yard(), NO_COLOR="").text)

    def test_data_for_programs_is_not_coloured(self):
        for report_format in ("json", "ndjson", "csv"):
            self.assertNotIn(ESCAPE, self.on_terminal("check", "--format", report_format, self.yard()).text)

    def test_a_pipe_gets_no_colours_while_errors_are_on_a_terminal(self):
        shown = self.on_terminal("check", self.yard(), streams=("stderr",))
        self.assertNotIn(ESCAPE, shown.piped["stdout"])
        self.assertIn("overlapping", shown.piped["stdout"])
        self.assertEqual(shown.text, "")

    def test_a_file_gets_no_colours(self):
        report = self.folder / "report"
        self.on_terminal("check", "--output", report, self.yard())
        self.assertNotIn(ESCAPE, report.read_text())

    def test_an_error_is_coloured_on_a_terminal_only(self):
        shown = self.on_terminal("check", "missing", streams=("stderr",))
        self.assertEqual(shown.code, 3)
        self.assertIn(f"graze: {ESCAPE}[1;31merror:{ESCAPE}[0m missing: there is no such file", shown.text)
        self.assertNotIn(ESCAPE, self.on_terminal("check", "missing", streams=("stdout",)).piped["stderr"])

    def test_names_cannot_give_orders_to_a_terminal(self):
        boxes = "".join(f'"{ESCAPE}[2J{i}",0,0,1,1\n' for i in range(2))
        shown = self.on_terminal("check", self.write("b.csv", "id,min_x,min_y,max_x,max_y\n" + boxes))
        self.assertIn("\\x1b[2J0", shown.text)
        self.assertNotIn(f"{ESCAPE}[2J", shown.text)


if __name__ == "__main__":
    unittest.main()
