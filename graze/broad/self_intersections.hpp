// SPDX-License-Identifier: MIT
/// @file
/// self_intersections(mesh): where a mesh crosses itself.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <graze/broad/pair.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/faces/meeting_triangles.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/mesh.hpp>

namespace graze {

/// Calls visit(Pair), which returns whether to go on, for all pairs of faces that share more than their common vertices
/// and edges, in any order. Vertices are common if their indices are equal; so faces with the same three vertices, in
/// any order, intersect, and faces that meet in vertices of other indices, too (see `welded`). Decided exactly for the
/// numbers as stored. Returns whether all were visited.
template <Dim N, class T, class Visit>
bool visit_self_intersections(const Mesh<N, T>& mesh, const Visit& visit) {
  const detail::PlacedMesh<N, T>& faces = detail::placed(mesh);
  const auto visit_if_crossing = [&](std::uint32_t a, std::uint32_t b) {
    const auto corners_a = faces.triangle(a).vertices();
    const auto corners_b = faces.triangle(b).vertices();
    const detail::CommonVertices common = detail::common_vertices(mesh.faces()[a], mesh.faces()[b]);
    return !detail::do_faces_cross(corners_a, corners_b, common) || visit(Pair{std::min(a, b), std::max(a, b)});
  };
  return detail::visit_near_faces(faces, visit_if_crossing);
}

/// All pairs of faces that share more than their common vertices and edges, ascending.
template <Dim N, class T>
std::vector<Pair> self_intersections(const Mesh<N, T>& mesh) {
  std::vector<Pair> pairs;
  visit_self_intersections(mesh, [&pairs](const Pair& pair) {
    pairs.push_back(pair);
    return true;
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace graze
