// SPDX-License-Identifier: MIT
// Rotating calipers: the rectangles around a convex polygon that have a side along one of its edges. The smallest
// rectangle by area is among them (Freeman and Shapira, "Determining the minimum-area encasing rectangle", 1975).
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include <graze/math/vec.hpp>

namespace graze::detail {

/// Walks the corners of a convex polygon counter-clockwise, cyclically. Differences of corners are exact up to one
/// rounding, wherever the polygon is. They are multiplied by `scale`, a power of two that makes the largest about 1.
template <class T>
struct CornerWalk {
  std::span<const Vec<2, T>> corners;
  double scale;
  std::size_t corner = 0;  ///< The current corner.
  std::size_t steps = 0;   ///< The number of steps so far.

  std::size_t next() const { return corner + 1 < corners.size() ? corner + 1 : 0; }
  void step() {
    corner = next();
    ++steps;
  }

  Vec<2, double> to(std::size_t other) const {
    return (wide<2, T>(corners[other]) - wide<2, T>(corners[corner])) * scale;
  }

  /// Advances to the first corner, at least `least_steps` from the start, after which the polygon turns back along
  /// `direction`; at most one more revolution.
  void advance(std::size_t least_steps, const Vec<2, double>& direction) {
    while (steps < least_steps) step();
    while (steps < least_steps + corners.size() && dot(to(next()), direction) > 0) step();
  }
};

/// A vector along the edge between two distinct corners, with its larger coordinate 1: its direction is that of the
/// edge up to one rounding, however short the edge. None for corners farther apart than the largest double.
template <class T>
Vec<2, double> edge_direction(const Vec<2, T>& from, const Vec<2, T>& to) {
  const Vec<2, double> edge = wide<2, T>(to) - wide<2, T>(from);
  return edge / max_abs(edge);
}

/// A vector along the edge after a corner, whose square is in the range of double. Long edges, nearly all, are taken
/// unchanged, because divisions would take longer than everything else.
template <class T>
Vec<2, double> moderate_edge(const CornerWalk<T>& walk) {
  const Vec<2, double> edge = walk.to(walk.next());
  return max_abs(edge) > 0x1p-400 ? edge : edge_direction(walk.corners[walk.corner], walk.corners[walk.next()]);
}

/// The unit vector along the edge of a convex polygon (corners counter-clockwise, no three collinear, at least two)
/// whose flush rectangle has the least `measure(width, height)`, the width along the edge; the first of equal ones.
/// Lengths are multiplied by `scale`, which makes the largest about 1. Toussaint, "Solving geometric problems with the
/// rotating calipers" (1983): linear time.
template <class T, class Measure>
Vec<2, double> best_flush_direction(std::span<const Vec<2, T>> corners, double scale, Measure measure) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  CornerWalk<T> start{corners, scale};
  CornerWalk<T> right = start;
  CornerWalk<T> top = start;
  CornerWalk<T> left = start;
  for (; start.steps < corners.size(); start.step()) {
    const Vec<2, double> edge = moderate_edge(start);
    right.advance(start.steps + 1, edge);
    top.advance(right.steps, perpendicular(edge));
    left.advance(top.steps, -edge);
    const double per_length = 1 / std::sqrt(dot(edge, edge));  // not zero: corners are distinct
    const double width = dot(left.to(right.corner), edge) * per_length;
    const double height = dot(start.to(top.corner), perpendicular(edge)) * per_length;
    const double size = measure(width, height);
    if (size < least) {
      least = size;
      best = start.corner;
    }
  }
  if (corners.size() < 2) return unit_axis<2>(0);
  const Vec<2, double> edge = edge_direction(corners[best], corners[best + 1 < corners.size() ? best + 1 : 0]);
  return edge / std::sqrt(dot(edge, edge));  // at least 1
}

}  // namespace graze::detail
