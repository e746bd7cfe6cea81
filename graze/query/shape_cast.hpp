// SPDX-License-Identifier: MIT
/// @file
/// shape_cast(a, motion, b): when and where a shape that translates along a vector first touches another one.
///
/// What finds it. C: closed form, with GJK for near misses. S: the supports along the plane's normal, a closed form for
/// every convex shape. P: part by part. G: GJK, a few steps. C/G: C in 2D, G in 3D.
///
///                 segment ray sphere aabb obb plane half-space triangle capsule polytope compound user's
///     point          C     C    C     C    C    S       S         C        C      C/G       P       G
///     segment       C/G   C/G   C     C    C    S       S         G        C       G        P       G
///     ray                  C    C     C    C    S       S         G        C       G        P       G
///     sphere                    C     C    C    S       S         G        C       G        P       G
///     aabb                            C    C    S       S         G        C       G        P       G
///     obb                                  C    S       S         G        C       G        P       G
///     plane                                     S       S         S        S       S        P       S
///     half-space                                        S         S        S       S        P       S
///     triangle                                                    G        G       G        P       G
///     capsule                                                              C       G        P       G
///     polytope                                                                     G        P       G
///     compound                                                                              P       P
///
/// For a point, the result is that of ray_cast.hpp for the ray from the point along `motion` with t_max = 1, near
/// misses included. Any two shapes become a ray from zero and the Minkowski difference b - a: a sphere and a capsule
/// make a capsule, two axis-aligned boxes a box, and segments and boxes a zonotope (see zonotope_cast.hpp), with round
/// edges if one of them is the core of a capsule or a sphere. The set of any two convex shapes has support points.
///
/// Shapes that meet at the start, as relation(a, b) decides, have contact(a, b) as the impact, at t = 0. Later, the
/// normal is that of a plane with a on one side at t and b on the other, and a has moved towards it. Shapes that touch
/// along a face or an edge return one of many points; it is as near to both as closest_points.hpp states. A compound
/// counts as its first part to touch.
///
/// `error` is a length: at t, before rounding to T, the shapes are at most that far apart, and before t they are
/// nowhere deeper in each other. For closed forms of bounded shapes, and shapes without curved faces, it is a few
/// epsilon of double of the coordinates relative to a or b, the motion's included; for planes, half-spaces, polytopes
/// and users' shapes a few epsilon of the largest coordinate (of T for those that calculate in T); for nearly parallel
/// rays also of where they touch, which may be far away. `status` tells if GJK could not come that near. At a grazing
/// angle t is less exact than the distance. Coordinates may be any finite numbers; see range.hpp for sizes that differ
/// by more than a factor of 2^900.
#pragma once

#include <algorithm>
#include <cassert>
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
#include <graze/query/compiled/instances.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/nan_check.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

namespace detail {

// ---- Planes and half-spaces: the gap along the normal is all that counts, and it shrinks evenly

template <class A, class B>
std::optional<CastHit<dimension_of<A>>> cast_hit_at_half_space(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                               const B& b) {
  constexpr Dim N = dimension_of<A>;
  const Proximity<N, double> gap = proximity_in_order(a, b, Relation::apart);
  const double approach = dot(gap.normal, motion);
  const double error = gap.error + tolerance::rounding * sum_abs(motion);
  if (!(approach > 0) || gap.distance - approach > error) return std::nullopt;
  const double t = std::min(1.0, gap.distance / approach);
  const bool moves_with_a = is_plane_or_half_space<B> && !is_plane_or_half_space<A>;
  return CastHit<N>{t, moves_with_a ? gap.point_a + motion * t : gap.point_b, gap.normal, Status::converged, error};
}

// ---- Rays

/// The touch in front of both origins: where the two lines cross, at one t unless they are parallel or move in their
/// common plane. With w from the origin of a to that of b and n = u x v, it is at t = (w . n) / (m . n).
template <Dim N, class T>
std::optional<CastHit<N>> cast_hit_of_lines(const Ray<N, T>& a, const Vec<N, double>& motion, const Ray<N, T>& b) {
  const Vec<3, double> u = direction_of(a);
  const Vec<3, double> v = direction_of(b);
  const Vec<3, double> w = lifted(wide<N, T>(b.origin) - wide<N, T>(a.origin));
  const Vec<3, double> m = lifted(motion);
  const Vec<3, double> n = accurate_cross(u, v);
  const double whole = dot(n, n);
  const double approach = dot(m, n);
  if (!(whole > 0) || approach == 0) return std::nullopt;
  const double t = dot(w, n) / approach;
  if (!(t >= 0 && t <= 1)) return std::nullopt;
  const Vec<3, double> between = w - m * t;
  const double on_a = dot(accurate_cross(between, v), n) / whole;
  const double on_b = dot(accurate_cross(between, u), n) / whole;
  if (!(on_a >= 0 && on_b >= 0)) return std::nullopt;
  const Vec<N, double> point = wide<N, T>(b.origin) + Vec<N, double>(v * on_b);
  const double size = sum_abs(w) + sum_abs(m) + sum_abs(v) * on_b + sum_abs(u) * on_a;
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
    keep_earlier(first, cast_hit_of_lines(a, motion, b));
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
  if constexpr (HasMinkowskiDifference<A, B>) {
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
/// start.
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

/// The first touch of two cores, by a ray at the set of their differences, relative to a stored point.
template <class A, class B>
std::optional<CastHit<dimension_of<A>>> cast_hit_of_cores(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                          const B& b, const Radii& radii) {
  constexpr Dim N = dimension_of<A>;
  auto hit = hit_of_cores(a, motion, b, radii.a + radii.b);
  if (hit && hit->status != Status::converged) hit = advance_by_features(a, motion, b, radii.a + radii.b, *hit);
  if (!hit) return std::nullopt;
  const auto moved_a = relative_to(motion * -hit->t, a);
  const double size = size_around_zero(moved_a) + size_around_zero(b);
  const ClosestPair<N> nearest = closest_of_touching(moved_a, b, size);
  CastHit<N> cast_hit = cast_hit_between(*hit, nearest, motion, radii, !HasMinkowskiDifference<A, B>);
  cast_hit.error += tolerance::rounding * size;
  return cast_hit;
}

template <HasSimpleCore A, HasSimpleCore B>
std::optional<CastHit<dimension_of<A>>> cast_hit_of_simple(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                           const B& b) {
  constexpr Dim N = dimension_of<A>;
  const auto& core_a = core(a);
  const auto& core_b = core(b);
  const Vec<N, double> origin = reference(core_a);
  const auto local_a = seen_beside_moving(origin, core_a, core_b, -motion);
  const auto local_b = seen_beside_moving(origin, core_b, core_a, motion);
  const Radii radii{core_radius(a), core_radius(b)};
  std::optional<CastHit<N>> cast_hit;
  if constexpr (HaveZonotopes<decltype(local_a), decltype(local_b)>) {
    const CastHitOfZonotopes<N> found = cast_hit_of_zonotopes(local_a, motion, local_b, radii);
    if (found.verdict == RayVerdict::misses) return std::nullopt;
    if (found.verdict == RayVerdict::hits) cast_hit = found.cast_hit;
  }
  if (!cast_hit) cast_hit = cast_hit_of_cores(local_a, motion, local_b, radii);
  if (cast_hit) cast_hit->point += origin;
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

template <Convex A, Convex B>
std::optional<CastHit<dimension_of<A>>> cast_hit_of_convex(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                           const B& b) {
  constexpr Dim N = dimension_of<A>;
  using Number = SupportNumber<A, B>;
  const auto& core_a = core(a);
  const auto& core_b = core(b);
  const ConvexView<N> view_a(core_a);
  const ConvexView<N> view_b(core_b);
  const Vec<N, double> place = view_a.support(motion);
  const MinkowskiDifference<N, Number> difference{view_a, view_b, place, core_radius(a) + core_radius(b)};
  const auto hit = hit_in_double(difference, Ray<N, double>{place, motion});
  if (!hit) return std::nullopt;
  const ConvexCores<N> nearest = closest_of_convex(MovedView<N, Number>{view_a, motion * hit->t},
                                                   MovedView<N, Number>{view_b, Vec<N, double>(0.0)});
  return cast_hit_between(*hit, nearest.closest, motion, {core_radius(a), core_radius(b)}, true);
}

/// Cuts the ray first.
template <class A, class B>
std::optional<CastHit<dimension_of<A>>> cast_hit_past_ray(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                          const B& b) {
  const Vec<dimension_of<A>, double> zero(0.0);
  if constexpr (is_ray<A>) {
    return cast_hit_of_convex(seen_beside_moving(zero, a, b, -motion), motion, b);
  } else if constexpr (is_ray<B>) {
    return cast_hit_of_convex(a, motion, seen_beside_moving(zero, b, a, motion));
  } else {
    return cast_hit_of_convex(a, motion, b);
  }
}

// ---- Any two shapes

/// For two simple shapes that are apart, in the order of AnyShape.
template <class A, class B>
std::optional<CastHit<dimension_of<A>>> cast_hit_in_order(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                          const B& b) {
  constexpr Dim N = dimension_of<A>;
  using T = scalar_of<A>;
  if constexpr (is_point<A>) {
    return cast_hit_of_ray(hit_in_double(b, Ray<N, T>{a, Vec<N, T>(motion)}));
  } else if constexpr (is_plane_or_half_space<A> || is_plane_or_half_space<B>) {
    return cast_hit_at_half_space(a, motion, b);
  } else if constexpr (is_ray<A> && is_ray<B>) {
    return cast_hit_of_rays(a, motion, b);
  } else if constexpr (HasSimpleCore<A> && HasSimpleCore<B>) {
    return cast_hit_of_simple(a, motion, b);
  } else {
    return cast_hit_past_ray(a, motion, b);
  }
}

/// For b before a: b moves the opposite way past a, and the result is moved along.
template <class A, class B>
std::optional<CastHit<dimension_of<A>>> exchanged_cast_hit(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                           const B& b) {
  auto cast_hit = cast_hit_in_order(b, -motion, a);
  if (cast_hit) {
    cast_hit->point += motion * cast_hit->t;
    cast_hit->normal = Vec<dimension_of<A>, double>(0.0) - cast_hit->normal;
  }
  return cast_hit;
}

template <class A, class B>
std::optional<CastHit<dimension_of<A>>> cast_hit(const A& a, const Vec<dimension_of<A>, double>& motion, const B& b);

/// The impact of shapes that are out of range, if there is one; none for others.
template <class A, class B>
auto cast_hit_in_range(const A& a, const Vec<dimension_of<A>, double>& motion, const B& b) {
  return answer_in_range<std::optional<CastHit<dimension_of<A>>>>(
      [](const auto& power, const auto& scaled_a, const auto& scaled_motion, const auto& scaled_b) {
        return resized(cast_hit(scaled_a, scaled_motion, scaled_b), power.inverse());
      },
      a, motion, b);
}

/// For shapes that are apart and a nonzero motion.
template <class A, class B>
std::optional<CastHit<dimension_of<A>>> cast_hit(const A& a, const Vec<dimension_of<A>, double>& motion, const B& b) {
  if constexpr (is_any_shape<A>) {
    return detail::visit([&](const auto& held) { return cast_hit(held, motion, b); }, a);
  } else if constexpr (is_any_shape<B>) {
    return detail::visit([&](const auto& held) { return cast_hit(a, motion, held); }, b);
  } else if constexpr (is_compound<A>) {
    return cast_hit_of_parts(a, motion, b, [&](const auto& part) { return cast_hit(part, motion, b); });
  } else if constexpr (is_compound<B>) {
    return cast_hit_of_parts(b, -motion, a, [&](const auto& part) { return cast_hit(a, motion, part); });
  } else {
    if (any_nan(a, b)) return std::nullopt;
    if (!are_usual(a, b, motion)) {
      if (const auto rescaled = cast_hit_in_range(a, motion, b)) return *rescaled;
    }
    if constexpr (type_place<A> < type_place<B>) {
      return cast_hit_in_order(a, motion, b);
    } else if constexpr (type_place<A> > type_place<B>) {
      return exchanged_cast_hit(a, motion, b);
    } else {
      return is_in_order(a, b) ? cast_hit_in_order(a, motion, b) : exchanged_cast_hit(a, motion, b);
    }
  }
}

/// shape_cast for shapes that need not be valid.
template <class A, class B>
std::optional<Impact<dimension_of<A>, scalar_of<A>>> impact_of(const A& a,
                                                               const Vec<dimension_of<A>, scalar_of<A>>& motion,
                                                               const B& b) {
  using T = scalar_of<A>;
  if (!is_finite(motion)) return std::nullopt;
  if (const auto contact = penetration(a, b)) return rounded_impact<T>(cast_hit_at_start(*contact));
  if (max_abs(motion) == T(0)) return std::nullopt;
  if (const auto found = cast_hit(a, wide<dimension_of<A>, T>(motion), b)) return rounded_impact<T>(*found);
  return std::nullopt;
}

}  // namespace detail

/// The first touch of a valid shape (asserted) that translates by `motion` from t = 0 to t = 1, and a fixed one of the
/// same dimension and number type; none if they do not touch. Touching counts, also at the start and at the end; a zero
/// motion hits what the shape touches already. t is never after the first touch and no earlier than the error explains.
/// Swapping the shapes and reversing the motion moves the point along, negates the normal and changes nothing else. A
/// compound is the union of its parts. Shapes or motions with a NaN touch nothing. For shapes that also rotate:
/// `time_of_impact`.
template <Shape A, SameSpace<A> B>
std::optional<Impact<dimension_of<A>, scalar_of<A>>> shape_cast(const A& a,
                                                                const Vec<dimension_of<A>, scalar_of<A>>& motion,
                                                                const B& b) {
  assert(detail::is_valid_if_known(a) && detail::is_valid_if_known(b));
  return detail::impact_of(a, motion, b);
}

GRAZE_DECLARE_INSTANCES(GRAZE_SHAPE_CAST_INSTANCES)

}  // namespace graze
