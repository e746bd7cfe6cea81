// SPDX-License-Identifier: MIT
// The definition of vertices.hpp's function.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/hull/edges.hpp>
#include <graze/shape/hull/flat_points.hpp>
#include <graze/shape/hull/frame.hpp>
#include <graze/shape/hull/quickhull.hpp>
#include <graze/shape/hull/undecided_points.hpp>
#include <graze/shape/hull/vertices.hpp>

namespace graze::detail {

template <class T>
std::vector<std::uint32_t> hull_vertices(std::span<const Vec<3, T>> points) {
  const HullFrame<T> frame(points);
  const Quickhull<T> hull = hull_of(frame);
  if (hull.base().size() < 4) return flat_vertices(hull);
  const std::vector<bool> is_vertex = are_vertices(hull, bent_edges(hull));
  std::vector<std::uint32_t> result;
  for (std::size_t i = 0; i < is_vertex.size(); ++i) {
    if (is_vertex[i]) result.push_back(hull.corners()[i].index);
  }
  return result;
}

}  // namespace graze::detail
