// SPDX-License-Identifier: MIT
// The closed forms of closest_points.hpp for planes and half-spaces, and for rays among themselves; in double. Include
// closest_points.hpp.
#pragma once

#include <algorithm>
#include <cmath>

#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/cores/closest.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/relation/unbounded.hpp>
#include <graze/shape/half_space.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// Two shapes with a common point.
template <Dim N>
Proximity<N, double> meeting_at(const Vec<N, double>& point, Relation relation) {
  return {0, point, point, Vec<N, double>(0.0), relation, Status::converged, 0};
}

// ---- A plane, or the plane that bounds a half-space, and the core of a bounded shape

/// A point of a core, and its height above a plane.
template <Dim N>
struct CorePoint {
  Vec<N, double> point;
  double height;
};

template <Dim N>
struct ExtremePoints {
  CorePoint<N> lowest;
  CorePoint<N> highest;
};

template <Dim N, class T, Convex Core>
ExtremePoints<N> extremes_over(const Plane<N, T>& plane, const Core& core) {
  const Vec<N, double> normal = wide<N, T>(plane.normal);
  const double length = std::sqrt(dot(normal, normal));  // a valid normal is not zero
  const Vec<N, double> lowest = wide_support(core, -normal);
  const Vec<N, double> highest = wide_support(core, normal);
  return {{lowest, height_over(plane, lowest) / length}, {highest, height_over(plane, highest) / length}};
}

/// The corners of an oriented box are rounded, but its center is not.
template <Dim N, class T>
ExtremePoints<N> extremes_over(const Plane<N, T>& plane, const Obb<N, T>& box) {
  const Vec<N, double> normal = wide<N, T>(plane.normal);
  const double length = std::sqrt(dot(normal, normal));
  const double middle = height_over(plane, wide<N, T>(box.center));
  double reach = 0;
  const Mat<N, double> edges = half_edges(box);
  for (Dim i = 0; i < N; ++i) reach += std::fabs(dot(normal, edges[i]));
  return {{support(box, -normal), (middle - reach) / length}, {support(box, normal), (middle + reach) / length}};
}

/// The error of heights, relative to the largest numbers that they are calculated from.
template <Dim N, class T>
double error_of_heights(const Plane<N, T>& plane, const Vec<N, double>& largest, double relative) {
  const Vec<N, double> normal = wide<N, T>(plane.normal);
  const double magnitude = dot(abs(normal), largest) + std::fabs(static_cast<double>(plane.offset));
  return relative * magnitude / std::sqrt(dot(normal, normal));
}

template <Convex S, Dim N, class T>
double error_of_extremes(const Plane<N, T>& plane, const ExtremePoints<N>& extremes, double radius) {
  const Vec<N, double> largest = max(abs(extremes.lowest.point), abs(extremes.highest.point));
  return error_of_heights(plane, largest, support_error<S>) + tolerance::rounding * radius;
}

/// The plane is a, and b a core that does not meet it, inflated by a radius, which may.
template <Dim N, class T>
Proximity<N, double> beside_plane(const Plane<N, T>& plane, const CorePoint<N>& nearest, double radius,
                                  Relation relation) {
  const Vec<N, double> upward = unit_or(wide<N, T>(plane.normal), unit_axis<N>(0));
  Proximity<N, double> result;
  result.relation = relation;
  result.normal = nearest.height < 0 ? -upward : upward;
  result.point_a = surface_point(plane, nearest.point).point;
  const bool is_apart = relation == Relation::apart;
  result.distance = is_apart ? std::max(0.0, std::fabs(nearest.height) - radius) : 0.0;
  result.point_b = is_apart ? nearest.point - result.normal * radius : result.point_a;
  return result;
}

/// The point of the plane between the lowest and the highest point of a core.
template <Dim N>
Vec<N, double> crossing_between(const CorePoint<N>& lowest, const CorePoint<N>& highest) {
  const double whole = highest.height - lowest.height;
  const double share = whole > 0 ? -lowest.height / whole : 0.0;
  return lowest.point + (highest.point - lowest.point) * share;
}

template <Dim N, class T, Convex S>
Proximity<N, double> proximity_to_half_space(const Plane<N, T>& plane, const S& shape, Relation relation) {
  const auto [lowest, highest] = extremes_over(plane, core(shape));
  const bool do_cores_meet = relation != Relation::apart && lowest.height <= 0 && highest.height >= 0;
  const CorePoint<N>& nearest = lowest.height >= -highest.height ? lowest : highest;
  Proximity<N, double> result = do_cores_meet ? meeting_at(crossing_between(lowest, highest), relation)
                                              : beside_plane(plane, nearest, core_radius(shape), relation);
  result.error = error_of_extremes<S>(plane, {lowest, highest}, core_radius(shape));
  return result;
}

template <Dim N, class T, Convex S>
Proximity<N, double> proximity_to_half_space(const HalfSpace<N, T>& solid, const S& shape, Relation relation) {
  const Plane<N, T> plane = boundary(solid);
  const auto [lowest, highest] = extremes_over(plane, core(shape));
  const bool do_cores_meet = relation != Relation::apart && lowest.height <= 0;
  const CorePoint<N> nearest{lowest.point, std::max(lowest.height, 0.0)};
  Proximity<N, double> result =
      do_cores_meet ? meeting_at(lowest.point, relation) : beside_plane(plane, nearest, core_radius(shape), relation);
  result.error = error_of_extremes<S>(plane, {lowest, highest}, core_radius(shape));
  return result;
}

// ---- Rays and planes

/// Where a ray crosses a plane; its origin if it runs away from the plane or parallel to it.
template <Dim N, class T>
Vec<N, double> crossing_of(const Ray<N, T>& ray, const Plane<N, T>& plane) {
  const Vec<N, double> origin = wide<N, T>(ray.origin);
  const Vec<N, double> direction = wide<N, T>(ray.direction);
  const double height = height_over(plane, origin);
  const double climb = dot(wide<N, T>(plane.normal), direction);
  return height * climb < 0 ? origin - direction * (height / climb) : origin;
}

template <Dim N, class T>
Proximity<N, double> proximity_of_ray(const Ray<N, T>& ray, const Plane<N, T>& plane, Relation relation) {
  const Vec<N, double> origin = wide<N, T>(ray.origin);
  const CorePoint<N> nearest{origin, surface_point(plane, origin).distance};
  Proximity<N, double> result = relation == Relation::apart ? exchanged(beside_plane(plane, nearest, 0, relation))
                                                            : meeting_at(crossing_of(ray, plane), relation);
  result.error = error_of_heights(plane, abs(origin), tolerance::convex);
  return result;
}

template <Dim N, class T>
Proximity<N, double> proximity_of_ray(const Ray<N, T>& ray, const HalfSpace<N, T>& solid, Relation relation) {
  const Vec<N, double> origin = wide<N, T>(ray.origin);
  Proximity<N, double> result = proximity_of_ray(ray, boundary(solid), relation);
  const bool is_inside = relation != Relation::apart && height_over(boundary(solid), origin) <= 0;
  if (is_inside) result.point_a = result.point_b = origin;
  return result;
}

// ---- Pairs of planes and half-spaces

/// A plane with a normal of length 1, in space.
struct UnitPlane {
  Vec<3, double> normal;
  double offset;
};

template <Dim N, class T>
UnitPlane lifted_plane(const Plane<N, T>& plane) {
  const Plane<N, double> unit = unit_plane(plane);
  return {lifted(unit.normal), unit.offset};
}

inline Vec<3, double> closest_to_origin(const UnitPlane& plane) { return plane.normal * plane.offset; }

/// From the first plane's point nearest to the origin, along the plane and perpendicular to n = m x k, where the planes
/// have the normals m and k: the second plane is reached after its height above that point, divided by n^2, times n x
/// m. However small the angle, the point is on both planes. For parallel ones, it is on the first one.
inline Vec<3, double> crossing_of(const UnitPlane& first, const UnitPlane& second) {
  const Vec<3, double> n = accurate_cross(first.normal, second.normal);
  const double whole = dot(n, n);
  const Vec<3, double> start = closest_to_origin(first);
  if (!(whole > 0)) return start;
  return start + cross(n, first.normal) * ((second.offset - dot(second.normal, start)) / whole);
}

inline bool is_behind(const UnitPlane& plane, const Vec<3, double>& point) {
  return dot(plane.normal, point) <= plane.offset;
}

template <class S>
inline constexpr bool is_plane = false;
template <Dim N, class T>
inline constexpr bool is_plane<Plane<N, T>> = true;

/// A point of a's boundary in b near the origin, or vice versa; otherwise where the boundaries cross.
template <class A, class B>
Vec<3, double> common_point_of_boundaries(const UnitPlane& a, const UnitPlane& b, bool are_parallel) {
  const Vec<3, double> on_a = closest_to_origin(a);
  const Vec<3, double> on_b = closest_to_origin(b);
  if (!is_plane<B> && is_behind(b, on_a)) return on_a;
  if (!is_plane<A> && is_behind(a, on_b)) return on_b;
  return are_parallel ? on_a : crossing_of(a, b);
}

template <class Level>
auto boundary_of(const Level& level) {
  if constexpr (is_plane<Level>) {
    return level;
  } else {
    return boundary(level);
  }
}

/// Two planes or half-spaces: they are apart only if they are parallel.
template <class A, class B>
Proximity<dimension_of<A>, double> proximity_of_half_spaces(const A& a, const B& b, Relation relation) {
  constexpr Dim N = dimension_of<A>;
  const UnitPlane plane_a = lifted_plane(boundary_of(a));
  const UnitPlane plane_b = lifted_plane(boundary_of(b));
  const Parallel planes = compare_planes(boundary_of(a), boundary_of(b));
  Proximity<N, double> result;
  if (relation == Relation::apart) {
    const double rise = planes.second - planes.first;
    const Vec<N, double> upward(plane_a.normal);
    result.distance = std::fabs(rise);
    result.normal = rise < 0 ? -upward : upward;
    result.point_a = upward * planes.first;
    result.point_b = upward * planes.second;
  } else {
    const Vec<3, double> common = common_point_of_boundaries<A, B>(plane_a, plane_b, planes.parallel);
    result = meeting_at(Vec<N, double>(common), relation);
  }
  result.error = tolerance::rounding * (std::fabs(plane_a.offset) + std::fabs(plane_b.offset));
  return result;
}

// ---- Pairs of rays

template <Dim N>
ClosestOnCore<3> lifted(const ClosestOnCore<N>& closest) {
  return {lifted(closest.point), lifted(closest.off)};
}

/// Relative to the origin of a. The nearest pair among the projections of both origins and the ends of the lines'
/// common perpendicular, which for rays o + s d and p + t e, with w = p - o and n = d x e, are at s n^2 = (w x e) . n,
/// t n^2 = (w x d) . n.
template <Dim N, class T>
ClosestPair<3> closest_of_rays(const Ray<N, T>& a, const Ray<N, T>& b) {
  const Vec<3, double> d = direction_of(a);
  const Vec<3, double> e = direction_of(b);
  const Vec<3, double> w = lifted(wide<N, T>(b.origin) - wide<N, T>(a.origin));
  const Vec<3, double> zero(0.0);
  ClosestPair<3> best;
  best.offer_from_a(zero, closest_on(Ray<3, double>{w, e}, zero));
  best.offer_from_b(w, closest_on(Ray<3, double>{zero, d}, w));
  const Vec<3, double> n = accurate_cross(d, e);
  const double whole = dot(n, n);
  const double lengths_squared = dot(d, d) * dot(e, e);
  if (!(whole > tolerance::rounding * tolerance::rounding * lengths_squared)) return best;  // parallel, as in relation
  const double s = dot(accurate_cross(w, e), n) / whole;
  const double t = dot(accurate_cross(w, d), n) / whole;
  if (s > 0 && t > 0) best.offer({d * s, w + e * t, n * (dot(w, n) / whole)});
  return best;
}

}  // namespace graze::detail
