// SPDX-License-Identifier: MIT
// outer_points(points): the points of the plane that may be corners of a hull. Most of many points are inside the
// octagon of those that are farthest along eight directions, and need not be sorted.
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

/// The hull of the points that are farthest along the axes and between them (Akl and Toussaint, "A fast convex hull
/// algorithm", 1978), made to be asked what it holds. Which points they are is not exact, but each is one of all; so
/// what is strictly inside is no corner of the hull of all.
class HullOctagon {
 public:
  /// Of at least one point, finite. Holds nothing if they are on a line, or so near to each other or far from each
  /// other that products of their differences are no doubles.
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

  /// True only for what is strictly inside. Without a branch, for which sides a point is behind cannot be foreseen.
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

  /// The points farthest along each direction, sorted, each once.
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

  /// What is to the left of an edge by more than rounding: its ends are `size` or less apart from all points along each
  /// axis, and so is `origin_`.
  Side side_along(const Vec<2, double>& start, const Vec<2, double>& end, double size) const {
    const Vec<2, double> edge = end - start;
    const Vec<2, double> inward(-edge.y, edge.x);
    constexpr double underflow = 0x1p-1000;  // far above what products lose that are less than all doubles
    return {inward, dot(inward, start - origin_) + tolerance::hull_octagon * sum_abs(edge) * size + underflow};
  }

  Vec<2, double> origin_ = Vec<2, double>(0.0);
  Vec<2, double> low_ = Vec<2, double>(0.0);
  Vec<2, double> high_ = Vec<2, double>(0.0);
  std::array<Side, directions> sides_{};
  bool holds_something_ = false;
};

/// The points but for some that are strictly inside the hull of others.
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
