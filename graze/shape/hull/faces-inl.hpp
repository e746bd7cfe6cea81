// SPDX-License-Identifier: MIT
// The definition of faces.hpp's function.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/hull/faces.hpp>
#include <graze/shape/hull/frame.hpp>
#include <graze/shape/hull/quickhull.hpp>
#include <graze/shape/hull/undecided_points.hpp>

namespace graze::detail {

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
