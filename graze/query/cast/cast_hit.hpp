// SPDX-License-Identifier: MIT
// The ray casts of shape_cast.hpp. Include shape_cast.hpp.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <type_traits>

#include <graze/math/vec.hpp>
#include <graze/query/cast/minkowski_difference.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// Whether GJK has the final decision for a Minkowski difference. For a given shape, `relation` has it, as for rays.
template <class S>
inline constexpr bool is_minkowski_difference = false;
template <Dim N, Scalar Number>
inline constexpr bool is_minkowski_difference<MinkowskiDifference<N, Number>> = true;

/// A finite path, relative to its own origin if the shape can be expressed relative to it.
template <Dim N>
struct AskAboutPath {
  template <class S>
  Relation operator()(const S& shape) const {
    const Vec<N, double> end = path.direction * path.t_max;
    if (!is_finite(end)) return Relation::apart;
    if constexpr (HasRayVerdict<S>) {
      return decide(relative_to(path.origin, shape), Segment<N, double>{Vec<N, double>(0.0), end});
    } else if constexpr (HasBoundaryVerdict<S>) {
      return closed_form(shape, Segment<N, double>{path.origin, path.origin + end});
    } else {
      return relation_of_convex(Segment<N, double>{path.origin, path.origin + end}, shape);
    }
  }

  const Path<N>& path;
};

/// Where a path that is the beginning of a ray first touches. Touching at its end counts, even if only rounding moves
/// the end there.
template <class S, class T>
RayFinding<dimension_of<S>> ray_verdict_along(const S& shape, const Ray<dimension_of<S>, T>& ray,
                                              const Path<dimension_of<S>>& path) {
  constexpr Dim N = dimension_of<S>;
  const AskAboutRay<N, T> ask{ray};
  const RayFinding<N> start = verdict(shape, path);
  if constexpr (!HasBoundaryVerdict<S>) {
    if (start.verdict == RayVerdict::misses) return start;
    if (start.verdict == RayVerdict::hits) return is_minkowski_difference<S> ? start : confirmed(shape, ask, start);
  }
  const Path<N> whole{path.origin, path.direction, std::numeric_limits<double>::infinity(), path.far};
  const RayFinding<N> found = entry(shape, whole, ask);
  if (found.verdict == RayVerdict::misses || found.hit.t <= path.t_max) return found;
  if (start.verdict == RayVerdict::misses) return start;
  return settled(shape, path, AskAboutPath<N>{path}, start);
}

/// ray_cast(shape, ray, 1) before t is rounded, for a nonzero direction; includes what touches at t = 1 up to rounding.
template <class S, class T>
std::optional<RayHit<dimension_of<S>, double>> hit_in_double(const S& shape, const Ray<dimension_of<S>, T>& ray) {
  constexpr Dim N = dimension_of<S>;
  if constexpr (HasQuickCast<S> && std::is_same_v<T, double>) {
    const auto quick = quick_cast(shape, ray, 1.0);
    if (quick.verdict() == RayVerdict::misses) return std::nullopt;
    if (quick.verdict() == RayVerdict::hits) return quick.hit();
  }
  const Usable<N, T> usable(ray);
  const Path<N> path{wide<N, T>(ray.origin), wide<N, T>(usable.ray.direction), usable.to_usable(1.0)};
  RayFinding<N> found = ray_verdict_along(shape, usable.ray, path);
  if (found.verdict == RayVerdict::misses) return std::nullopt;
  if constexpr (is_a<Aabb, S>) put_on_surface(found.hit, shape);
  const double t = std::min(1.0, usable.from_usable(found.hit.t));
  return rounded<N, double>(found.hit, t, path.direction, RaySide::entry);
}

template <Dim N>
std::optional<CastHit<N>> cast_hit_of_ray(const std::optional<RayHit<N, double>>& hit) {
  if (!hit) return std::nullopt;
  return CastHit<N>{hit->t, hit->point, -hit->normal, hit->status, hit->error};
}

}  // namespace graze::detail
