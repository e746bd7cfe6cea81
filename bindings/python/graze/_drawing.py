# SPDX-License-Identifier: MIT
"""Pictures and tables of results, for notebooks."""

import html

import numpy as np

from graze import _graze

SHOWN_ROWS = 10


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


def _cell(value):
    if isinstance(value, np.ndarray) and value.size > 12:
        return html.escape(f"{value.dtype} {value.shape}")
    if isinstance(value, (float, np.floating)):
        return f"{value:.6g}"
    if isinstance(value, np.ndarray):
        return html.escape(np.array2string(value, precision=6))
    if hasattr(value, "_fields"):
        return html.escape(", ".join(str(each) for each in value))
    return html.escape(str(value))


def table_html(header, rows, total):
    """A table of the first rows of `total`."""
    lines = ["<table>", "<tr>" + "".join(f"<th>{html.escape(name)}</th>" for name in header) + "</tr>"]
    lines += ["<tr>" + "".join(f"<td>{_cell(value)}</td>" for value in row) + "</tr>" for row in rows]
    if len(rows) < total:
        lines.append(f'<tr><td colspan="{len(header)}">{total - len(rows):,} more</td></tr>')
    return "\n".join([*lines, "</table>"])


def _contacts_html(contacts):
    total = len(contacts.pairs)
    rows = []
    for i in range(min(total, SHOWN_ROWS)):
        points = slice(contacts.offsets[i], contacts.offsets[i + 1])
        rows.append([*contacts.pairs[i], contacts.normals[i], contacts.points[points], contacts.depths[points]])
    return table_html(["a", "b", "normal", "points", "depths"], rows, total)


def result_html(result):
    """One row for each of many hits or contacts; else one for each field, after the picture of one that has it."""
    kind = type(result).__name__
    if kind == "Contacts":
        return _contacts_html(result)
    if kind == "RayHits":
        total = len(result.t)
        return table_html(["ray", *result._fields], [[i, *(column[i] for column in result)] for i in range(min(total, SHOWN_ROWS))], total)
    if kind == "Manifold" and result.points:
        rows = [[point.point, point.depth, point.id.a, point.id.b] for point in result.points]
        return table_html(["point", "depth", "feature of a", "feature of b"], rows, len(rows)) + f"<p>normal {_cell(result.normal)}</p>"
    if kind == "SceneFile":
        return scene_html(result.scene)
    picture = result._repr_svg_() if hasattr(result, "_repr_svg_") else ""
    rows = list(zip(result._fields, result))
    return picture + table_html(["field", "value"], rows, len(rows))


def scene_html(scene):
    """A picture, and the first objects."""
    ids = scene.ids()
    rows = []
    for number in ids[:SHOWN_ROWS]:
        thing = scene.object(number)
        rows.append([number, thing.name, type(thing.shape).__name__, thing.layer, "fixed" if thing.fixed else "moving"])
    summary = f"<p>{len(ids):,} objects in {scene.dimension}D of {scene.dtype}, {len(scene.pairs()):,} pairs touch</p>"
    return scene._repr_svg_() + summary + table_html(["id", "name", "type", "layer", "mobility"], rows, len(ids))
