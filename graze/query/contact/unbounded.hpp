// SPDX-License-Identifier: MIT
// The closed forms of contact.hpp for planes and half-spaces, and for rays among themselves; in double. Include
// contact.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/closest/unbounded.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/cores/penetration.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/shape/half_space.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// For shapes that no translation separates, at a common point.
template <Dim N>
Penetration<N> inseparable_at(const Vec<N, double>& point) {
  Penetration<N> result;
  result.depth = std::numeric_limits<double>::infinity();
  result.point_a = result.point_b = point;
  return result;
}

// ---- A plane, or the plane that bounds a half-space, and a bounded shape

/// A depth of about zero may come out negative.
template <Dim N>
Penetration<N> of_depth(double depth) {
  Penetration<N> result;
  result.depth = std::max(0.0, depth);
  result.error = std::max(0.0, -depth);
  return result;
}

/// b, a core inflated by a radius, is moved along the normal until its lowest point is on the plane of a.
template <Dim N, class T>
Penetration<N> above_plane(const Plane<N, T>& plane, const CorePoint<N>& lowest, double radius, double side) {
  Penetration<N> result = of_depth<N>(radius - lowest.height * side);
  result.normal = unit_or(wide<N, T>(plane.normal), unit_axis<N>(0)) * side;
  result.point_b = lowest.point - result.normal * radius;
  result.point_a = surface_point(plane, result.point_b).point;
  return result;
}

template <Dim N, class T, Convex S>
Penetration<N> penetration_in_half_space(const HalfSpace<N, T>& solid, const S& shape) {
  const auto extremes = extremes_over(boundary(solid), core(shape));
  Penetration<N> result = above_plane(boundary(solid), extremes.lowest, core_radius(shape), 1.0);
  result.error += error_of_extremes<S>(boundary(solid), extremes, core_radius(shape));
  return result;
}

/// To the side with less of the shape on the wrong side; upward if equal.
template <Dim N, class T, Convex S>
Penetration<N> penetration_in_half_space(const Plane<N, T>& plane, const S& shape) {
  const auto extremes = extremes_over(plane, core(shape));
  const auto& [lowest, highest] = extremes;
  Penetration<N> result = lowest.height >= -highest.height ? above_plane(plane, lowest, core_radius(shape), 1.0)
                                                           : above_plane(plane, highest, core_radius(shape), -1.0);
  result.error += error_of_extremes<S>(plane, extremes, core_radius(shape));
  return result;
}

// ---- Rays and planes

/// Moves the plane until the ray starts on it; along the normal if `is_upward`, otherwise back.
template <Dim N, class T>
Penetration<N> at_origin(const Ray<N, T>& ray, const Plane<N, T>& plane, bool is_upward) {
  const Vec<N, double> origin = wide<N, T>(ray.origin);
  const auto closest = surface_point(plane, origin);
  Penetration<N> result = of_depth<N>(is_upward ? closest.distance : -closest.distance);
  result.normal = unit_or(wide<N, T>(plane.normal), unit_axis<N>(0)) * (is_upward ? 1.0 : -1.0);
  result.point_a = origin;
  result.point_b = closest.point;
  result.error += error_of_heights(plane, abs(origin), tolerance::convex);
  return result;
}

/// A rising ray ends above the plane, and a falling one below it; a parallel one is on the origin's side.
template <Dim N, class T>
Penetration<N> penetration_of_ray(const Ray<N, T>& ray, const Plane<N, T>& plane) {
  const Heights heights = heights_over(plane, ray);
  const bool ends_above = std::isinf(heights.high);
  const bool ends_below = std::isinf(heights.low);
  const bool is_upward = ends_above ? false : ends_below ? true : heights.low + heights.high < 0;
  return at_origin(ray, plane, is_upward);
}

template <Dim N, class T>
Penetration<N> penetration_of_ray(const Ray<N, T>& ray, const HalfSpace<N, T>& solid) {
  const Plane<N, T> plane = boundary(solid);
  if (std::isinf(heights_over(plane, ray).low)) {
    const Vec<N, double> origin = wide<N, T>(ray.origin);
    return inseparable_at<N>(height_over(plane, origin) <= 0 ? origin : crossing_of(ray, plane));
  }
  return at_origin(ray, plane, false);
}

// ---- Pairs of planes and half-spaces

/// The direction along the first one's normal in which b can leave a, or has left it: 1, -1; 0 for both directions, if
/// both are planes.
template <class A, class B>
double minimum_translation(bool face_the_same_way) {
  if constexpr (!is_plane<A>) return 1;
  if constexpr (!is_plane<B>) return face_the_same_way ? -1 : 1;
  return 0;
}

/// Only parallel ones can be separated, and half-spaces only if they face each other.
template <class A, class B>
Penetration<dimension_of<A>> penetration_of_half_spaces(const A& a, const B& b) {
  constexpr Dim N = dimension_of<A>;
  const UnitPlane plane_a = lifted_plane(boundary_of(a));
  const UnitPlane plane_b = lifted_plane(boundary_of(b));
  const Parallel planes = compare_planes(boundary_of(a), boundary_of(b));
  if (!planes.parallel || (!is_plane<A> && !is_plane<B> && planes.same_way)) {
    return inseparable_at(Vec<N, double>(common_point_of_boundaries<A, B>(plane_a, plane_b, planes.parallel)));
  }
  const double rise = planes.second - planes.first;
  const double way = minimum_translation<A, B>(planes.same_way);
  const double side = way != 0 ? way : rise < 0 ? -1.0 : 1.0;
  const Vec<N, double> upward(plane_a.normal);
  Penetration<N> result = of_depth<N>(way != 0 ? -rise * side : 0.0);
  result.normal = upward * side;
  result.point_a = upward * planes.first;
  result.point_b = upward * planes.second;
  result.error += tolerance::rounding * (std::fabs(plane_a.offset) + std::fabs(plane_b.offset));
  return result;
}

// ---- Pairs of rays

/// Moves b until the lines of both rays meet at an origin: a direction perpendicular to one ray such that the other
/// does not lead back. Both rays are 2D.
template <Dim N, class T>
Penetration<N> penetration_of_crossing_rays(const Ray<N, T>& a, const Ray<N, T>& b) {
  const Vec<N, double> along_a = wide<N, T>(a.direction);
  const Vec<N, double> along_b = wide<N, T>(b.direction);
  const Vec<N, double> between = wide<N, T>(b.origin) - wide<N, T>(a.origin);
  Vec<N, double> across_a = across(along_a);
  Vec<N, double> across_b = across(along_b);
  if (dot(across_a, along_b) < 0) across_a = -across_a;
  if (dot(across_b, along_a) > 0) across_b = -across_b;
  const double depth_a = -dot(across_a, between);
  const double depth_b = -dot(across_b, between);
  Penetration<N> result = of_depth<N>(std::min(depth_a, depth_b));
  result.normal = depth_a <= depth_b ? across_a : across_b;
  // Perpendicular to a, the origin of b comes to lie on a; perpendicular to b, that of a on b.
  const Vec<N, double> way = result.normal * result.depth;
  result.point_b = depth_a <= depth_b ? wide<N, T>(b.origin) : wide<N, T>(a.origin) - way;
  result.point_a = result.point_b + way;
  result.error += tolerance::rounding * sum_abs(between);
  return result;
}

/// In 3D, and on one line, rays have no depth: the normal is perpendicular to both.
template <Dim N, class T>
Penetration<N> penetration_of_rays(const Ray<N, T>& a, const Ray<N, T>& b) {
  const ClosestPair<3> pair = closest_of_rays(a, b);
  const Vec<3, double> n = accurate_cross(direction_of(a), direction_of(b));
  const double lengths = std::sqrt(length_squared(direction_of(a)) * length_squared(direction_of(b)));
  const bool are_parallel = !(std::sqrt(length_squared(n)) > tolerance::rounding * lengths);  // as in relation
  if constexpr (N == 2) {
    if (!are_parallel) return penetration_of_crossing_rays(a, b);
  }
  const Vec<N, double> origin = wide<N, T>(a.origin);
  Penetration<N> result;
  result.normal = are_parallel ? across(wide<N, T>(a.direction)) : unit_or(Vec<N, double>(n), unit_axis<N>(0));
  result.point_a = origin + Vec<N, double>(pair.on_a);
  result.point_b = origin + Vec<N, double>(pair.on_b);
  result.error = std::sqrt(pair.squared) + tolerance::rounding * sum_abs(wide<N, T>(b.origin) - origin);
  return result;
}

}  // namespace graze::detail
