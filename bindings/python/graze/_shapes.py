# SPDX-License-Identifier: MIT
"""Poses and motions, and what pickle needs to restore a shape."""

from typing import NamedTuple

import numpy as np

from graze import _graze
from graze._results import _result


def restore_shape(type_name, keywords):
    return getattr(_graze, type_name)(**keywords)


@_result
class Pose(NamedTuple):
    """A rigid transform: maps x to rotation @ x + position. rotation: (N, N), orthonormal; position: (N,)."""

    rotation: np.ndarray
    position: np.ndarray

    @staticmethod
    def identity(dimension):
        """The pose that moves nothing."""
        return Pose(np.eye(dimension), np.zeros(dimension))

    @staticmethod
    def from_angle(position, radians):
        """In 2D: rotates counter-clockwise, then translates."""
        return Pose(_graze.rotation_from_angle(radians), np.asarray(position, dtype=float))

    @staticmethod
    def from_axis_angle(position, axis, radians):
        """In 3D: rotates right-handed about an axis of any length but zero, then translates."""
        return Pose(_graze.rotation_from_axis_angle(axis, radians), np.asarray(position, dtype=float))

    @staticmethod
    def from_quaternion(position, quaternion):
        """In 3D: rotates by a quaternion (x, y, z, w) of any length but zero, then translates."""
        return Pose(_graze.rotation_from_quaternion(quaternion), np.asarray(position, dtype=float))

    @staticmethod
    def from_matrix(matrix):
        """From a homogeneous matrix, (N + 1, N + 1), with a last row of zeros and a one."""
        matrix = np.asarray(matrix, dtype=float)
        size = matrix.shape[0] if matrix.ndim == 2 else 0
        if matrix.shape not in ((3, 3), (4, 4)):
            raise ValueError(f"Pose.from_matrix: matrix has shape {matrix.shape}; (3, 3) or (4, 4) is needed")
        if not np.array_equal(matrix[-1], np.eye(size)[-1]):
            raise ValueError("Pose.from_matrix: the last row is not 0, ..., 0, 1")
        return Pose(matrix[:-1, :-1].copy(), matrix[:-1, -1].copy())

    def __matmul__(self, other):
        """The pose that applies `other` first."""
        return Pose(self.rotation @ other.rotation, self.rotation @ other.position + self.position)


@_result
class Motion(NamedTuple):
    """A rigid motion from t = 0 to t = 1: the center moves by `linear`, and the shape rotates about it by `angular`, in
    2D an angle in radians, in 3D a vector along the axis whose length is the angle. None stands for zero."""

    linear: "np.ndarray | None" = None
    angular: "np.ndarray | float | None" = None
    center: "np.ndarray | None" = None
