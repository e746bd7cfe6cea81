# SPDX-License-Identifier: MIT
"""`graze info`."""

import json
import unittest

from graze_program import CommandLineTest, IMAGE_LAYER, ROOT, YARD


class Info(CommandLineTest):
    def info(self, scene, **options):
        return json.loads(self.succeed("info", "--format", "json", scene, **options)[0])

    def test_json_has_the_documented_fields(self):
        scene = self.yard()
        self.assertEqual(self.info(scene), {
            "schema": "graze.info/1",
            "scene": str(scene),
            "format": "graze.scene/1",
            "dimension": 2,
            "objects": 4,
            "types": [{"name": "sphere", "objects": 2}, {"name": "aabb", "objects": 2}],
            "layers": [{"name": "layer 0", "objects": 4}],
            "bounds": {"min": [-10, -1], "max": [10, 8.5]},
            "unbounded": 0,
            "empty": 0,
            "sizes": {
                "min": 1, "median": 2, "p90": 20, "max": 20,
                "bins": [
                    {"from": 1, "to": 2, "objects": 1}, {"from": 2, "to": 4, "objects": 2},
                    {"from": 4, "to": 8, "objects": 0}, {"from": 8, "to": 16, "objects": 0},
                    {"from": 16, "to": 32, "objects": 1},
                ],
            },
            "meshes": [],
            "not_read": [],
        })

    def test_the_table_tells_the_same(self):
        scene = self.yard()
        text, said = self.succeed("info", scene)
        self.assertEqual(said, "")
        self.assertEqual(text.splitlines()[0], f"{scene}: graze.scene/1, 2D, 4 objects")
        for line in ("  sphere  2", "  layer 0  4", "  from  -10, -1", "  to    10, 8.5"):
            self.assertIn(f"\n{line}\n", text)
        self.assertRegex(text, r"\n  median +2\n")
        self.assertNotIn("not read", text)

    def test_unbounded_objects_are_counted_apart_from_the_bounds(self):
        objects = [{"type": "plane", "normal": [1, 1, 0], "offset": 0}, {"type": "point", "position": [1, 2, 3]}]
        info = self.info(self.write("s.json", {"schema": "graze.scene/1", "dimension": 3, "objects": objects}))
        self.assertEqual(info["unbounded"], 1)
        self.assertEqual(info["bounds"], {"min": [1, 2, 3], "max": [1, 2, 3]})
        self.assertEqual(info["sizes"]["bins"], [{"from": 0, "to": 0, "objects": 1}])

    def test_an_empty_scene_has_no_bounds(self):
        info = self.info(self.write("s.json", YARD | {"objects": []}))
        self.assertIsNone(info["bounds"])
        self.assertIsNone(info["sizes"])

    def test_the_bundled_scenes_are_counted_whole(self):
        for name, dimension in (("platform_level.tmx", 2), ("workshop.json", 3)):
            with self.subTest(name):
                info = self.info(ROOT / "data" / name)
                self.assertEqual(info["dimension"], dimension)
                self.assertGreater(info["objects"], 50)
                for counts in ("types", "layers"):
                    self.assertEqual(sum(count["objects"] for count in info[counts]), info["objects"])
                in_bins = sum(size_bin["objects"] for size_bin in info["sizes"]["bins"])
                self.assertEqual(in_bins + info["unbounded"] + info["empty"], info["objects"])

    def test_what_was_not_read_is_part_of_the_answer(self):
        scene = self.write("layers.tmx", IMAGE_LAYER)
        (omission,) = self.info(scene)["not_read"]
        self.assertEqual((omission["what"], omission["count"]), ("image layer", 1))
        self.assertEqual(set(omission), {"what", "count", "loss", "where", "why"})
        self.assertIn("\nnot read\n  image layer  1\n", self.succeed("info", scene)[0])

    def test_the_standard_input_is_read(self):
        self.assertEqual(self.info("-", input=self.yard().read_bytes())["objects"], 4)


if __name__ == "__main__":
    unittest.main()
