// SPDX-License-Identifier: MIT
// The first filter of a ray and a sphere. Include ray_cast.hpp.
#pragma once

#include <cmath>
#include <optional>

#include <graze/math/lanes/paired.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/sphere.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// Three dot products decide that a ray misses a sphere. For a ray that hits from outside and clearly before its end,
/// point and normal are calculated as in SpherePassage; all bands are those of ray_verdict_of. Others are unclear.
template <Dim N, class T>
class RaySphereFilter {
 public:
  [[gnu::always_inline]] RaySphereFilter(const Sphere<N, T>& sphere, const Ray<N, T>& ray, T t_max)
      : center_(Paired<N>(sphere.center) - Paired<N>(ray.origin)),
        direction_(ray.direction),
        radius_(static_cast<double>(sphere.radius)),
        origin_(ray.origin) {
    const double squared_radius = radius_ * radius_;
    const double squared_way = dot(center_, center_);
    const double whole = dot(direction_, direction_);
    const double along = dot(center_, direction_);
    const double squares = squared_way + squared_radius;
    const double band = tolerance::ray_filter * squares;
    const double outside = squared_way - squared_radius;
    const bool is_moderate = (whole > 0x1p-400) & (whole < 0x1p400) & (squares > 0x1p-400) & (squares < 0x1p400);
    if (!(is_moderate & (outside > band))) return;
    const double squared_along = along * along;
    if ((along < 0) | (outside * whole - squared_along > band * whole)) {
      verdict_ = RayVerdict::misses;
      return;
    }
    const double per_whole = 1 / whole;
    const double middle = along * per_whole;
    off_ = center_ - direction_ * middle;
    const double depth = squared_radius - dot(off_, off_);
    half_ = std::sqrt(std::fabs(depth) * per_whole);
    t_ = middle - half_;
    const double rest = static_cast<double>(t_max) - t_;
    const double late = t_ - latest_t(t_max);
    const double least = tolerance::ray_end * tolerance::ray_end * squares;
    if (!(depth > band)) return;
    if ((rest > 0) & (rest * rest * whole > least)) verdict_ = RayVerdict::hits;
    if ((late > 0) & (late * late * whole > least)) verdict_ = RayVerdict::misses;
  }

  [[gnu::always_inline]] RayVerdict verdict() const { return verdict_; }

  [[gnu::always_inline]] std::optional<RayHit<N, T>> hit() const {
    const Paired<N> spoke = off_ + direction_ * half_;  // to the center
    const Paired<N> normal = unit_of(spoke * -1, radius_);
    const double error = tolerance::rounding * (sum_of_coordinates(magnitude(center_)) + radius_);
    return RayHit<N, T>{static_cast<T>(t_), rounded_vec<T>(center_ + normal * radius_ + origin_),
                        rounded_vec<T>(normal), Status::converged, error};
  }

 private:
  Paired<N> center_;  ///< Relative to the ray's origin.
  Paired<N> direction_;
  double radius_;
  Paired<N> origin_;
  Paired<N> off_{Vec<N, double>(0.0)};  ///< From the middle of the chord to the center.
  double half_ = 0;
  double t_ = 0;
  RayVerdict verdict_ = RayVerdict::unclear;
};

template <Dim N, class T>
[[gnu::always_inline]] inline RaySphereFilter<N, T> quick_cast(const Sphere<N, T>& sphere, const Ray<N, T>& ray,
                                                               T t_max) {
  return {sphere, ray, t_max};
}

}  // namespace graze::detail

#endif
