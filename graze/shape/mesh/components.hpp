// SPDX-License-Identifier: MIT
// Which faces of a mesh hang together by common vertices.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace graze::detail {

/// The least vertex of each component, in order; vertices of no face are in none.
inline std::vector<std::uint32_t> vertices_of_components(std::span<const std::array<std::uint32_t, 3>> faces,
                                                         std::size_t vertices) {
  std::vector<std::uint32_t> lesser(vertices);  // a vertex of the same component, itself if it is the least
  std::iota(lesser.begin(), lesser.end(), 0U);
  const auto least = [&lesser](std::uint32_t vertex) {
    while (lesser[vertex] != vertex) vertex = lesser[vertex] = lesser[lesser[vertex]];
    return vertex;
  };
  std::vector<bool> is_used(vertices, false);
  for (const std::array<std::uint32_t, 3>& face : faces) {
    for (const std::uint32_t vertex : face) {
      is_used[vertex] = true;
      const std::uint32_t a = least(face[0]);
      const std::uint32_t b = least(vertex);
      lesser[a < b ? b : a] = a < b ? a : b;
    }
  }
  std::vector<std::uint32_t> result;
  for (std::uint32_t vertex = 0; vertex < vertices; ++vertex) {
    if (is_used[vertex] && lesser[vertex] == vertex) result.push_back(vertex);
  }
  return result;
}

}  // namespace graze::detail
