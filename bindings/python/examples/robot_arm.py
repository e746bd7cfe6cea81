# SPDX-License-Identifier: MIT
"""How far an arm of three links can turn its shoulder before it touches the table."""

import graze
import numpy as np

table = graze.HalfSpace([0, 0, 1], 0)
links = [graze.Capsule([i, 0, 0], [i + 1, 0, 0], 0.1) for i in range(3)]
arm = graze.translated(graze.Compound(links), [0, 0, 1])

print(f"{graze.distance(arm, table):.2f} above the table")
down = graze.Motion(angular=[0, np.pi / 2, 0], center=[0, 0, 1])
impact = graze.time_of_impact(arm, down, table)
if impact:
    print(f"touches after {np.degrees(impact.t * np.pi / 2):.1f} degrees")
