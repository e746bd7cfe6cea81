// SPDX-License-Identifier: MIT
// hull_corners(points): the corners of the convex hull of many 2D points, in about linear time if most of them are
// inside.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include <graze/math/orientation.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounding/box.hpp>
#include <graze/query/bounding/extreme_points.hpp>
#include <graze/shape/polytope.hpp>

namespace graze::detail {

/// Sorts points lexicographically. Many points are first distributed to narrow strips by x, then each strip is sorted:
/// linear time if x is evenly distributed, n log n in the worst case.
template <class T>
void sort_by_strips(std::span<Vec<2, T>> points) {
  constexpr std::size_t many = 1000;
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
  constexpr std::size_t points_per_strip = 4;
  const auto less = lexicographically_less<2, T>;
  const auto less_x = [](const Vec<2, T>& a, const Vec<2, T>& b) { return a.x < b.x; };
  const auto [least, greatest] = std::minmax_element(points.begin(), points.end(), less_x);
  const double low = points.empty() ? 0 : static_cast<double>(least->x);
  const double high = points.empty() ? 0 : static_cast<double>(greatest->x);
  const std::size_t strips = points.size() / points_per_strip;
  const double per_length = static_cast<double>(strips) / (high - low);
  if (points.size() < many || points.size() > most || !std::isfinite(per_length)) {
    std::sort(points.begin(), points.end(), less);
    return;
  }
  // Non-decreasing in x, including rounding.
  const auto strip_of = [&](const Vec<2, T>& point) {
    return std::min(strips - 1, static_cast<std::size_t>((static_cast<double>(point.x) - low) * per_length));
  };
  std::vector<std::uint32_t> ends(strips + 1, 0);
  for (const Vec<2, T>& point : points) ++ends[strip_of(point) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  const std::vector<Vec<2, T>> drawn(points.begin(), points.end());
  for (const Vec<2, T>& point : drawn) points[ends[strip_of(point)]++] = point;
  std::size_t start = 0;
  for (std::size_t strip = 0; strip < strips; ++strip) {
    const auto strip_points = points.subspan(start, ends[strip] - start);
    if (strip_points.size() > 1) std::sort(strip_points.begin(), strip_points.end(), less);
    start = ends[strip];
  }
}

/// Extends a convex chain by a point farther along; equal points count once. Andrew, "Another efficient algorithm for
/// convex hulls in two dimensions" (1979), with an exact orientation test: no corner is lost to rounding.
template <class T>
void extend_chain(std::vector<Vec<2, T>>& chain, std::size_t fixed, const Vec<2, T>& point) {
  while (chain.size() > fixed && orientation(chain[chain.size() - 2], chain.back(), point) <= 0) chain.pop_back();
  chain.push_back(point);
}

/// The corners of the hull from candidates for its lower and its upper chain, each sorted, and the lexicographically
/// least and greatest point: counter-clockwise, none between its neighbours.
template <class T>
std::vector<Vec<2, T>> chain_around(const Vec<2, T>& least, std::span<const Vec<2, T>> below, const Vec<2, T>& greatest,
                                    std::span<const Vec<2, T>> above) {
  std::vector<Vec<2, T>> chain{least};
  if (least == greatest) return chain;
  chain.reserve(below.size() + above.size() + 2);
  for (const Vec<2, T>& point : below) extend_chain(chain, 1, point);
  extend_chain(chain, 1, greatest);
  const std::size_t lower = chain.size();
  for (auto point = above.rbegin(); point != above.rend(); ++point) extend_chain(chain, lower, *point);
  extend_chain(chain, lower, least);
  chain.pop_back();
  return chain;
}

/// The corners of the hull of some points. They are split by the line between the outermost two, so that each is a
/// candidate for one chain only; those on the line, up to rounding, for both.
template <class T>
std::vector<Vec<2, T>> sorted_chain(std::vector<Vec<2, T>> points) {
  if (points.empty()) return points;
  const auto [first, last] = std::minmax_element(points.begin(), points.end(), lexicographically_less<2, T>);
  const Vec<2, T> least = *first;
  const Vec<2, T> greatest = *last;
  const Vec<2, double> way = wide<2, T>(greatest) - wide<2, T>(least);
  std::vector<Vec<2, T>> above;
  std::vector<Vec<2, T>> below;
  above.reserve(points.size());
  below.reserve(points.size());
  for (const Vec<2, T>& point : points) {
    const Vec<2, double> off = wide<2, T>(point) - wide<2, T>(least);
    const double height = cross_2d<double>(way, off);
    const double bound = tolerance::rounding * (std::fabs(way.x * off.y) + std::fabs(way.y * off.x));
    const bool is_above = height > bound;
    const bool is_below = height < -bound;
    if (!is_below) above.push_back(point);
    if (!is_above) below.push_back(point);
  }
  if (below.size() + above.size() > points.size() + points.size() / 4) {
    sort_by_strips(std::span(points));
    return chain_around<T>(least, points, greatest, points);
  }
  sort_by_strips(std::span(below));
  sort_by_strips(std::span(above));
  return chain_around<T>(least, below, greatest, above);
}

/// A side of a polygon: points with dot(inward, x) above `offset` are strictly inside of it, including rounding.
struct InnerSide {
  Vec<2, double> inward;
  double offset;
};

/// The sides of a convex polygon with corners in counter-clockwise order, in local coordinates, which are at most 1.
/// None if it has no interior.
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

/// The same as `sorted_chain`, but points inside the octagon of extreme points are removed before sorting. Akl and
/// Toussaint, "A fast convex hull algorithm" (1978).
template <class T>
std::vector<Vec<2, T>> hull_corners(std::span<const Vec<2, T>> points, const LocalFrame<2>& frame) {
  std::vector<Vec<2, T>> kept;
  for (const std::size_t index : extreme_points(points)) kept.push_back(points[index]);
  const std::vector<InnerSide> sides = inner_sides(sorted_chain(kept), frame);
  if (sides.empty()) return sorted_chain(std::vector<Vec<2, T>>(points.begin(), points.end()));
  const auto is_inside = [&sides](const Vec<2, double>& local) {
    double least = std::numeric_limits<double>::infinity();
    for (const InnerSide& side : sides) least = std::min(least, dot(side.inward, local) - side.offset);
    return least > 0;
  };
  kept.reserve(points.size());
  for (const Vec<2, T>& point : points) {
    if (!is_inside(frame.local(point))) kept.push_back(point);
  }
  return sorted_chain(std::move(kept));
}

}  // namespace graze::detail
