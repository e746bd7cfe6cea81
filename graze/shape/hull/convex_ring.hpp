// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include <graze/math/orientation.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/hull/lexicographic.hpp>

namespace graze::detail {

/// Whether points, at least one, are the corners of a convex polygon in counter-clockwise order, with no corner on the
/// line between its neighbours; decided exactly. Two distinct points are a degenerate polygon.
template <class T>
bool is_convex_ring(std::span<const Vec<2, T>> points) {
  const std::size_t count = points.size();
  if (count < 3) return count == 1 || points[0] != points[1];
  std::size_t valleys = 0;
  bool was_falling = lexicographically_less<2, T>(points[0], points[count - 1]);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec<2, T>& next = points[i + 1 < count ? i + 1 : 0];
    if (orientation(points[i > 0 ? i - 1 : count - 1], points[i], next) <= 0) return false;
    // If all turns are left turns, each revolution passes one lexicographic minimum.
    const bool is_falling = lexicographically_less<2, T>(next, points[i]);
    if (was_falling && !is_falling) ++valleys;
    was_falling = is_falling;
  }
  return valleys == 1;
}

}  // namespace graze::detail
