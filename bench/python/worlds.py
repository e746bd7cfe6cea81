# SPDX-License-Identifier: MIT
"""The arrays that the benchmarks of Python ask about."""

import numpy as np


def boxes_of(count, seed=1):
    """Boxes of about unit size that fill a fifth of a cube: minima, then maxima; and the same after a small step."""
    random = np.random.default_rng(seed)
    centers = random.random((count, 3)) * (5 * count) ** (1 / 3)
    half = random.uniform(0.3, 0.6, (count, 3))
    moved = centers + random.normal(scale=0.02, size=centers.shape)
    return np.hstack([centers - half, centers + half]), np.hstack([moved - half, moved + half])


def rotations(count, seed=2):
    """Rotation matrices, (n, 3, 3)."""
    numbers = np.random.default_rng(seed).normal(size=(count, 4))
    x, y, z, w = (numbers / np.linalg.norm(numbers, axis=1)[:, None]).T
    rows = [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), 2 * (x * y + z * w), 1 - 2 * (x * x + z * z),
            2 * (y * z - x * w), 2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]
    return np.stack(rows, axis=1).reshape(-1, 3, 3)


def bumpy_sphere(faces):
    """A closed mesh of about this many faces: vertices (n, 3) and faces (m, 3) of uint32."""
    rings = max(3, int((faces / 4) ** 0.5))
    around = 2 * rings
    polar = np.pi * (np.arange(rings) + 1) / (rings + 1)
    turn = 2 * np.pi * np.arange(around) / around
    theta, phi = np.meshgrid(polar, turn, indexing="ij")
    radius = 1 + 0.1 * np.sin(7 * phi) * np.sin(5 * theta)
    ring_points = radius[..., None] * np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=-1)
    vertices = np.vstack([ring_points.reshape(-1, 3), [[0, 0, 1], [0, 0, -1]]])
    i, j = np.meshgrid(np.arange(rings - 1), np.arange(around), indexing="ij")
    low, low_next = i * around + j, i * around + (j + 1) % around
    high, high_next = low + around, low_next + around
    sides = [np.stack([low, high, high_next], axis=-1).reshape(-1, 3), np.stack([low, high_next, low_next], axis=-1).reshape(-1, 3)]
    top, bottom, last = rings * around, rings * around + 1, (rings - 1) * around
    each = np.arange(around)
    following = (each + 1) % around
    caps = [np.stack([np.full(around, top), each, following], axis=1), np.stack([np.full(around, bottom), last + following, last + each], axis=1)]
    return vertices, np.vstack([*sides, *caps]).astype(np.uint32)


def rays_of(count, seed=3):
    """Rays from around a mesh of radius 1 to points in it; some miss."""
    random = np.random.default_rng(seed)
    origins = random.normal(size=(count, 3))
    origins *= 3 / np.linalg.norm(origins, axis=1)[:, None]
    return np.hstack([origins, random.uniform(-1, 1, (count, 3)) - origins])


def points_of(count, seed=4):
    """Points in and around a mesh of radius 1."""
    return np.random.default_rng(seed).uniform(-1.5, 1.5, (count, 3))
