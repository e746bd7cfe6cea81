// SPDX-License-Identifier: MIT
// The precise algorithm of ray_cast.hpp for one simple shape. Include ray_cast.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/query/ray/advance.hpp>
#include <graze/query/ray/parts.hpp>
#include <graze/query/ray/portal.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/ray/verdict_2d.hpp>
#include <graze/query/ray/verdict_box.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/nan_check.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// A shape with a closed form in double, relative to the ray's origin.
template <class S>
concept HasRayVerdict = requires(const S& shape, const Path<dimension_of<S>>& path) {
  ray_verdict_of(relative_to(path.origin, shape), path);
};

/// A shape with a fast test that rejects most paths that miss it.
template <class S>
concept HasQuickMiss = requires(const S& shape, const Path<dimension_of<S>>& path) {
  is_missed(relative_to(path.origin, shape), path);
};

template <class S>
concept HasBoundaryVerdict = is_a<Plane, S> || is_a<HalfSpace, S>;

// ---- The path as an argument of `relation`

template <Dim N, class T>
struct AskAboutSegment {
  template <class S>
  Relation operator()(const S& shape) const {
    return decide(shape, segment);
  }

  const Segment<N, T>& segment;
};

/// The whole ray.
template <Dim N, class T>
struct AskAboutRay {
  template <class S>
  Relation operator()(const S& shape) const {
    return decide(shape, ray);
  }

  const Ray<N, T>& ray;
};

// ---- One simple shape

/// The result of the shape's closed form, with points in the original coordinates.
template <class S>
[[gnu::always_inline]] inline RayFinding<dimension_of<S>> verdict(const S& shape, const Path<dimension_of<S>>& path) {
  constexpr Dim N = dimension_of<S>;
  if constexpr (HasRayVerdict<S>) {
    RayFinding<N> result = ray_verdict_of(relative_to(path.origin, shape), path);
    result.hit.point += path.origin;
    return result;
  } else if constexpr (HasBoundaryVerdict<S>) {
    return ray_verdict_of_boundary(shape, path);
  } else if constexpr (N == 2 && is_a<Polytope, S>) {
    RayFinding<N> result = ray_verdict_of_polygon<scalar_of<S>>(shape.vertices(), sum_abs(path.origin), path);
    result.hit.point += path.origin;
    return result;
  } else if constexpr (is_a<Polytope, S>) {
    return ray_verdict_of_polytope(shape, path);
  } else {
    return advance_to(shape, path);
  }
}

/// Where an unclear path touches, if `relation` decides that it does. `relation` also reports a touch for shapes that
/// are apart by less than the rounding of its longest calculations, which is a few times that of the closed forms here.
template <class S, class Ask>
RayFinding<dimension_of<S>> settled(const S& shape, const Path<dimension_of<S>>& path, const Ask& ask,
                                    const RayFinding<dimension_of<S>>& unclear) {
  constexpr Dim N = dimension_of<S>;
  if (ask(shape) == Relation::apart) return missed<N>();
  RayFinding<N> result{RayVerdict::hits, unclear.hit};
  if (unclear.is_hit_known) {
    constexpr double slack_of_touching = tolerance::coarse / tolerance::rounding;
    if constexpr (!HasBoundaryVerdict<S>) result.hit.error *= slack_of_touching;
    return result;
  }
  if constexpr (Convex<S> && HasRayVerdict<S>) {
    const Path<N> from_zero{Vec<N, double>(0.0), path.direction, path.t_max, path.far};
    result.hit = hit_by_advance(relative_to(path.origin, shape), from_zero);
    result.hit.point += path.origin;
  } else if constexpr (Convex<S>) {
    result.hit = hit_by_advance(shape, path);
  }
  return result;
}

/// A hit, if `relation` confirms it where necessary.
template <class S, class Ask>
RayFinding<dimension_of<S>> confirmed(const S& shape, const Ask& ask, const RayFinding<dimension_of<S>>& hit) {
  return hit.is_certain || ask(shape) != Relation::apart ? hit : missed<dimension_of<S>>();
}

/// A touch, or that the path misses.
template <class S, class Ask>
RayFinding<dimension_of<S>> entry(const S& shape, const Path<dimension_of<S>>& path, const Ask& ask) {
  const RayFinding<dimension_of<S>> result = verdict(shape, path);
  if (result.verdict == RayVerdict::unclear) return settled(shape, path, ask, result);
  return result.verdict == RayVerdict::hits ? confirmed(shape, ask, result) : result;
}

/// A power of two that t cannot reach before the path has left the shape; exact, so that the reversed path is exact,
/// too.
template <class S>
double beyond(const S& shape, const Path<dimension_of<S>>& path) {
  constexpr Dim N = dimension_of<S>;
  const Vec<N, double> reach = reach_past(shape, path);
  int exponent = 0;
  (void)std::frexp(max_abs(reach) / max_abs(path.direction), &exponent);
  return std::ldexp(1.0, exponent + 1);
}

/// The entry of the reversed path, from a point where the path has left the shape.
template <class S, class Ask>
RayFinding<dimension_of<S>> last_touch(const S& shape, const Path<dimension_of<S>>& path, const Ask& ask) {
  constexpr Dim N = dimension_of<S>;
  if constexpr (HasRayVerdict<S>) {
    const auto seen = relative_to(path.origin, shape);
    const double last = beyond(seen, {Vec<N, double>(0.0), path.direction, path.t_max});
    const Path<N> back{path.direction * last, -path.direction, last, path.far};
    RayFinding<N> result = entry(seen, back, [&](const auto&) { return ask(shape); });
    result.hit.t = last - result.hit.t;
    result.hit.point += path.origin;
    return result;
  } else {
    const double last = beyond(shape, path);
    const Path<N> back{path.origin + path.direction * last, -path.direction, last, path.far};
    RayFinding<N> result = entry(shape, back, ask);
    result.hit.t = last - result.hit.t;
    return result;
  }
}

/// Where the path leaves a shape that it has entered, which may be after its end.
template <class S, class Ask>
RayFinding<dimension_of<S>> exit(const S& shape, const Path<dimension_of<S>>& path, const Ask& ask) {
  const RayFinding<dimension_of<S>> last = last_touch(shape, path, ask);
  if (last.verdict == RayVerdict::misses || last.hit.t <= path.t_max) return last;
  return entry(shape, path, ask).verdict == RayVerdict::misses ? missed<dimension_of<S>>() : last;
}

/// Never left: the path then leaves at infinity.
template <Dim N>
RayFinding<N> never() {
  return {RayVerdict::hits, {std::numeric_limits<double>::infinity()}};
}

/// A path meets a plane once, and leaves it there, unless it runs along it.
template <Dim N, class T, class Ask>
RayFinding<N> exit(const Plane<N, T>& plane, const Path<N>& path, const Ask& ask) {
  RayFinding<N> result = entry(plane, path, ask);
  if (result.verdict == RayVerdict::hits && is_along(plane, path)) return never<N>();
  result.hit.normal = -result.hit.normal;
  return result;
}

/// A path leaves a half-space if it climbs, otherwise never.
template <Dim N, class T, class Ask>
RayFinding<N> exit(const HalfSpace<N, T>& solid, const Path<N>& path, const Ask& ask) {
  if (ask(solid) == Relation::apart) return missed<N>();
  const Vec<N, double> normal = wide<N, T>(solid.normal);
  if (!(dot(normal, path.direction) > 0) || is_along(boundary(solid), path)) return never<N>();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  RayFinding<N> result{RayVerdict::hits, hit_of_plane(boundary(solid), Path<N>{path.origin, path.direction, infinity})};
  result.hit.normal = normal;
  return result;
}

/// A ray on the same line is left at its origin, or never if it has the same direction; any other ray where it is met.
template <Dim N, class T, class Ask>
RayFinding<N> exit(const Ray<N, T>& target, const Path<N>& path, const Ask& ask) {
  RayFinding<N> result = entry(target, path, ask);
  if (result.verdict == RayVerdict::misses) return result;
  result.hit.normal = -result.hit.normal;
  const Vec<3, double> d = direction_of(Ray<N, double>{path.origin, path.direction});
  const Vec<3, double> e = direction_of(target);
  const double lengths = std::sqrt(length_squared(d) * length_squared(e));
  if (std::sqrt(length_squared(accurate_cross(d, e))) > tolerance::rounding * lengths) return result;
  if (dot(d, e) > 0) return never<N>();
  const Vec<N, double> end = wide<N, T>(target.origin);
  const RayFinding<N> at_end = ray_verdict_of(end - path.origin, path);
  result.hit = {at_end.hit.t, end, Vec<N, double>(0.0), result.hit.error};
  return result;
}

}  // namespace graze::detail
