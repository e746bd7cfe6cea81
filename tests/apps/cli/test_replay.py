# SPDX-License-Identifier: MIT
"""`graze replay`, and the logs that `graze simulate --log` writes."""

import json
import unittest

from graze_program import YARD, CommandLineTest, Terminal, PROGRAM, environment

ROLLING = YARD | {
    "objects": [
        {"name": "ground", "type": "half_space", "normal": [0, 1], "offset": 0, "fixed": True},
        {"name": "post", "type": "aabb", "min": [4, 0], "max": [5, 3], "fixed": True},
        {"name": "ball", "type": "sphere", "center": [0, 1], "radius": 1, "velocity": [2, 0]},
    ]
}


class Replay(CommandLineTest):
    def log(self, name="rolling.log"):
        """The log of four frames: three adds, five updates, four moves."""
        path = self.folder / name
        self.succeed("simulate", self.write("rolling.json", ROLLING), "--frames", "4", "--seconds-per-frame", "1",
                     "--log", path, "--output", self.folder / "frames.ndjson")
        return path

    def wrong_log(self):
        """The same log, in which the ball has touched the post longer than it actually did."""
        text = self.log().read_text()
        self.assertIn('"began", [1, 1], [2, 1]', text)
        return self.write("wrong.log", text.replace('"began", [1, 1], [2, 1]', '"stayed", [1, 1], [2, 1]'))

    def test_a_simulation_is_recorded_and_replayed(self):
        lines = [json.loads(line) for line in self.log().read_text().splitlines()]
        self.assertEqual(lines[0], {"schema": "graze.log/1", "dimension": 2, "numbers": "double"})
        self.assertEqual([line["call"] for line in lines if "call" in line],
                         ["add"] * 3 + ["update"] + ["move_many", "update"] * 4)
        text, said = self.succeed("replay", self.log())
        self.assertRegex(text, r"\Anone of 12 answers differ; 2D double, [0-9.]+ seconds\n\Z")
        self.assertEqual(said, "")

    def test_recording_changes_no_frame(self):
        self.log()
        scene = self.write("rolling.json", ROLLING)
        text, _ = self.succeed("simulate", scene, "--frames", "4", "--seconds-per-frame", "1")
        self.assertEqual(text, (self.folder / "frames.ndjson").read_text())

    def test_an_answer_that_differs_is_shown_and_is_exit_code_1(self):
        text, _ = self.succeed("replay", self.wrong_log(), code=1)
        self.assertEqual(text.splitlines()[:3], ["LINE  CALL    DIFFERS FROM", "16    update  the log", ""])
        self.assertIn("\n1 of 12 answers differs;", text)

    def test_json_has_the_documented_fields(self):
        log = self.wrong_log()
        document = json.loads(self.succeed("replay", "--format", "json", log, code=1)[0])
        self.assertGreaterEqual(document["summary"].pop("seconds"), 0)
        began = [["began", [1, 1], [2, 1]], ["stayed", [0, 1], [2, 1]]]
        self.assertEqual(document, {
            "schema": "graze.replay/1", "log": str(log), "dimension": 2, "numbers": "double",
            "differences": [{"line": 16, "call": {"call": "update"}, "given": {"answer": began}, "brute_force": {"answer": began},
                             "log": {"answer": [["stayed", [1, 1], [2, 1]], began[1]]},
                             "differs_from_brute_force": False, "differs_from_log": True}],
            "summary": {"calls": 12, "differing": 1},
        })

    def test_shrinking_leaves_what_the_difference_needs(self):
        small = self.folder / "small.log"
        text, said = self.succeed("replay", "--shrink", "--output", small, self.wrong_log(), code=1)
        self.assertEqual(text, "")
        self.assertRegex(said, r"\Agraze: 6 of 12 calls are left after \d+ attempts\n\Z")
        calls = [json.loads(line).get("call") for line in small.read_text().splitlines()[1::2]]
        self.assertEqual(calls, ["add", "add", "move_many", "update", "move_many", "update"])  # post and ball
        self.assertIn("1 of 6 answers differs", self.succeed("replay", small, code=1)[0])

    def test_nothing_is_shrunk_where_all_agree(self):
        small = self.folder / "small.log"
        _, said = self.succeed("replay", "--shrink", "--output", small, self.log())
        self.assertIn("none of 12 answers differs", said)
        self.assertFalse(small.exists())

    def test_the_standard_input_is_read(self):
        text, _ = self.succeed("replay", "-", input=self.log().read_bytes())
        self.assertIn("none of 12", text)

    def test_a_bad_log_is_refused_with_its_line(self):
        text = self.log().read_text()
        cut = self.write("cut.log", text[:-20])
        self.refused("replay", cut, says=("cut.log: line 25, column ", "is the file cut off?"))
        self.refused("replay", self.write("odd.log", text.replace('"update"', '"updat"', 1)),
                     says='odd.log: line 8, column 10: "call" is "updat", which is not known; did you mean "update"?')
        self.refused("replay", self.yard(), says="yard.json: line 1, column 12: \"schema\" is \"graze.scene/1\", which is not a query log")
        self.refused("replay", self.folder, says="this is a folder; give the log in it")
        self.refused("replay", self.folder / "none.log", says="there is no such file")

    def test_wrong_usage_is_refused(self):
        log = self.log()
        self.refused("replay", code=2, says="needs LOG")
        self.refused("replay", log, "--format", "csv", code=2, says='--format "csv" is not known')
        self.refused("replay", log, "--shrink", "--format", "json", code=2, says="but --shrink writes a log")
        self.refused("replay", log, "--output", log, code=2, says="would be overwritten")
        scene = self.write("rolling.json", ROLLING)
        self.refused("simulate", scene, "--frames", "1", "--log", scene, code=2, says="would be overwritten")
        self.refused("simulate", scene, "--frames", "1", "--log", "-", code=2, says="is also the output of the frames")

    def test_nothing_of_the_progress_is_left_on_a_terminal(self):
        shown = Terminal([PROGRAM, "replay", str(self.log())], ("stdout", "stderr"), env=environment())
        self.assertEqual(shown.code, 0)
        self.assertRegex(shown.screen(), r"\Anone of 12 answers differ; 2D double, [0-9.]+ seconds\s*\Z")


if __name__ == "__main__":
    unittest.main()
