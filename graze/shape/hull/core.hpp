// SPDX-License-Identifier: MIT
// put_candidates(frame, list): the points that may be corners of a hull. Most points of a large set are deep inside,
// which the hull of a small sample shows quickly.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <graze/math/random/linear_congruential.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/hull/frame.hpp>
#include <graze/shape/hull/quickhull.hpp>

namespace graze::detail {

/// A solid inside the convex hull of some points, with a point-containment test in constant time. Project the hull's
/// surface from its center onto a cube: in direction (1, u, v) the surface is at distance 1 / f(u, v), where f is the
/// maximum of (n.x + n.y u + n.z v) / offset over the faces. f is convex, so interpolation between its values on a
/// lattice is never below f, and a point is inside if the interpolated value for its position is below one.
class HullCore {
 public:
  /// An empty core.
  HullCore() = default;

  /// The core of a sample of points in a frame whose box has these half extents. The points are rounded to a grid, on
  /// which planes are exact, and the hull shrinks by as much on all sides. The core is empty if nothing significant
  /// remains, or if it would not pay because most of the sample are corners or near the surface.
  HullCore(std::span<const HullPoint> sample, const Vec<3, double>& half_extents)
      : to_units_(1.0 / max(half_extents, Vec<3, double>(1 / steps))) {
    std::vector<Vec<3, double>> on_grid;
    on_grid.reserve(sample.size());
    for (const HullPoint& point : sample) {
      Vec<3, double>& place = on_grid.emplace_back();
      for (Dim i = 0; i < 3; ++i) place[i] = std::round(point.place[i] * steps);
    }
    const HullFrame<double> frame(on_grid);
    const Quickhull<double> hull(frame, all_points(frame));  // exact on a grid: no point is undecided
    if (hull.base().size() < 4 || hull.corners().size() > sample.size() / 2 || !are_deep(hull)) return;
    Vec<3, double> sum(0.0);
    for (const HullPoint& corner : hull.corners()) sum += on_grid[corner.index];
    for (Dim i = 0; i < 3; ++i) middle_[i] = std::round(sum[i] / static_cast<double>(hull.corners().size()));
    for (const auto& face : hull.faces()) {
      if (!face.is_alive) continue;
      const auto corner = [&](std::size_t i) { return on_grid[hull.corners()[face.corners[i]].index] - middle_; };
      cut(corner(0), corner(1), corner(2));
    }
    middle_ /= steps;
    holds_something_ = true;
  }

  bool holds_something() const { return holds_something_; }

  /// True only for points strictly inside the hull.
  bool holds(const Vec<3, double>& place) const {
    if (!holds_something_) return false;
    const Vec<3, double> way = (place - middle_) * to_units_;
    const Vec<3, double> size(std::fabs(way.x), std::fabs(way.y), std::fabs(way.z));
    const Dim axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    const double distance = size[axis];
    if (!(distance > 0)) return false;
    const std::size_t side = 2 * static_cast<std::size_t>(axis) + (way[axis] > 0 ? 1 : 0);
    const double u = (way[(axis + 1) % 3] / distance + 1) * (0.5 * cells);
    const double v = (way[(axis + 2) % 3] / distance + 1) * (0.5 * cells);
    const auto column = std::min(cells - 1, static_cast<std::int32_t>(u));
    const auto row = std::min(cells - 1, static_cast<std::int32_t>(v));
    const double* corner = &inverse_[number_of(side, column, row)];
    const double right = u - column;
    const double up = v - row;
    const double below = corner[0] + right * (corner[1] - corner[0]);
    const double above = corner[cells + 1] + right * (corner[cells + 2] - corner[cells + 1]);
    return distance * (below + up * (above - below)) < 1 - tolerance::hull_core;
  }

 private:
  static constexpr std::int32_t cells = 8;  // along each edge of the cube
  static constexpr double steps = 0x1p14;   // grid steps per unit
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Whether at least a quarter of some hull's points are inside by more than a few steps.
  static bool are_deep(const Quickhull<double>& hull) {
    constexpr std::uint32_t looked_at = 32;
    constexpr double least = 4 / steps;
    const std::uint32_t stride = hull.frame().size() / looked_at + 1;
    std::uint32_t count = 0;
    std::uint32_t deep = 0;
    for (std::uint32_t i = 0; i < hull.frame().size(); i += stride, ++count) {
      const Vec<3, double> place = hull.frame().at(i).place;
      deep += std::all_of(hull.faces().begin(), hull.faces().end(),
                          [&](const auto& face) {
                            return !face.is_alive || face.plane.height(place) < -least * sum_abs(face.plane.normal);
                          })
                  ? 1
                  : 0;
    }
    return 4 * deep > count;
  }

  static std::size_t number_of(std::size_t side, std::int32_t column, std::int32_t row) {
    return (side * (cells + 1) + static_cast<std::size_t>(row)) * (cells + 1) + static_cast<std::size_t>(column);
  }

  /// Removes what is outside a face, or closer to it than one step in each coordinate. Coordinates are in steps,
  /// relative to the center.
  void cut(const Vec<3, double>& a, const Vec<3, double>& b, const Vec<3, double>& c) {
    const Vec<3, double> normal = cross(b - a, c - a);
    const double size = sum_abs(normal);
    const double depth = dot(normal, a) - size;
    const bool is_deep = depth > tolerance::hull_core_depth * steps * size;
    const Vec<3, double> rise = normal * steps / to_units_;
    for (std::size_t side = 0; side < 6; ++side) {
      const auto axis = static_cast<Dim>(side / 2);
      const double ahead = side % 2 == 1 ? rise[axis] : -rise[axis];
      for (std::int32_t row = 0; row <= cells; ++row) {
        for (std::int32_t column = 0; column <= cells; ++column) {
          const double height = ahead + rise[(axis + 1) % 3] * (2.0 * column / cells - 1) +
                                rise[(axis + 2) % 3] * (2.0 * row / cells - 1);
          double& inverse = inverse_[number_of(side, column, row)];
          inverse = std::max(inverse, is_deep ? height / depth : infinity);
        }
      }
    }
  }

  Vec<3, double> to_units_ = Vec<3, double>(1.0);
  Vec<3, double> middle_ = Vec<3, double>(0.0);
  std::array<double, 6UL * (cells + 1) * (cells + 1)> inverse_{};  // f, on the lattice
  bool holds_something_ = false;
};

/// A sample of a frame's points, always the same.
template <class T>
std::vector<HullPoint> sample_of(const HullFrame<T>& frame, std::size_t count) {
  std::vector<HullPoint> sample;
  sample.reserve(count);
  LinearCongruential random;
  for (std::size_t i = 0; i < count; ++i) {
    sample.push_back(frame.at(static_cast<std::uint32_t>(random.below(frame.size()))));
  }
  return sample;
}

/// The core of a frame's points; empty if there are too few points for it to pay. More are required where most may be
/// near the surface.
template <class T>
HullCore core_of(const HullFrame<T>& frame) {
  constexpr std::uint32_t many = 16000;
  constexpr std::uint32_t many_sheared = 4000;
  if (frame.size() < (frame.is_sheared() ? many_sheared : many)) return {};
  const double root = std::cbrt(static_cast<double>(frame.size()));
  return {sample_of(frame, static_cast<std::size_t>(2 * root * root)), frame.half_extents()};
}

/// Appends the points with index in [first, last) to a list, except those that the core contains.
template <class T>
void put_points_beside(const HullCore& core, const HullFrame<T>& frame, std::uint32_t first, std::uint32_t last,
                       std::vector<HullPoint>& result) {
  result.clear();
  result.reserve(last - first);
  for (std::uint32_t i = first; i < last; ++i) {
    const HullPoint point = frame.at(i);
    if (!core.holds(point.place)) result.push_back(point);
  }
}

/// Appends the points of a frame to a list, except some that are strictly inside the hull of others.
template <class T>
void put_candidates(const HullFrame<T>& frame, std::vector<HullPoint>& result) {
  put_points_beside(core_of(frame), frame, 0, frame.size(), result);
}

}  // namespace graze::detail
