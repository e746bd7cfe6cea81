# SPDX-License-Identifier: MIT
"""`graze check`: formats, content and destination of the report."""

import csv
import io
import json
import math
import unittest
import xml.etree.ElementTree

from graze_program import CommandLineTest, IMAGE_LAYER, ROOT, YARD, YARD_PAIRS

SPHERES_3D = {
    "schema": "graze.scene/1",
    "dimension": 3,
    "objects": [{"name": f"s{i}", "type": "sphere", "center": [i, 0, 0], "radius": 0.5} for i in range(3)],
}


class Check(CommandLineTest):
    def pairs_of(self, report_format, *arguments, **options):
        """The program's report, parsed from a format."""
        text, _ = self.succeed("check", "--format", report_format, *arguments, **options)
        if report_format == "csv":
            rows = list(csv.reader(io.StringIO(text)))
            self.assertEqual(rows[0], ["a", "b", "relation"])
            return [tuple(row) for row in rows[1:]]
        if report_format == "table":
            lines = text.splitlines()
            if len(lines) == 1:
                return []
            self.assertEqual(lines[0].split(), ["A", "B", "RELATION"])
            return [tuple(line.split()) for line in lines[1 : lines.index("")]]
        found = json.loads(text)["pairs"] if report_format == "json" else map(json.loads, text.splitlines())
        return [(pair["a"], pair["b"], pair["relation"]) for pair in found]

    def test_every_format_tells_the_same_pairs(self):
        scene = self.yard()
        for report_format in ("table", "json", "ndjson", "csv"):
            with self.subTest(report_format):
                self.assertEqual(self.pairs_of(report_format, scene), YARD_PAIRS)
                self.assertEqual(self.pairs_of(report_format, scene, "--interior"), [("crate", "ball", "overlapping")])

    def test_formats_agree_on_the_bundled_scenes(self):
        for name in ("platform_level.tmx", "workshop.json"):
            with self.subTest(name):
                scene = ROOT / "data" / name
                pairs = self.pairs_of("json", scene)
                self.assertGreater(len(pairs), 10)
                self.assertEqual(pairs, self.pairs_of("ndjson", scene))
                self.assertEqual(pairs, self.pairs_of("csv", scene))
                self.assertEqual(pairs, self.pairs_of("json", scene), "a second run differs")
                overlapping = [pair for pair in pairs if pair[2] == "overlapping"]
                self.assertEqual(overlapping, self.pairs_of("csv", scene, "--interior"))

    def test_json_has_the_documented_fields(self):
        scene = self.yard()
        document = json.loads(self.succeed("check", "--format", "json", scene)[0])
        self.assertEqual(list(document), ["schema", "scene", "dimension", "objects", "not_read", "pairs", "summary"])
        self.assertEqual(document["schema"], "graze.check/1")
        self.assertEqual(document["scene"], str(scene))
        self.assertEqual((document["dimension"], document["objects"]), (2, 4))
        self.assertEqual(list(document["summary"]), ["pairs", "candidates", "seconds"])
        self.assertEqual((document["summary"]["pairs"], document["summary"]["candidates"]), (3, 3))
        self.assertGreaterEqual(document["summary"]["seconds"], 0)

    def test_3d_scenes_say_so(self):
        document = json.loads(self.succeed("check", "--format", "json", self.write("s.json", SPHERES_3D))[0])
        self.assertEqual(document["dimension"], 3)
        self.assertEqual([(pair["a"], pair["b"]) for pair in document["pairs"]], [("s0", "s1"), ("s1", "s2")])

    def test_the_table_closes_with_a_summary_and_nothing_is_said_beside_it(self):
        text, said = self.succeed("check", self.yard())
        self.assertRegex(text, r"\n3 pairs; 4 objects, 3 candidates, \d+\.\d{3} seconds\n\Z")
        self.assertEqual(said, "")

    def test_formats_without_a_summary_have_it_on_the_error_stream(self):
        for report_format in ("ndjson", "csv"):
            _, said = self.succeed("check", "--format", report_format, self.yard())
            self.assertRegex(said, r"\Agraze: 3 pairs; 4 objects, 3 candidates, [0-9.]+ seconds\n\Z")

    def test_a_scene_without_contacts_is_reported_in_every_format(self):
        scene = self.write("empty.json", {"schema": "graze.scene/1", "dimension": 2, "objects": []})
        for report_format in ("table", "json", "ndjson", "csv"):
            with self.subTest(report_format):
                self.assertEqual(self.pairs_of(report_format, scene), [])

    def test_difficult_names_come_back_from_every_format(self):
        names = ['a "quoted", name', "two\nlines\r\ttab", "Prüfstück 球 🎱", "\x1b[31mred\x1b[0m", "back\\slash"]
        boxes = [{"name": name, "type": "aabb", "min": [0, 0], "max": [1, 1]} for name in names]
        scene = self.write("names.json", YARD | {"objects": boxes})
        expected = [(a, b, "overlapping") for i, a in enumerate(names) for b in names[i + 1 :]]
        for report_format in ("json", "ndjson"):
            self.assertEqual(self.pairs_of(report_format, scene), expected)
        text, _ = self.succeed("check", "--format", "csv", scene)
        rows = list(csv.reader(io.StringIO(text, newline="")))
        self.assertEqual([tuple(row) for row in rows[1:]], expected)

    def test_a_table_shows_no_control_characters_of_names(self):
        names = ("\x1b]0;title\x07", "\u202eabc")
        boxes = [{"name": name, "type": "aabb", "min": [0, 0], "max": [1, 1]} for name in names]
        text, _ = self.succeed("check", self.write("names.json", YARD | {"objects": boxes}))
        self.assertNotIn("\x1b", text)
        self.assertNotIn("\u202e", text)
        self.assertIn("\\x1b]0;title\\x07  \\u{202e}abc  overlapping\n", text)

    def test_contacts_tell_depth_normal_and_points_in_every_format(self):
        scene = self.yard()
        document = json.loads(self.succeed("check", "--contacts", "--format", "json", scene)[0])
        self.assertEqual(document["schema"], "graze.check/1")
        ground_crate, _, crate_ball = document["pairs"]
        self.assertEqual(list(crate_ball), ["a", "b", "relation", "depth", "normal", "contacts", "status", "error"])
        self.assertEqual(crate_ball["depth"], 0.5)
        self.assertEqual(crate_ball["normal"], [1, 0])
        self.assertEqual(crate_ball["contacts"], [{"point": [1.75, 1], "depth": 0.5}])
        self.assertEqual(ground_crate["normal"], [0, 1])
        self.assertEqual(sorted(contact["point"] for contact in ground_crate["contacts"]), [[0, 0], [2, 0]])
        lines = self.succeed("check", "--contacts", "--format", "ndjson", scene)[0].splitlines()
        self.assertEqual([json.loads(line) for line in lines], document["pairs"])
        rows = list(csv.reader(io.StringIO(self.succeed("check", "--contacts", "--format", "csv", scene)[0])))
        self.assertEqual(rows[0], ["a", "b", "relation", "depth", "x", "y", "normal_x", "normal_y", "status", "error"])
        self.assertEqual(len(rows), 1 + sum(len(pair["contacts"]) for pair in document["pairs"]))
        self.assertEqual(rows[-1][:-1], ["crate", "ball", "overlapping", "0.5", "1.75", "1", "1", "0", "converged"])
        self.assertEqual(float(rows[-1][-1]), crate_ball["error"])
        self.assertLess(crate_ball["error"], 1e-13)
        table = self.succeed("check", "--contacts", "--interior", scene)[0].splitlines()
        self.assertEqual(table[:2], ["A      B     RELATION     DEPTH  POINT    NORMAL",
                                     "crate  ball  overlapping  0.5    1.75, 1  1, 0"])

    def test_contacts_in_space_have_three_coordinates(self):
        scene = self.write("s.json", SPHERES_3D)
        rows = list(csv.reader(io.StringIO(self.succeed("check", "--contacts", "--format", "csv", scene)[0])))
        self.assertEqual(rows[0][3:], ["depth", "x", "y", "z", "normal_x", "normal_y", "normal_z", "status", "error"])
        self.assertEqual(rows[1][:10], ["s0", "s1", "touching", "0", "0.5", "0", "0", "1", "0", "0"])

    def test_contacts_of_many_boxes_are_those_of_each_pair_alone(self):
        # Parts of compounds are tested one by one, and boxes in batches.
        boxes = [{"type": "obb", "center": [3 * (i // 40), 0, 0.95 * (i % 40)], "half_extents": [0.5, 0.5, 0.5],
                  "rotation": {"axis": [1, 2, 3] if i % 7 == 0 else [0, 0, 1], "angle": 37 * i}} for i in range(1200)]
        balls = [{"type": "sphere", "center": [3 * (i // 40), 0, 0.95 * (i % 40)], "radius": 0.4}
                 for i in range(0, 1200, 50)]
        parts = [{"type": "compound", "parts": [box]} for box in boxes]
        def lines(name, *things):
            objects = [thing | {"name": f"thing {i}"} for i, thing in enumerate(sum(things, []))]
            scene = self.write(name, {"schema": "graze.scene/1", "dimension": 3, "objects": objects})
            return self.succeed("check", "--contacts", "--format", "ndjson", scene)[0].splitlines()
        of_boxes = lines("boxes.json", boxes, balls)
        self.assertGreater(len(of_boxes), 1150)
        self.assertEqual(of_boxes, lines("parts.json", parts, balls))

    def test_what_has_not_converged_is_told_with_its_error(self):
        # For a ball in the center of a hull with hundreds of equally near faces, the search must not try each.
        golden = math.pi * (3 - 5**0.5)
        heights = [1 - 2 * (i + 0.5) / 400 for i in range(400)]
        points = [[(1 - z * z) ** 0.5 * math.cos(golden * i), (1 - z * z) ** 0.5 * math.sin(golden * i), z]
                  for i, z in enumerate(heights)]
        objects = [{"name": "hull", "type": "polytope", "points": points},
                   {"name": "ball", "type": "sphere", "center": [0, 0, 0], "radius": 0.25},
                   {"name": "box", "type": "aabb", "min": [-9, -9, -9], "max": [-8, -8, -8]},
                   {"name": "other", "type": "aabb", "min": [-8, -9, -9], "max": [-7, -8, -8]}]
        scene = self.write("round.json", {"schema": "graze.scene/1", "dimension": 3, "objects": objects})
        deep, flat = json.loads(self.succeed("check", "--contacts", "--format", "json", scene)[0])["pairs"]
        self.assertEqual((deep["status"], flat["status"]), ("best_bound", "converged"))
        self.assertTrue(1e-9 < deep["error"] < 0.1, deep["error"])
        text, said = self.succeed("check", "--contacts", "--format", "csv", scene)
        rows = list(csv.reader(io.StringIO(text)))
        self.assertEqual([rows[1][-2], rows[-1][-2]], ["best_bound", "converged"])
        self.assertEqual(float(rows[1][-1]), deep["error"])
        self.assertIn("2 pairs, 1 not converged; 4 objects", said)
        table = self.succeed("check", "--contacts", scene)[0]
        self.assertRegex(table, r"hull +ball +overlapping +1\.[0-9]+ \+- [0-9.e-]+ ")
        self.assertIn("\n2 pairs, 1 not converged; 4 objects", table)

    def test_a_depth_without_end_is_null(self):
        solids = [{"name": name, "type": "half_space", "normal": normal, "offset": 0}
                  for name, normal in (("left", [1, 0]), ("below", [0, 1]))]
        scene = self.write("crossing.json", YARD | {"objects": solids})
        (pair,) = json.loads(self.succeed("check", "--contacts", "--format", "json", scene)[0])["pairs"]
        self.assertEqual((pair["depth"], pair["normal"]), (None, [0, 0]))

    def test_a_clearance_reports_all_that_is_nearer_and_how_far_it_is(self):
        scene = self.yard()
        touching = [list(pair) + ["0"] for pair in YARD_PAIRS]
        def within(distance, *options):
            text, _ = self.succeed("check", "--within", distance, "--format", "csv", *options, scene)
            rows = list(csv.reader(io.StringIO(text)))
            self.assertEqual(rows[0], ["a", "b", "relation", "distance", "status", "error"])
            self.assertEqual({row[4] for row in rows[1:]}, {"converged"})
            return [row[:4] for row in rows[1:]]
        self.assertEqual(within("0"), touching)
        self.assertEqual(within("5.499"), touching)
        self.assertEqual(within("5.5"), touching + [["crate", "lamp", "apart", "5.5"]])
        everything = within("1e9")
        self.assertEqual([row[:2] for row in everything], [["ground", "crate"], ["ground", "ball"], ["ground", "lamp"],
                                                           ["crate", "ball"], ["crate", "lamp"], ["ball", "lamp"]])
        self.assertEqual(everything[2][2:], ["apart", "7.5"])
        self.assertAlmostEqual(float(everything[5][3]), (2.5**2 + 7**2) ** 0.5 - 1.5, places=12)
        (_, _, _, near) = json.loads(self.succeed("check", "--within", "5.75", "--format", "json", scene)[0])["pairs"]
        self.assertLess(near.pop("error"), 1e-13)
        self.assertEqual(near, {"a": "crate", "b": "lamp", "relation": "apart", "distance": 5.5, "status": "converged"})
        self.assertIn("crate   lamp   apart        5.5\n", self.succeed("check", "--within", "5.75", scene)[0])

    def test_a_clearance_is_a_failure_when_asked(self):
        apart = self.write("apart.json", YARD | {"objects": YARD["objects"][1::2]})  # crate and lamp
        self.succeed("check", "--fail-on-contact", "--within", "5", apart)
        self.succeed("check", "--fail-on-contact", "--within", "6", apart, code=1)

    def test_a_clearance_that_is_none_and_reports_that_exclude_each_other_are_refused(self):
        scene = self.yard()
        self.refused("check", "--within", "-1", scene, code=2, says="--within -1 is not a valid distance; it must be 0 or more")
        self.refused("check", "--within", "inf", scene, code=2, says="it must be 0 or more")
        self.refused("check", "--within", "near", scene, code=2, says="--within")
        self.refused("check", "--within", "1", "--contacts", scene, code=2, says="give only one of them")
        self.refused("check", "--within", "1", "--interior", scene, code=2, says="give only one of them")

    def test_contact_is_a_failure_only_when_asked(self):
        scene = self.yard()
        apart = self.write("apart.json", YARD | {"objects": YARD["objects"][2:]})
        touching = self.write("touching.json", YARD | {"objects": YARD["objects"][:2]})
        self.succeed("check", scene)
        self.succeed("check", "--fail-on-contact", scene, code=1)
        self.succeed("check", "--fail-on-contact", apart)
        self.succeed("check", "--fail-on-contact", touching, code=1)
        self.succeed("check", "--fail-on-contact", "--interior", touching)

    def test_the_standard_input_is_read_whatever_its_format(self):
        scene = self.yard().read_bytes()
        self.assertEqual(self.pairs_of("csv", "-", input=scene), YARD_PAIRS)
        boxes = b"id,min_x,min_y,max_x,max_y\na,0,0,1,1\nb,1,0,2,1\n"
        self.assertEqual(self.pairs_of("json", "-", input=boxes), [("a", "b", "touching")])
        document = json.loads(self.succeed("check", "--format", "json", "-", input=scene)[0])
        self.assertEqual(document["scene"], "-")

    def test_relative_references_of_the_standard_input_start_at_the_working_directory(self):
        level = (ROOT / "data" / "platform_level.tmx").read_bytes()
        from_input = self.pairs_of("csv", "-", input=level, cwd=ROOT / "data")
        self.assertEqual(from_input, self.pairs_of("csv", ROOT / "data" / "platform_level.tmx"))

    def test_a_report_goes_to_a_file_and_its_summary_to_the_error_stream(self):
        report = self.folder / "report.json"
        text, said = self.succeed("check", "--format", "json", "--output", report, self.yard())
        self.assertEqual(text, "")
        self.assertIn("3 pairs; 4 objects", said)
        self.assertEqual(json.loads(report.read_text())["summary"]["pairs"], 3)
        self.assert_no_litter("report.json", "yard.json")

    def test_output_to_a_hyphen_is_the_standard_output(self):
        self.assertEqual(self.pairs_of("csv", "--output", "-", self.yard()), YARD_PAIRS)

    def test_the_picture_is_xml_that_names_the_objects(self):
        picture = self.folder / "picture.svg"
        text, _ = self.succeed("check", "--svg", picture, self.yard())
        self.assertIn("3 pairs;", text)
        root = xml.etree.ElementTree.parse(picture).getroot()
        self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
        self.assertIn("lamp", picture.read_text())

    def test_the_picture_goes_to_the_standard_output_when_the_report_does_not(self):
        text, _ = self.succeed("check", "--svg", "-", "--output", self.folder / "report", self.yard())
        self.assertEqual(xml.etree.ElementTree.fromstring(text).tag, "{http://www.w3.org/2000/svg}svg")
        self.refused("check", "--svg", "-", self.yard(), code=2, says="--svg - needs --output FILE")

    def test_outputs_that_would_overwrite_each_other_or_the_scene_are_refused(self):
        scene = self.yard()
        before = scene.read_bytes()
        file = self.folder / "file"
        same_file = f"{self.folder}/./file"
        self.refused("check", scene, "--svg", file, "--output", same_file, code=2, says="name the same file")
        self.refused("check", scene, "--output", scene, code=2, says="would be overwritten")
        self.refused("check", scene, "--svg", f"{self.folder}/./yard.json", code=2, says="would be overwritten")
        self.assertEqual(scene.read_bytes(), before)

    def test_what_was_not_read_is_said_in_every_format(self):
        scene = self.write("layers.tmx", IMAGE_LAYER)
        for report_format in ("table", "json", "ndjson", "csv"):
            with self.subTest(report_format):
                _, said = self.succeed("check", "--format", report_format, scene)
                self.assertIn("graze: not read: 1 x image layer\n", said)

    def test_what_was_not_read_is_part_of_the_answer(self):
        scene = self.write("layers.tmx", IMAGE_LAYER)
        (omission,) = json.loads(self.succeed("check", "--format", "json", scene)[0])["not_read"]
        self.assertEqual((omission["what"], omission["count"], omission["loss"]), ("image layer", 1, "none"))
        svg, _ = self.succeed("check", "--svg", "-", "--output", self.folder / "report", scene)
        self.assertIn(">not read: 1 x image layer<", svg)
        self.assertEqual(json.loads(self.succeed("query", "--point", "0,0", "--format", "json", scene)[0])["not_read"],
                         [omission])

    def test_missing_shapes_are_named_in_every_report_and_a_check_does_not_pass(self):
        future = '<map width="1" height="1" tilewidth="8" tileheight="8"><futurelayer name="f"/></map>'
        scene = self.write("future.tmx", future)
        texts = {name: self.succeed("check", "--format", name, scene)[0] for name in ("table", "json", "ndjson", "csv")}
        (omission,) = json.loads(texts["json"])["not_read"]
        self.assertEqual((omission["what"], omission["count"], omission["loss"]), ("unknown element", 1, "shape"))
        self.assertEqual([json.loads(line) for line in texts["ndjson"].splitlines()], [{"not_read": omission}])
        (row,) = list(csv.reader(io.StringIO(texts["csv"])))[1:]
        self.assertRegex(row[0], r"\A1 x unknown element \(")
        self.assertEqual(row[1:], ["", "not_read"])
        self.assertRegex(texts["table"], r"\Anot read: 1 x unknown element \([^\n]*\n0 pairs; 0 objects")
        for command in (["query", "--point", "0,0", "--format", "ndjson"], ["simulate", "--frames", "1"]):
            self.assertEqual(json.loads(self.succeed(*command, scene)[0].splitlines()[0]), {"not_read": omission})
        _, said = self.succeed("check", "--fail-on-contact", scene, code=3)
        self.assertIn("future.tmx: no pair is reported, but --fail-on-contact does not pass", said)
        self.assertIn("1 x unknown element", said)
        harmless = self.write("extra.csv", "id,min_x,min_y,max_x,max_y,colour\na,0,0,1,1,red\n")
        self.succeed("check", "--fail-on-contact", harmless)
        boxes = '<objectgroup><object id="1" width="2" height="2"/><object id="2" width="2" height="2"/></objectgroup>'
        both = self.write("both.tmx", future.replace("</map>", boxes + "</map>"))
        self.succeed("check", "--fail-on-contact", both, code=1)

    def test_strict_refuses_whatever_is_not_read(self):
        extra = self.write("extra.csv", "id,min_x,min_y,max_x,max_y,colour\na,0,0,1,1,red\n")
        for command in (["check"], ["query", "--point", "0,0"], ["info"], ["simulate", "--frames", "1"],
                        ["convert", "--", extra, self.folder / "c.json"]):
            with self.subTest(command[0]):
                arguments = command[1:] if command[0] == "convert" else [*command[1:], extra]
                said = self.refused(command[0], "--strict", *arguments,
                                    says=['extra.csv: refused because of --strict: not read: 1 x column "colour"'])
                self.assertEqual(said.count("\n"), 1)
        self.succeed("check", "--strict", self.yard())
        self.refused("check", "--strict", "-", input=extra.read_bytes(), says="standard input: refused")


if __name__ == "__main__":
    unittest.main()
