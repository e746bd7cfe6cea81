# SPDX-License-Identifier: MIT
"""All overlapping pairs among 100,000 boxes that move."""

import graze
import numpy as np

random = np.random.default_rng(1)
centers = random.random((100_000, 3)) * 100
finder = graze.PairFinder(dimension=3)
for _ in range(5):
    centers += random.normal(scale=0.05, size=centers.shape)
    boxes = np.hstack([centers - 0.5, centers + 0.5])  # minima, then maxima
    pairs = finder.find(boxes)
    print(len(pairs), "pairs")
