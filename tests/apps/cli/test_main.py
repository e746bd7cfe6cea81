# SPDX-License-Identifier: MIT
"""Help, version, exit codes, and the page that documents them."""

import re
import unittest

from graze_program import CAN_BE_LIMITED, ROOT, CommandLineTest, with_memory_of

COMMANDS = ("check", "view", "query", "simulate", "replay", "info", "convert", "bench", "generate", "pairs")


def options_in(text):
    return set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", text))


class Main(CommandLineTest):
    def help_of(self, *command):
        text, said = self.succeed(*command, "--help")
        self.assertEqual(said, "")
        return text

    def test_help_lists_the_commands_with_examples_and_exit_codes(self):
        text = self.help_of()
        for command in COMMANDS:
            self.assertRegex(text, rf"(?m)^  {command} +[A-Z]")
        self.assertIn("Usage: graze [OPTIONS] [COMMAND]", text)
        self.assertIn("Examples:", text)
        self.assertIn("Exit codes: 0 done;", text)
        self.assertEqual(self.help_of(), self.succeed("-h")[0])

    def test_help_of_a_command_has_a_line_per_option_examples_and_exit_codes(self):
        for command in COMMANDS:
            with self.subTest(command):
                text = self.help_of(command)
                self.assertIn(f"Usage: graze {command} [OPTIONS]", text)
                self.assertIn(f"\nExamples:\n  graze {command} ", text)
                self.assertIn("\nExit codes: 0 done;", text)
                for line in text.splitlines():
                    self.assertLessEqual(len(line), 100, line)

    def test_version_is_the_version_of_the_project(self):
        declared = re.search(r"project\(graze VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
        self.assertEqual(self.succeed("--version"), (f"graze {declared}\n", ""))

    def test_without_a_command_help_is_shown_as_an_error(self):
        text, said = self.succeed(code=2)
        self.assertEqual(text, "")
        self.assertIn("Usage: graze", said)

    def test_the_page_documents_every_option_and_no_other(self):
        page = (ROOT / "docs" / "cli.md").read_text()
        sections = re.split(r"(?m)^## ", page)
        known = options_in(self.help_of())
        for command in COMMANDS:
            with self.subTest(command):
                section = next(text for text in sections if text.startswith(f"`graze {command}`"))
                of_command = options_in(self.help_of(command).split("Examples:")[0])
                self.assertEqual(of_command - {"--help"}, options_in(section) - {"--help"})
                known |= of_command
        self.assertEqual(options_in(page), known)

    def test_the_page_documents_every_exit_code_of_the_help(self):
        codes = re.findall(r"\b(\d+) (?=done|contact|wrong|bad|internal)", self.help_of())
        self.assertEqual(codes, ["0", "1", "2", "3", "70"])
        page = (ROOT / "docs" / "cli.md").read_text()
        for code in codes:
            self.assertRegex(page, rf"(?m)^\| {code} \|")

    @unittest.skipUnless(CAN_BE_LIMITED, "the program is built with a sanitizer")
    def test_running_out_of_memory_is_said_in_one_line(self):
        # As objects of a scene they take more than 256 MiB.
        scene = self.write("many.csv", "x,y,radius\n" + "".join(f"{3 * i},0,1\n" for i in range(1_000_000)))
        self.refused("check", scene, code=70, says="out of memory", **with_memory_of(mebibytes=256))


if __name__ == "__main__":
    unittest.main()
