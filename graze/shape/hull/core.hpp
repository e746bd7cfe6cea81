// SPDX-License-Identifier: MIT
// put_candidates(frame, list): the points that may be corners of a hull. Most of many points are deep inside, which the
// hull of a few of them tells at a glance.
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

/// A solid inside the hull of some points, made to be asked what it holds in constant time. Seen from a middle, on a
/// cube around it, the hull's surface in direction (1, u, v) is at the distance 1 / f(u, v), where f, the largest of
/// (n.x + n.y u + n.z v) / offset over the faces, is convex. So what is interpolated between values of f on a lattice
/// is nowhere below f, and what is nearer than one by it is inside.
class HullCore {
 public:
  /// Holds nothing.
  HullCore() = default;

  /// Of places in a frame whose box has these half extents. The places are moved to a grid, on which planes are exact,
  /// and the hull then loses as much all around. Holds nothing where that leaves no middle to speak of, or would not
  /// pay: most of the places are corners, or near the surface.
  HullCore(std::span<const HullPoint> sample, const Vec<3, double>& half_extents)
      : to_units_(1.0 / max(half_extents, Vec<3, double>(1 / steps))) {
    std::vector<Vec<3, double>> on_grid;
    on_grid.reserve(sample.size());
    for (const HullPoint& point : sample) {
      Vec<3, double>& place = on_grid.emplace_back();
      for (Dim i = 0; i < 3; ++i) place[i] = std::round(point.place[i] * steps);
    }
    const HullFrame<double> frame(on_grid);
    const Quickhull<double> hull(frame, all_points(frame));  // nothing is in doubt on a grid
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

  /// True only for what is strictly inside the hull.
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
  static constexpr std::int32_t cells = 8;  // along each side of the cube
  static constexpr double steps = 0x1p14;   // of the grid, in 1
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Whether of some points of a hull a quarter are inside by more than a few steps.
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

  /// Takes away what is outside of a face, or nearer to it than a step in each coordinate. In steps, from the middle.
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
  std::array<double, 6UL * (cells + 1) * (cells + 1)> inverse_{};  // f
  bool holds_something_ = false;
};

/// Some of the points of a frame, the same ones each time.
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

/// What the hull of some points of a frame holds for certain: nothing where there are too few for it to pay, of which
/// more are needed where most of them may be near the surface.
template <class T>
HullCore core_of(const HullFrame<T>& frame) {
  constexpr std::uint32_t many = 16000;
  constexpr std::uint32_t many_sheared = 4000;
  if (frame.size() < (frame.is_sheared() ? many_sheared : many)) return {};
  const double root = std::cbrt(static_cast<double>(frame.size()));
  return {sample_of(frame, static_cast<std::size_t>(2 * root * root)), frame.half_extents()};
}

/// Puts the points of a frame from one place to before another one into a list, but for those that the core holds.
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

/// Puts the points of a frame into a list, but for some that are strictly inside the hull of others.
template <class T>
void put_candidates(const HullFrame<T>& frame, std::vector<HullPoint>& result) {
  put_points_beside(core_of(frame), frame, 0, frame.size(), result);
}

}  // namespace graze::detail
