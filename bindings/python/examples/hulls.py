# SPDX-License-Identifier: MIT
"""Two hulls: whether they touch, how far apart they are, and when they meet."""

import graze
import numpy as np

random = np.random.default_rng(1)
left = graze.convex_hull(random.random((100, 3)))
right = graze.translated(left, [3, 0, 0])

print(graze.relation(left, right))
near = graze.closest_points(left, right)
print(f"{near.distance:.3f} apart, along {near.normal.round(3)}")

impact = graze.shape_cast(left, [4, 0, 0], right)
if impact:
    print(f"they meet at {impact.t:.3f} of the way")
