# SPDX-License-Identifier: MIT
"""Pictures of results, for notebooks."""

from graze import _graze


def contact_svg(contact):
    """The two points of a contact and the segment between them, or its normal if it has no depth."""
    dimension = len(contact.point)
    dtype = contact.point.dtype
    scene = _graze.Scene(dimension, dtype)
    scene.add(_graze.Point(contact.point_a, dtype=dtype), name="point_a")
    scene.add(_graze.Point(contact.point_b, dtype=dtype), name="point_b")
    end = contact.point_a if contact.depth != 0 else contact.point + contact.normal
    scene.add(_graze.Segment(contact.point_b, end, dtype=dtype), name="normal")
    return scene._repr_svg_()
