# SPDX-License-Identifier: MIT
"""`graze pairs`: the overlapping boxes of a generated world."""

import csv
import io
import json
import unittest

from graze_program import CommandLineTest


class Pairs(CommandLineTest):
    def boxes_of(self, world):
        rows = list(csv.reader(io.StringIO(self.succeed("generate", world)[0])))[1:]
        return [tuple(map(float, row[1:])) for row in rows]

    def test_are_those_of_the_generated_boxes(self):
        for world, size in (("brownian:200", 3), ("2d:heavy:200", 2)):
            boxes = self.boxes_of(world)
            expected = [f"{a},{b}" for a in range(len(boxes)) for b in range(a + 1, len(boxes))
                        if all(boxes[a][k] <= boxes[b][size + k] and boxes[b][k] <= boxes[a][size + k] for k in range(size))]
            text, said = self.succeed("pairs", "--generate", world)
            self.assertEqual(said, "")
            self.assertEqual(text.splitlines(), ["a,b", *expected])
            document = json.loads(self.succeed("pairs", "--generate", world, "--format", "json")[0])
            self.assertEqual((document["schema"], document["world"], document["seed"], document["frame"]),
                             ("graze.pairs/1", world, 1, 0))
            self.assertEqual([f"{a},{b}" for a, b in document["pairs"]], expected)

    def test_frames_and_seeds_change_them(self):
        texts = {self.succeed("pairs", "--generate", "brownian:5k", *options)[0]
                 for options in ((), ("--frame", "3"), ("--seed", "2"))}
        self.assertEqual(len(texts), 3)
        self.assertEqual(json.loads(self.succeed("pairs", "--generate", "brownian:1", "--format", "json")[0])["pairs"], [])


if __name__ == "__main__":
    unittest.main()
