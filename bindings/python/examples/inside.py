# SPDX-License-Identifier: MIT
"""Which points are inside a mesh that has a hole, as scans do."""

import graze
import numpy as np

corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
hull = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4]]
scan = graze.Mesh(corners, hull, kind="solid")  # without the side z = 1

points = np.random.default_rng(1).random((1000, 3)) * 2 - 0.5
inside = graze.winding_numbers(scan, points) > 0.5
print(graze.report(scan).open_edges, "open edges,", np.count_nonzero(inside), "points inside")
