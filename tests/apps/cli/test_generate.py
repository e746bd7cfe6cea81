# SPDX-License-Identifier: MIT
"""`graze generate`: generated scenes as scene files and as recordings."""

import csv
import io
import json
import struct
import unittest

from graze_program import PROGRAM, CommandLineTest, Terminal, environment


class Generate(CommandLineTest):
    def boxes_of_csv(self, text):
        rows = list(csv.reader(io.StringIO(text)))
        return rows[0], [tuple(map(float, row[1:])) for row in rows[1:]]

    def pairs_of(self, *arguments):
        return json.loads(self.succeed("bench", "--format", "json", *arguments)[0])["pairs"]

    def test_a_world_goes_to_the_standard_output_as_csv(self):
        text, said = self.succeed("generate", "brownian:50")
        self.assertEqual(said, "")
        head, boxes = self.boxes_of_csv(text)
        self.assertEqual(head, ["id", "min_x", "min_y", "min_z", "max_x", "max_y", "max_z"])
        self.assertEqual(len(boxes), 50)
        self.assertEqual([line.split(",")[0] for line in text.splitlines()[1:4]], ["b0", "b1", "b2"])
        for box in boxes:
            for low, high in zip(box[:3], box[3:], strict=True):
                self.assertTrue(1 - 1e-6 < high - low < 3**0.5 + 1e-6)
        head, boxes = self.boxes_of_csv(self.succeed("generate", "2d:lattice:4")[0])
        self.assertEqual(head, ["id", "min_x", "min_y", "max_x", "max_y"])
        self.assertEqual(boxes, [(-1, -1, 0, 0), (0, -1, 1, 0), (-1, 0, 0, 1), (0, 0, 1, 1)])

    def test_seeds_choose_the_world(self):
        texts = [self.succeed("generate", "heavy:20", *seed)[0]
                 for seed in ((), ("--seed", "1"), ("--seed", "2"), ("--seed", "18446744073709551615"))]
        self.assertEqual(texts[0], texts[1])
        self.assertEqual(len(set(texts)), 3)

    def test_every_format_holds_the_same_boxes(self):
        for world in ("cluster:300", "2d:giants:300"):
            with self.subTest(world):
                dimension = 2 if world.startswith("2d") else 3
                for name in ("w.csv", "w.json", "w.aabbs"):
                    self.assertEqual(self.succeed("generate", world, "--output", self.folder / name), ("", ""))
                _, from_csv = self.boxes_of_csv((self.folder / "w.csv").read_text())
                scene = json.loads((self.folder / "w.json").read_text())
                self.assertEqual((scene["schema"], scene["dimension"]), ("graze.scene/1", dimension))
                self.assertEqual([one["name"] for one in scene["objects"]][:2], ["b0", "b1"])
                self.assertEqual([tuple(one["min"] + one["max"]) for one in scene["objects"]], from_csv)
                recording = (self.folder / "w.aabbs").read_bytes()
                numbers = [struct.unpack_from("<8f", recording, 304 + 32 * i) for i in range(300)]
                self.assertEqual([box[:dimension] + box[4:4 + dimension] for box in numbers], from_csv)
                self.assertEqual({box[i] for box in numbers for i in (*range(dimension, 4), *range(4 + dimension, 8))}, {0.0})

    def test_a_recording_has_the_head_of_the_format(self):
        path = self.folder / "r.aabbs"
        self.succeed("generate", "brownian:20", "--frames", "3", "--seed", "5", "--output", path)
        content = path.read_bytes()
        name, objects, *numbers = struct.unpack_from("<128s128s4i8f", content)
        self.assertEqual((name.rstrip(b"\0"), objects.rstrip(b"\0")), (b"brownian:20, seed 5", b"cubes"))
        self.assertEqual(numbers[:4], [20, 2, 0, 0])
        self.assertEqual(len(content), 304 + 3 * 20 * 32)
        world = numbers[4:]
        boxes = [struct.unpack_from("<8f", content, 304 + 32 * i) for i in range(60)]
        for box in boxes:
            for i in range(3):
                self.assertTrue(world[i] <= box[i] <= box[4 + i] <= world[4 + i])
        self.assertNotEqual(boxes[:20], boxes[20:40])

    def test_bench_finds_in_what_was_written_what_it_finds_in_the_world(self):
        expected = self.pairs_of("--generate", "brownian:2k", "--seed", "3")
        self.succeed("generate", "brownian:2k", "--seed", "3", "--output", self.folder / "w.aabbs")
        self.assertEqual(self.pairs_of(self.folder / "w.aabbs"), expected)
        for name in ("w.csv", "w.json"):
            self.succeed("generate", "brownian:2k", "--seed", "3", "--output", self.folder / name)
            self.assertEqual(self.pairs_of(self.folder / name, "--frames", "1"), expected[:1])

    def test_the_format_may_be_named(self):
        text, _ = self.succeed("generate", "line:3", "--format", "json")
        self.assertEqual(len(json.loads(text)["objects"]), 3)
        recording = self.folder / "w"
        self.succeed("generate", "line:3", "--format", "aabbs", "--output", recording)
        self.assertEqual(recording.stat().st_size, 304 + 10 * 3 * 32)
        with open(self.folder / "redirected", "wb") as file:
            self.succeed("generate", "line:3", "--format", "aabbs", stdout=file)
        self.assertEqual((self.folder / "redirected").read_bytes(), recording.read_bytes())
        self.succeed("generate", "line:3", "--format", "csv", "--output", self.folder / "W.CSV")

    def test_formats_that_do_not_fit_are_refused_with_the_way_out(self):
        for arguments, says in ((("--output", "w.txt"), "give a name that ends in .csv, .json or .aabbs, or add --format"),
                                (("--output", "w"), "or add --format"),
                                (("--output", "w.json", "--format", "csv"), "leave one of them out"),
                                (("--format", "aabb"), 'did you mean "aabbs"?'),
                                (("--frames", "2"), "add --format aabbs"),
                                (("--frames", "2", "--output", "w.csv"), "a name that ends in .aabbs"),
                                (("--frames", "1", "--output", "w.aabbs"), "for a single one write a scene"),
                                (("--frames", "0", "--output", "w.aabbs"), "--frames is 0; it must be from 1"),
                                (("--seed", "x"), '--seed is "x", which is not a whole number')):
            with self.subTest(arguments):
                self.refused("generate", "line:5", *arguments, code=2, says=says, cwd=self.folder)
        self.assert_no_litter()

    def test_worlds_that_are_not_understood_are_refused(self):
        self.refused("generate", code=2, says="graze generate needs WORLD")
        self.refused("generate", "latice:5", code=2, says='did you mean "lattice"?')
        self.refused("generate", "lattice", code=2, says="lattice:100k")

    def test_a_recording_is_not_written_to_a_terminal(self):
        command = [PROGRAM, "generate", "line:3", "--format", "aabbs"]
        shown = Terminal(command, ("stdout",), env=environment())
        self.assertEqual((shown.code, shown.text), (2, ""))
        self.assertIn("name a file with --output", shown.piped["stderr"])

    def test_an_output_that_cannot_be_written_is_said_and_leaves_nothing(self):
        self.refused("generate", "line:3", "--output", self.folder / "none" / "w.csv", says="there is no folder")
        for output_format in ("csv", "json", "aabbs"):
            self.refused("generate", "brownian:20k", "--format", output_format, "--output", "/dev/full",
                         says=["/dev/full", "No space left"])
        self.assert_no_litter()


if __name__ == "__main__":
    unittest.main()
