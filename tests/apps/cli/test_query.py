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
        """Asserts that the command line is rejected with this message."""
        self.refused("query", scene, *options, code=2, says=says)

    def test_json_has_the_documented_fields(self):
        scene = self.yard()
        answer = self.query(scene, "--ray", "0,9,0,-1", "--first")
        self.assertGreaterEqual(answer["summary"].pop("seconds"), 0)
        self.assertEqual(answer, {
            "schema": "graze.query/1", "scene": str(scene), "dimension": 2, "objects": 4, "not_read": [],
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
        self.assertEqual(self.names(scene, "--box", "3,3,-3,2"), ["crate", "ball"])  # any two opposite corners
        self.assertEqual(self.names(scene, "--sphere", "0,5,2.5"), ["lamp"])
        self.assertEqual(self.names(scene, "--sphere", "0,5,2.4"), [])

    def test_shapes_that_move_touch_or_are_near(self):
        scene = self.yard()
        [hit] = self.query(scene, "--cast", "lamp", "--motion", "0,-11", "--first")["found"]
        self.assertAlmostEqual(hit.pop("t"), 0.5, delta=1e-15)
        self.assertEqual(hit, {"name": "crate", "type": "aabb", "point": [0, 2], "normal": [0, -1]})
        self.assertEqual(self.names(scene, "--cast", "lamp", "--motion", "0,-10"), ["crate", "ground"])
        ball = json.dumps({"type": "sphere", "center": [-5, 1], "radius": 1})
        self.assertEqual(self.query(scene, "--contacts-with", ball)["found"],
                         [{"name": "ground", "type": "aabb", "depth": 0, "point": [-5, 0], "normal": [0, -1]}])
        crate = self.query(scene, "--contacts-with", "crate")["found"]
        self.assertEqual([(found["name"], found["depth"]) for found in crate], [("ground", 0), ("ground", 0), ("ball", 0.5)])
        self.assertEqual(self.query(scene, "--nearest-to", "lamp")["found"],
                         [{"name": "crate", "type": "aabb", "distance": 5.5}])
        self.assertEqual(self.names(scene, "--nearest-to", ball, "--nearest", "2"), ["ground", "crate"])
        text, _ = self.succeed("query", "--format", "csv", scene, "--contacts-with", ball)
        self.assertEqual(text, "name,type,depth,x,y,normal_x,normal_y\nground,aabb,0,-5,0,0,-1\n")

    def test_shapes_that_are_none_are_named(self):
        scene = self.yard()
        self.wrong('--cast "lamb" is no object of the scene', scene, "--cast", "lamb", "--motion", "1,0")
        self.wrong('did you mean "lamp"', scene, "--nearest-to", "lamb")
        self.wrong("--cast needs --motion", scene, "--cast", "lamp")
        self.wrong("--motion needs --cast", scene, "--point", "0,0", "--motion", "1,0")
        self.wrong("--contacts-with: line 1, column 2:", scene, "--contacts-with", "{]")
        self.wrong("radius", scene, "--contacts-with", '{"type": "sphere", "center": [0, 0], "radius": -1}')

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
        self.wrong("no query is given", scene)
        self.wrong("several queries", scene, "--point", "0,0", "--box", "0,0,1,1")
        self.wrong("--nearest needs --point or --nearest-to", scene, "--box", "0,0,1,1", "--nearest", "3")
        for count in ("-3", "0"):
            self.wrong(f"--nearest is {count}; it must be 1 or more", scene, "--point", "0,0", "--nearest", count)
        self.wrong("--t-max needs --ray", scene, "--point", "0,0", "--t-max", "3")
        self.wrong("--first needs --ray", scene, "--point", "0,0", "--first")
        self.wrong('--point "0,0,0" has 3 numbers; it takes x,y', scene, "--point", "0,0,0")
        self.wrong("is not a comma-separated list of numbers", scene, "--point", "0,x")
        self.wrong("is not a comma-separated list of numbers", scene, "--point", "0,")
        self.wrong("negative radius", scene, "--sphere", "0,0,-1")
        self.wrong("direction", scene, "--ray", "0,0,0,0")
        self.wrong("t_max", scene, "--ray", "0,0,1,0", "--t-max", "-1")
        self.wrong("must be a finite number", scene, "--point", "nan,0")
        room = self.write("room.json", ROOM)
        self.wrong('did you mean "walls"', room, "--point", "0,0,0", "--layer", "wals")


ROLLING = {
    "schema": "graze.scene/1", "dimension": 2, "layers": ["ground", "things"],
    "objects": [
        {"name": "ground", "type": "half_space", "normal": [0, 1], "offset": 0, "fixed": True, "layer": "ground"},
        {"name": "ball", "type": "sphere", "center": [0, 1], "radius": 1, "velocity": [2, 0], "layer": "things"},
    ],
}


class QueryOfALog(CommandLineTest):
    def log(self):
        """A log of four frames; at the end, the ball is at 8, 1."""
        path = self.folder / "rolling.log"
        self.succeed("simulate", self.write("rolling.json", ROLLING), "--frames", "4", "--seconds-per-frame", "1",
                     "--log", path, "--output", self.folder / "frames.ndjson")
        return path

    def ask(self, log, *options, **more):
        return json.loads(self.succeed("query", "--format", "json", "--log", log, *options, **more)[0])

    def test_the_scene_at_its_end_is_asked(self):
        log = self.log()
        answer = self.ask(log, "--ray", "8,9,0,-1")
        self.assertEqual((answer["scene"], answer["dimension"], answer["objects"]), (str(log), 2, 2))
        self.assertEqual([(found["name"], found["t"]) for found in answer["found"]], [("ball", 7), ("ground", 9)])
        self.assertEqual(self.ask(log, "--point", "0,1")["found"], [])
        self.assertEqual([found["name"] for found in self.ask(log, "--point", "8,0", "--layer", "ground")["found"]],
                         ["ground"])

    def test_what_is_asked_later_and_what_went_wrong_changes_nothing(self):
        text = self.log().read_text()
        text += '{"call": "remove", "id": [7, 1]}\n{"refused": "there is none"}\n{"call": "pairs"}\n{"answer": []}\n'
        text += '{"call": "remove", "id": [1, 1]}\n'  # during which the program crashed
        log = self.write("more.log", text)
        self.assertEqual(self.ask(log, "--point", "8,1")["found"], [{"name": "ball", "type": "sphere"}])

    def test_an_object_without_a_name_has_its_id(self):
        head = '{"schema": "graze.log/1", "dimension": 3, "numbers": "float"}\n'
        add = '{"call": "add", "shape": {"type": "point", "position": [0, 0, 0.5]}}\n{"answer": [[0, 1]]}\n'
        found = self.ask("-", "--point", "0,0,0.5", input=(head + add).encode())["found"]
        self.assertEqual(found, [{"name": "[0, 1]", "type": "point"}])

    def test_wrong_usage_and_wrong_logs_are_refused(self):
        log = self.log()
        point = ("--point", "0,0")
        self.refused("query", *point, code=2, says="query needs a SCENE, or --log FILE")
        self.refused("query", self.yard(), "--log", log, *point, code=2, says="give only one of SCENE and --log")
        self.refused("query", "--log", log, *point, "--output", log, code=2, says="would be overwritten")
        self.refused("query", "--log", log, code=2, says="no query is given")
        self.refused("query", "--log", self.yard(), *point, says='is "graze.scene/1", which is not a query log')
        self.refused("query", "--log", self.folder / "none.log", *point, says="there is no such file")
        lines = log.read_text().splitlines()
        end = next(i for i, line in enumerate(lines) if line.startswith('{"call": "update"'))
        twice = self.write("twice.log", "\n".join(lines[:end] + lines[end - 2:end]) + "\n")
        self.refused("query", "--log", twice, *point,
                     says=(f'twice.log: line {end + 1}: the log says that its scene accepted this "add", but a scene refuses it',
                           'there is already an object "ball"', "must be as it was recorded"))


if __name__ == "__main__":
    unittest.main()
