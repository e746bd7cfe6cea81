# SPDX-License-Identifier: MIT
"""`graze convert`."""

import csv
import io
import json
import unittest

from graze_program import CommandLineTest, IMAGE_LAYER, ROOT


class Convert(CommandLineTest):
    def pairs_of(self, scene):
        return list(csv.reader(io.StringIO(self.succeed("check", "--format", "csv", scene)[0])))

    def test_what_was_converted_has_the_same_contacts(self):
        for name in ("platform_level.tmx", "workshop.json"):
            with self.subTest(name):
                converted = self.folder / "converted.json"
                self.succeed("convert", ROOT / "data" / name, converted)
                self.assertEqual(json.loads(converted.read_text())["schema"], "graze.scene/1")
                self.assertEqual(self.pairs_of(converted), self.pairs_of(ROOT / "data" / name))

    def test_converting_twice_changes_nothing_more(self):
        once, twice = self.folder / "once.json", self.folder / "twice.json"
        self.succeed("convert", ROOT / "data" / "platform_level.tmx", once)
        self.succeed("convert", once, twice)
        self.assertEqual(once.read_bytes(), twice.read_bytes())

    def test_input_and_output_may_be_the_same_file(self):
        scene = self.write("boxes.json", "id,min_x,min_y,max_x,max_y\na,0,0,1,1\n")  # recognised by content, not by name
        self.succeed("convert", scene, scene)
        self.assertEqual(json.loads(scene.read_text())["objects"][0]["name"], "a")
        self.assert_no_litter("boxes.json")

    def test_hyphens_are_the_standard_streams(self):
        text, _ = self.succeed("convert", "-", "-", input=self.yard().read_bytes())
        self.assertEqual([one["name"] for one in json.loads(text)["objects"]], ["ground", "crate", "ball", "lamp"])

    def test_numbers_survive_bit_for_bit(self):
        numbers = ["0.1", "-0.0", "5e-324", "1.7976931348623157e+308", "0.30000000000000004", "123456789.12345679"]
        boxes = "".join(f"b{i},{number},0,1.7976931348623157e308,1\n" for i, number in enumerate(numbers))
        text, _ = self.succeed("convert", "-", "-", input=f"id,min_x,min_y,max_x,max_y\n{boxes}".encode())
        found = [one["min"][0] for one in json.loads(text)["objects"]]
        self.assertEqual([float(number).hex() for number in numbers], [float(number).hex() for number in found])

    def test_what_is_not_carried_over_is_said(self):
        _, said = self.succeed("convert", self.write("layers.tmx", IMAGE_LAYER), "-")
        self.assertIn("graze: not read: 1 x image layer\n", said)

    def test_names_that_promise_another_format_are_refused(self):
        scene = self.yard()
        for name in ("out.csv", "out.tmx", "out", "json"):
            says = ["it writes graze's JSON", ".json", f'{name}"']
            self.refused("convert", scene, self.folder / name, code=2, says=says)
        self.assert_no_litter("yard.json")
        self.succeed("convert", scene, self.folder / "OUT.JSON")

    TETRAHEDRON = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"

    def test_meshes_go_from_format_to_format_and_back(self):
        last = self.write("a.off", self.TETRAHEDRON)
        for ending in ("glb", "obj", "ply", "stl", "json", "OFF"):
            following = self.folder / f"b.{ending}"
            self.succeed("convert", last, following)
            mesh = json.loads(self.succeed("info", "--format", "json", following)[0])["meshes"][0]
            self.assertEqual((mesh["vertices"], mesh["faces"], mesh["closed"]), (4, 4, True), ending)
            last = following

    def test_meshes_are_scaled_and_turned(self):
        mesh, turned = self.write("a.off", self.TETRAHEDRON), self.folder / "b.obj"
        self.succeed("convert", "--scale", "0.5", "--turn", "y-to-z", mesh, turned)
        self.assertIn("v 0.5 0 0\nv 0 0 0.5\nv 0 -0.5 0\n", turned.read_text().replace("-0 ", "0 "))
        self.refused("convert", "--scale", "0", mesh, turned, code=2, says="--scale 0 is not a factor")
        self.refused("convert", "--turn", "x-to-z", mesh, turned, code=2, says="y-to-z")
        self.refused("convert", "--scale", "1e308", "--turn", "y-to-z", self.write("c.off", "OFF\n1 0 0\n9 9 9\n"), turned,
                     says="makes a coordinate larger than about 1.8e308")
        self.refused("convert", "--scale", "2", self.yard(), turned, says="this is")

    def test_closed_meshes_become_solids(self):
        mesh = self.write("a.off", self.TETRAHEDRON)
        text, said = self.succeed("convert", "--solid", mesh, "-")
        self.assertEqual((json.loads(text)["objects"][0]["kind"], said), ("solid", ""))
        self.assertEqual(json.loads(self.succeed("convert", mesh, "-")[0])["objects"][0]["kind"], "surface")
        _, said = self.succeed("convert", "--solid", self.write("b.off", self.TETRAHEDRON.replace("4 4 6", "4 3 6")), "-")
        self.assertIn("the mesh number 0 is not closed, so it stays a surface", said)

    def test_mesh_formats_hold_only_meshes(self):
        self.refused("convert", self.yard(), self.folder / "a.glb", says="is a 2D scene, and mesh files are 3D")
        scene = {"schema": "graze.scene/1", "dimension": 3, "objects": [
            {"name": "ball", "type": "sphere", "center": [0, 0, 0], "radius": 1}]}
        self.refused("convert", self.write("b.json", scene), self.folder / "b.stl",
                     says="the object \"ball\" is a sphere, and mesh files hold only meshes; write it as .json")
        self.assert_no_litter("b.json", "yard.json")

    def test_an_existing_file_survives_input_that_is_refused(self):
        kept = self.write("kept.json", "precious")
        self.refused("convert", self.write("broken.json", '{"schema": '), kept, says="broken.json")
        self.assertEqual(kept.read_text(), "precious")
        self.assert_no_litter("broken.json", "kept.json")


if __name__ == "__main__":
    unittest.main()
