// SPDX-License-Identifier: MIT
// Which parts of a compound a ray cast may skip. Include ray_cast.hpp.
#pragma once

#include <algorithm>
#include <cmath>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/ray/verdict_box.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::detail {

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

  template <class T>
  bool operator()(const Aabb<N, T>& box) const {
    const Vec<N, double> to_min = wide<N, T>(box.min) - origin_;
    const Vec<N, double> to_max = wide<N, T>(box.max) - origin_;
    double size = far_;
    for (Dim i = 0; i < N; ++i) size += std::max(std::fabs(to_min[i]), std::fabs(to_max[i]));
    const double margin = 2 * tolerance::ray_side * size;
    double enter = 0;
    double leave = t_max_;
    for (Dim i = 0; i < N; ++i) {
      const double at_min = to_min[i] * inverse_[i];
      const double at_max = to_max[i] * inverse_[i];
      const double slack = margin * std::fabs(inverse_[i]);
      enter = std::max(enter, std::min(at_min, at_max) - slack);
      leave = std::min(leave, std::max(at_min, at_max) + slack);
    }
    return enter <= leave;
  }
  template <class T>
  bool operator()(const Part<N, T>& part) const {
    const Aabb<N, T> grown = touching_bounds(part.box);
    return !is_bounded(grown) || (*this)(grown);
  }

 private:
  Vec<N, double> origin_;
  Vec<N, double> inverse_;
  double far_;
  double scale_;
  double t_max_;  // where the path ends, along the scaled direction
};

/// For `visit_parts`: boxes by the place of their centers along a direction.
template <Dim N>
struct AlongDirection {
  template <class T>
  double operator()(const Aabb<N, T>& box) const {
    return dot(direction, wide<N, T>(box.min) + wide<N, T>(box.max));
  }

  Vec<N, double> direction;
};

}  // namespace graze::detail
