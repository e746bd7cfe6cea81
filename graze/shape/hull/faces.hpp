// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/hull/frame.hpp>
#include <graze/shape/hull/quickhull.hpp>
#include <graze/shape/hull/undecided_points.hpp>

namespace graze::detail {

/// The indices of three points, counter-clockwise as seen from outside.
using HullTriangle = std::array<std::uint32_t, 3>;

/// The surface of the convex hull, for finite points in any order, with duplicates allowed: a closed mesh of triangles,
/// none of them degenerate. Sides are decided exactly, so no corner is lost, however nearly coplanar the points are. A
/// face with more than three corners becomes several triangles, whose corners may include points inside that face or on
/// its edges. Empty if all points are coplanar, exactly.
template <class T>
std::vector<HullTriangle> hull_faces(std::span<const Vec<3, T>> points) {
  if (points.empty()) return {};
  const HullFrame<T> frame(points);
  const Quickhull<T> hull = hull_of(frame);
  std::vector<HullTriangle> result;
  for (const auto& face : hull.faces()) {
    if (!face.is_alive) continue;
    HullTriangle& triangle = result.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) triangle[i] = hull.corners()[face.corners[i]].index;
  }
  return result;
}

}  // namespace graze::detail
