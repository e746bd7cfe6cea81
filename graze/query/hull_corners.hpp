// SPDX-License-Identifier: MIT
// hull_corners(points): the corners of the convex hull of many points in the plane, in about linear time when most of
// them lie inside.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounding_box.hpp>
#include <graze/query/extreme_points.hpp>
#include <graze/shape/polytope.hpp>

namespace graze::detail {

/// Sorts points lexicographically. Many are dealt into narrow strips by their x first, then each strip is sorted:
/// linear time where x is spread out, n log n at worst.
template <class T>
std::vector<Vec<2, T>> sorted_by_strips(std::vector<Vec<2, T>> points) {
  constexpr std::size_t many = 1000;
  constexpr std::size_t points_per_strip = 4;
  const auto less = lexicographically_less<2, T>;
  const auto less_x = [](const Vec<2, T>& a, const Vec<2, T>& b) { return a.x < b.x; };
  const auto [least, greatest] = std::minmax_element(points.begin(), points.end(), less_x);
  const double low = points.empty() ? 0 : static_cast<double>(least->x);
  const double high = points.empty() ? 0 : static_cast<double>(greatest->x);
  const std::size_t strips = points.size() / points_per_strip;
  const double per_length = static_cast<double>(strips) / (high - low);
  if (points.size() < many || !std::isfinite(per_length)) {
    std::sort(points.begin(), points.end(), less);
    return points;
  }
  // Never decreasing in x, rounding included.
  const auto strip_of = [&](const Vec<2, T>& point) {
    return std::min(strips - 1, static_cast<std::size_t>((static_cast<double>(point.x) - low) * per_length));
  };
  std::vector<std::size_t> ends(strips + 1, 0);
  for (const Vec<2, T>& point : points) ++ends[strip_of(point) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<Vec<2, T>> dealt(points.size());
  for (const Vec<2, T>& point : points) dealt[ends[strip_of(point)]++] = point;
  std::size_t start = 0;
  for (std::size_t strip = 0; strip < strips; ++strip) {
    std::sort(dealt.begin() + static_cast<std::ptrdiff_t>(start),
              dealt.begin() + static_cast<std::ptrdiff_t>(ends[strip]), less);
    start = ends[strip];
  }
  return dealt;
}

/// The corners of the hull of points in any order, duplicates allowed: counter-clockwise, none between its neighbours.
template <class T>
std::vector<Vec<2, T>> sorted_chain(std::vector<Vec<2, T>> points) {
  points = sorted_by_strips(std::move(points));
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return monotone_chain(points);
}

/// A side of a polygon: points with dot(inward, x) above `offset` lie strictly inside of it, rounding included.
struct InnerSide {
  Vec<2, double> inward;
  double offset;
};

/// The sides of a convex polygon with corners in counter-clockwise order, in local coordinates, which are at most 1.
/// None when it has no inside.
template <class T>
std::vector<InnerSide> inner_sides(const std::vector<Vec<2, T>>& polygon, const LocalFrame<2>& frame) {
  std::vector<InnerSide> sides;
  for (std::size_t i = 0; i < polygon.size() && polygon.size() > 2; ++i) {
    const Vec<2, double> start = frame.local(polygon[i]);
    const Vec<2, double> inward = perpendicular(frame.local(polygon[(i + 1) % polygon.size()]) - start);
    sides.push_back({inward, dot(inward, start) + tolerance::rounding * sum_abs(inward)});
  }
  return sides;
}

/// The same as `sorted_chain`, but points inside the octagon of extreme points, or equal to those, are dropped before
/// anything is sorted. Akl and Toussaint, "A fast convex hull algorithm" (1978).
template <class T>
std::vector<Vec<2, T>> hull_corners(std::span<const Vec<2, T>> points, const LocalFrame<2>& frame) {
  std::vector<Vec<2, T>> kept;
  kept.reserve(points.size());
  for (const std::size_t index : extreme_points(points)) kept.push_back(points[index]);
  const std::vector<Vec<2, T>> octagon = sorted_chain(kept);
  const std::vector<InnerSide> sides = inner_sides(octagon, frame);
  const auto is_inside = [&sides](const Vec<2, double>& local) {
    return !sides.empty() && std::all_of(sides.begin(), sides.end(), [&local](const InnerSide& side) {
      return dot(side.inward, local) > side.offset;
    });
  };
  for (const Vec<2, T>& point : points) {
    if (is_inside(frame.local(point))) continue;
    if (std::find(octagon.begin(), octagon.end(), point) == octagon.end()) kept.push_back(point);
  }
  return sorted_chain(std::move(kept));
}

}  // namespace graze::detail
