// SPDX-License-Identifier: MIT
// Which parts of a compound, or faces of a mesh, a ray cast may skip. Include ray_cast.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/ray/triangle_lanes.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/ray/verdict_box.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/parts/box_block.hpp>
#include <graze/shape/parts/triangle_block.hpp>

namespace graze::detail {

template <Dim N, class T>
class RestOfPathInside;

/// For `visit_parts`: whether a path, up to the nearest hit so far, meets a box or does not pass it by far. Its margin
/// grows with the box, so that a box that it passes by contains none that it meets.
template <Dim N>
class RestOfPath {
 public:
  /// The direction is scaled to a largest coordinate of 1, so that the bound of slopes is far below it.
  explicit RestOfPath(const Path<N>& path)
      : origin_(path.origin), direction_(path.direction), far_(path.far), scale_(max_abs(path.direction)) {
    for (Dim i = 0; i < N; ++i) {
      const double slope = path.direction[i] / scale_;
      inverse_[i] = std::fabs(slope) > least_slope ? 1 / slope : 1 / least_slope;
    }
    end_at(path.t_max);
  }

  /// Ends the path at t.
  void end_at(double t) { t_max_ = t * scale_; }

  /// Where the path enters a box, along the scaled direction; NaN if it passes the box by.
  template <class T>
  double key(const Aabb<N, T>& box) const {
    const Ends within = ends_in(box, std::numeric_limits<double>::infinity());
    return within.enter <= within.leave ? within.enter : std::numeric_limits<double>::quiet_NaN();
  }
  /// Whether a box with this key is entered before the end.
  bool admits(double key) const { return key <= t_max_; }

  template <class T>
  bool operator()(const Aabb<N, T>& box) const {
    const Ends within = ends_in(box, t_max_);
    return within.enter <= within.leave;
  }
  /// The same for boxes in this one, which asks for less of them, and for faces in it, each up to `error` away from
  /// where the path sees it. It refers to this object.
  template <class T>
  RestOfPathInside<N, T> inside(const Aabb<N, T>& box, double error) const {
    return RestOfPathInside<N, T>(*this, box, error);
  }

  template <class T>
  bool operator()(const Part<N, T>& part) const {
    const Aabb<N, T> grown = touching_bounds(part.box);
    return !is_bounded(grown) || (*this)(grown);
  }

 private:
  template <Dim M, class T>
  friend class RestOfPathInside;

  static constexpr double relative_margin = 2 * tolerance::ray_side;

  struct Ends {
    double enter;
    double leave;
  };

  /// The size of a box and the path to it; no smaller for a box than for those in it.
  template <class T>
  [[gnu::always_inline]] double size_to(const Aabb<N, T>& box) const {
    const Vec<N, double> to_min = wide<N, T>(box.min) - origin_;
    const Vec<N, double> to_max = wide<N, T>(box.max) - origin_;
    double size = far_;
    for (Dim i = 0; i < N; ++i) size += std::max(std::fabs(to_min[i]), std::fabs(to_max[i]));
    return size;
  }

  /// Where a path of this length enters and leaves a box, along the scaled direction.
  template <class T>
  [[gnu::always_inline]] Ends ends_in(const Aabb<N, T>& box, double length) const {
    const double margin = relative_margin * size_to(box);
    Ends within{0, length};
    for (Dim i = 0; i < N; ++i) {
      const double at_min = (static_cast<double>(box.min[i]) - origin_[i]) * inverse_[i];
      const double at_max = (static_cast<double>(box.max[i]) - origin_[i]) * inverse_[i];
      const double slack = margin * std::fabs(inverse_[i]);
      within.enter = std::max(within.enter, std::min(at_min, at_max) - slack);
      within.leave = std::min(within.leave, std::max(at_min, at_max) + slack);
    }
    return within;
  }

  Vec<N, double> origin_;
  Vec<N, double> direction_;
  Vec<N, double> inverse_;
  double far_;
  double scale_;
  double t_max_;  // where the path ends, along the scaled direction
};

/// A RestOfPath for the boxes in another one: with the margin of that, and sides chosen by the direction.
template <Dim N, class T>
class RestOfPathInside {
 public:
  RestOfPathInside(const RestOfPath<N>& rest, const Aabb<N, T>& around, [[maybe_unused]] double error) : rest_(rest) {
    const double size = rest.size_to(around);
    for (Dim i = 0; i < N; ++i) {
      slack_[i] = RestOfPath<N>::relative_margin * size * std::fabs(rest.inverse_[i]);
      is_backward_[static_cast<std::size_t>(i)] = rest.inverse_[i] < 0 ? 1 : 0;
    }
#ifdef GRAZE_HAS_LANES
    set_lanes(size + max_abs(rest.origin_));
    if constexpr (N == 3) {
      const double grown =
          tolerance::box_slack * static_cast<double>(std::max(max_abs(around.min), max_abs(around.max)));
      line_ = lane_line<T>(rest.origin_, rest.direction_, size, error + grown);
    }
#endif
  }

  double key(const Aabb<N, T>& box) const {
    const std::array<const Vec<N, T>*, 2> corners{&box.min, &box.max};
    double enter = 0;
    double leave = std::numeric_limits<double>::infinity();
    for (Dim i = 0; i < N; ++i) {
      const std::size_t first = is_backward_[static_cast<std::size_t>(i)];
      const double near = static_cast<double>((*corners[first])[i]) - rest_.origin_[i];
      const double far = static_cast<double>((*corners[1 - first])[i]) - rest_.origin_[i];
      enter = std::max(near * rest_.inverse_[i] - slack_[i], enter);
      leave = std::min(far * rest_.inverse_[i] + slack_[i], leave);
    }
    return enter <= leave ? enter : std::numeric_limits<double>::quiet_NaN();
  }
  bool admits(double key) const { return rest_.admits(key); }

#ifdef GRAZE_HAS_LANES
  LaneMask lanes(const BoxBlock<N, T>& block, Row<T>& keys) const {
    return entered_lanes(block, lanes_, round_up<T>(rest_.t_max_), keys);
  }
  LaneMask lanes(const TriangleBlock<N, T>& triangles) const requires(N == 3) { return met_lanes(triangles, line_); }
#endif

  bool operator()(const Aabb<N, T>& box) const { return admits(key(box)); }

 private:
#ifdef GRAZE_HAS_LANES
  /// `size` includes the largest coordinate of the origin, which is rounded.
  void set_lanes(double size) {
    constexpr double most = 0x1p100;  // an inverse in T, so large that the path practically does not move
    for (Dim i = 0; i < N; ++i) {
      const double inverse = std::clamp(rest_.inverse_[i], -most, most);
      const double margin = (RestOfPath<N>::relative_margin + static_cast<double>(lane_slack<T>)) * size;
      lanes_.origin[i] = static_cast<T>(rest_.origin_[i]);
      lanes_.inverse[i] = static_cast<T>(inverse);
      lanes_.slack[i] = static_cast<T>(margin * std::fabs(inverse));
      const auto k = static_cast<std::size_t>(i);
      lanes_.near[k] = k + is_backward_[k] * static_cast<std::size_t>(N);
      lanes_.far[k] = k + (1 - is_backward_[k]) * static_cast<std::size_t>(N);
    }
  }

  LanePath<N, T> lanes_;
  LaneLine<T> line_;  ///< In 3D.
#endif
  const RestOfPath<N>& rest_;
  Vec<N, double> slack_;
  std::array<std::size_t, static_cast<std::size_t>(N)> is_backward_;
};

}  // namespace graze::detail
