# SPDX-License-Identifier: MIT
"""The results of queries: immutable tuples with named fields. Vectors are read-only NumPy arrays."""

from typing import NamedTuple

import numpy as np


def _are_equal(a, b):
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        return np.array_equal(a, b)
    return bool(a == b)


def _result(cls):
    """Compares arrays as a whole, because a tuple compares the truth of an array of truths, which NumPy refuses; and shows
    itself as a table in notebooks."""

    def equals(self, other):
        if type(other) is not cls:
            return NotImplemented
        return all(_are_equal(a, b) for a, b in zip(self, other))

    def differs(self, other):
        result = equals(self, other)
        return result if result is NotImplemented else not result

    def html(self):
        from graze._drawing import result_html

        return result_html(self)

    cls.__eq__ = equals
    cls.__ne__ = differs
    cls._repr_html_ = html
    cls.__hash__ = None
    cls.__module__ = "graze"
    return cls


@_result
class Proximity(NamedTuple):
    """The distance of two shapes and their nearest points."""

    distance: float
    point_a: np.ndarray
    point_b: np.ndarray
    normal: np.ndarray
    relation: str
    status: str
    error: float


@_result
class Contact(NamedTuple):
    """Where and how deep two shapes overlap: moving b by normal * depth separates them."""

    point: np.ndarray
    normal: np.ndarray
    depth: float
    point_a: np.ndarray
    point_b: np.ndarray
    status: str
    error: float

    def _repr_svg_(self):
        from graze._drawing import contact_svg

        return contact_svg(self)


@_result
class Feature(NamedTuple):
    """A vertex, an edge or a face of a shape."""

    kind: str
    index: int


@_result
class ContactId(NamedTuple):
    """The features of two shapes on which a contact point lies, the same from frame to frame."""

    a: Feature
    b: Feature
    part_a: int
    part_b: int


# Keys by which a solver finds what it knew of a point in the last frame.
Feature.__hash__ = tuple.__hash__
ContactId.__hash__ = tuple.__hash__


@_result
class ManifoldPoint(NamedTuple):
    """One point of a manifold."""

    point: np.ndarray
    point_a: np.ndarray
    point_b: np.ndarray
    depth: float
    id: ContactId


@_result
class Manifold(NamedTuple):
    """The contact points of two shapes: up to two in 2D and four in 3D, none if they are apart."""

    points: tuple
    normal: np.ndarray
    status: str
    error: float


@_result
class RayHit(NamedTuple):
    """Where a ray enters or leaves a shape; t is in units of the ray's direction."""

    t: float
    point: np.ndarray
    normal: np.ndarray
    status: str
    error: float


@_result
class MeshHit(NamedTuple):
    """Where a ray meets a mesh; face is None for a ray that starts inside a solid."""

    t: float
    point: np.ndarray
    normal: np.ndarray
    status: str
    error: float
    face: "int | None"
    barycentric: np.ndarray


@_result
class RayHits(NamedTuple):
    """The hits of many rays, one row each. t is infinite for a ray that misses; face is -1 for it, and for one that starts
    inside a solid."""

    t: np.ndarray
    point: np.ndarray
    normal: np.ndarray
    face: np.ndarray
    barycentric: np.ndarray
    error: np.ndarray


@_result
class Impact(NamedTuple):
    """When and where moving shapes first touch; t is from 0 to 1."""

    t: float
    point: np.ndarray
    normal: np.ndarray
    status: str
    error: float


@_result
class MassProperties(NamedTuple):
    """Volume (in 2D area), centroid and inertia about it at density 1: a matrix, in 2D a number."""

    volume: float
    centroid: np.ndarray
    inertia: "np.ndarray | float"


@_result
class MeshReport(NamedTuple):
    """What is unusual about a mesh."""

    open_edges: int
    non_manifold_edges: int
    flipped_edges: int
    degenerate_faces: int
    duplicate_faces: int
    unused_vertices: int
    components: int
    is_closed: bool


@_result
class Contacts(NamedTuple):
    """The contact points of many pairs. Pair i has the points offsets[i] to offsets[i + 1]."""

    pairs: np.ndarray
    normals: np.ndarray
    offsets: np.ndarray
    points: np.ndarray
    depths: np.ndarray


@_result
class SceneEvents(NamedTuple):
    """How the touching pairs of a scene changed in an update: arrays of ids, (n, 2) each, ascending."""

    began: np.ndarray
    stayed: np.ndarray
    ended: np.ndarray


@_result
class SceneObject(NamedTuple):
    """An object of a scene."""

    shape: object
    name: str
    layer: int
    mask: int
    user: int
    fixed: bool


@_result
class NearObject(NamedTuple):
    """An object and its distance."""

    id: int
    distance: float


@_result
class NearPair(NamedTuple):
    """Two objects and their distance."""

    a: int
    b: int
    distance: float


@_result
class ObjectHit(NamedTuple):
    """An object that a ray hits, and the hit: a MeshHit on a face of a mesh, else a RayHit."""

    id: int
    hit: RayHit | MeshHit


@_result
class ObjectImpact(NamedTuple):
    """An object that a moving shape touches."""

    id: int
    impact: Impact


@_result
class ObjectTouch(NamedTuple):
    """An object that touches a shape; the normal points from the shape to the object."""

    id: int
    manifold: Manifold


@_result
class ObjectContact(NamedTuple):
    """Two objects that touch."""

    a: int
    b: int
    manifold: Manifold


@_result
class Slide(NamedTuple):
    """Where a sliding shape ends, and what it met on its way."""

    motion: np.ndarray
    touches: tuple


@_result
class SceneFile(NamedTuple):
    """A scene and what else its file says; velocities are by id."""

    scene: object
    format: str
    y_axis: str
    velocities: dict
    warnings: list
    omissions: list


@_result
class MeshPart(NamedTuple):
    """A mesh of a file, in the file's coordinates."""

    name: str
    mesh: object


@_result
class MeshFile(NamedTuple):
    """The meshes of a file; up is 'y', 'z' or None, metres_per_unit None if the format does not say."""

    parts: tuple
    format: str
    up: "str | None"
    metres_per_unit: "float | None"
    warnings: list
    omissions: list


@_result
class ReplayReport(NamedTuple):
    """The result of replaying a query log."""

    calls: int
    differing: int
