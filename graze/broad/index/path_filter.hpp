// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/ray/verdict_box.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

/// The part of a ray up to t_max, and what rounds to it: a region, but not a shape. The ray must outlive it.
template <Dim N, class T>
struct RayUntil {
  const Ray<N, T>& ray;
  T t_max;
};

template <Dim N, class T>
struct ShapeTraits<RayUntil<N, T>> : Space<N, T> {};

/// Rounded outward.
template <Dim N, class T>
Aabb<N, T> bounds(const RayUntil<N, T>& way) {
  const Aabb<N, T> whole = bounds(way.ray);
  Aabb<N, T> box{way.ray.origin, way.ray.origin};
  for (Dim i = 0; i < N; ++i) {
    const double step = std::fabs(static_cast<double>(way.ray.direction[i]));
    if (step == 0) continue;
    const double way_along = next_up(step * detail::latest_t(way.t_max));
    const auto start = static_cast<double>(way.ray.origin[i]);
    if (whole.max[i] > box.max[i]) box.max[i] = round_up<T>(next_up(start + way_along));
    if (whole.min[i] < box.min[i]) box.min[i] = round_down<T>(next_down(start - way_along));
  }
  return box;
}

}  // namespace graze

namespace graze::detail {

/// Decides for most boxes, with certainty, that a ray or a segment misses them, by a slab test with a margin.
template <Dim N>
class PathFilter {
 public:
  /// The direction is scaled to a largest coordinate of 1, so that nothing underflows; rounding moves the ray by less
  /// than the margin.
  template <class T>
  explicit PathFilter(const Ray<N, T>& ray, double t_max = std::numeric_limits<double>::infinity())
      : origin_(wide<N, T>(ray.origin)),
        direction_(wide<N, T>(ray.direction) / static_cast<double>(max_abs(ray.direction))),  // valid, so not zero
        t_max_(t_max * static_cast<double>(max_abs(ray.direction))) {}

  template <class T>
  explicit PathFilter(const RayUntil<N, T>& way) : PathFilter(way.ray, latest_t(way.t_max)) {}

  template <class T>
  explicit PathFilter(const Segment<N, T>& segment)
      : origin_(wide<N, T>(segment.start)), direction_(wide<N, T>(segment.end) - origin_), t_max_(1) {}

  /// True only if they are farther apart than the slack along one axis or a cross product of two. Always false for
  /// boxes that are infinite or nearly so.
  template <class T>
  bool part(const Aabb<N, T>& box, double slack) const {
    const PathAtBox path{lifted(wide<N, T>(box.min) - origin_ - slack), lifted(wide<N, T>(box.max) - origin_ + slack),
                         lifted(direction_), 0};
    constexpr double no_product_overflows = 0x1p500;
    if (!(sum_abs(path.min) + sum_abs(path.max) + sum_abs(path.direction) < no_product_overflows)) return false;
    return slabs_of<N>(path, tolerance::ray_side).are_missed(t_max_);
  }

  /// A box that is not missed remains undecided.
  template <class T>
  bool share_point(const Aabb<N, T>& /*box*/, double /*slack*/) const {
    return false;
  }

 private:
  Vec<N, double> origin_;
  Vec<N, double> direction_;
  double t_max_ = std::numeric_limits<double>::infinity();
};

}  // namespace graze::detail
