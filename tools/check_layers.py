# SPDX-License-Identifier: MIT
"""Checks the structure of the project: includes between layers, mirror tests, self-contained headers."""

import argparse
import re
import shutil
import sys
from pathlib import Path

from compile_headers import compile_headers
from project_files import ROOT, includes, project_files

# Lowest first: a file includes its own layer and those before it. Folders outside graze/ may include all layers.
LAYERS = ["math", "shape", "query", "broad", "scene", "io"]
# An optional layer beside those above broad: it may include broad and what is below, and none of the others includes it.
DISTRIBUTED = "distributed"
BELOW_DISTRIBUTED = LAYERS[:LAYERS.index("broad") + 1]
# graze::geometry: these layers need only GLM, and only one file includes it.
GEOMETRY = LAYERS[:3]
GLM_DOOR = Path("graze/math/vec.hpp")
MAX_LINES = 450

SPDX = "SPDX-License-Identifier: MIT"
SOURCES = [".hpp", ".cpp", ".cpp.in", ".h", ".c", ".py", ".sh", ".cmake", ".cmake.in", "CMakeLists.txt", "dev", ".ci/run"]

# Files without their own mirror test: the test file that covers them, and the reason. Parts of kernels (`-inl.hpp`) are
# tested with the kernels.
TESTED_ELSEWHERE = {
    "graze/math/lanes/lane_vec.hpp": ("tests/query/closest/triangle_lanes_test.cpp", "used by the tests of triangles"),
    "graze/math/lanes/paired.hpp": ("tests/query/ray/filters_test.cpp", "used by the ray filters"),
    "graze/math/platform/compiler.hpp": ("tests/package/test_compiler.py", "refuses compilers and flags"),
    "graze/math/platform/export.hpp": ("tests/package/exports/test_exports.py", "what a shared library exports"),
    "graze/math/platform/has_lanes.hpp": ("tests/math/lanes/lanes_test.cpp", "two macros that lanes.hpp uses"),
    "graze/math/platform/throw.hpp": ("tests/package/test_compiler.py", "errors without exceptions"),
    "graze/shape/mesh/components.hpp": ("tests/shape/mesh_report_test.cpp", "counted by report"),
    "graze/shape/mesh/flat_triangle.hpp": ("tests/shape/mesh_report_test.cpp", "counted by report"),
    "graze/shape/mesh/open_edges.hpp": ("tests/shape/mesh_report_test.cpp", "counted by report"),
    "graze/shape/mesh/placed_mesh.hpp": ("tests/shape/mesh_test.cpp", "what a mesh points to"),
    "graze/shape/parts/reach_lanes.hpp": ("tests/shape/mesh_test.cpp", "the boxes of moved meshes"),
    "graze/shape/parts/box_visit.hpp": ("tests/shape/parts/part_tree_test.cpp", "BoxTree::visit"),
    "graze/shape/parts/may_matter.hpp": ("tests/shape/parts/part_tree_test.cpp", "what a tree asks about its boxes"),
    "graze/shape/parts/pieces.hpp": ("tests/shape/mesh_test.cpp", "the same mesh from every executor"),
    "graze/shape/parts/grown_box.hpp": ("tests/query/bounds_test.cpp", "touching_bounds"),
    "graze/query/contact/deciding_contact.hpp": ("tests/query/mesh_laws_test.cpp", "contacts of meshes"),
    "graze/query/faces/meeting_triangles.hpp": ("tests/broad/touching_faces_test.cpp", "faces that touch or cross"),
    "graze/query/mesh_hit.hpp": ("tests/query/mesh_laws_test.cpp", "the hits of meshes"),
    "graze/query/parts/on_way.hpp": ("tests/query/winding_number_test.cpp", "faces on the way from a point"),
    "graze/query/parts/may_be_near.hpp": ("tests/query/parts/visit_test.cpp", "which parts a point may be near to"),
    "graze/query/parts/inside.hpp": ("tests/query/mesh_laws_test.cpp", "what is inside a solid mesh"),
    "graze/query/ray/simple_shape.hpp": ("tests/query/ray_cast_test.cpp", "ray_cast where no filter decides"),
    "graze/query/scaling/mapped.hpp": ("tests/query/scaling/range_test.cpp", "shapes whose numbers are scaled"),
    "graze/broad/closest_points.hpp": ("tests/broad/batch/answers_test.cpp", "one question to many"),
    "graze/broad/ray_casts.hpp": ("tests/broad/batch/answers_test.cpp", "one question to many"),
    "graze/broad/signed_distances.hpp": ("tests/broad/batch/answers_test.cpp", "one question to many"),
    "graze/broad/winding_numbers.hpp": ("tests/broad/batch/answers_test.cpp", "one question to many"),
    "graze/shape/fields/transformed.hpp": ("tests/query/transformed_test.cpp", "moves every shape"),
    "graze/shape/hull/flat_points.hpp": ("tests/shape/hull/vertices_test.cpp", "the corners of flat points"),
    "graze/shape/hull/input.hpp": ("tests/shape/polytope_test.cpp", "the arguments that convex_hull refuses"),
    "graze/shape/hull/lexicographic.hpp": ("tests/shape/polytope_test.cpp", "the order of a polytope's vertices"),
    "graze/shape/hull/monotone_chain.hpp": ("tests/shape/polytope_test.cpp", "convex_hull in 2D"),
    "graze/shape/hull/quickhull.hpp": ("tests/shape/hull/faces_test.cpp", "the method behind hull_faces"),
    "graze/query/cast/cast_hit.hpp": ("tests/query/shape_cast_test.cpp", "shape_cast by a ray"),
    "graze/query/cast/moving_parts.hpp": ("tests/query/parts/visit_test.cpp", "shape_cast of compounds"),
    "graze/query/closest/nearest_part.hpp": ("tests/query/parts/visit_test.cpp", "closest_points of compounds"),
    "graze/query/cast/pair_cast.hpp": ("tests/query/shape_cast_test.cpp", "shape_cast of each pair of types"),
    "graze/query/compiled/instances.hpp":
        ("tests/package/consumer/queries.cpp", "the queries that a user's file takes from the library"),
    "graze/query/compiled/pairs_2d_double.cpp": ("tests/query/agreement_test.cpp", "instances of the queries under test"),
    "graze/query/compiled/pairs_2d_float.cpp": ("tests/query/agreement_test.cpp", "instances of the queries under test"),
    "graze/query/compiled/pairs_3d_double.cpp": ("tests/query/agreement_test.cpp", "instances of the queries under test"),
    "graze/query/compiled/pairs_3d_float.cpp": ("tests/query/agreement_test.cpp", "instances of the queries under test"),
    "graze/query/compiled/searches.cpp": ("tests/query/epa_test.cpp", "instances of the searches under test"),
    "graze/query/compiled/singles_2d.cpp": ("tests/query/agreement_test.cpp", "instances of the queries under test"),
    "graze/query/compiled/singles_3d.cpp": ("tests/query/agreement_test.cpp", "instances of the queries under test"),
    "graze/query/fast_contact/cores_2d.hpp":
        ("tests/query/fast_contact/boxes_2d_test.cpp", "used by 2D contacts"),
    "graze/query/fast_contact/fast_result.hpp":
        ("tests/query/fast_contact/fast_contact_test.cpp", "a struct that every fast contact fills"),
    "graze/query/fast_contact/one_pair.hpp":
        ("tests/query/fast_contact/sphere_box_test.cpp", "the numbers that fast contacts calculate with"),
    "graze/query/fast_contact/sphere_2d.hpp":
        ("tests/query/fast_contact/boxes_2d_test.cpp", "compared there with all shapes"),
    "graze/query/patch/pair_manifold.hpp": ("tests/query/manifold_test.cpp", "manifold of each pair of types"),
    "graze/query/patch/of_shape.hpp": ("tests/query/manifold_test.cpp", "selects the patch of each shape"),
    "graze/query/ray/careful.hpp": ("tests/query/ray_cast_test.cpp", "ray_cast where no filter decides"),
    "graze/query/ray/filter/capsule.hpp": ("tests/query/ray/filters_test.cpp", "one of the filters of rays"),
    "graze/query/ray/filter/obb.hpp": ("tests/query/ray/filters_test.cpp", "one of the filters of rays"),
    "graze/query/ray/filter/plane.hpp": ("tests/query/ray/filters_test.cpp", "one of the filters of rays"),
    "graze/query/ray/filter/polygon.hpp": ("tests/query/ray/filters_test.cpp", "one of the filters of rays"),
    "graze/query/ray/filter/rectangle.hpp": ("tests/query/ray/filters_test.cpp", "one of the filters of rays"),
    "graze/query/ray/filter/slab.hpp": ("tests/query/ray/filter/box_test.cpp", "used by the filters of boxes"),
    "graze/query/ray/filter/sphere.hpp": ("tests/query/ray/filters_test.cpp", "one of the filters of rays"),
    "graze/query/ray/hit_lanes.hpp": ("tests/query/ray/filter/box_test.cpp", "writes the results of the ray filters"),
    "graze/query/ray/parts.hpp": ("tests/query/parts/visit_test.cpp", "ray_cast of compounds"),
    "graze/query/ray_hit.hpp":
        ("tests/query/ray_cast_test.cpp", "structs without functions, for ray_cast"),
    "graze/query/simplex_cache.hpp": ("tests/query/closest/hulls_test.cpp", "a struct that the queries fill"),
    "graze/query/status.hpp": ("tests/query/gjk_test.cpp", "an enum without functions, returned by gjk and epa"),
    "graze/broad/executor/alone.cpp":
        ("tests/broad/executor_test.cpp", "executor.hpp without oneTBB"),
    "graze/broad/executor/tbb.cpp": ("tests/broad/executor_test.cpp", "executor.hpp with oneTBB"),
    "graze/broad/memory/prefetch.hpp": ("tests/broad/pairs/cluster_test.cpp", "affects only the speed"),
    "graze/broad/pair.hpp": ("tests/broad/pairs_test.cpp", "a struct without functions, returned by overlapping_pairs"),
    "graze/broad/pairs/bucket_sort.hpp": ("tests/broad/pairs/pair_sort_test.cpp", "used by the sorting of pairs"),
    "graze/broad/pairs/pair_search.hpp": ("tests/broad/pairs_test.cpp", "the method behind overlapping_pairs"),
    "graze/broad/pairs/pair_sink.hpp":
        ("tests/broad/pairs/dense_search_test.cpp", "a function type that both methods use"),
    "graze/broad/simd/block.hpp":
        ("tests/broad/pairs/block_tree_test.cpp", "structs without functions, for the tree"),
    "graze/broad/simd/choice.hpp":
        ("tests/broad/pairs/block_kernels_test.cpp", "one macro, whose values the tests force in turn"),
    "graze/broad/touching/pair_tasks.hpp":
        ("tests/broad/touching_pairs_test.cpp", "invalid arguments, and equal results with any executor"),
    "graze/distributed/id_pair.hpp":
        ("tests/distributed/overlapping_pairs_test.cpp", "a struct without functions, returned by overlapping_pairs"),
    "graze/scene/storage/hit_with_face.hpp": ("tests/scene/scene_ray_test.cpp", "ray casts of scenes"),
    "graze/scene/storage/meets_inflated.hpp": ("tests/scene/plain_scene_test.cpp", "the test of boxes for PlainScene"),
    "graze/io/gltf/accessors.cpp": ("tests/io/gltf/reader_test.cpp", "the numbers of whole files"),
    "graze/io/gltf/accessors.hpp": ("tests/io/gltf/reader_test.cpp", "the numbers of whole files"),
    "graze/io/gltf/meshes.cpp": ("tests/io/gltf/reader_test.cpp", "the meshes of whole files"),
    "graze/io/gltf/meshes.hpp": ("tests/io/gltf/reader_test.cpp", "the meshes of whole files"),
    "graze/io/gltf/root.cpp": ("tests/io/gltf/reader_test.cpp", "the arrays of whole files"),
    "graze/io/gltf/root.hpp": ("tests/io/gltf/reader_test.cpp", "the arrays of whole files"),
    "graze/io/gltf/writer.cpp": ("tests/io/mesh_file_test.cpp", "what is written is read back"),
    "graze/io/gltf/writer.hpp": ("tests/io/mesh_file_test.cpp", "what is written is read back"),
    "graze/io/mesh/joined.cpp": ("tests/io/mesh_file_test.cpp", "used by the writers"),
    "graze/io/mesh/joined.hpp": ("tests/io/mesh_file_test.cpp", "used by the writers"),
    "graze/io/mesh/shared_triangles.hpp": ("tests/io/mesh_file_test.cpp", "meshes that are made solid and scaled"),
    "graze/io/obj/writer.cpp": ("tests/io/mesh_file_test.cpp", "what is written is read back"),
    "graze/io/obj/writer.hpp": ("tests/io/mesh_file_test.cpp", "what is written is read back"),
    "graze/io/off/header.hpp": ("tests/io/off/reader_test.cpp", "the first word of whole files"),
    "graze/io/off/writer.cpp": ("tests/io/mesh_file_test.cpp", "what is written is read back"),
    "graze/io/off/writer.hpp": ("tests/io/mesh_file_test.cpp", "what is written is read back"),
    "graze/io/ply/header.cpp": ("tests/io/ply/reader_test.cpp", "the headers of whole files"),
    "graze/io/ply/header.hpp": ("tests/io/ply/reader_test.cpp", "the headers of whole files"),
    "graze/io/ply/values.cpp": ("tests/io/ply/reader_test.cpp", "the numbers of whole files"),
    "graze/io/ply/values.hpp": ("tests/io/ply/reader_test.cpp", "the numbers of whole files"),
    "graze/io/ply/writer.cpp": ("tests/io/mesh_file_test.cpp", "what is written is read back"),
    "graze/io/ply/writer.hpp": ("tests/io/mesh_file_test.cpp", "what is written is read back"),
    "graze/io/stl/layout.hpp": ("tests/io/stl/reader_test.cpp", "constants"),
    "graze/io/stl/writer.cpp": ("tests/io/mesh_file_test.cpp", "what is written is read back"),
    "graze/io/stl/writer.hpp": ("tests/io/mesh_file_test.cpp", "what is written is read back"),
}


def layer_of(path):
    """The layer of a file under graze/<layer>/, or None."""
    return path.parts[1] if len(path.parts) >= 3 and path.parts[0] == "graze" and path.parts[1] in [*LAYERS, DISTRIBUTED] else None


def is_public(path):
    """Whether a header is public API: directly in a layer's folder, not in a sub-folder."""
    return path.suffix == ".hpp" and path.parts[0] == "graze" and len(path.parts) <= 3


def is_of_cpp(name):
    """Whether an include is a header of C++: of the project, or of the standard library, which has no suffix."""
    return name.endswith(".hpp") or "." not in name


def include_problem(root, path, name, quoted):
    """A problem of `#include name` in the file `path`, or None."""
    layer = layer_of(path)
    if name.startswith("glm/") and path.parts[0] == "graze" and path != GLM_DOOR:
        return f"includes GLM ({name}); only {GLM_DOOR} may; include that"
    if path.suffix in (".h", ".c") and is_of_cpp(name):
        return f"includes {name}, which is C++; the C interface may include C alone"
    if not name.startswith("graze/"):
        third_party = not quoted and ("/" in name or "." in name) and not name.startswith("glm/")
        if layer in GEOMETRY and third_party:
            return f"includes {name}, but graze::geometry ({', '.join(GEOMETRY)}) may need only GLM"
        return None
    if not (root / name).is_file():
        return f"includes {name}, which does not exist"
    if path.parts[0] == "examples" and not is_public(Path(name)):
        return f"includes {name}, which is internal; an example may only use public headers"
    if layer is None:
        return None
    included = layer_of(Path(name))
    if included is None:
        return f"includes {name}, which is above every layer"
    allowed = [*BELOW_DISTRIBUTED, DISTRIBUTED] if layer == DISTRIBUTED else LAYERS[: LAYERS.index(layer) + 1]
    if included not in allowed:
        return f"includes upwards: {name}; {layer} may include {', '.join(allowed)}"
    return None


def check_includes(root, sources):
    problems = []
    for path in sources:
        if not path.name.endswith((".hpp", ".cpp", ".cpp.in", ".h", ".c")):
            continue
        for line, name, quoted in includes((root / path).read_text(encoding="utf-8")):
            problem = include_problem(root, path, name, quoted)
            if problem:
                problems.append(f"{path}:{line}: {problem}")
    return problems


def check_public_headers(root, sources):
    """A header without public declarations belongs in a sub-folder."""
    problems = []
    for path in sources:
        if layer_of(path) and is_public(path):
            namespaces = re.findall(r"^namespace ([\w:]+) {", (root / path).read_text(encoding="utf-8"), re.MULTILINE)
            if namespaces and all("detail" in name.split("::") for name in namespaces):
                problems.append(f"{path}:1: declares nothing public; move it into a sub-folder of graze/{layer_of(path)}")
    return problems


def check_throws(root, sources):
    """graze::geometry also compiles without exceptions, so its headers throw with a macro."""
    problems = []
    for path in sources:
        if layer_of(path) not in GEOMETRY or path.name == "throw.hpp":
            continue
        for number, line in enumerate((root / path).read_text(encoding="utf-8").splitlines(), 1):
            if not line.startswith("#") and re.search(r"\b(throw|try|catch)\b", line.split("//")[0]):
                problems.append(f"{path}:{number}: uses throw, try or catch; use GRAZE_THROW (math/platform/throw.hpp)")
    return problems


def check_text(root, sources):
    problems = []
    for path in sources:
        lines = (root / path).read_text(encoding="utf-8").splitlines()
        if not any(SPDX in line for line in lines[:2]):
            problems.append(f"{path}:1: the first line (the second after #!) must say {SPDX}")
        if len(lines) > MAX_LINES:
            problems.append(f"{path}:{MAX_LINES + 1}: has {len(lines)} lines; split it by operation; the limit is {MAX_LINES}")
    return problems


def check_mirror_tests(root, sources, tested_elsewhere):
    problems = []
    layered = [path for path in sources
               if path.suffix in (".hpp", ".cpp") and layer_of(path) and not path.stem.endswith("-inl")]
    for path in layered:
        test = Path("tests") / path.relative_to("graze").with_name(f"{path.stem}_test.cpp")
        other = tested_elsewhere.get(str(path.with_suffix(".hpp"))) or tested_elsewhere.get(str(path))
        if other and (root / test).is_file():
            problems.append(f"tools/check_layers.py:1: {path} now has {test}; remove its row from TESTED_ELSEWHERE")
        elif other and not (root / other[0]).is_file():
            problems.append(f"tools/check_layers.py:1: {path} should be tested by {other[0]}, which does not exist")
        elif not other and not (root / test).is_file():
            problems.append(f"{path}:1: has no mirror test; write {test}")
    known = {str(path) for path in layered}
    problems += [f"tools/check_layers.py:1: TESTED_ELSEWHERE names {name}, which does not exist"
                 for name in tested_elsewhere if name not in known]
    return problems, len(layered)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--root", type=Path, default=ROOT, help="root folder of the project")
    parser.add_argument("--compiler", default="g++", help="the compiler for the check of headers (default: g++)")
    options = parser.parse_args()
    root = options.root.resolve()

    sources = project_files(root, SOURCES)
    problems = check_includes(root, sources) + check_public_headers(root, sources)
    problems += check_throws(root, sources) + check_text(root, sources)
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
