# SPDX-License-Identifier: MIT
"""Calls of the Python module beside the same calls in C++, on the same arrays, in one process."""

import graze
import native
import numpy as np
from race import best_times, require_equal, seconds_of, spelled
from worlds import boxes_of, bumpy_sphere, points_of, rays_of, rotations


def in_python(call):
    return lambda: seconds_of(call)


def contests(scale):
    """The name, our side, that of C++, and how our answer becomes comparable: for arrays of a size."""
    count = int(100_000 * scale)
    boxes, moved = boxes_of(count)
    finder, native_finder = graze.PairFinder(), native.Finder()
    yield "overlapping_pairs", lambda: graze.overlapping_pairs(boxes), lambda: native.overlapping_pairs(boxes), None
    yield "PairFinder.find", lambda: finder.find(moved), lambda: native_finder.find(moved), None

    centers, half, axes = (boxes[:, :3] + boxes[:, 3:]) / 2, (boxes[:, 3:] - boxes[:, :3]) / 2, rotations(count)
    shapes, native_shapes = graze.Obb.many(centers, half, axes), native.ShapeList(centers, half, axes)
    pairs = graze.overlapping_pairs(graze.bounds(shapes))
    yield "bounds of oriented boxes", lambda: graze.bounds(shapes), native_shapes.bounds, None
    yield "touching_pairs", lambda: graze.touching_pairs(shapes, pairs), lambda: native_shapes.touching_pairs(pairs), None
    yield "relations", lambda: graze.relations(shapes, pairs), lambda: native_shapes.relations(pairs), None
    yield "contacts", lambda: graze.contacts(shapes, pairs), lambda: native_shapes.contacts(pairs), lambda found: found.depths
    yield "convex_hull", lambda: graze.convex_hull(centers), lambda: native.convex_hull(centers), lambda hull: len(hull.points)

    vertices, faces = bumpy_sphere(80_000 * scale)
    mesh, native_mesh = graze.Mesh(vertices, faces, kind="solid"), native.Surface(vertices, faces)
    rays, points = rays_of(count), points_of(count)
    few = points[: count // 10]
    yield ("Mesh(...)", lambda: graze.Mesh(vertices, faces, kind="solid"), lambda: native.Surface.mesh_of(vertices, faces),
           lambda made: len(made.faces))
    yield "ray_casts", lambda: graze.ray_casts(mesh, rays), lambda: native_mesh.ray_casts(rays), lambda hits: hits.face
    yield "signed_distances", lambda: graze.signed_distances(mesh, few), lambda: native_mesh.signed_distances(few), None
    yield "closest_points", lambda: graze.closest_points(mesh, few), lambda: native_mesh.closest_points(few), None
    yield "winding_numbers", lambda: graze.winding_numbers(mesh, few), lambda: native_mesh.winding_numbers(few), None

    index, native_index = graze.Bvh(), native.Index()
    keys = index.assign(boxes)
    native_index.assign(boxes)
    yield "Bvh.update_many", lambda: index.update_many(keys, moved), lambda: native_index.update_many(moved), lambda _: count
    yield "Bvh.assign", lambda: index.assign(boxes), lambda: native_index.assign(boxes), len
    yield from scene_contests(boxes, moved)


def scene_contests(boxes, moved):
    """Frames of a scene in which everything moves to and fro."""
    middle, radii = [(side[:, :3] + side[:, 3:]) / 2 for side in (boxes, moved)], np.full(len(boxes), 0.5)
    spheres = graze.Sphere.many(middle[0], radii)
    worlds = {}
    for name in ("boxes", "spheres"):
        scene, native_scene = graze.Scene(), native.World()
        ids = scene.add_many(spheres)
        native_scene.add_many(native.ShapeList(middle[0], radii))
        worlds[name] = scene, native_scene, ids
    turns = {(name, side): 0 for name in worlds for side in ("ours", "native")}

    def place(name, side):
        turns[name, side] += 1
        return turns[name, side] % 2

    def changed(events):
        return len(events.began) + len(events.ended)

    def move_boxes():
        scene, _, ids = worlds["boxes"]
        scene.move_many(ids, (boxes, moved)[place("boxes", "ours")])
        return scene.update()

    def move_spheres():
        scene, _, ids = worlds["spheres"]
        scene.move_many(ids, graze.Sphere.many(middle[place("spheres", "ours")], radii))
        return scene.update()

    yield ("Scene: boxes move, update", move_boxes,
           lambda: worlds["boxes"][1].move_to_boxes((boxes, moved)[place("boxes", "native")]), changed)
    yield ("Scene: spheres move, update", move_spheres,
           lambda: worlds["spheres"][1].move_to_spheres(middle[place("spheres", "native")], radii), changed)
    yield "Scene.pairs", worlds["spheres"][0].pairs, worlds["spheres"][1].pairs, len


def batch_rows(scale, seconds, wanted):
    for name, ours, theirs, comparable in contests(scale):
        if wanted not in name:
            continue
        (our_time, native_time), (answer, native_answer) = best_times([in_python(ours), theirs], seconds)
        require_equal(name, answer if comparable is None else comparable(answer), native_answer)
        yield name, spelled(native_time), spelled(our_time), f"{our_time / native_time:.2f}"


def single_rows(seconds):
    """One call of intersects for each of many pairs, without the time of the loop around it."""
    boxes, _ = boxes_of(1000)
    centers, half = (boxes[:, :3] + boxes[:, 3:]) / 2, (boxes[:, 3:] - boxes[:, :3]) / 2
    kinds = {"two spheres": ((centers, half[:, 0]), graze.Sphere), "two oriented boxes": ((centers, half, rotations(1000)), graze.Obb)}
    pairs = np.stack(np.meshgrid(np.arange(100), np.arange(100)), axis=-1).reshape(-1, 2).astype(np.uint32)
    for name, (fields, kind) in kinds.items():
        shapes = list(kind.many(*fields))
        native_shapes = native.ShapeList(*fields)
        arguments = [(shapes[a], shapes[b]) for a, b in pairs]
        intersects = graze.intersects

        def call_all():
            count = 0
            for a, b in arguments:
                if intersects(a, b):
                    count += 1
            return count

        def call_none():
            count = 0
            for a, b in arguments:
                if a is b:
                    count += 1
            return count

        contestants = [in_python(call_all), in_python(call_none), lambda: native_shapes.intersects(pairs)]
        (ours, loop, theirs), (count, _, native_count) = best_times(contestants, seconds)
        require_equal(name, count, native_count)
        mine, other = (ours - loop) / len(pairs), theirs / len(pairs)
        yield name, spelled(other), spelled(mine), f"{(mine - other) * 1e9:.0f}"
