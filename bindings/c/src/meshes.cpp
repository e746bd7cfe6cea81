// SPDX-License-Identifier: MIT
// Questions about meshes alone.
#include <graze/broad/self_intersections.hpp>
#include <graze/broad/touching_faces.hpp>
#include <graze/query/winding_number.hpp>
#include <graze/shape/mesh_report.hpp>

#include "arrays.hpp"
#include "results.hpp"
#include "shape_in.hpp"
#include "vectors.hpp"

using namespace graze;
using namespace graze::c;

graze_status graze_winding_number(const graze_shape* mesh, graze_vec point, double* out) {
  return guarded(__func__, [&] {
    double& result = required("out", out);
    result = on_mesh("mesh", mesh, [&]<Dim N, class T>(const Mesh<N, T>& in) {
      return winding_number(in, finite_in<N, T>("point", point));
    });
  });
}

graze_status graze_report_mesh(const graze_shape* mesh, graze_mesh_report* out) {
  return guarded(__func__, [&] {
    graze_mesh_report& result = required("out", out);
    const MeshReport found = on_mesh("mesh", mesh, [](const auto& in) { return report(in); });
    result.open_edges = found.open_edges;
    result.non_manifold_edges = found.non_manifold_edges;
    result.flipped_edges = found.flipped_edges;
    result.degenerate_faces = found.degenerate_faces;
    result.duplicate_faces = found.duplicate_faces;
    result.unused_vertices = found.unused_vertices;
    result.components = found.components;
    result.is_closed = found.is_closed;
  });
}

graze_status graze_touching_faces(const graze_shape* mesh_a, const graze_shape* mesh_b, graze_pair* out,
                                  size_t capacity, size_t* count) {
  return guarded(__func__, [&] {
    const Buffer<graze_pair> buffer(out, capacity, count);
    require_world("mesh_a", required("mesh_a", mesh_a).world, "mesh_b", required("mesh_b", mesh_b).world);
    return on_mesh("mesh_a", mesh_a, [&]<Dim N, class T>(const Mesh<N, T>& in_a) {
      if (mesh_b->kind != GRAZE_MESH) refuse_kind("mesh_b", mesh_b->kind, "a mesh");
      const ShapeIn<N, T> in_b("mesh_b", *mesh_b);
      return buffer.fill(touching_faces(in_a, *std::get_if<Mesh<N, T>>(&*in_b)), in_c);
    });
  });
}

graze_status graze_self_intersections(const graze_shape* mesh, graze_pair* out, size_t capacity, size_t* count) {
  return guarded(__func__, [&] {
    const Buffer<graze_pair> buffer(out, capacity, count);
    return on_mesh("mesh", mesh, [&](const auto& in) { return buffer.fill(self_intersections(in), in_c); });
  });
}
