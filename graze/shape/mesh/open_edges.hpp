// SPDX-License-Identifier: MIT
// The edges of triangles, and those at which a surface ends.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace graze::detail {

/// One side of an edge in a face: `from` is the lesser vertex, `way` is 1 if the face runs from there to `to`, else -1.
struct EdgeUse {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::int32_t way = 0;

  bool is_along(const EdgeUse& other) const { return from == other.from && to == other.to; }
};

/// An edge that faces use more often from `from` to `to` than back, and by how much.
struct OpenEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::int32_t count = 0;
};

/// All sides of all faces, except those between equal vertices, sorted so that uses of one edge are neighbours.
inline std::vector<EdgeUse> sorted_edge_uses(std::span<const std::array<std::uint32_t, 3>> faces) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * faces.size());
  for (const std::array<std::uint32_t, 3>& face : faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t start = face[i];
      const std::uint32_t end = face[(i + 1) % 3];
      if (start != end) uses.push_back({std::min(start, end), std::max(start, end), start < end ? 1 : -1});
    }
  }
  std::sort(uses.begin(), uses.end(),
            [](const EdgeUse& a, const EdgeUse& b) { return std::pair(a.from, a.to) < std::pair(b.from, b.to); });
  return uses;
}

/// Calls visit(uses of one edge) for each edge.
template <class Visit>
void for_each_edge(std::span<const EdgeUse> uses, const Visit& visit) {
  for (std::size_t begin = 0; begin < uses.size();) {
    std::size_t end = begin + 1;
    while (end < uses.size() && uses[end].is_along(uses[begin])) ++end;
    visit(uses.subspan(begin, end - begin));
    begin = end;
  }
}

/// The boundary of the faces as a chain: none if it is closed.
inline std::vector<OpenEdge> open_edges_of(std::span<const std::array<std::uint32_t, 3>> faces) {
  std::vector<OpenEdge> open;
  const std::vector<EdgeUse> all = sorted_edge_uses(faces);
  for_each_edge(all, [&open](std::span<const EdgeUse> uses) {
    std::int32_t count = 0;
    for (const EdgeUse& use : uses) count += use.way;
    const EdgeUse& edge = uses.front();
    if (count > 0) open.push_back({edge.from, edge.to, count});
    if (count < 0) open.push_back({edge.to, edge.from, -count});
  });
  return open;
}

}  // namespace graze::detail
