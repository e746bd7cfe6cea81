# SPDX-License-Identifier: MIT
"""graze beside other libraries of Python, on the same arrays, with the same answers."""

import importlib

import graze
import numpy as np
from race import best_times, require_equal, seconds_of, spelled
from worlds import bumpy_sphere, points_of, rays_of


def row(task, peer, ours, theirs, seconds, compare):
    (our_time, peer_time), answers = best_times([lambda: seconds_of(ours), lambda: seconds_of(theirs)], seconds, least=2)
    compare(*answers)
    return task, spelled(our_time), peer, f"{peer_time / our_time:.3g}"


def same(task, convert_ours, convert_theirs, tolerance=None):
    return lambda ours, theirs: require_equal(task, convert_ours(ours), convert_theirs(theirs), tolerance)


def shapely_rows(scale, seconds):
    """Rectangles in 2D. Version 1.8, which Debian 12 has, answers one question a call."""
    geometry = importlib.import_module("shapely.geometry")
    tree_type = importlib.import_module("shapely.strtree").STRtree
    count = int(20_000 * scale)
    random = np.random.default_rng(5)
    corners = random.random((count, 2)) * count**0.5 * 2
    boxes = np.hstack([corners, corners + random.uniform(0.5, 1.5, (count, 2))])
    rectangles = [geometry.box(*each) for each in boxes]
    places = {id(rectangle): place for place, rectangle in enumerate(rectangles)}

    def ours():
        index = graze.Bvh(2)
        keys = index.assign(boxes)
        rows, met = index.query_many(boxes)
        return keys, rows, met

    def theirs():
        tree = tree_type(rectangles)
        return [tree.query(rectangle) for rectangle in rectangles]

    def our_pairs(answer):
        keys, rows, met = answer
        return np.column_stack([rows, np.searchsorted(keys, met)])

    def their_pairs(answer):
        return np.array([[i, place] for i, found in enumerate(answer) for place in sorted(places[id(each)] for each in found)])

    task = f"{count:,} rectangles: build, and which meet each"
    yield row(task, "shapely STRtree", ours, theirs, seconds, same(task, our_pairs, their_pairs))


def scipy_rows(scale, seconds):
    tree_type = importlib.import_module("scipy.spatial").cKDTree
    count = int(100_000 * scale)
    points = np.random.default_rng(6).random((count, 3)) * count ** (1 / 3)
    asked = points + 0.1
    index, tree = graze.Bvh(), tree_type(points)
    boxes = np.hstack([points, points])
    keys = index.assign(boxes)
    task = f"{count:,} points: build"
    yield row(task, "SciPy cKDTree", lambda: graze.Bvh().assign(boxes), lambda: tree_type(points), seconds, lambda *_: None)
    for k in (1, 8):
        task = f"{count:,} points: nearest {k} of each, all cores"
        yield row(task, "SciPy cKDTree", lambda k=k: index.nearest_many(asked, k), lambda k=k: tree.query(asked, k, workers=-1), seconds,
                  same(task, lambda found: np.sqrt(found[1]).ravel(), lambda found: found[0].ravel(), 1e-12))
    radii = np.full(count, 0.35)

    def ours():
        candidates = graze.overlapping_pairs(np.hstack([points - radii[:, None], points + radii[:, None]]))
        return graze.touching_pairs(graze.Sphere.many(points, radii), candidates)

    def sorted_pairs(found):
        ordered = np.sort(np.asarray(found, dtype=np.int64), axis=1)
        return ordered[np.lexsort((ordered[:, 1], ordered[:, 0]))]

    task = f"{count:,} points: all pairs within a distance"
    yield row(task, "SciPy cKDTree", ours, lambda: tree_type(points).query_pairs(0.7, output_type="ndarray"), seconds,
              same(task, sorted_pairs, sorted_pairs))
    assert len(keys) == count


def open3d_rows(scale, seconds):
    core = importlib.import_module("open3d").core
    scene_type = importlib.import_module("open3d").t.geometry.RaycastingScene
    vertices, faces = bumpy_sphere(80_000 * scale)
    vertices = vertices.astype(np.float32)
    count = int(100_000 * scale)
    rays, points = rays_of(count).astype(np.float32), points_of(count // 10).astype(np.float32)

    def build():
        scene = scene_type()
        scene.add_triangles(core.Tensor(vertices), core.Tensor(faces))
        scene.cast_rays(core.Tensor(rays[:1]))  # builds the tree
        return scene

    def tensor(ask, array):
        return lambda: ask(core.Tensor(array))

    scene = build()
    surface, mesh = [graze.Mesh(vertices, faces, kind=kind, dtype=np.float32) for kind in ("surface", "solid")]
    peer = "Open3D RaycastingScene"
    yield row(f"mesh of {len(faces):,} faces: build", peer, lambda: graze.Mesh(vertices, faces, kind="solid", dtype=np.float32), build,
              seconds, lambda *_: None)

    task = f"closest point of {len(points):,} points"
    yield row(task, peer, lambda: graze.closest_points(surface, points), tensor(scene.compute_closest_points, points), seconds,
              lambda ours, theirs: require_equal(task, np.linalg.norm(ours - points, axis=1),
                                                 np.linalg.norm(theirs["points"].numpy() - points, axis=1), 1e-5))
    through_the_middle = np.array([[3, 0.1, 0.2, -1, 0, 0]], dtype=np.float32)
    if not np.isfinite(scene.cast_rays(core.Tensor(through_the_middle))["t_hit"].numpy()[0]):
        yield "rays, signed distances", "", f"{peer}: no ray hits anything, as in Debian 12", ""
        return
    rays_task = f"{count:,} rays"
    yield row(rays_task, peer, lambda: graze.ray_casts(mesh, rays), tensor(scene.cast_rays, rays), seconds,
              lambda ours, theirs: require_few_differ(rays_task, finite(ours.t), finite(theirs["t_hit"].numpy())))
    signed_task = f"signed distance of {len(points):,} points"
    yield row(signed_task, peer, lambda: graze.signed_distances(mesh, points), tensor(scene.compute_signed_distance, points), seconds,
              same(signed_task, lambda found: found, lambda found: found.numpy(), 1e-5))


def finite(times):
    """-1 for a ray that misses."""
    return np.where(np.isfinite(times), times, -1)


def require_few_differ(task, ours, theirs):
    """Rays along an edge may pass on either side of it in float32: at most one in 10,000."""
    differing = np.count_nonzero(~np.isclose(ours, theirs, rtol=0, atol=1e-4))
    if differing > len(ours) // 10_000:
        require_equal(f"{task}: {differing} hits", 0, differing)


def peer_rows(scale, seconds):
    for rows, package in ((shapely_rows, "shapely"), (scipy_rows, "scipy"), (open3d_rows, "open3d")):
        try:
            importlib.import_module(package)
        except ImportError:
            yield f"python3-{package} is not installed", "", "", ""
            continue
        yield from rows(scale, seconds)
