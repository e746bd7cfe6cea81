// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include <graze/math/orientation.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/hull/lexicographic.hpp>

namespace graze::detail {

/// Whether points, at least one, are the corners of a convex polygon, once around and counter-clockwise, none of them
/// on the line between its neighbours; decided exactly. Two points, if they differ, are the ends of a flat one.
template <class T>
bool is_convex_ring(std::span<const Vec<2, T>> points) {
  const std::size_t count = points.size();
  if (count < 3) return count == 1 || points[0] != points[1];
  std::size_t valleys = 0;
  bool was_falling = lexicographically_less<2, T>(points[0], points[count - 1]);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec<2, T>& next = points[i + 1 < count ? i + 1 : 0];
    if (orientation(points[i > 0 ? i - 1 : count - 1], points[i], next) <= 0) return false;
    // With left turns alone, every time around has one lexicographically least point.
    const bool is_falling = lexicographically_less<2, T>(next, points[i]);
    if (was_falling && !is_falling) ++valleys;
    was_falling = is_falling;
  }
  return valleys == 1;
}

}  // namespace graze::detail
