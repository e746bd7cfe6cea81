# SPDX-License-Identifier: MIT
"""Invalid input: exit code 3, one line that names the fact, no data, nothing lost."""

import gzip
import json
import os
import shutil
import unittest

from graze_program import PROGRAM, YARD, CommandLineTest, with_memory_of


def scene_of(*objects, **changes):
    return YARD | {"objects": list(objects)} | changes


BALL = {"name": "ball", "type": "sphere", "center": [0, 0], "radius": 1}
BOXES = "id,min_x,min_y,max_x,max_y\n"


def map_of(body, size=1):
    attributes = f'orientation="orthogonal" width="{size}" height="{size}" tilewidth="8" tileheight="8"'
    return f'<map version="1.10" {attributes}>{body}</map>'


def map_with_object(attributes, before=""):
    return map_of(f'{before}<objectgroup><object id="7" {attributes}/></objectgroup>')


# Invalid inputs: a file's name, its content, and what the message must name.
JSON_CASES = {
    "truncated json": ("s.json", json.dumps(YARD)[:-30], ["s.json", "line 1", "column"]),
    "unknown shape": ("s.json", scene_of(BALL | {"type": "spere"}), ["ball", '"spere"', '"sphere"']),
    "unknown field": ("s.json", scene_of(BALL | {"radios": 1}), ["ball", '"radios"', '"radius"']),
    "wrong number of coordinates": ("s.json", scene_of(BALL | {"center": [0, 0, 0]}), ["ball", "center", "3", "2"]),
    "wrong dimension": ("s.json", scene_of(dimension=4), ["dimension", "4"]),
    "other schema": ("s.json", scene_of(schema="graze.scene/99"), ["graze.scene/99", "graze.scene/1"]),
    "nan": ("s.json", json.dumps(scene_of(BALL | {"radius": float("nan")})), ["s.json", "line 1"]),
    "infinity": ("s.json", json.dumps(scene_of(BALL)).replace('"radius": 1', '"radius": 1e999'), ["s.json"]),
    "negative radius": ("s.json", scene_of(BALL | {"radius": -1}), ["ball", "radius", "-1"]),
    "duplicate names": ("s.json", scene_of(BALL, BALL), ["ball"]),
    "missing field": ("s.json", scene_of({"name": "ball", "type": "sphere", "center": [0, 0]}), ["ball", "radius"]),
    "deep nesting": ("s.json", '{"schema": ' + "[" * 1000000, ["s.json"]),
    "not utf-8": ("s.json", b'{"schema": "\xff"}', ["s.json", "UTF-8"]),
    "json of something else": ("s.json", {"name": "package"}, ["s.json"]),
}
CSV_CASES = {
    "missing column": ("b.csv", "id,min_x,min_y,max_x\n", ["b.csv", "max_y"]),
    "short line": ("b.csv", BOXES + "a,0,0,1\n", ["b.csv", "line 2"]),
    "no number": ("b.csv", BOXES + "a,0,0,1,one\n", ["b.csv", "line 2", "max_y", "one"]),
    "nan in csv": ("b.csv", BOXES + "a,0,0,1,nan\n", ["b.csv", "line 2", "max_y"]),
    "infinity in csv": ("b.csv", BOXES + "a,0,0,1,inf\n", ["b.csv", "line 2", "max_y"]),
    "min above max": ("b.csv", BOXES + "a,0,0,-1,1\n", ["b.csv", "line 2"]),
    "duplicate id": ("b.csv", BOXES + "a,0,0,1,1\na,0,0,1,1\n", ["b.csv", "line 3", '"a"']),
    "open quote": ("b.csv", BOXES + '"a,0,0,1,1\n', ["b.csv", "line 2"]),
}
TILED_CASES = {
    "truncated xml": ("m.tmx", map_of("<objectgroup>")[:-8], ["m.tmx", "line 1", "column"]),
    "missing template": ("m.tmx", map_with_object('template="lost.tx"'), ["m.tmx", "lost.tx"]),
    "missing tileset": (
        "m.tmx",
        map_with_object('gid="1" x="0" y="0" width="8" height="8"', before='<tileset firstgid="1" source="lost.tsx"/>'),
        ["m.tmx", "lost.tsx"],
    ),
    "no number in a map": ("m.tmx", map_with_object('x="left"'), ["m.tmx", "line 1", "left"]),
    "negative width": ("m.tmx", map_with_object('width="-3" height="1"'), ["m.tmx", "7", "-3"]),
    "truncated tmj": ("m.tmj", '{"type": "map", "layers": [', ["m.tmj", "line 1"]),
    "entity bomb": ("m.tmx", '<!DOCTYPE map [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;&a;">]><map>&b;</map', ["m.tmx"]),
}
OTHER_CASES = {
    "empty file": ("empty.json", "", ["empty.json", "empty"]),
    "only blanks": ("blank.json", " \n\t\n", ["blank.json"]),
    "binary": ("b.bin", bytes(range(256)), ["b.bin"]),
    "godot": ("level.tscn", "[gd_scene format=3]\n", ["level.tscn: this is a Godot scene; write its collision shapes"]),
    "robot": ("r.urdf", '<?xml version="1.0"?><robot name="r"/>', ["r.urdf: this is a robot in URDF; write its"]),
    "tileset": ("t.tsj", '{"type":"tileset","name":"a"}', ["t.tsj: this is a Tiled tileset; give the map"]),
    "tileset in xml": ("t.tsx", '<tileset name="a"/>', ["t.tsx: this is a Tiled tileset; give the map"]),
    "template": ("t.tj", '{"type":"template","object":{"id":1}}', ["t.tj: this is a Tiled template, a single object;"]),
    "javascript": ("m.js", "(function(name,data){\n if(", ["m.js: this is a map that Tiled exported as JavaScript;"]),
    "utf-16": ("s.json", json.dumps(YARD).encode("utf-16"), ["s.json: this is UTF-16; save it as UTF-8"]),
    "a log": ("s.log", '{"schema": "graze.log/1", "dimension": 2}\n{}', ["s.log: this is a query log; run it with"]),
    "a report": ("r.csv", "a,b,relation\nx,y,touching\n", ["r.csv: this is a report of graze check; give the scene"]),
    "prose": ("prose.txt", "It was a dark and stormy night\n", ["prose.txt"]),
    "compressed": ("s.json.gz", gzip.compress(b"{}"), ["s.json.gz"]),
}


class Input(CommandLineTest):
    def assert_refused(self, scene, says):
        """With every command, with the same message, and without changing existing files."""
        report, picture, converted = (self.write(name, "precious") for name in ("kept.txt", "kept.svg", "kept.json"))
        said = self.refused("check", "--output", report, "--svg", picture, scene, says=says)
        self.assertEqual(said.count("\n"), 1, said)
        for report_format in ("json", "ndjson", "csv", "table"):
            self.assertEqual(self.refused("check", "--format", report_format, "--fail-on-contact", scene), said)
        self.assertEqual(self.refused("info", scene), said)
        self.assertEqual(self.refused("convert", scene, converted), said)
        for kept in (report, picture, converted):
            self.assertEqual(kept.read_text(), "precious")
        self.assertNotIn("\x1b", said)

    def try_cases(self, cases):
        for fact, (name, content, says) in cases.items():
            with self.subTest(fact):
                self.assert_refused(self.write(name, content), says)

    def test_bad_json_scenes_are_refused(self):
        self.try_cases(JSON_CASES)

    def test_bad_tables_are_refused(self):
        self.try_cases(CSV_CASES)

    def test_bad_maps_are_refused(self):
        self.try_cases(TILED_CASES)

    def test_what_is_no_scene_is_refused(self):
        self.try_cases(OTHER_CASES)

    def test_tables_of_every_kind_are_read(self):
        for content in ("x,y,radius\n0,0,1\n1,0,1\n", "x;y;z;radius\r\n+0;0;0;1\r\n1;0;0;1\r\n",
                        "ax\tay\tbx\tby\tradius\r0\t0\t1\t0\t1\r0\t1\t1\t1\t1\r"):
            with self.subTest(content):
                text, said = self.succeed("check", "--format", "csv", "-", input=content.encode())
                self.assertEqual(text, "a,b,relation\n#0,#1,overlapping\n")
                self.assertNotIn("warning", said)

    def test_a_table_that_may_be_cut_off_is_warned_of(self):
        cut = self.write("cut.csv", BOXES + "a,0,0,1,12")
        _, said = self.succeed("info", cut)
        self.assertIn("cut.csv: line 2, the last one, has no line break; if the file was cut off", said)
        self.assertTrue(said.startswith("graze: warning: "), said)
        self.refused("info", "--strict", cut, says="has no line break")

    def test_a_scene_given_as_a_log_is_refused_as_one(self):
        scene = self.write("s.json", json.dumps(YARD, indent=1))
        self.refused("replay", scene, says="s.json: this is a scene, not a query log; graze simulate --log records one")

    def test_a_missing_file_and_a_folder_are_refused(self):
        self.assert_refused(self.folder / "missing.json", ["missing.json", "no such file"])
        self.assert_refused(self.folder, [str(self.folder)])

    def test_a_file_without_permission_is_refused(self):
        scene = self.yard()
        scene.chmod(0)
        options = {}
        if os.geteuid() == 0:  # root can read every file, so another user must try, who may have no access to the build folder
            self.folder.chmod(0o755)
            options = {"program": shutil.copy(PROGRAM, self.folder), "user": 65534, "group": 65534, "extra_groups": []}
        self.refused("check", scene, says=["yard.json", "Permission denied"], **options)

    def test_a_template_that_includes_itself_is_refused(self):
        self.write("loop.tx", '<template><object template="loop.tx"/></template>')
        self.assert_refused(self.write("m.tmx", map_with_object('template="loop.tx"')), "loop.tx")

    def test_templates_that_include_each_other_are_refused(self):
        self.write("a.tx", '<template><object template="b.tx"/></template>')
        self.write("b.tx", '<template><object template="a.tx"/></template>')
        self.assert_refused(self.write("m.tmx", map_with_object('template="a.tx"')), ".tx")

    def test_sizes_that_a_file_only_declares_cost_nothing(self):
        layer = '<layer width="1000000000" height="1000000000"><data encoding="csv">1</data></layer>'
        for name, content in (
            ("m.tmx", map_of(layer, size=1000000000)),
            ("m.tmj", {"type": "map", "width": 1000000000, "height": 1000000000, "tilewidth": 8, "tileheight": 8,
                       "nextobjectid": 1000000000, "layers": []}),
        ):
            with self.subTest(name):
                scene = self.write(name, content)
                text, _ = self.succeed("check", scene, **with_memory_of(mebibytes=512))  # 1e9 of anything would exceed the limit
                self.assertRegex(text, r"(?m)^0 pairs; 0 objects")

    def test_the_standard_input_is_refused_by_that_name(self):
        self.refused("check", "-", input=b"", says=["standard input", "empty"])
        self.refused("check", "-", input=json.dumps(YARD).encode()[:-30], says=["standard input", "line 1"])
        folder = os.open(self.folder, os.O_RDONLY)
        self.addCleanup(os.close, folder)
        self.refused("check", "-", stdin=folder, says=["the standard input cannot be read", "directory"])

    def test_escape_sequences_in_a_message_do_not_reach_the_terminal(self):
        for field in ("name", "type", "\x1b[2Jfield"):
            scene = self.write("s.json", scene_of(BALL | {field: "\x1b[2J", "radius": -1}))
            self.assertNotIn("\x1b", self.refused("check", scene))

    def test_paths_with_spaces_and_utf8_are_read_and_named_as_they_are(self):
        name = "Prüf stück 球's/my scene 🎱.json"
        text, _ = self.succeed("check", "--format", "json", self.write(name, YARD))
        self.assertEqual(json.loads(text)["scene"], str(self.folder / name))
        self.refused("check", self.write(name, "{"), says=name)
        self.succeed("convert", self.yard(), self.folder / name)


if __name__ == "__main__":
    unittest.main()
