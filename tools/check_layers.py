# SPDX-License-Identifier: MIT
"""Checks the shape of the house: who may include whom, that everything has its mirror test, that headers stand alone."""

import argparse
import re
import shutil
import sys
from pathlib import Path

from compile_headers import compile_headers
from project_files import ROOT, includes, project_files

# Lower ones first: a file includes its own layer and those before it. Folders outside of graze/ may include all of them.
LAYERS = ["math", "shape", "query", "broad", "scene", "io"]
# graze::geometry: these need GLM alone, and reach it through one file.
GEOMETRY = LAYERS[:3]
GLM_DOOR = Path("graze/math/vec.hpp")
MAX_LINES = 450

SPDX = "SPDX-License-Identifier: MIT"
SOURCES = [".hpp", ".cpp", ".cpp.in", ".py", ".sh", ".cmake", ".cmake.in", "CMakeLists.txt", "dev", ".ci/run"]

# Headers, and sources of another name than their header, without a test file of their own: the test file that covers them,
# and why it is another's.
TESTED_ELSEWHERE = {
    "graze/broad/block.hpp": ("tests/broad/block_tree_test.cpp", "structs without functions: what the tree is made of"),
    "graze/math/compiler.hpp": ("tests/package/test_compiler.py", "refuses compilers and flags"),
    "graze/math/throw.hpp": ("tests/package/test_compiler.py", "what errors become without exceptions"),
    "graze/math/has_lanes.hpp": ("tests/query/lanes_test.cpp", "two macros, for what is tested there"),
    "graze/query/flat_core.hpp": ("tests/query/flat_touch_test.cpp", "what a touch in the plane is calculated from"),
    "graze/query/flat_ball.hpp": ("tests/query/flat_touch_test.cpp", "compared there with all shapes, as the others"),
    "graze/query/simplex_cache.hpp": ("tests/query/closest_hulls_test.cpp", "a struct, which the queries fill"),
    "graze/broad/pair.hpp": ("tests/broad/pairs_test.cpp", "a struct without functions: it is what overlapping_pairs gives"),
    "graze/broad/pair_room.hpp": ("tests/broad/dense_search_test.cpp", "a function's type, which both methods fill"),
    "graze/broad/pair_search.hpp": ("tests/broad/pairs_test.cpp", "the method behind overlapping_pairs"),
    "graze/broad/bucket_sort.hpp": ("tests/broad/pair_sort_test.cpp", "what the sorting of pairs is made of"),
    "graze/broad/simd_choice.hpp": ("tests/broad/block_kernels_test.cpp", "one macro, whose sets the tests force one by one"),
    "graze/broad/simd_lanes-inl.hpp": ("tests/broad/block_kernels_test.cpp", "names for vectors, which all kernels use"),
    "graze/broad/box_lanes-inl.hpp": ("tests/broad/block_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/simd_compress-inl.hpp": ("tests/broad/center_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/pair_writer-inl.hpp": ("tests/broad/meet_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/touched_lanes-inl.hpp": ("tests/broad/meet_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/bvh_near-inl.hpp": ("tests/broad/bvh_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/bvh_ray-inl.hpp": ("tests/broad/bvh_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/cell_codes-inl.hpp": ("tests/broad/cell_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/prefetch.hpp": ("tests/broad/crowd_test.cpp", "changes nothing but the time"),
    "graze/broad/manifolds.hpp": ("tests/broad/contacts_test.cpp", "instances of manifold(), which contacts calls"),
    "graze/broad/manifolds_2d.cpp": ("tests/broad/contacts_test.cpp", "the same"),
    "graze/broad/manifolds_3d.cpp": ("tests/broad/contacts_test.cpp", "the same"),
    "graze/broad/pair_tasks.hpp": ("tests/broad/touching_pairs_test.cpp", "what it refuses, and the same from any executor"),
    "graze/broad/relations.hpp": ("tests/broad/touching_pairs_test.cpp", "instances of relation(), for all who ask it"),
    "graze/broad/round_contacts-inl.hpp": ("tests/broad/primitive_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/round_lanes-inl.hpp": ("tests/broad/primitive_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/ball_box_lanes-inl.hpp": ("tests/broad/primitive_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/aabb_contacts-inl.hpp": ("tests/broad/primitive_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/axis_over_face-inl.hpp": ("tests/broad/primitive_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/capsule_boxes-inl.hpp": ("tests/broad/primitive_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/way_out-inl.hpp": ("tests/broad/primitive_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/contact_groups-inl.hpp": ("tests/broad/primitive_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/flat_aabb_lanes-inl.hpp": ("tests/broad/flat_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/flat_ball_lanes-inl.hpp": ("tests/broad/flat_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/flat_contacts-inl.hpp": ("tests/broad/flat_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/flat_core_lanes-inl.hpp": ("tests/broad/flat_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/flat_touch_lanes-inl.hpp": ("tests/broad/flat_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/touch_boxes-inl.hpp": ("tests/broad/touch_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/touch_lanes-inl.hpp": ("tests/broad/touch_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/touch_round-inl.hpp": ("tests/broad/touch_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/manifold_axes-inl.hpp": ("tests/broad/manifold_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/manifold_lines-inl.hpp": ("tests/broad/manifold_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/manifold_looks-inl.hpp": ("tests/broad/manifold_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/manifold_choice-inl.hpp": ("tests/broad/manifold_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/manifold_clip-inl.hpp": ("tests/broad/manifold_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/manifold_edges-inl.hpp": ("tests/broad/manifold_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/manifold_faces-inl.hpp": ("tests/broad/manifold_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/manifold_lanes-inl.hpp": ("tests/broad/manifold_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/manifold_points-inl.hpp": ("tests/broad/manifold_kernels_test.cpp", "what the kernels are made of"),
    "graze/broad/executor_alone.cpp": ("tests/broad/executor_test.cpp", "what executor.hpp promises, where there is no oneTBB"),
    "graze/broad/executor_tbb.cpp": ("tests/broad/executor_test.cpp", "what executor.hpp promises, by oneTBB"),
    "graze/broad/simd_wasm_doubles-inl.hpp": ("bindings/wasm/test/pairs.test.mjs", "compiled for WebAssembly only"),
    "graze/query/paired.hpp": ("tests/query/ray_filters_test.cpp", "what the filters of rays calculate with"),
    "graze/query/ray_ball_filter.hpp": ("tests/query/ray_filters_test.cpp", "one of the filters of rays"),
    "graze/query/ray_capsule_filter.hpp": ("tests/query/ray_filters_test.cpp", "one of the filters of rays"),
    "graze/query/ray_obb_filter.hpp": ("tests/query/ray_filters_test.cpp", "one of the filters of rays"),
    "graze/query/ray_plane_filter.hpp": ("tests/query/ray_filters_test.cpp", "one of the filters of rays"),
    "graze/query/ray_polygon_filter.hpp": ("tests/query/ray_filters_test.cpp", "one of the filters of rays"),
    "graze/query/ray_rectangle_filter.hpp": ("tests/query/ray_filters_test.cpp", "one of the filters of rays"),
    "graze/query/ray_slab_filter.hpp": ("tests/query/ray_box_filter_test.cpp", "what the filters of boxes are made of"),
    "graze/query/ray_careful.hpp": ("tests/query/ray_cast_test.cpp", "ray_cast where no filter settles it"),
    "graze/query/ray_hit.hpp": ("tests/query/ray_cast_test.cpp", "structs without functions: what ray_cast is asked and gives"),
    "graze/query/ray_hit_lanes.hpp": ("tests/query/ray_box_filter_test.cpp", "writes what the filters of rays find"),
    "graze/query/axis_over_face.hpp": ("tests/query/capsule_touch_test.cpp", "what the look at capsules is made of"),
    "graze/query/touch_look.hpp": ("tests/query/quick_touch_test.cpp", "a struct that every quick look fills"),
    "graze/query/patch_of_shape.hpp": ("tests/query/manifold_test.cpp", "which patch is whose, for manifolds"),
    "graze/query/strike_of_hit.hpp": ("tests/query/shape_cast_test.cpp", "what shape_cast makes of rays"),
    "graze/query/status.hpp": ("tests/query/gjk_test.cpp", "an enum without functions: it is how gjk and epa end"),
    "graze/scene/single_queries.hpp": ("tests/scene/plain_scene_test.cpp", "instances of what PlainScene asks"),
    "graze/shape/hull_flat.hpp": ("tests/shape/hull_vertices_test.cpp", "the corners of flat points"),
    "graze/shape/hull_input.hpp": ("tests/shape/polytope_test.cpp", "what convex_hull refuses"),
    "graze/shape/lexicographic.hpp": ("tests/shape/polytope_test.cpp", "the order of a polytope's vertices"),
    "graze/shape/monotone_chain.hpp": ("tests/shape/polytope_test.cpp", "convex_hull in the plane"),
    "graze/shape/quickhull.hpp": ("tests/shape/hull_faces_test.cpp", "the method behind hull_faces"),
}


def layer_of(path):
    """The layer of a file under graze/<layer>/, or None."""
    return path.parts[1] if len(path.parts) == 3 and path.parts[0] == "graze" and path.parts[1] in LAYERS else None


def include_problem(root, path, name, quoted):
    """What is wrong with `#include name` in the file `path`, or None."""
    layer = layer_of(path)
    if name.startswith("glm/") and path.parts[0] == "graze" and path != GLM_DOOR:
        return f"includes GLM ({name}); only {GLM_DOOR} may, include that"
    if not name.startswith("graze/"):
        third_party = not quoted and ("/" in name or "." in name) and not name.startswith("glm/")
        if layer in GEOMETRY and third_party:
            return f"includes {name}, but graze::geometry ({', '.join(GEOMETRY)}) may need GLM alone"
        return None
    if not (root / name).is_file():
        return f"includes {name}, which does not exist"
    if layer is None:
        return None
    included = layer_of(Path(name))
    if included is None:
        return f"includes {name}, which stands above every layer"
    if LAYERS.index(included) > LAYERS.index(layer):
        return f"includes upwards: {name}; {layer} may include {', '.join(LAYERS[: LAYERS.index(layer) + 1])}"
    return None


def check_includes(root, sources):
    problems = []
    for path in sources:
        if not path.name.endswith((".hpp", ".cpp", ".cpp.in")):
            continue
        for line, name, quoted in includes((root / path).read_text(encoding="utf-8")):
            problem = include_problem(root, path, name, quoted)
            if problem:
                problems.append(f"{path}:{line}: {problem}")
    return problems


def check_throws(root, sources):
    """graze::geometry is also compiled without exceptions, so its headers throw by the macro that knows."""
    problems = []
    for path in sources:
        if layer_of(path) not in GEOMETRY or path.name == "throw.hpp":
            continue
        for number, line in enumerate((root / path).read_text(encoding="utf-8").splitlines(), 1):
            if not line.startswith("#") and re.search(r"\b(throw|try|catch)\b", line.split("//")[0]):
                problems.append(f"{path}:{number}: throws or catches by itself; use GRAZE_THROW (graze/math/throw.hpp)")
    return problems


def check_text(root, sources):
    problems = []
    for path in sources:
        lines = (root / path).read_text(encoding="utf-8").splitlines()
        if not any(SPDX in line for line in lines[:2]):
            problems.append(f"{path}:1: the first line (the second after #!) must say {SPDX}")
        if len(lines) > MAX_LINES:
            problems.append(f"{path}:{MAX_LINES + 1}: has {len(lines)} lines; split it by operation, {MAX_LINES} are the limit")
    return problems


def check_mirror_tests(root, sources, tested_elsewhere):
    problems = []
    layered = [path for path in sources if path.suffix in (".hpp", ".cpp") and layer_of(path)]
    for path in layered:
        test = Path("tests") / layer_of(path) / f"{path.stem}_test.cpp"
        other = tested_elsewhere.get(str(path.with_suffix(".hpp"))) or tested_elsewhere.get(str(path))
        if other and (root / test).is_file():
            problems.append(f"tools/check_layers.py:1: {path} has {test} now; remove its row from TESTED_ELSEWHERE")
        elif other and not (root / other[0]).is_file():
            problems.append(f"tools/check_layers.py:1: {path} is to be tested by {other[0]}, which does not exist")
        elif not other and not (root / test).is_file():
            problems.append(f"{path}:1: has no mirror test; write {test}")
    known = {str(path) for path in layered}
    problems += [f"tools/check_layers.py:1: TESTED_ELSEWHERE names {name}, which does not exist"
                 for name in tested_elsewhere if name not in known]
    return problems, len(layered)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--root", type=Path, default=ROOT, help="the project's folder")
    parser.add_argument("--compiler", default="g++", help="compiles the headers alone (default: g++)")
    options = parser.parse_args()
    root = options.root.resolve()

    sources = project_files(root, SOURCES)
    problems = check_includes(root, sources) + check_throws(root, sources) + check_text(root, sources)
    mirror_problems, mirrored = check_mirror_tests(root, sources, TESTED_ELSEWHERE if root == ROOT else {})
    problems += mirror_problems
    compiled = 0
    if shutil.which(options.compiler):
        header_problems, compiled = compile_headers(root, options.compiler)
        problems += header_problems
    else:
        problems.append(f"tools/check_layers.py:1: there is no {options.compiler} to compile the headers with")
    for problem in problems:
        print(problem, file=sys.stderr)
    print(f"layers: {len(sources)} files read, {mirrored} sources with mirror tests, {compiled} headers compiled alone, "
          f"{len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
