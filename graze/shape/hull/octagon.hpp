// SPDX-License-Identifier: MIT
// outer_points(points): the 2D points that may be corners of a hull. Most points of a large set are inside the octagon
// of the extreme points in eight directions and need not be sorted.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/hull/lexicographic.hpp>
#include <graze/shape/hull/monotone_chain.hpp>

namespace graze::detail {

/// The hull of the extreme points along the axes and the diagonals (Akl and Toussaint, "A fast convex hull algorithm",
/// 1978), with a fast containment test. The choice of extreme points is not exact, but any of the points would do: what
/// is strictly inside their hull is no corner of the hull of all.
class HullOctagon {
 public:
  /// At least one finite point. The octagon is empty if the points are collinear, or if products of their differences
  /// leave the range of double.
  template <class T>
  explicit HullOctagon(std::span<const Vec<2, T>> points) {
    const std::vector<Vec<2, double>> corners = monotone_chain(farthest_of(points));
    if (corners.size() < 3) return;
    origin_ = corners.front();
    const double size = std::max(max_abs(high_ - origin_), max_abs(low_ - origin_));
    if (!(size > 0x1p-400 && size < 0x1p400)) return;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const std::size_t start = i % corners.size();
      sides_[i] = side_along(corners[start], corners[(start + 1) % corners.size()], size);
    }
    holds_something_ = true;
  }

  bool holds_something() const { return holds_something_; }

  /// True only for points strictly inside. Branch-free, because the side that excludes a point is unpredictable.
  bool holds(const Vec<2, double>& point) const {
    const Vec<2, double> place = point - origin_;
    bool is_inside = holds_something_;
    for (const Side& side : sides_) is_inside &= dot(side.inward, place) > side.least;
    return is_inside;
  }

 private:
  static constexpr std::size_t directions = 8;

  struct Side {
    Vec<2, double> inward = Vec<2, double>(0.0);
    double least = 0;
  };

  /// The extreme points in each direction, sorted, without duplicates.
  template <class T>
  std::vector<Vec<2, double>> farthest_of(std::span<const Vec<2, T>> points) {
    std::vector<Vec<2, double>> farthest(directions, wide<2, T>(points.front()));
    std::array<double, directions> heights = heights_of(farthest.front());
    for (const Vec<2, T>& point : points) {
      const std::array<double, directions> here = heights_of(wide<2, T>(point));
      for (std::size_t i = 0; i < directions; ++i) {
        if (!(here[i] > heights[i])) continue;
        heights[i] = here[i];
        farthest[i] = wide<2, T>(point);
      }
    }
    high_ = {heights[0], heights[2]};
    low_ = {-heights[1], -heights[3]};
    std::sort(farthest.begin(), farthest.end(), lexicographically_less<2, double>);
    farthest.erase(std::unique(farthest.begin(), farthest.end()), farthest.end());
    return farthest;
  }

  static std::array<double, directions> heights_of(const Vec<2, double>& p) {
    return {p.x, -p.x, p.y, -p.y, p.x + p.y, -(p.x + p.y), p.x - p.y, p.y - p.x};
  }

  /// The half-plane to the left of an edge, reduced by the rounding error. The ends of the edge and `origin_` are at
  /// most `size` away from all points along each axis.
  Side side_along(const Vec<2, double>& start, const Vec<2, double>& end, double size) const {
    const Vec<2, double> edge = end - start;
    const Vec<2, double> inward(-edge.y, edge.x);
    constexpr double underflow = 0x1p-1000;  // far above errors of products that underflow
    return {inward, dot(inward, start - origin_) + tolerance::hull_octagon * sum_abs(edge) * size + underflow};
  }

  Vec<2, double> origin_ = Vec<2, double>(0.0);
  Vec<2, double> low_ = Vec<2, double>(0.0);
  Vec<2, double> high_ = Vec<2, double>(0.0);
  std::array<Side, directions> sides_{};
  bool holds_something_ = false;
};

/// The points except some that are strictly inside the hull of others.
template <class T>
std::vector<Vec<2, T>> outer_points(std::span<const Vec<2, T>> points) {
  constexpr std::size_t many = 128;
  if (points.size() < many) return {points.begin(), points.end()};
  const HullOctagon octagon(points);
  if (!octagon.holds_something()) return {points.begin(), points.end()};
  std::vector<Vec<2, T>> result;
  for (const Vec<2, T>& point : points) {
    if (!octagon.holds(wide<2, T>(point))) result.push_back(point);
  }
  return result;
}

}  // namespace graze::detail
