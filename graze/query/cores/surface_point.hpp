// SPDX-License-Identifier: MIT
// The point of a shape's surface nearest to a given point, in double: what closest_point.hpp,
// closest_boundary_point.hpp and signed_distance.hpp round. Closed forms; boxes are in surface_point_box.hpp, 3D
// polytopes and user-defined types in surface_point_convex.hpp. Include one of those three.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>

#include <graze/math/orientation.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/cores/closest_on_core.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/half_space.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/polytope.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/sphere.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

/// For a set without interior `point` is the set's point nearest to p, and `inner` the same.
template <Dim N>
struct SurfacePoint {
  Vec<N, double> point;
  Vec<N, double> inner;  ///< A point where the shape is about as thick as anywhere: rounding goes towards it.
  double distance = 0;   ///< Of p: negative inside, or the side of a plane.
  double measure = 0;    ///< Shows whether it was calculated in range, see `is_usual_measure`.
};

/// `v` normalised, however small it is; `fallback` if it is zero.
template <Dim N>
[[gnu::always_inline]] inline Vec<N, double> unit_or(const Vec<N, double>& v, const Vec<N, double>& fallback) {
  const double squared = dot(v, v);
  if (squared > 0x1p-900 && squared < 0x1p900) return v / std::sqrt(squared);  // no square is lost
  const double size = max_abs(v);
  if (!(size > 0)) return fallback;
  const Vec<N, double> scaled = v / size;
  return scaled / std::sqrt(dot(scaled, scaled));
}

/// Whether a shape has an interior, however thin.
template <class S>
inline constexpr bool has_inside = true;
template <Dim N, class T>
inline constexpr bool has_inside<Vec<N, T>> = false;
template <Dim N, class T>
inline constexpr bool has_inside<Segment<N, T>> = false;
template <Dim N, class T>
inline constexpr bool has_inside<Ray<N, T>> = false;
template <Dim N, class T>
inline constexpr bool has_inside<Plane<N, T>> = false;
template <class T>
inline constexpr bool has_inside<Triangle<3, T>> = false;

// ---- Points, segments, rays

/// With a square that is as large as those of the shape's lengths.
template <Dim N>
[[gnu::always_inline]] inline SurfacePoint<N> without_inside(const ClosestOnCore<N>& closest, double whole) {
  const double squared_distance = squared(closest);
  return {closest.point, closest.point, std::sqrt(squared_distance), squared_distance + whole};
}

template <Dim N, class T>
[[gnu::always_inline]] inline SurfacePoint<N> surface_point(const Vec<N, T>& point, const Vec<N, double>& p) {
  return without_inside<N>({wide<N, T>(point), p - wide<N, T>(point)}, 0);
}

template <Dim N, class T>
[[gnu::always_inline]] inline SurfacePoint<N> surface_point(const Segment<N, T>& segment, const Vec<N, double>& p) {
  const ClosestOnCore<N> closest = closest_on(segment, p);
  return without_inside(closest, closest.whole);
}

template <Dim N, class T>
[[gnu::always_inline]] inline SurfacePoint<N> surface_point(const Ray<N, T>& ray, const Vec<N, double>& p) {
  const ClosestOnCore<N> closest = closest_on(ray, p);
  SurfacePoint<N> result = without_inside(closest, 0);
  if (!is_usual_measure<T>(closest.whole)) result.measure = 0;
  return result;
}

// ---- Spheres, capsules

/// From the center of the sphere: the point in direction x.
template <Dim N, class T>
[[gnu::always_inline]] inline SurfacePoint<N> surface_point(const Sphere<N, T>& sphere, const Vec<N, double>& p) {
  const Vec<N, double> center = wide<N, T>(sphere.center);
  const Vec<N, double> off = p - center;
  const auto radius = static_cast<double>(sphere.radius);
  const double squared_way = dot(off, off);
  return {center + unit_or(off, unit_axis<N>(0)) * radius, center, std::sqrt(squared_way) - radius,
          squared_way + radius * radius};
}

/// A direction perpendicular to `edge`, always the same; x if the edge is zero.
inline Vec<2, double> across(const Vec<2, double>& edge) { return unit_or(perpendicular(edge), unit_axis<2>(0)); }

inline Vec<3, double> across(const Vec<3, double>& edge) {
  const Vec<3, double> size = abs(edge);
  const Dim least = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
  return unit_or(cross(edge, unit_axis<3>(least)), unit_axis<3>(0));
}

/// `off` minus its component along `edge` (not zero). Zero if hardly anything remains: then it was all rounding.
template <Dim N>
Vec<N, double> straightened(const Vec<N, double>& off, const Vec<N, double>& edge) {
  const double whole = dot(edge, edge);
  const Vec<N, double> once = off - edge * (dot(off, edge) / whole);
  const Vec<N, double> twice = once - edge * (dot(once, edge) / whole);
  return dot(twice, twice) > 0.25 * dot(once, once) ? twice : Vec<N, double>(0.0);
}

/// From the axis of a capsule: a perpendicular point. Beside the axis the vector from the projection may have a
/// component along it, from rounding errors as large as itself, so that is removed.
template <Dim N, class T>
SurfacePoint<N> surface_point(const Capsule<N, T>& capsule, const Vec<N, double>& p) {
  const ClosestOnCore<N> closest = closest_on(axis(capsule), p);
  const auto radius = static_cast<double>(capsule.radius);
  const Vec<N, double> edge = wide<N, T>(capsule.b) - wide<N, T>(capsule.a);
  const bool is_at_end = closest.point == wide<N, T>(capsule.a) || closest.point == wide<N, T>(capsule.b);
  const Vec<N, double> off = is_at_end ? closest.off : straightened(closest.off, edge);
  const double squared_way = dot(off, off);
  return {closest.point + unit_or(off, across(edge)) * radius, closest.point, std::sqrt(squared_way) - radius,
          closest.whole + squared_way + radius * radius};
}

// ---- Planes, half-spaces

/// dot(normal, p) - offset; for doubles with the rounding errors of every product and sum added up, so that little is
/// lost to cancellation. The products of floats are exact anyway.
template <Dim N, class T>
double height_over(const Plane<N, T>& plane, const Vec<N, double>& p) {
  const Vec<N, double> normal = wide<N, T>(plane.normal);
  const auto offset = static_cast<double>(plane.offset);
  if constexpr (std::same_as<T, float>) return dot(normal, p) - offset;
  Rounded sum{-offset, 0};
  for (Dim i = 0; i < N; ++i) {
    const Rounded product = two_product(normal[i], p[i]);
    const Rounded next = two_sum(sum.value, product.value);
    sum = {next.value, sum.error + (next.error + product.error)};
  }
  return sum.value + sum.error;
}

/// The axis along which a vector is longest, the first of several.
template <Dim N>
Dim longest_axis(const Vec<N, double>& v) {
  Dim longest = 0;
  for (Dim i = 1; i < N; ++i) {
    if (std::fabs(v[i]) > std::fabs(v[longest])) longest = i;
  }
  return longest;
}

/// The projection to a plane, calculated twice: the rounding error of the first is relative to p, that of the second to
/// the projection. The coordinate with the steepest normal is then recalculated from the others: so the projection is
/// on the plane as closely as those permit, also if it should be zero.
template <Dim N, class T>
SurfacePoint<N> surface_point(const Plane<N, T>& plane, const Vec<N, double>& p) {
  const Vec<N, double> normal = wide<N, T>(plane.normal);
  const double squared_length = dot(normal, normal);  // a valid normal is not zero
  const double height = height_over(plane, p);
  const Vec<N, double> near = p - normal * (height / squared_length);
  Vec<N, double> closest = near - normal * (height_over(plane, near) / squared_length);
  const Dim steepest = longest_axis(normal);
  closest[steepest] = 0;
  closest[steepest] = -height_over(plane, closest) / normal[steepest];
  const double distance = height / std::sqrt(squared_length);
  const double measure = is_usual_measure<T>(squared_length) ? max_abs(p) + std::fabs(distance) : 0;
  return {closest, closest, distance, measure};
}

/// Arbitrarily deep: as deep inside as the projection is far from the origin.
template <Dim N, class T>
SurfacePoint<N> surface_point(const HalfSpace<N, T>& solid, const Vec<N, double>& p) {
  SurfacePoint<N> result = surface_point(boundary(solid), p);
  result.inner = result.point - unit_or(wide<N, T>(solid.normal), unit_axis<N>(0)) * max_abs(result.point);
  return result;
}

// ---- 3D triangles, polygons

template <class T>
SurfacePoint<3> surface_point(const Triangle<3, T>& triangle, const Vec<3, double>& p) {
  const Triangle<3, double> corners{wide<3, T>(triangle.a), wide<3, T>(triangle.b), wide<3, T>(triangle.c)};
  return without_inside(closest_on(corners, p),
                        length_squared(corners.b - corners.a) + length_squared(corners.c - corners.a));
}

/// Counter-clockwise; collinear ones are unchanged.
template <class T>
std::array<Vec<2, T>, 3> counter_clockwise(const Triangle<2, T>& triangle) {
  if (orientation(triangle.a, triangle.b, triangle.c) < 0) return {triangle.a, triangle.c, triangle.b};
  return triangle.vertices();
}

/// The mean of the corners; relative to one of them, so that it is accurate far from the origin too.
template <Dim N, class T>
Vec<N, double> middle_of(std::span<const Vec<N, T>> points) {
  const Vec<N, double> first = wide<N, T>(points.front());
  Vec<N, double> sum(0.0);
  for (const Vec<N, T>& point : points) sum += wide<N, T>(point) - first;
  return first + sum / static_cast<double>(points.size());  // never empty
}

/// Inside is what is left of every edge of a polygon with area, which `orientation` decides exactly.
template <class T>
SurfacePoint<2> surface_point_of(Corners<T> corners, const Vec<2, double>& p, double measure = 0) {
  const ClosestOnPolygon closest = closest_on_polygon(corners, p);
  const double distance = std::sqrt(squared(closest.closest));
  return {closest.closest.point, middle_of(corners), closest.is_inside ? -distance : distance, measure};
}

template <class T>
SurfacePoint<2> surface_point(const Triangle<2, T>& triangle, const Vec<2, double>& p) {
  const Vec<2, double> corner = wide<2, T>(triangle.a);
  const double edges = sum_abs(wide<2, T>(triangle.b) - corner) + sum_abs(wide<2, T>(triangle.c) - corner);
  return surface_point_of<T>(counter_clockwise(triangle), p, sum_abs(p - corner) + edges);
}

template <class T>
SurfacePoint<2> surface_point(const Polytope<2, T>& polygon, const Vec<2, double>& p) {
  return surface_point_of<T>(polygon.vertices(), p, rows_of(polygon).largest() + max_abs(p));
}

}  // namespace graze::detail
