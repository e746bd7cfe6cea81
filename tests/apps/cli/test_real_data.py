# SPDX-License-Identifier: MIT
"""Known answers on real scenes, counted independently, and the total time they take. The folder is in
GRAZE_SHARED_DATA, or ../shared/data beside the project."""

import json
import os
import time
import unittest
from pathlib import Path

from graze_program import ROOT, CommandLineTest

DATA = Path(os.environ.get("GRAZE_SHARED_DATA", ROOT.parent / "shared" / "data"))
GENEROUS_SECONDS = 10  # for a sanitizer's build on a busy machine; an ordinary one takes a tenth of a second

# Scene, further arguments, pairs.
KNOWN = [
    ("chip_aes.csv", [], 26815),
    ("chip_aes.csv", ["--interior"], 26091),
    ("chip_aes_legal.csv", [], 42887),
    ("chip_aes_legal.csv", ["--interior"], 0),
    ("sticker-knight/sandbox2.tmx", [], 178),
    ("sticker-knight/sandbox2.tmx", ["--interior"], 104),
]


class RealData(CommandLineTest):
    def test_known_answers_come_fast(self):
        for name, arguments, pairs in KNOWN:
            if not (DATA / name).exists():
                print(f"skipped: {DATA / name} does not exist")
                continue
            with self.subTest(name, arguments=arguments):
                start = time.perf_counter()
                text, _ = self.succeed("check", "--format", "json", *arguments, DATA / name)
                seconds = time.perf_counter() - start
                print(f"{name} {' '.join(arguments)}: {pairs} pairs expected, {seconds:.3f} s from start to end")
                document = json.loads(text)
                self.assertEqual(document["summary"]["pairs"], pairs)
                self.assertEqual(len(document["pairs"]), pairs)
                self.assertLess(seconds, GENEROUS_SECONDS)

    def test_pairs_come_once_in_the_order_of_the_file(self):
        if not (DATA / "chip_aes.csv").exists():
            self.skipTest(f"{DATA} does not exist")
        names = [line.split(",")[0] for line in (DATA / "chip_aes.csv").read_text().splitlines()[1:]]
        order = {name: index for index, name in enumerate(names)}
        text, _ = self.succeed("check", "--format", "ndjson", DATA / "chip_aes.csv")
        found = [json.loads(line) for line in text.splitlines()]
        positions = [(order[pair["a"]], order[pair["b"]]) for pair in found]
        self.assertEqual(positions, sorted(set(positions)), "pairs are not in the file's order, or not unique")
        self.assertTrue(all(a < b for a, b in positions))


if __name__ == "__main__":
    unittest.main()
