// SPDX-License-Identifier: MIT
// Which parts of a compound a ray cast may skip. Include ray_cast.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/ray/verdict_box.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::detail {

template <Dim N>
class RestOfPathInside;

/// For `visit_parts`: whether a path, up to the nearest hit so far, meets a box or does not pass it by far. Its margin
/// grows with the box, so that a box that it passes by contains none that it meets.
template <Dim N>
class RestOfPath {
 public:
  /// The direction is scaled to a largest coordinate of 1, so that the bound of slopes is far below it.
  explicit RestOfPath(const Path<N>& path) : origin_(path.origin), far_(path.far), scale_(max_abs(path.direction)) {
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
  /// The same for boxes in this one, which asks for less of them. It refers to this object.
  template <class T>
  RestOfPathInside<N> inside(const Aabb<N, T>& box) const {
    return RestOfPathInside<N>(*this, margin_of(box));
  }

  template <class T>
  bool operator()(const Part<N, T>& part) const {
    const Aabb<N, T> grown = touching_bounds(part.box);
    return !is_bounded(grown) || (*this)(grown);
  }

 private:
  friend class RestOfPathInside<N>;

  struct Ends {
    double enter;
    double leave;
  };

  /// No smaller for a box than for those in it.
  template <class T>
  [[gnu::always_inline]] double margin_of(const Aabb<N, T>& box) const {
    const Vec<N, double> to_min = wide<N, T>(box.min) - origin_;
    const Vec<N, double> to_max = wide<N, T>(box.max) - origin_;
    double size = far_;
    for (Dim i = 0; i < N; ++i) size += std::max(std::fabs(to_min[i]), std::fabs(to_max[i]));
    return 2 * tolerance::ray_side * size;
  }

  /// Where a path of this length enters and leaves a box, along the scaled direction.
  template <class T>
  [[gnu::always_inline]] Ends ends_in(const Aabb<N, T>& box, double length) const {
    const double margin = margin_of(box);
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
  Vec<N, double> inverse_;
  double far_;
  double scale_;
  double t_max_;  // where the path ends, along the scaled direction
};

/// A RestOfPath for the boxes in another one: with the margin of that, and sides chosen by the direction.
template <Dim N>
class RestOfPathInside {
 public:
  RestOfPathInside(const RestOfPath<N>& rest, double margin) : rest_(rest) {
    for (Dim i = 0; i < N; ++i) {
      slack_[i] = margin * std::fabs(rest.inverse_[i]);
      is_backward_[static_cast<std::size_t>(i)] = rest.inverse_[i] < 0 ? 1 : 0;
    }
  }

  template <class T>
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

  template <class T>
  bool operator()(const Aabb<N, T>& box) const {
    return admits(key(box));
  }

 private:
  const RestOfPath<N>& rest_;
  Vec<N, double> slack_;
  std::array<std::size_t, static_cast<std::size_t>(N)> is_backward_;
};

}  // namespace graze::detail
