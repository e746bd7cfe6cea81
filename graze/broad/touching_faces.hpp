// SPDX-License-Identifier: MIT
/// @file
/// touching_faces(a, b): which faces of two meshes share a point.
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

/// Calls visit(Pair{face of a, face of b}), which returns whether to go on, for all pairs of faces that share a point,
/// in any order. Decided exactly for the numbers as stored (of moved meshes, their `vertices()`), so `intersects`
/// affirms whatever is found. Only faces count, not the inside of solids. Returns whether all were visited.
template <Dim N, class T, class Visit>
bool visit_touching_faces(const Mesh<N, T>& a, const Mesh<N, T>& b, const Visit& visit) {
  const detail::PlacedMesh<N, T>& faces_a = detail::placed(a);
  const detail::PlacedMesh<N, T>& faces_b = detail::placed(b);
  const auto visit_if_touching = [&](std::uint32_t face_a, std::uint32_t face_b) {
    const auto corners_a = faces_a.triangle(face_a).vertices();
    const auto corners_b = faces_b.triangle(face_b).vertices();
    return !detail::do_triangles_meet(corners_a, corners_b) || visit(Pair{face_a, face_b});
  };
  return detail::visit_near_faces(faces_a, faces_b, visit_if_touching);
}

/// All pairs of faces of two meshes that share a point, ascending.
template <Dim N, class T>
std::vector<Pair> touching_faces(const Mesh<N, T>& a, const Mesh<N, T>& b) {
  std::vector<Pair> pairs;
  visit_touching_faces(a, b, [&pairs](const Pair& pair) {
    pairs.push_back(pair);
    return true;
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace graze
