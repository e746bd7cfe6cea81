// SPDX-License-Identifier: MIT
// Where a ray meets any convex shape, from nothing but its support function. Include ray_cast.hpp.
#pragma once

#include <algorithm>
#include <cmath>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/gjk.hpp>
#include <graze/query/ray_sight.hpp>
#include <graze/query/relation_unbounded.hpp>
#include <graze/query/wide_support.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// A halving of the distance per step, as when a ray grazes a round shape, ends at rounding after 52 steps.
inline constexpr int ray_step_limit = 64;

/// A plane between a point of the ray and the shape.
template <Dim N>
struct Barrier {
  Vec<N, double> normal = Vec<N, double>(0.0);  ///< Of length 1, towards the point.
  double height = 0;                            ///< Of the point over the plane; not positive if there is none.
  double gap = 0;                               ///< How far the shape may be at most.
  double resolution = 0;
};

/// The plane across the shortest way, with the shape's own farthest point: what GJK has proved is the distance to it.
template <Convex S>
Barrier<dimension_of<S>> barrier_at(const S& shape, const Vec<dimension_of<S>, double>& point) {
  constexpr Dim N = dimension_of<S>;
  const auto& inner = core(shape);
  const double radius = core_radius(shape);
  const GjkResult<N> found = gjk(point, inner);  // its separation leads from the shape to the point
  Barrier<N> barrier;
  barrier.gap = std::max(0.0, found.upper - radius);
  barrier.resolution = found.resolution + tolerance::rounding * radius;
  if (!(found.upper > radius + barrier.resolution)) return barrier;
  barrier.normal = unit_or(found.separation, Vec<N, double>(0.0));
  barrier.height = dot(barrier.normal, point - wide_support(inner, barrier.normal)) - radius;
  return barrier;
}

/// How near a missed shape must be for `relation` to have the last word.
template <Convex S>
double band_of_miss(const S& shape, const Path<dimension_of<S>>& path) {
  constexpr Dim N = dimension_of<S>;
  const auto box = bounds(shape);
  const Vec<N, double> largest = max(abs(wide<N, scalar_of<S>>(box.min)), abs(wide<N, scalar_of<S>>(box.max)));
  return 64 * support_error<S> * (sum_abs(path.origin) + sum_abs(largest) + core_radius(shape));
}

/// Moves a point along the path, each time to the plane that GJK has found between it and the shape: Newton's method on
/// the distance, which is a convex function of t, so it never gets past the first touch (van den Bergen, "Ray casting
/// against general convex objects with application to continuous collision detection", 2004, with a support of its own
/// for each plane). Ends where the shape is as near as support points can tell, or is not met, or at the step limit,
/// with the distance that is left as the error. A path that is known to touch ends where it is nearest.
template <Convex S>
Sighting<dimension_of<S>> advance_to(const S& shape, const Path<dimension_of<S>>& path) {
  constexpr Dim N = dimension_of<S>;
  Sighting<N> result{Sight::hits, {0, path.origin}};
  Touch<N>& touch = result.touch;
  const auto miss_by = [&](double distance) {
    result.sight = distance > band_of_miss(shape, path) ? Sight::misses : Sight::unclear;
    return result;
  };
  for (int step = 0; step < ray_step_limit; ++step) {
    touch.point = path.origin + path.direction * touch.t;
    const Barrier<N> barrier = barrier_at(shape, touch.point);
    touch.error = barrier.gap + barrier.resolution;
    if (!(barrier.height > barrier.resolution)) return result;
    const double approach = -dot(barrier.normal, path.direction);
    if (!(approach > 0)) return miss_by(barrier.height);
    touch.normal = barrier.normal;
    const double next = touch.t + barrier.height / approach;
    if (next > path.t_max) {
      const double missing = (next - path.t_max) * approach;
      touch.t = path.t_max;
      touch.point = path.origin + path.direction * path.t_max;
      return miss_by(missing);
    }
    if (next == touch.t) return result;
    touch.t = next;
  }
  touch.status = Status::best_bound;
  return result;
}

}  // namespace graze::detail
