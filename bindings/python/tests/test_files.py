# SPDX-License-Identifier: MIT
"""Files of meshes and scenes, and what notebooks show."""

import pathlib
import tempfile
import unittest

import graze
import numpy as np
from test_shapes import CUBE, FACES

ROOT = pathlib.Path(__file__).resolve().parents[3]


class MeshFilesTest(unittest.TestCase):
    def setUp(self):
        self.cube = graze.Mesh(CUBE, FACES)

    def test_every_format_gives_the_mesh_again(self):
        for form in ("obj", "ply", "off", "glb", "stl"):
            data = graze.mesh_bytes(self.cube, form)
            file = graze.parse_meshes(data, f"cube.{form}")
            self.assertEqual(file.format, "gltf" if form == "glb" else form)
            self.assertEqual((file.up, file.metres_per_unit), ("y", 1) if form == "glb" else (None, None))
            mesh = file.parts[0].mesh
            if form == "stl":  # it has no indices, so vertices come in the order of the faces
                self.assertEqual((len(mesh.vertices), len(mesh.faces)), (8, 12))
            else:
                self.assertEqual(mesh, self.cube)

    def test_parts_keep_their_names_and_closed_ones_become_solid(self):
        open_part = graze.Mesh(CUBE, FACES[1:], dtype=np.float32)
        parts = [graze.MeshPart("whole", self.cube), graze.MeshPart("open", open_part)]
        data = graze.mesh_bytes(parts, "obj")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "two.obj")
            path.write_bytes(data)
            file = graze.read_meshes(path, kind="solid")
            scene = graze.read_scene(path, meshes="solid").scene
            surfaces = graze.read_scene(str(path)).scene
        self.assertEqual([part.name for part in file.parts], ["whole", "open"])
        self.assertEqual([part.mesh.kind for part in file.parts], ["solid", "surface"])
        self.assertEqual(len(file.warnings), 1)
        self.assertEqual(file.parts[1].mesh.dtype, np.float64)
        self.assertEqual(scene.object(scene.find("whole")).shape.kind, "solid")
        self.assertEqual(surfaces.object(surfaces.find("whole")).shape.kind, "surface")

    def test_faults_are_named(self):
        for error, text, call in [
            (graze.InputError, "cube.ply", lambda: graze.parse_meshes(b"ply\n", "cube.ply")),
            (graze.InputError, "no such file", lambda: graze.read_meshes("no such file.obj")),
            (ValueError, "stl, obj, ply, off, glb", lambda: graze.mesh_bytes(self.cube, "fbx")),
            (TypeError, "mesh 0 is a Sphere in 3D", lambda: graze.mesh_bytes([graze.Sphere([0, 0, 0], 1)], "obj")),
            (TypeError, "mesh 1 is a int", lambda: graze.mesh_bytes([self.cube, 5], "obj")),
            (TypeError, "in 2D", lambda: graze.mesh_bytes(graze.Mesh([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]), "obj")),
            (ValueError, "'surface' or 'solid'", lambda: graze.read_meshes("cube.obj", kind="hollow")),
            (graze.OutputError, "", lambda: graze.mesh_bytes(graze.Mesh(np.array(CUBE) * 1e300, FACES), "stl")),
            (TypeError, "", lambda: graze.read_meshes(5)),
        ]:
            with self.subTest(text), self.assertRaisesRegex(error, text):
                call()


class NotebookTest(unittest.TestCase):
    def test_scenes_show_a_picture_and_their_objects(self):
        scene = graze.read_scene(ROOT / "data/workshop.json").scene
        html = scene._repr_html_()
        self.assertIn("<svg", html)
        self.assertIn(f"{len(scene):,} objects in 3D of float64", html)
        self.assertIn(f"{len(scene) - 10:,} more", html)
        named = graze.Scene()
        named.add(graze.Sphere([0, 0, 0], 1), name="<b>")
        self.assertIn("&lt;b&gt;", named._repr_html_().split("</svg>")[1])

    def test_results_show_tables(self):
        mesh = graze.Mesh(CUBE, FACES)
        rays = np.tile([0.25, 0.5, 5, 0, 0, -1.0], (12, 1))
        hits = graze.ray_casts(mesh, rays)._repr_html_()
        self.assertIn("<th>barycentric</th>", hits)
        self.assertEqual(hits.count("<tr>"), 1 + 10 + 1)
        self.assertIn("2 more", hits)
        spheres = graze.Sphere.many(np.array([[0.0, 0, 0], [1.5, 0, 0]]), [1, 1])
        contacts = graze.contacts(spheres, [[0, 1]])._repr_html_()
        self.assertIn("<td>[0.5]</td>", contacts)
        contact = graze.contact(*spheres)._repr_html_()
        self.assertTrue("<svg" in contact and "<td>depth</td><td>0.5</td>" in contact)
        self.assertIn("<th>feature of a</th>", graze.manifold(*spheres)._repr_html_())
        self.assertIn("<td>open_edges</td><td>0</td>", graze.report(mesh)._repr_html_())
        apart = graze.manifold(spheres[0], graze.Sphere([9, 0, 0], 1))
        self.assertIn("<table>", apart._repr_html_())


if __name__ == "__main__":
    unittest.main()
