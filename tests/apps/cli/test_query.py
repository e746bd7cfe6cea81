# SPDX-License-Identifier: MIT
"""`graze query`."""

import json
import unittest

from graze_program import CommandLineTest

ROOM = {
    "schema": "graze.scene/1", "dimension": 3, "layers": ["walls", "things"],
    "objects": [
        {"name": "floor", "type": "half_space", "normal": [0, 0, 1], "offset": 0, "layer": "walls"},
        {"name": "ball", "type": "sphere", "center": [0, 0, 2], "radius": 1, "layer": "things"},
        {"name": "lamp", "type": "sphere", "center": [0, 0, 9], "radius": 0.5, "layer": "things"},
    ],
}


class Query(CommandLineTest):
    def query(self, scene, *options):
        return json.loads(self.succeed("query", "--format", "json", scene, *options)[0])

    def names(self, scene, *options):
        return [found["name"] for found in self.query(scene, *options)["found"]]

    def wrong(self, says, scene, *options):
        """The command line is refused with these words."""
        self.refused("query", scene, *options, code=2, says=says)

    def test_json_has_the_documented_fields(self):
        scene = self.yard()
        answer = self.query(scene, "--ray", "0,9,0,-1", "--first")
        self.assertGreaterEqual(answer["summary"].pop("seconds"), 0)
        self.assertEqual(answer, {
            "schema": "graze.query/1", "scene": str(scene), "dimension": 2, "objects": 4,
            "found": [{"name": "lamp", "type": "sphere", "t": 0.5, "point": [0, 8.5], "normal": [0, 1]}],
            "summary": {"found": 1},
        })
        self.assertEqual(self.query(scene, "--point", "0,5", "--nearest", "1")["found"],
                         [{"name": "lamp", "type": "sphere", "distance": 2.5}])
        self.assertEqual(self.query(scene, "--point", "0,5")["found"], [])

    def test_regions_and_points_find_what_touches_them(self):
        scene = self.yard()
        self.assertEqual(self.names(scene, "--point", "1.8,1"), ["crate", "ball"])
        self.assertEqual(self.names(scene, "--point", "-3,-0.5"), ["ground"])
        self.assertEqual(self.names(scene, "--box", "3,3,-3,2"), ["crate", "ball"])  # any two corners
        self.assertEqual(self.names(scene, "--sphere", "0,5,2.5"), ["lamp"])
        self.assertEqual(self.names(scene, "--sphere", "0,5,2.4"), [])

    def test_in_space_and_on_a_layer(self):
        room = self.write("room.json", ROOM)
        self.assertEqual(self.names(room, "--ray", "0,0,20,0,0,-2"), ["lamp", "ball", "floor"])
        self.assertEqual(self.names(room, "--ray", "0,0,20,0,0,-2", "--t-max", "9"), ["lamp", "ball"])
        self.assertEqual(self.names(room, "--ray", "0,0,20,0,0,-2", "--layer", "walls"), ["floor"])
        self.assertEqual(self.names(room, "--box", "-1,-1,-1,1,1,1"), ["floor", "ball"])
        self.assertEqual(self.names(room, "--point", "0,0,6", "--nearest", "9"), ["lamp", "ball", "floor"])

    def test_the_other_formats_tell_the_same(self):
        scene = self.yard()
        ray = ("--ray", "0,9,0,-1", "--first")
        text, said = self.succeed("query", "--format", "csv", scene, *ray)
        self.assertEqual(text, "name,type,t,x,y,normal_x,normal_y\nlamp,sphere,0.5,0,8.5,0,1\n")
        self.assertIn("1 found; 4 objects", said)
        text, _ = self.succeed("query", "--format", "ndjson", scene, *ray)
        self.assertEqual(json.loads(text), self.query(scene, *ray)["found"][0])
        text, said = self.succeed("query", scene, *ray)
        self.assertEqual(text.splitlines()[:2], ["NAME  TYPE    T    POINT   NORMAL", "lamp  sphere  0.5  0, 8.5  0, 1"])
        self.assertEqual(said, "")
        target = self.folder / "answer.csv"
        self.succeed("query", "--format", "csv", "--output", target, scene, *ray)
        self.assertTrue(target.read_text().startswith("name,type,t,"))

    def test_what_cannot_be_asked_is_named(self):
        scene = self.yard()
        self.wrong("there is no question", scene)
        self.wrong("several questions", scene, "--point", "0,0", "--box", "0,0,1,1")
        self.wrong("nearest to what?", scene, "--box", "0,0,1,1", "--nearest", "3")
        for count in ("-3", "0"):
            self.wrong(f"--nearest {count} is no number of objects", scene, "--point", "0,0", "--nearest", count)
        self.wrong("--t-max needs --ray", scene, "--point", "0,0", "--t-max", "3")
        self.wrong("--first needs --ray", scene, "--point", "0,0", "--first")
        self.wrong('--point "0,0,0" has 3 numbers; it takes x,y', scene, "--point", "0,0,0")
        self.wrong("is not a list of numbers", scene, "--point", "0,x")
        self.wrong("is not a list of numbers", scene, "--point", "0,")
        self.wrong("negative radius", scene, "--sphere", "0,0,-1")
        self.wrong("direction", scene, "--ray", "0,0,0,0")
        self.wrong("t_max", scene, "--ray", "0,0,1,0", "--t-max", "-1")
        self.wrong("not finite", scene, "--point", "nan,0")
        room = self.write("room.json", ROOM)
        self.wrong('did you mean "walls"', room, "--point", "0,0,0", "--layer", "wals")


if __name__ == "__main__":
    unittest.main()
