// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/hull/lexicographic.hpp>
#include <graze/shape/mesh.hpp>

namespace graze {

/// The same faces, in the same order, on vertices without duplicates: of vertices with equal coordinates only the first
/// is kept, and those of no face are dropped. The others keep their order. So edges that only looked common become
/// common, as in a file that lists the corners of each face.
template <Dim N, class T>
Mesh<N, T> welded(const Mesh<N, T>& mesh) {
  const std::span<const Vec<N, T>> vertices = mesh.vertices();
  std::vector<std::uint32_t> by_place(vertices.size());
  std::iota(by_place.begin(), by_place.end(), 0U);
  std::sort(by_place.begin(), by_place.end(), [&vertices](std::uint32_t a, std::uint32_t b) {
    if (vertices[a] == vertices[b]) return a < b;
    return detail::lexicographically_less<N, T>(vertices[a], vertices[b]);
  });
  std::vector<std::uint32_t> first(vertices.size());  // the first vertex at the same place
  for (std::size_t i = 0; i < by_place.size(); ++i) {
    const bool is_same = i > 0 && vertices[by_place[i]] == vertices[by_place[i - 1]];
    first[by_place[i]] = is_same ? first[by_place[i - 1]] : by_place[i];
  }
  std::vector<bool> is_kept(vertices.size(), false);
  for (const std::array<std::uint32_t, 3>& face : mesh.faces()) {
    for (const std::uint32_t vertex : face) is_kept[first[vertex]] = true;
  }
  std::vector<Vec<N, T>> kept;
  std::vector<std::uint32_t> place(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    place[i] = static_cast<std::uint32_t>(kept.size());
    if (is_kept[i]) kept.push_back(vertices[i]);
  }
  std::vector<std::array<std::uint32_t, 3>> faces(mesh.faces().begin(), mesh.faces().end());
  for (std::array<std::uint32_t, 3>& face : faces) {
    for (std::uint32_t& vertex : face) vertex = place[first[vertex]];
  }
  return mesh_of<N, T>(kept, faces, mesh.kind());
}

}  // namespace graze
