# SPDX-License-Identifier: MIT
"""Usage errors: exit code 2, the most similar known word, and how to get help."""

import unittest

from graze_program import CommandLineTest


class Usage(CommandLineTest):
    def refuse(self, *arguments, says, of=""):
        """Asserts that the program reports an error and refers to the help of the program or `of` a command."""
        said = self.refused(*arguments, code=2, says=says)
        command = f"graze {of} --help" if of else "graze --help"
        self.assertEqual(said.splitlines()[1:], [f"graze: run `{command}` for usage"])

    def test_an_unknown_command_names_the_nearest(self):
        self.refuse("chekc", "x.json", says='no command "chekc"; did you mean "check"?')

    def test_an_unknown_command_like_no_other_names_all(self):
        self.refuse("zzzzzzzz", says='known: "check", "view", "query", "simulate", "replay", "info", "convert"')

    def test_an_unknown_option_names_the_nearest(self):
        self.refuse("check", "x.json", "--interor", says='"--interor"; did you mean "--interior"?', of="check")
        self.refuse("check", "x.json", "--fromat=csv", says='"--fromat"; did you mean "--format"?', of="check")
        self.refuse("info", "--fromat", "json", "x.json", says='did you mean "--format"?', of="info")
        self.refuse("--versoin", says='"--versoin"; did you mean "--version"?')

    def test_an_unknown_short_option_is_named(self):
        self.refuse("check", "-q", "x.json", says='no option "-q"', of="check")

    def test_an_unknown_format_names_the_nearest_or_all(self):
        scene = self.yard()
        self.refuse("check", scene, "--format", "jsn", says='"jsn" is not known; did you mean "json"?', of="check")
        self.refuse("check", scene, "--format", "yaml", says='"table", "json", "ndjson", "csv"', of="check")
        self.refuse("info", scene, "--format", "csv", says='"csv" is not known', of="info")

    def test_a_missing_argument_is_named(self):
        self.refuse("check", says="needs SCENE", of="check")
        self.refuse("info", says="needs SCENE", of="info")
        self.refuse("convert", says="needs IN", of="convert")
        self.refuse("convert", "x.json", says="needs OUT", of="convert")

    def test_a_missing_value_is_named(self):
        self.refuse("check", "x.json", "--svg", says="--svg", of="check")

    def test_an_argument_too_many_is_named(self):
        self.refuse("check", "x.json", "y.json", says='no further argument "y.json"', of="check")

    def test_escape_sequences_in_arguments_do_not_reach_the_terminal(self):
        said = self.refused("check", "x.json", "--\x1b[2J", code=2, says="\\x1b[2J")
        self.assertNotIn("\x1b", said)

    def test_of_an_option_given_twice_the_last_counts(self):
        text, _ = self.succeed("check", self.yard(), "--format", "json", "--format", "csv")
        self.assertTrue(text.startswith("a,b,relation\n"))

    def test_names_that_begin_with_a_hyphen_come_after_two(self):
        self.write("-yard.json", self.yard().read_bytes())
        text, _ = self.succeed("check", "--", "-yard.json", cwd=self.folder)
        self.assertIn("3 pairs;", text)


if __name__ == "__main__":
    unittest.main()
