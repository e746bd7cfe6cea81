# SPDX-License-Identifier: MIT
"""Reads meshes, tells which are closed, and writes one of them in another format."""

import pathlib

import graze

corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
tetrahedron = graze.Mesh(corners, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
path = pathlib.Path("tetrahedron.ply")
path.write_bytes(graze.mesh_bytes(tetrahedron, "ply"))

file = graze.read_meshes(path, kind="solid")  # of closed meshes
for name, mesh in file.parts:
    print(name or "a mesh", "of", len(mesh.faces), "faces is a", mesh.kind)
path.with_suffix(".stl").write_bytes(graze.mesh_bytes(file.parts, "stl"))
print(f"volume {graze.mass_properties(file.parts[0].mesh).volume:.3f}")
