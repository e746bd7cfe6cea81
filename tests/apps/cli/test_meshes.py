# SPDX-License-Identifier: MIT
"""Mesh files as scenes of `graze check`, `query` and `info`."""

import json
import unittest
from pathlib import Path

from graze_program import CommandLineTest

MODELS = Path("/usr/share/assimp/models")  # Debian's package assimp-testmodels
ENGINE = MODELS / "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb"


def cube(name, low, high, first):
    """A box as an object of OBJ, whose vertices are numbered from `first`."""
    lines = [f"o {name}"]
    lines += [f"v {x} {y} {z}" for z in (low, high) for y in (low, high) for x in (low, high)]
    for face in ((1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)):
        lines.append("f " + " ".join(str(first - 1 + corner) for corner in face))
    return "\n".join(lines) + "\n"


class Meshes(CommandLineTest):
    def boxes(self):
        """`small` lies inside `large`, `next` touches `large` at a corner, `far` is 3 away from `next` in each axis."""
        return self.write("boxes.obj", cube("large", 0, 10, 1) + cube("small", 4, 5, 9) + cube("next", 10, 12, 17) +
                          cube("far", 15, 16, 25))

    def pairs(self, *arguments):
        document = json.loads(self.succeed("check", "--format", "json", *arguments)[0])
        return [(pair["a"], pair["b"]) for pair in document["pairs"]]

    def test_parts_that_touch_are_found(self):
        self.assertEqual(self.pairs(self.boxes()), [("large", "next")])

    def test_what_is_inside_touches_a_solid(self):
        self.assertEqual(self.pairs("--solid", self.boxes()), [("large", "small"), ("large", "next")])

    def test_clearances_are_measured(self):
        document = json.loads(self.succeed("check", "--within", "6", "--format", "json", self.boxes())[0])
        self.assertEqual([(pair["a"], pair["b"], round(pair["distance"], 3)) for pair in document["pairs"]],
                         [("large", "small", 4), ("large", "next", 0), ("next", "far", 5.196)])

    def test_queries_find_parts(self):
        scene = self.boxes()
        ray = json.loads(self.succeed("query", scene, "--ray", "-5,1,1,1,0,0", "--format", "json")[0])
        self.assertEqual([(one["name"], one["t"]) for one in ray["found"]], [("large", 5)])
        inside = ("query", "--point", "4.5,4.5,4.5", "--format", "json", scene)
        self.assertEqual(json.loads(self.succeed(*inside)[0])["found"], [])
        found = json.loads(self.succeed("query", "--solid", *inside[1:])[0])["found"]
        self.assertEqual([one["name"] for one in found], ["large", "small"])

    def test_info_counts_faces_and_faults(self):
        info = json.loads(self.succeed("info", "--format", "json", self.boxes())[0])
        self.assertEqual(info["format"], "obj")
        self.assertEqual([(one["name"], one["faces"], one["closed"]) for one in info["meshes"]],
                         [("large", 12, True), ("small", 12, True), ("next", 12, True), ("far", 12, True)])
        self.assertIn("\nmeshes\n  vertices    32\n  faces       48\n  closed      4 of 4\n  components  4\n",
                      self.succeed("info", self.boxes())[0])

    def test_scenes_name_mesh_files_relative_to_themselves(self):
        objects = [{"name": "crate", "type": "mesh", "file": self.boxes().name, "part": "large", "kind": "solid"},
                   {"name": "rest", "type": "mesh", "file": "./boxes.obj", "part": "far"},
                   {"name": "ball", "type": "sphere", "center": [5, 5, 5], "radius": 1}]
        scene = {"schema": "graze.scene/1", "dimension": 3, "objects": objects}
        self.assertEqual(self.pairs(self.write("scene.json", scene)), [("crate", "ball")])
        objects[0]["file"] = "none.obj"
        self.refused("check", self.write("none.json", scene),
                     says='object 0 "crate": "file" is "none.obj", which cannot be read: there is no such file')

    def test_the_standard_input_may_be_a_mesh(self):
        self.assertEqual(json.loads(self.succeed("check", "--format", "json", "-", input=self.boxes().read_bytes())[0])
                         ["summary"]["pairs"], 1)

    def test_broken_meshes_are_refused_with_a_message(self):
        self.refused("check", self.write("a.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\n"
                                         "property float y\nproperty float z\nend_header\n"),
                     says="a.ply: line 3, column 1: the header promises 4000000000 elements \"vertex\"")

    def test_the_engine_is_checked(self):
        if not ENGINE.exists():
            self.skipTest(f"there is no {ENGINE}; install assimp-testmodels")
        document = json.loads(self.succeed("check", "--format", "json", ENGINE)[0])
        self.assertEqual(document["objects"], 67)
        self.assertEqual(document["summary"]["pairs"], 80)
        info = json.loads(self.succeed("info", "--format", "json", ENGINE)[0])
        self.assertEqual(sum(mesh["faces"] for mesh in info["meshes"]), 121496)


if __name__ == "__main__":
    unittest.main()
