// SPDX-License-Identifier: MIT
// Which edges and corners of a hull's triangles are those of the hull.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <graze/shape/hull/quickhull.hpp>

namespace graze::detail {

/// For each half-edge, whether the triangles on both sides are not coplanar.
template <class T>
std::vector<bool> bent_edges(const Quickhull<T>& hull) {
  std::vector<bool> are_bent(4 * hull.faces().size(), false);
  for (std::uint32_t face = 0; face < hull.faces().size(); ++face) {
    if (!hull.faces()[face].is_alive) continue;
    for (std::uint32_t edge = 4 * face; edge < 4 * face + 3; ++edge) {
      const std::uint32_t twin = hull.twin(edge);
      if (twin < edge) continue;
      are_bent[edge] = hull.is_bent(edge);
      are_bent[twin] = are_bent[edge];
    }
  }
  return are_bent;
}

/// Whether each corner of a hull's triangles is a corner of the hull. At a corner, at least three planes meet, in as
/// many bent edges; inside an edge of the hull two meet, inside a flat part none.
template <class T>
std::vector<bool> are_vertices(const Quickhull<T>& hull, const std::vector<bool>& are_bent) {
  constexpr std::uint8_t enough = 3;
  std::vector<std::uint8_t> counts(hull.corners().size(), 0);
  for (std::uint32_t edge = 0; edge < are_bent.size(); ++edge) {
    if (!are_bent[edge]) continue;
    std::uint8_t& count = counts[hull.origin(edge)];
    if (count < enough) ++count;
  }
  std::vector<bool> result(counts.size());
  std::transform(counts.begin(), counts.end(), result.begin(), [](std::uint8_t count) { return count == enough; });
  return result;
}

}  // namespace graze::detail
