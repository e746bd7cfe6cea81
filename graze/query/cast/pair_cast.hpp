// SPDX-License-Identifier: MIT
// The casts of shape_cast.hpp for two simple shapes of given types: up to the first touch, or until they are as near as
// a target distance. Include shape_cast.hpp.
//
// A target distance is a radius more: the shapes are that near where a, inflated by it, touches b.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/cast/cast_hit.hpp>
#include <graze/query/cast/minkowski_difference.hpp>
#include <graze/query/cast/moving_parts.hpp>
#include <graze/query/cast/zonotope_cast.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// The target distance of casts up to the first touch. A type of its own, so that they do not calculate with it.
struct NoTarget {
  constexpr operator double() const { return 0; }
};

/// The point at the target distance along a normal.
template <Dim N>
Vec<N, double> beyond(const Vec<N, double>& point, const Vec<N, double>& normal, double target) {
  return point + normal * target;
}
template <Dim N>
Vec<N, double> beyond(const Vec<N, double>& point, const Vec<N, double>&, NoTarget) {
  return point;
}

// ---- Planes and half-spaces: the gap along the normal is all that counts, and it shrinks evenly

template <class A, class B, class Target>
std::optional<CastHit<dimension_of<A>>> cast_hit_at_half_space(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                               const B& b, Target target) {
  constexpr Dim N = dimension_of<A>;
  const Proximity<N, double> gap = proximity_in_order(a, b, Relation::apart);
  const double approach = dot(gap.normal, motion);
  const double error = gap.error + tolerance::rounding * (target + sum_abs(motion));
  const double way = gap.distance - target;
  if (!(approach > 0) || way - approach > error) return std::nullopt;
  const double t = std::min(1.0, way / approach);
  const bool moves_with_a = is_plane_or_half_space<B> && !is_plane_or_half_space<A>;
  const Vec<N, double> point = moves_with_a ? beyond(gap.point_a, gap.normal, target) + motion * t : gap.point_b;
  return CastHit<N>{t, point, gap.normal, Status::converged, error};
}

// ---- Rays

/// In front of both origins: where the two lines cross, at one t unless they are parallel or move in their common
/// plane. With w from the origin of a to that of b and n = u x v, it is at t = (w . n) / (m . n), or earlier by the
/// time in which the lines come nearer by the target.
template <Dim N, class T>
std::optional<CastHit<N>> cast_hit_of_lines(const Ray<N, T>& a, const Vec<N, double>& motion, const Ray<N, T>& b,
                                            double target) {
  const Vec<3, double> u = direction_of(a);
  const Vec<3, double> v = direction_of(b);
  const Vec<3, double> w = lifted(wide<N, T>(b.origin) - wide<N, T>(a.origin));
  const Vec<3, double> m = lifted(motion);
  const Vec<3, double> n = accurate_cross(u, v);
  const double whole = dot(n, n);
  const double approach = dot(m, n);
  if (!(whole > 0) || approach == 0) return std::nullopt;
  const double t = (dot(w, n) - std::copysign(target * std::sqrt(whole), approach)) / approach;
  if (!(t >= 0 && t <= 1)) return std::nullopt;
  const Vec<3, double> between = w - m * t;
  const double on_a = dot(accurate_cross(between, v), n) / whole;
  const double on_b = dot(accurate_cross(between, u), n) / whole;
  if (!(on_a >= 0 && on_b >= 0)) return std::nullopt;
  const Vec<N, double> point = wide<N, T>(b.origin) + Vec<N, double>(v * on_b);
  const double size = sum_abs(w) + sum_abs(m) + sum_abs(v) * on_b + sum_abs(u) * on_a + target;
  return CastHit<N>{t, point, unit_or(Vec<N, double>(approach > 0 ? n : -n), Vec<N, double>(0.0)), Status::converged,
                    tolerance::coarse * size};
}

/// The first touch is between an origin and a ray, or in 3D between two inner points. If the rays are not coplanar, the
/// normal is perpendicular to both.
template <Dim N, class T>
std::optional<CastHit<N>> cast_hit_of_rays(const Ray<N, T>& a, const Vec<N, double>& motion, const Ray<N, T>& b) {
  std::optional<CastHit<N>> first = cast_hit_of_ray(hit_in_double(b, Ray<N, T>{a.origin, Vec<N, T>(motion)}));
  std::optional<CastHit<N>> other = cast_hit_of_ray(hit_in_double(a, Ray<N, T>{b.origin, Vec<N, T>(-motion)}));
  if (other) {
    other->normal = -other->normal;
    other->point = wide<N, T>(b.origin);
  }
  keep_earlier(first, other);
  if constexpr (N == 3) {
    keep_earlier(first, cast_hit_of_lines(a, motion, b, 0));
    if (first) {
      const Vec<N, double> across = unit_or(accurate_cross(direction_of(a), direction_of(b)), Vec<N, double>(0.0));
      const double approach = dot(across, motion);
      if (std::fabs(approach) > tolerance::coarse * sum_abs(motion)) first->normal = approach > 0 ? across : -across;
    }
  }
  return first;
}

/// The box of all points that a shape passes as it moves.
template <class S>
Aabb<dimension_of<S>, double> swept_box(const S& shape, const Vec<dimension_of<S>, double>& motion) {
  return box_swept_by(bounds(shape), motion);
}

/// A core in double; a ray is cut where it has passed the other, moving shape.
template <class Core, class Other>
auto seen_beside_moving(const Vec<dimension_of<Core>, double>& origin, const Core& core, const Other& other,
                        const Vec<dimension_of<Core>, double>& motion) {
  if constexpr (is_ray<Core>) {
    using Number = scalar_of<Core>;
    constexpr Dim N = dimension_of<Core>;
    const Ray<N, double> ray{wide<N, Number>(core.origin), wide<N, Number>(core.direction)};
    const Vec<N, double> start = ray.origin - origin;
    return Segment<N, double>{start, start + reach_to(ray, swept_box(other, motion))};
  } else {
    return relative_to(origin, core);
  }
}

// ---- Shapes with simple cores, relative to one of them

template <class A, class B>
concept HasMinkowskiDifference = requires(const A& a, const B& b) {
  minkowski_difference_of(a, b, 0.0);
};

/// Where a moving core first touches another, both widened by radii; the point is not yet known.
template <class A, class B>
std::optional<RayHit<dimension_of<A>, double>> hit_of_cores(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                            const B& b, double radius) {
  constexpr Dim N = dimension_of<A>;
  const Ray<N, double> ray{Vec<N, double>(0.0), motion};
  if constexpr (is_a<Aabb, A> && is_a<Aabb, B>) {
    const Aabb<N, double> difference = minkowski_difference_of(a, b, 0.0);
    if (radius > 0) return hit_in_double(RoundedBox<N>{difference, radius}, ray);
    return hit_in_double(difference, ray);
  } else if constexpr (HasMinkowskiDifference<A, B>) {
    return hit_in_double(minkowski_difference_of(a, b, radius), ray);
  } else {
    return hit_in_double(MinkowskiDifference<N, double>{ConvexView<N>(a), ConvexView<N>(b), ray.origin, radius}, ray);
  }
}

template <Dim N>
ClosestPair<N> closest_of_touching(const Aabb<N, double>& a, const Aabb<N, double>& b, double) {
  return closest_of_boxes(a, b);
}
template <class A, class B>
ClosestPair<dimension_of<A>> closest_of_touching(const A& a, const B& b, double size) {
  return closest_of_apart(a, b, size);
}

/// If GJK stalled, as between slivers: advances from there to the plane between the nearest points of both cores, as
/// advance_by_distance does, but with the closed forms.
template <class A, class B>
std::optional<RayHit<dimension_of<A>, double>> advance_by_features(const A& a,
                                                                   const Vec<dimension_of<A>, double>& motion,
                                                                   const B& b, double radius,
                                                                   RayHit<dimension_of<A>, double> hit) {
  constexpr Dim N = dimension_of<A>;
  for (int step = 0; step < ray_step_limit; ++step) {
    const auto moved_a = relative_to(motion * -hit.t, a);
    const double size = size_around_zero(moved_a) + size_around_zero(b);
    const ClosestPair<N> nearest = closest_of_touching(moved_a, b, size);
    const double distance = std::max(0.0, std::sqrt(nearest.squared) - radius);
    const double resolution = tolerance::coarse * (size + radius);
    hit.error = distance + resolution;
    hit.status = distance <= resolution ? Status::converged : Status::best_bound;
    if (hit.status == Status::converged) return hit;
    const Vec<N, double> normal = unit_or(nearest.between, Vec<N, double>(0.0));
    const double height = span_along(normal, b).low - span_along(normal, moved_a).high - radius;
    const double approach = dot(normal, motion);
    if (!(height > resolution / 2)) return hit;
    if (!(height - approach * (1 - hit.t) <= resolution)) return std::nullopt;  // never near enough
    const double next = std::min(1.0, hit.t + (height - resolution / 2) / approach);
    if (!(next > hit.t)) return hit;
    hit.t = next;
    hit.normal = -normal;
  }
  return hit;
}

/// The direction between two cores that are apart, unless the motion goes backward along it; else `otherwise`.
template <Dim N>
Vec<N, double> normal_between(const Vec<N, double>& between, const Vec<N, double>& motion,
                              const Vec<N, double>& otherwise) {
  const Vec<N, double> way = motion / max_abs(motion);  // not zero, though its square may be
  const double back = dot(between, way);
  return unit_or(back < 0 ? between - way * (back / dot(way, way)) : between, otherwise);
}

/// The impact of two cores widened by radii, from the hit and their nearest points at its t. GJK's planes are proved to
/// separate the shapes up to rounding; the spokes of round obstacles have the rounding of their centers, and the vector
/// between the cores is more exact. It also is used if there was no plane, because the shapes nearly touch at the
/// start, and with a target distance, over which the error of a plane's normal would move the point.
template <Dim N>
CastHit<N> cast_hit_between(const RayHit<N, double>& hit, const ClosestPair<N>& nearest, const Vec<N, double>& motion,
                            const Radii& radii, bool is_proved) {
  const bool are_apart = radii.a + radii.b > hit.error;
  const Vec<N, double> between = normal_between(nearest.between, motion, -hit.normal);
  const bool is_between = hit.t == 0 || (are_apart && !is_proved);
  const Vec<N, double> normal = is_between ? between : -hit.normal;
  const Vec<N, double> point = nearest.on_b - (are_apart ? between : normal) * radii.b;
  const double rounding = tolerance::rounding * (radii.a + radii.b + sum_abs(motion));
  return {hit.t, point, normal, hit.status, hit.error + rounding};
}

template <class A, class B>
concept HaveZonotopes = HasZonotope<std::decay_t<A>> && HasZonotope<std::decay_t<B>> && !HasMinkowskiDifference<A, B>;

/// The first touch of two cores, by a ray at the set of their differences, relative to a stored point. The radius of b
/// includes the target.
template <class A, class B, class Target = NoTarget>
std::optional<CastHit<dimension_of<A>>> cast_hit_of_cores(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                          const B& b, const Radii& radii, Target target = {}) {
  constexpr Dim N = dimension_of<A>;
  auto hit = hit_of_cores(a, motion, b, radii.a + radii.b);
  if (hit && hit->status != Status::converged) hit = advance_by_features(a, motion, b, radii.a + radii.b, *hit);
  if (!hit) return std::nullopt;
  const auto moved_a = relative_to(motion * -hit->t, a);
  const double size = size_around_zero(moved_a) + size_around_zero(b);
  const ClosestPair<N> nearest = closest_of_touching(moved_a, b, size);
  CastHit<N> cast_hit = cast_hit_between(*hit, nearest, motion, radii, !HasMinkowskiDifference<A, B> && target == 0);
  cast_hit.error += tolerance::rounding * size;
  return cast_hit;
}

template <HasSimpleCore A, HasSimpleCore B, class Target>
std::optional<CastHit<dimension_of<A>>> cast_hit_of_simple(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                           const B& b, Target target) {
  constexpr Dim N = dimension_of<A>;
  const auto& core_a = core(a);
  const auto& core_b = core(b);
  const Vec<N, double> origin = reference(core_a);
  const auto local_a = seen_beside_moving(origin, core_a, core_b, -motion);
  const auto local_b = seen_beside_moving(origin, core_b, core_a, motion);
  const Radii radii{core_radius(a), core_radius(b) + target};
  std::optional<CastHit<N>> cast_hit;
  if constexpr (HaveZonotopes<decltype(local_a), decltype(local_b)>) {
    const CastHitOfZonotopes<N> found = cast_hit_of_zonotopes(local_a, motion, local_b, radii);
    if (found.verdict == RayVerdict::misses) return std::nullopt;
    if (found.verdict == RayVerdict::hits) cast_hit = found.cast_hit;
  }
  if (!cast_hit) cast_hit = cast_hit_of_cores(local_a, motion, local_b, radii, target);
  if (cast_hit) cast_hit->point = beyond(cast_hit->point + origin, cast_hit->normal, target);
  return cast_hit;
}

// ---- Everything else that is convex

/// The moved shape a and the shape b of an obstacle, in the number type of their supports.
template <Dim N, Scalar Number>
struct MovedView {
  ConvexView<N> view;
  Vec<N, double> motion;
};

template <Dim N, Scalar Number>
Vec<N, double> support(const MovedView<N, Number>& moved, const std::type_identity_t<Vec<N, double>>& direction) {
  return moved.view.support(direction) + moved.motion;
}

template <Dim N>
inline constexpr double support_error<MovedView<N, float>> = tolerance::convex_in<float>;

template <Convex A, Convex B, class Target>
std::optional<CastHit<dimension_of<A>>> cast_hit_of_convex(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                           const B& b, Target target) {
  constexpr Dim N = dimension_of<A>;
  using Number = SupportNumber<A, B>;
  const auto& core_a = core(a);
  const auto& core_b = core(b);
  const ConvexView<N> view_a(core_a);
  const ConvexView<N> view_b(core_b);
  const Vec<N, double> place = view_a.support(motion);
  const Radii radii{core_radius(a), core_radius(b) + target};
  const MinkowskiDifference<N, Number> difference{view_a, view_b, place, radii.a + radii.b};
  const auto hit = hit_in_double(difference, Ray<N, double>{place, motion});
  if (!hit) return std::nullopt;
  const ConvexCores<N> nearest = closest_of_convex(MovedView<N, Number>{view_a, motion * hit->t},
                                                   MovedView<N, Number>{view_b, Vec<N, double>(0.0)});
  CastHit<N> cast_hit = cast_hit_between(*hit, nearest.closest, motion, radii, target == 0);
  cast_hit.point = beyond(cast_hit.point, cast_hit.normal, target);
  return cast_hit;
}

/// Cuts the ray first.
template <class A, class B, class Target>
std::optional<CastHit<dimension_of<A>>> cast_hit_past_ray(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                          const B& b, Target target) {
  const Vec<dimension_of<A>, double> zero(0.0);
  if constexpr (is_ray<A>) {
    return cast_hit_of_convex(seen_beside_moving(zero, a, b, -motion), motion, b, target);
  } else if constexpr (is_ray<B>) {
    return cast_hit_of_convex(a, motion, seen_beside_moving(zero, b, a, motion), target);
  } else {
    return cast_hit_of_convex(a, motion, b, target);
  }
}

// ---- Any two shapes

template <class A, class B, class Target>
std::optional<CastHit<dimension_of<A>>> cast_hit_in_order(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                          const B& b, Target target);

/// Two rays come as near as the target at the origin of one of them, or in 3D between two inner points.
template <Dim N, class T>
std::optional<CastHit<N>> near_hit_of_rays(const Ray<N, T>& a, const Vec<N, double>& motion, const Ray<N, T>& b,
                                           double target) {
  std::optional<CastHit<N>> first = cast_hit_of_simple(Sphere<N, T>{a.origin, 0}, motion, b, target);
  std::optional<CastHit<N>> other = cast_hit_of_simple(Sphere<N, T>{b.origin, 0}, -motion, a, target);
  if (other) {
    other->normal = -other->normal;
    other->point = wide<N, T>(b.origin);
  }
  keep_earlier(first, other);
  if constexpr (N == 3) keep_earlier(first, cast_hit_of_lines(a, motion, b, target));
  return first;
}

/// For two simple shapes that are farther apart than the target, in the order of AnyShape. The point is on b.
template <class A, class B, class Target>
std::optional<CastHit<dimension_of<A>>> cast_hit_in_order(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                          const B& b, Target target) {
  constexpr Dim N = dimension_of<A>;
  using T = scalar_of<A>;
  if constexpr (is_plane_or_half_space<B> || is_plane_or_half_space<A>) {
    if constexpr (is_point<A>) {
      if (target == 0) return cast_hit_of_ray(hit_in_double(b, Ray<N, T>{a, Vec<N, T>(motion)}));
    }
    return cast_hit_at_half_space(a, motion, b, target);
  } else if constexpr (is_point<A>) {
    if (target == 0) return cast_hit_of_ray(hit_in_double(b, Ray<N, T>{a, Vec<N, T>(motion)}));
    return cast_hit_in_order(Sphere<N, T>{a, 0}, motion, b, target);
  } else if constexpr (is_ray<A> && is_ray<B>) {
    return target == 0 ? cast_hit_of_rays(a, motion, b) : near_hit_of_rays(a, motion, b, target);
  } else if constexpr (HasSimpleCore<A> && HasSimpleCore<B>) {
    return cast_hit_of_simple(a, motion, b, target);
  } else {
    return cast_hit_past_ray(a, motion, b, target);
  }
}

/// For b before a: b moves the opposite way past a, and the result is moved along, to the side of b.
template <class A, class B, class Target>
std::optional<CastHit<dimension_of<A>>> exchanged_cast_hit(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                           const B& b, Target target) {
  auto cast_hit = cast_hit_in_order(b, -motion, a, target);
  if (cast_hit) {
    cast_hit->normal = Vec<dimension_of<A>, double>(0.0) - cast_hit->normal;
    cast_hit->point = beyond(cast_hit->point, cast_hit->normal, target) + motion * cast_hit->t;
  }
  return cast_hit;
}

}  // namespace graze::detail
