# SPDX-License-Identifier: MIT
"""`graze simulate`: the positions of objects in each frame, the report, and errors."""

import json
import unittest

from graze_program import YARD, CommandLineTest

# The ball moves to the crate, at x = 0 to 2, and through it.
FLIGHT = YARD | {
    "objects": [
        {"name": "crate", "type": "aabb", "min": [0, 0], "max": [2, 2]},
        {"name": "ball", "type": "sphere", "center": [-4, 1], "radius": 1, "velocity": [3, 0]},
        {"name": "box", "type": "aabb", "min": [8, 0], "max": [9, 2], "velocity": [-1, 0]},
    ]
}


class Simulate(CommandLineTest):
    def frames_of(self, scene, *arguments, **options):
        text, said = self.succeed("simulate", scene, *arguments, **options)
        self.assertRegex(said, r"\Agraze: \d+ frames; \d+ objects, \d+ moving, \d+ contacts began, \d+ ended, [0-9.]+ seconds\n\Z")
        return [json.loads(line) for line in text.splitlines()]

    def test_events_come_in_the_frames_in_which_they_happen(self):
        scene = self.write("flight.json", FLIGHT)
        frames = self.frames_of(scene, "--frames", "4", "--seconds-per-frame", "1")
        self.assertEqual(list(frames[0]), ["frame", "seconds", "touching", "began", "ended"])
        self.assertEqual([frame["frame"] for frame in frames], [0, 1, 2, 3, 4])
        self.assertEqual([frame["seconds"] for frame in frames], [0, 1, 2, 3, 4])
        # The ball is at -4, -1, 2, 5, 8, the box at 8 to 9, ..., 4 to 5.
        self.assertEqual([frame["began"] for frame in frames], [[], [["crate", "ball"]], [], [["ball", "box"]], []])
        self.assertEqual([frame["ended"] for frame in frames], [[], [], [], [["crate", "ball"]], [["ball", "box"]]])
        self.assertEqual([frame["touching"] for frame in frames], [0, 1, 1, 1, 0])

    def test_rounding_does_not_add_up(self):
        frames = self.frames_of(self.write("flight.json", FLIGHT), "--frames", "200", "--seconds-per-frame", "0.01")
        (first,) = [frame["frame"] for frame in frames if frame["began"]]
        self.assertEqual(first, 100)  # three units in a second: the ball just touches the crate

    def test_what_touches_at_the_start_began_in_frame_0(self):
        frames = self.frames_of(self.yard(), "--frames", "1")
        self.assertEqual(frames[0]["began"], [["ground", "crate"], ["ground", "ball"], ["crate", "ball"]])
        self.assertEqual((frames[1]["touching"], frames[1]["began"]), (3, []))
        self.assertAlmostEqual(frames[1]["seconds"], 1 / 60)

    def test_a_converted_scene_moves_alike(self):
        scene = self.write("flight.json", FLIGHT)
        copy = self.folder / "copy.json"
        self.succeed("convert", scene, copy)
        arguments = ("--frames", "5", "--seconds-per-frame", "0.5")
        self.assertEqual(self.frames_of(copy, *arguments), self.frames_of(scene, *arguments))

    def test_frames_go_to_a_file(self):
        file = self.folder / "frames.ndjson"
        self.assertEqual(self.frames_of(self.yard(), "--frames", "2", "--output", file), [])
        self.assertEqual(len(file.read_text().splitlines()), 3)

    def test_the_standard_input_is_read(self):
        self.assertEqual(len(self.frames_of("-", "--frames", "1", input=json.dumps(FLIGHT).encode())), 2)

    def test_nonsense_is_refused(self):
        scene = self.yard()
        self.refused("simulate", scene, code=2, says="--frames is missing; give the number of times")
        self.refused("simulate", scene, "--frames", "0", code=2, says="--frames is 0; it must be 1 or more")
        for time in ("0", "-1", "inf", "nan"):
            self.refused("simulate", scene, "--frames", "1", f"--seconds-per-frame={time}", code=2, says="it must be above 0")

    def test_an_object_that_leaves_all_numbers_is_an_error_that_says_when(self):
        objects = [{"name": "comet", "type": "sphere", "center": [0, 0], "radius": 1, "velocity": [1e308, 0]},
                   {"name": "kite", "type": "polytope", "points": [[0, 0], [1, 1]], "velocity": [0, 1e308]}]
        for each in objects:
            scene = self.write("far.json", YARD | {"objects": [each]})
            self.refused("simulate", scene, "--frames", "3", "--seconds-per-frame", "1", "--output", self.folder / "out",
                         code=3, says="in frame 2: ")
            self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
