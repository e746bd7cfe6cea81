// SPDX-License-Identifier: MIT
/// @file
/// report(mesh): what is unusual about a mesh. Nothing of it keeps a mesh from being used.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/mesh.hpp>
#include <graze/shape/mesh/flat_triangle.hpp>
#include <graze/shape/mesh/open_edges.hpp>

namespace graze {

/// Counts of what `report` finds. Vertices and edges are the same only if their indices are. An edge between equal
/// vertices does not count.
struct MeshReport {
  std::size_t open_edges = 0;          ///< Edges of a single face.
  std::size_t non_manifold_edges = 0;  ///< Edges of more than two faces.
  std::size_t flipped_edges = 0;       ///< Edges of two faces that both run along it in the same direction.
  std::size_t degenerate_faces = 0;    ///< Faces whose corners are collinear or equal, which is decided exactly.
  std::size_t duplicate_faces = 0;     ///< Faces with the same three vertices, in any order, as one before.
  std::size_t unused_vertices = 0;     ///< Vertices of no face.
  std::size_t components = 0;          ///< Groups of faces that hang together by common vertices.
  /// Whether each edge is used as often in one direction as in the other, so that winding numbers are integers.
  bool is_closed = true;

  friend bool operator==(const MeshReport&, const MeshReport&) = default;
};

namespace detail {

inline std::size_t count_duplicates(std::span<const std::array<std::uint32_t, 3>> faces) {
  std::vector<std::array<std::uint32_t, 3>> sorted(faces.begin(), faces.end());
  for (std::array<std::uint32_t, 3>& face : sorted) std::sort(face.begin(), face.end());
  std::sort(sorted.begin(), sorted.end());
  return static_cast<std::size_t>(sorted.end() - std::unique(sorted.begin(), sorted.end()));
}

}  // namespace detail

/// What is unusual about a mesh; a closed one without faults has zero everywhere but in `components`. Takes time
/// n log n in the number of faces.
template <Dim N, class T>
MeshReport report(const Mesh<N, T>& mesh) {
  MeshReport result;
  const std::vector<detail::EdgeUse> all = detail::sorted_edge_uses(mesh.faces());
  detail::for_each_edge(all, [&result](std::span<const detail::EdgeUse> uses) {
    std::int64_t sum = 0;
    for (const detail::EdgeUse& use : uses) sum += use.way;
    result.is_closed = result.is_closed && sum == 0;
    if (uses.size() == 1) ++result.open_edges;
    if (uses.size() > 2) ++result.non_manifold_edges;
    if (uses.size() == 2 && sum != 0) ++result.flipped_edges;
  });
  std::vector<bool> is_used(mesh.vertices().size(), false);
  for (std::size_t face = 0; face < mesh.faces().size(); ++face) {
    for (const std::uint32_t vertex : mesh.faces()[face]) is_used[vertex] = true;
    if (detail::is_flat(mesh.triangle(face).vertices())) ++result.degenerate_faces;
  }
  result.unused_vertices = static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), false));
  result.duplicate_faces = detail::count_duplicates(mesh.faces());
  result.components = detail::placed(mesh).data()->vertices_of_components().size();
  return result;
}

}  // namespace graze
