# SPDX-License-Identifier: MIT
"""`graze bench`: measurements, formats and errors."""

import csv
import io
import json
import struct
import unittest

from graze_program import CommandLineTest, IMAGE_LAYER, PROGRAM, ROOT, Terminal, environment

HEADING = ["METHOD", "CHOSEN", "MEDIAN", "ms", "FASTEST", "ms", "SLOWEST", "ms", "PAIRS", "BYTES", "ns/BOX", "TIMES",
           "FLOOR"]
COLUMNS = ["method", "chosen", "median_ms", "fastest_ms", "slowest_ms", "pairs", "bytes", "ns_per_box", "floor_ms",
           "times_floor"]
METHODS = ("automatic", "brute_force", "dense", "tree")


def recording(frames, boxes=None):
    """A recording of flat boxes, given as tuples of min x, min y, max x, max y."""
    head = struct.pack("<128s128siiii8f", b"test", b"boxes", len(frames[0]) if boxes is None else boxes,
                       len(frames) - 1, 0, 0, -9, -9, 0, 0, 9, 9, 0, 0)
    return head + b"".join(struct.pack("<8f", x, y, 0, 0, to_x, to_y, 0, 0)
                           for frame in frames for x, y, to_x, to_y in frame)


# One pair, two that touch, three.
MOVING = [[(0, 0, 1, 1), (0.5, 0, 2, 1), (4, 4, 5, 5)], [(0, 0, 1, 1), (1, 1, 2, 2), (2, 2, 3, 3)],
          [(0, 0, 1, 1), (0, 0, 2, 2), (1, 1, 3, 3)]]


class Bench(CommandLineTest):
    def measured(self, *arguments, **options):
        """The report in JSON."""
        return json.loads(self.succeed("bench", "--format", "json", *arguments, **options)[0])

    def test_the_table_has_aligned_columns_with_units(self):
        text, said = self.succeed("bench", "--generate", "brownian:500", "--method", "all", "--frames", "3")
        self.assertEqual(said, "")
        title, _, heading, *rows, _, floor = text.splitlines()
        self.assertRegex(title, r"\Abrownian:500, seed 1: 3D float, 500 boxes, 3 frames, order sorted, \d+ threads?\Z")
        self.assertEqual(heading.split(), HEADING)
        report = self.measured("--generate", "brownian:500", "--method", "all", "--frames", "3")
        self.assertEqual([row.split()[0] for row in rows], [method["method"] for method in report["methods"]])
        self.assertTrue(set(METHODS) <= {row.split()[0] for row in rows})
        for row in rows:
            self.assertEqual(len(row), len(heading))
            for column in ("MEDIAN ms", "SLOWEST ms", "PAIRS", "BYTES", "TIMES FLOOR"):
                end = heading.index(column) + len(column)
                self.assertRegex(row[:end], r"[0-9]\Z", "numbers end where their heading ends")
                self.assertRegex(row[end:], r"\A( |\Z)")
        self.assertRegex(floor, r"\Afloor: \d+\.\d{3} ms to read the boxes and write the pairs once, on one thread\Z")

    def test_json_has_the_documented_fields(self):
        report = self.measured("--generate", "2d:heavy:1k", "--seed", "7", "--frames", "4", "--threads", "1")
        self.assertEqual(list(report), ["schema", "source", "seed", "dimension", "scalar", "boxes", "frames", "order",
                                        "threads", "pairs", "floor_ms", "methods", "skipped"])
        self.assertEqual((report["schema"], report["source"], report["seed"]), ("graze.bench/1", "2d:heavy:1000", 7))
        self.assertEqual((report["dimension"], report["scalar"], report["boxes"]), (2, "float", 1000))
        self.assertEqual((report["frames"], report["order"], report["threads"]), (4, "sorted", 1))
        self.assertEqual(len(report["pairs"]), 4)
        self.assertGreater(report["floor_ms"], 0)
        method, = report["methods"]
        self.assertEqual(list(method), ["method", "chosen", "median_ms", "fastest_ms", "slowest_ms", "pairs", "bytes",
                                        "ns_per_box", "times_floor", "frames_ms"])
        self.assertEqual(method["method"], "automatic")
        self.assertNotEqual(method["chosen"], "automatic")
        self.assertEqual(method["pairs"], round(sum(report["pairs"]) / 4 + 1e-9))

    def test_the_figures_of_a_method_come_from_its_frames(self):
        for frames in ("5", "6"):
            report = self.measured("--generate", "brownian:2k", "--frames", frames)
            method, = report["methods"]
            times = sorted(method["frames_ms"])
            self.assertEqual(len(times), int(frames))
            self.assertEqual((method["fastest_ms"], method["slowest_ms"]), (times[0], times[-1]))
            middle = (times[(len(times) - 1) // 2] + times[len(times) // 2]) / 2
            self.assertAlmostEqual(method["median_ms"], middle, places=5)
            self.assertAlmostEqual(method["ns_per_box"], middle * 1e6 / 2000, delta=0.01)
            self.assertAlmostEqual(method["times_floor"], middle / report["floor_ms"], delta=0.02 * method["times_floor"])

    def test_csv_has_a_line_for_each_method(self):
        text, said = self.succeed("bench", "--generate", "cluster:300", "--method", "tree,brute_force", "--format", "csv")
        self.assertEqual(said, "")
        rows = list(csv.reader(io.StringIO(text)))
        self.assertEqual(rows[0], COLUMNS)
        self.assertEqual([row[:2] for row in rows[1:]], [["tree", "tree"], ["brute_force", "brute_force"]])
        for row in rows[1:]:
            self.assertTrue(all(float(field) >= 0 for field in row[2:]))

    def test_every_world_gives_every_method_the_same_pairs(self):
        for world in ("brownian", "heavy", "cluster", "line", "plane", "lattice", "giants", "point"):
            for dimension in ("", "2d:"):
                for order in ("sorted", "any"):
                    with self.subTest(world=world, dimension=dimension, order=order):
                        report = self.measured("--generate", f"{dimension}{world}:400", "--frames", "2", "--method", "all",
                                               "--order", order)
                        self.assertTrue(set(METHODS) <= {method["method"] for method in report["methods"]})
                        self.assertGreater(report["pairs"][1], 100)

    def test_equal_seeds_are_equal_worlds(self):
        runs = [self.measured("--generate", "giants:5k", "--seed", seed)["pairs"] for seed in ("1", "1", "2")]
        self.assertEqual(runs[0], runs[1])
        self.assertNotEqual(runs[0], runs[2])
        self.assertEqual(self.measured("--generate", "3d:giants:5000")["pairs"], runs[0])
        self.assertEqual(len(set(runs[0])), 10, "nothing moves")

    def test_methods_may_be_named_more_than_once_and_in_many_ways(self):
        for arguments in (("--method", "tree", "--method", "brute_force", "--method", "tree"),
                          ("--method", "tree,brute_force,tree"), ("--method=tree", "--method=brute_force")):
            report = self.measured("--generate", "brownian:50", *arguments)
            self.assertEqual([method["method"] for method in report["methods"]], ["tree", "brute_force"])

    def test_a_method_does_not_swallow_the_file_behind_it(self):
        report = self.measured("--method", "tree", self.yard())
        self.assertEqual([method["method"] for method in report["methods"]], ["tree"])

    def test_of_many_boxes_brute_force_runs_only_for_those_who_name_it(self):
        report = self.measured("--generate", "brownian:10001", "--frames", "1", "--method", "all")
        self.assertNotIn("brute_force", [method["method"] for method in report["methods"]])
        self.assertEqual(report["skipped"], [{"method": "brute_force", "reason": "10001 boxes are more than 10000"}])
        _, said = self.succeed("bench", "--generate", "brownian:10001", "--frames", "1", "--method", "all")
        self.assertEqual(said, "graze: brute_force is skipped: 10001 boxes are more than 10000; --method brute_force runs "
                               "it anyway\n")
        report = self.measured("--generate", "brownian:10001", "--frames", "1", "--method", "all,brute_force")
        self.assertIn("brute_force", [method["method"] for method in report["methods"]])
        self.assertEqual(report["skipped"], [])

    def test_the_boxes_of_a_scene_are_its_objects_bounds(self):
        # The ball's box overlaps the crate's and touches the ground's, on which the crate stands.
        report = self.measured("--method", "all", self.yard())
        self.assertEqual((report["dimension"], report["scalar"], report["boxes"]), (2, "double", 4))
        self.assertEqual((report["seed"], report["frames"], report["pairs"]), (None, 10, [3] * 10))
        report = self.measured("-", "--frames", "2", input=self.yard().read_bytes())
        self.assertEqual((report["source"], report["pairs"]), ("-", [3, 3]))

    def test_real_scenes_agree_with_check(self):
        for name in ("platform_level.tmx", "workshop.json"):
            candidates = json.loads(self.succeed("check", "--format", "json", ROOT / "data" / name)[0])
            pairs = self.measured(ROOT / "data" / name, "--frames", "1", "--method", "all")["pairs"]
            self.assertGreaterEqual(pairs[0], candidates["summary"]["candidates"])

    def test_a_scene_without_objects_is_measured_too(self):
        scene = self.write("empty.json", {"schema": "graze.scene/1", "dimension": 2, "objects": []})
        report = self.measured(scene)
        self.assertEqual((report["boxes"], report["pairs"][0], report["methods"][0]["ns_per_box"]), (0, 0, None))
        self.assertIn(" - ", self.succeed("bench", scene)[0])

    def test_what_was_not_read_is_said(self):
        _, said = self.succeed("bench", self.write("layers.tmx", IMAGE_LAYER))
        self.assertEqual(said, "graze: not read: 1 x image layer\n")

    def test_a_recording_is_measured_frame_by_frame(self):
        for name in ("moving.aabbs", "MOVING.AABBS"):
            report = self.measured("--method", "all", self.write(name, recording(MOVING)))
            self.assertEqual((report["dimension"], report["scalar"], report["boxes"]), (2, "float", 3))
            self.assertEqual((report["frames"], report["pairs"]), (3, [1, 2, 3]))
        report = self.measured("--frames", "2", self.folder / "moving.aabbs")
        self.assertEqual((report["frames"], report["pairs"]), (2, [1, 2]))
        self.refused("bench", "--frames", "4", self.folder / "moving.aabbs", code=2,
                     says=["--frames is 4", 'moving.aabbs" has only 3'])

    def test_recordings_that_cannot_be_used_are_refused(self):
        whole = recording(MOVING)
        for content, says in ((whole[:-32], "not complete"), (whole[:100], "begins with a header of 304"),
                              (recording(MOVING, boxes=-3), "the number of boxes is -3"),
                              (recording([MOVING[0], [(0, 0, 1, 1), (5, 0, 4, 1), (0, 0, 1, 1)]]),
                               "frame 1, box 1: min_x is above max_x: 5 > 4"),
                              (recording([[(0, 0, 1, 1), (0, float("nan"), 1, 1)], MOVING[0][:2]]),
                               "frame 0, box 1: min_y is nan")):
            with self.subTest(says):
                self.refused("bench", self.write("bad.aabbs", content), says=["bad.aabbs: ", says])
        self.refused("bench", self.folder / "none.aabbs", says="there is no such file")

    def test_there_must_be_one_source_of_boxes(self):
        self.refused("bench", code=2, says=["a FILE, or --generate", "brownian:100k"])
        self.refused("bench", self.yard(), "--generate", "line:5", code=2, says="leave one of them out")
        self.refused("bench", self.yard(), "--seed", "3", code=2, says="--seed requires --generate")

    def test_worlds_that_are_not_understood_are_refused_with_the_way_out(self):
        for world, says in (("brownien:5", 'did you mean "brownian"?'), ("box:5", 'known: "brownian", "heavy"'),
                            ("4d:line:5", "write 2d: or 3d:"), ("line", "line:100k"), ("2d:line", "line:100k"),
                            ("line:5:6", "nothing else"), ("line:0", "from 1 to 4294967295"), ("line:", "whole number"),
                            ("line:-1", "whole number"), ("line:1.5M", "whole number"), ("line:5000M", "from 1 to"),
                            ("line:99999999999999999999M", "from 1 to"), ("line:7G", "7, 50k or 1M")):
            with self.subTest(world):
                self.refused("bench", "--generate", world, code=2, says=says)

    def test_options_that_are_not_understood_are_refused_with_the_way_out(self):
        for option, value, says in (("--method", "tee", 'did you mean "tree"?'), ("--method", "al", '"all"'),
                                    ("--order", "sort", 'did you mean "sorted"?'), ("--format", "jsn", '"json"'),
                                    ("--frames", "0", "from 1 to 2147483647"), ("--threads", "0", "from 1 to 1024"),
                                    ("--threads", "all", "not a whole number"), ("--seed", "-1", "not a whole number"),
                                    ("--seed", "18446744073709551616", "to 18446744073709551615")):
            with self.subTest(option=option, value=value):
                self.refused("bench", "--generate", "line:5", option, value, code=2, says=[option, says])

    def test_threads_are_limited(self):
        self.assertEqual(self.measured("--generate", "line:5", "--threads", "1")["threads"], 1)
        pairs = [self.measured("--generate", "brownian:20k", "--frames", "2", "--threads", threads)["pairs"]
                 for threads in ("1", "2", "7")]
        self.assertEqual(pairs[0], pairs[1])
        self.assertEqual(pairs[0], pairs[2])

    def test_long_measurements_show_how_far_they_are(self):
        for frames in ("10", "40", "160", "640"):
            command = [PROGRAM, "bench", "--generate", "brownian:8k", "--method", "brute_force", "--frames", frames]
            shown = Terminal(command, ("stderr",), env=environment())
            self.assertEqual(shown.code, 0)
            self.assertNotIn("measuring", shown.screen())
            if "measuring" in shown.text:
                break
        self.assertRegex(shown.text, r"measuring \[=* *\] +\d+ % \d+ s")


if __name__ == "__main__":
    unittest.main()
