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

/// The places of three points, counter-clockwise seen from outside.
using HullTriangle = std::array<std::uint32_t, 3>;

/// The surface of the convex hull, for finite points in any order, duplicates allowed: triangles that share their edges
/// two by two, none of them without area. Which side a point is on is decided exactly, so no corner is lost, whatever
/// is nearly on one plane. Faces with more than three corners come in several triangles, which may have corners more in
/// the middle of a face or edge. Empty when all points lie on one plane, exactly.
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
