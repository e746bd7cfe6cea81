// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/frustum.hpp>

namespace graze::detail {

/// Decides for most boxes, with certainty, whether a frustum meets them, from axes calculated once. `slack` is a safety
/// margin that must exceed the rounding errors. Boxes must be finite.
template <Dim N>
class FrustumFilter {
 public:
  template <class T>
  explicit FrustumFilter(const Frustum<N, T>& frustum) {
    for (std::size_t k = 0; k < corners_.size(); ++k) corners_[k] = wide<N, T>(frustum.corners[k]);
    add_faces();
    faces_ = size_;
    if constexpr (N == 3) add_edges();
    depth_ = depth_direction();
  }

  /// True only if box and frustum, whose bounds were compared before, are farther apart than the slack. It is complete
  /// for a camera's frustum, whose near and far planes are parallel: the axes tested are all separating axes of the two
  /// bodies (Gottschalk, Lin and Manocha 1996). For other hulls of eight points, it misses some boxes beside an edge.
  template <class T>
  bool part(const Aabb<N, T>& box, double slack) const {
    const Vec<N, double> center = center_of(box);
    const Vec<N, double> half = half_of(box);
    bool center_is_inside = true;
    for (std::size_t i = 0; i < size_; ++i) {
      if (i == faces_ && center_is_inside) return false;
      const Axis& axis = axes_[i];
      const double middle = dot(axis.direction, center);
      const double reach = dot(axis.magnitude, half) + slack;
      if (middle - reach > axis.high || middle + reach < axis.low) return true;
      center_is_inside = center_is_inside && axis.low <= middle && middle <= axis.high;
    }
    return false;
  }

  /// True only if box and frustum share a point. It tests one convex combination of the frustum's corners: the one
  /// nearest the box's center if the section through the center, between near and far, were a parallelogram.
  template <class T>
  bool share_point(const Aabb<N, T>& box, double slack) const {
    const Vec<N, double> center = center_of(box);
    const double along = (dot(depth_.direction, center) - depth_.low) / (depth_.high - depth_.low);
    if (!(along >= 0 && along <= 1)) return false;
    std::array<Vec<N, double>, half_count> section;
    for (std::size_t k = 0; k < half_count; ++k) {
      section[k] = corners_[k] * (1 - along) + corners_[k + half_count] * along;
    }
    const Vec<N, double> off = mean_near(section, center) - center;
    const Vec<N, double> half = half_of(box);
    for (Dim i = 0; i < N; ++i) {
      if (!(std::fabs(off[i]) <= half[i] - slack)) return false;
    }
    return true;
  }

 private:
  static constexpr std::size_t corner_count = Frustum<N, double>::corner_count;
  static constexpr std::size_t half_count = corner_count / 2;

  struct Axis {
    Vec<N, double> direction;  // unit vector
    Vec<N, double> magnitude;  // its absolute values
    double low;                // the frustum's interval on it
    double high;
  };

  /// Six face normals, and cross products of three axes with eight edges.
  static constexpr std::size_t most = N == 2 ? 4 : 6 + 3 * 8;

  template <class T>
  static Vec<N, double> center_of(const Aabb<N, T>& box) {
    return wide<N, T>(box.min) * 0.5 + wide<N, T>(box.max) * 0.5;
  }

  template <class T>
  static Vec<N, double> half_of(const Aabb<N, T>& box) {
    return wide<N, T>(box.max) * 0.5 - wide<N, T>(box.min) * 0.5;
  }

  /// A zero direction, where corners coincide, separates nothing and is skipped.
  void add(const Vec<N, double>& direction) {
    const double largest = max_abs(direction);
    if (!(largest > 0 && largest < std::numeric_limits<double>::infinity())) return;
    Axis& axis = axes_[size_++];
    axis.direction = direction / largest;
    axis.direction /= std::sqrt(length_squared(axis.direction));
    for (Dim i = 0; i < N; ++i) axis.magnitude[i] = std::fabs(axis.direction[i]);
    axis.low = axis.high = dot(axis.direction, corners_[0]);
    for (const Vec<N, double>& corner : corners_) {
      const double height = dot(axis.direction, corner);
      axis.low = std::min(axis.low, height);
      axis.high = std::max(axis.high, height);
    }
  }

  Vec<N, double> way(unsigned from, unsigned to) const { return corners_[to] - corners_[from]; }

  /// Uses the diagonals of faces, which are nonzero even if a side has length zero.
  void add_faces() {
    if constexpr (N == 2) {
      for (const auto& [from, to] : {std::array{0U, 1U}, {2U, 3U}, {0U, 2U}, {1U, 3U}})
        add(perpendicular(way(from, to)));
    } else {
      constexpr std::array<std::array<unsigned, 4>, 6> diagonals = {
          {{0, 3, 1, 2}, {4, 7, 5, 6}, {0, 6, 2, 4}, {1, 7, 3, 5}, {0, 5, 1, 4}, {2, 7, 3, 6}}};
      for (const auto& [a, b, c, d] : diagonals) add(cross(way(a, b), way(c, d)));
    }
  }

  /// The edges from near to far, and those of the far face; for a camera the near face's edges are parallel to these.
  void add_edges() {
    constexpr std::array<std::array<unsigned, 2>, 8> edges = {
        {{0, 4}, {1, 5}, {2, 6}, {3, 7}, {4, 5}, {6, 7}, {4, 6}, {5, 7}}};
    for (const auto& [from, to] : edges) {
      for (Dim i = 0; i < 3; ++i) add(cross(unit_axis<3>(i), way(from, to)));
    }
  }

  /// The normal of the far face, with the depths of the first near and the first far corner.
  Axis depth_direction() const {
    Axis depth{};
    if constexpr (N == 2) {
      depth.direction = perpendicular(way(2, 3));
    } else {
      depth.direction = cross(way(4, 7), way(5, 6));
    }
    depth.low = dot(depth.direction, corners_[0]);
    depth.high = dot(depth.direction, corners_[half_count]);
    return depth;
  }

  /// A convex combination of the points of a section; equal to `point` if the section is a parallelogram around it.
  static Vec<N, double> mean_near(const std::array<Vec<N, double>, half_count>& section, const Vec<N, double>& point) {
    const Vec<N, double> right = section[1] - section[0];
    const Vec<N, double> to_point = point - section[0];
    if constexpr (N == 2) {
      const double u = std::clamp(dot(to_point, right) / dot(right, right), 0.0, 1.0);
      return section[0] * (1 - u) + section[1] * u;
    } else {
      // Solves to_point = u right + v up by least squares.
      const Vec<3, double> up = section[2] - section[0];
      const double mixed = dot(right, up);
      const double area_squared = dot(right, right) * dot(up, up) - mixed * mixed;
      const double u = (dot(to_point, right) * dot(up, up) - dot(to_point, up) * mixed) / area_squared;
      const double v = (dot(to_point, up) * dot(right, right) - dot(to_point, right) * mixed) / area_squared;
      const double s = std::clamp(u, 0.0, 1.0);
      const double t = std::clamp(v, 0.0, 1.0);
      return (section[0] * (1 - s) + section[1] * s) * (1 - t) + (section[2] * (1 - s) + section[3] * s) * t;
    }
  }

  std::array<Vec<N, double>, corner_count> corners_;
  std::array<Axis, most> axes_;
  std::size_t size_ = 0;
  std::size_t faces_ = 0;  // the number of axes that are face normals
  Axis depth_{};
};

}  // namespace graze::detail
