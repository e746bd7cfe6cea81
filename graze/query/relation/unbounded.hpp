// SPDX-License-Identifier: MIT
// The closed forms of relation.hpp for rays, planes and half-spaces. Include relation.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>

#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/relation/bounded.hpp>
#include <graze/query/relation/convex.hpp>
#include <graze/query/relation/sphere_filter.hpp>
#include <graze/query/relation/triangle.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/half_space.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/shape.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

// ---- Planes and half-spaces against everything else: the extent of a shape above and below the plane, in units of the
// normal.

struct Heights {
  double low;
  double high;
  double slack;  ///< Both may be off by it. NaN if the normal is too short to be squared.
};

/// The length of a normal; NaN if its square is too small to tell, and infinite if it is too large.
template <class T, Dim N>
[[gnu::always_inline]] inline double length_of_normal(const Vec<N, double>& normal) {
  const double squared = dot(normal, normal);
  if (std::is_same_v<T, float> || squared > 0x1p-900) return std::sqrt(squared);
  return std::numeric_limits<double>::quiet_NaN();
}

template <Dim N, class T, Convex S>
Heights heights_over(const Plane<N, T>& plane, const S& shape) {
  const Vec<N, double> normal = wide<N, T>(plane.normal);
  const Vec<N, double> lowest = wide_support(shape, -normal);
  const Vec<N, double> highest = wide_support(shape, normal);
  const double offset = static_cast<double>(plane.offset);
  const double magnitude = dot(abs(normal), max(abs(lowest), abs(highest))) + std::fabs(offset);
  return {dot(normal, lowest) - offset, dot(normal, highest) - offset, support_error<S> * magnitude};
}

// The same for spheres and boxes from their centers, without support points. The error is as small, and if any number
// is NaN, so are both heights.

template <Dim N, class T>
[[gnu::always_inline]] inline Heights heights_over(const Plane<N, T>& plane, const Sphere<N, T>& sphere) {
  const Vec<N, double> normal = wide<N, T>(plane.normal);
  const double offset = static_cast<double>(plane.offset);
  const Vec<N, double> center = wide<N, T>(sphere.center);
  const double height = dot(normal, center) - offset;
  const double reach = static_cast<double>(sphere.radius) * length_of_normal<T>(normal);
  const double magnitude = sum_abs(normal * center) + (reach + std::fabs(offset));
  return {height - reach, height + reach, tolerance::convex * magnitude};
}

template <Dim N, class T>
[[gnu::always_inline]] inline Heights heights_over(const Plane<N, T>& plane, const Aabb<N, T>& box) {
  const Vec<N, double> normal = wide<N, T>(plane.normal);
  const Vec<N, double> low = wide<N, T>(box.min);
  const Vec<N, double> high = wide<N, T>(box.max);
  const double offset = static_cast<double>(plane.offset);
  const double height = 0.5 * dot(normal, low + high) - offset;
  const double reach = 0.5 * dot(abs(normal), high - low);
  const double magnitude = dot(abs(normal), max(abs(low), abs(high))) + std::fabs(offset);
  return {height - reach, height + reach, tolerance::convex * magnitude};
}

template <Dim N, class T>
[[gnu::always_inline]] inline Heights heights_over(const Plane<N, T>& plane, const Obb<N, T>& box) {
  const Vec<N, double> normal = wide<N, T>(plane.normal);
  const Vec<N, double> center = wide<N, T>(box.center);
  const double offset = static_cast<double>(plane.offset);
  const double height = dot(normal, center) - offset;
  Vec<N, double> farthest = abs(center);
  double reach = 0;
  for (Dim i = 0; i < N; ++i) {
    const Vec<N, double> axis = wide<N, T>(box.axes[i]);
    const auto half = static_cast<double>(box.half_extents[i]);
    reach += std::fabs(dot(normal, axis)) * half;
    farthest += abs(axis) * half;
  }
  const double magnitude = dot(abs(normal), farthest) + std::fabs(offset);
  return {height - reach, height + reach, tolerance::convex * magnitude};
}

/// The same for a few corners, widened by a radius, from the height of each: a branch on which is the lowest would be
/// unpredictable.
template <Dim N, class T, std::size_t count>
[[gnu::always_inline]] inline Heights heights_of_corners(const Plane<N, T>& plane,
                                                         const std::array<Vec<N, T>, count>& corners, T radius) {
  const Vec<N, double> normal = wide<N, T>(plane.normal);
  const double offset = static_cast<double>(plane.offset);
  const double reach = radius == T(0) ? 0.0 : static_cast<double>(radius) * length_of_normal<T>(normal);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  double sum = 0;  // NaN if any of them is
  Vec<N, double> farthest(0.0);
  for (const Vec<N, T>& corner : corners) {
    const Vec<N, double> place = wide<N, T>(corner);
    const double height = dot(normal, place) - offset;
    low = std::min(low, height);
    high = std::max(high, height);
    sum += height;
    farthest = max(farthest, abs(place));
  }
  if (std::isnan(sum + reach)) low = high = sum + reach;
  const double magnitude = dot(abs(normal), farthest) + (reach + std::fabs(offset));
  return {low - reach, high + reach, tolerance::convex * magnitude};
}

template <Dim N, class T>
[[gnu::always_inline]] inline Heights heights_over(const Plane<N, T>& plane, const Segment<N, T>& segment) {
  return heights_of_corners(plane, std::array{segment.start, segment.end}, T(0));
}
template <Dim N, class T>
[[gnu::always_inline]] inline Heights heights_over(const Plane<N, T>& plane, const Triangle<N, T>& triangle) {
  return heights_of_corners(plane, std::array{triangle.a, triangle.b, triangle.c}, T(0));
}
template <Dim N, class T>
[[gnu::always_inline]] inline Heights heights_over(const Plane<N, T>& plane, const Capsule<N, T>& capsule) {
  return heights_of_corners(plane, std::array{capsule.a, capsule.b}, capsule.radius);
}

/// A ray that is not parallel to the plane is infinitely high on the side that it runs to.
template <Dim N, class T>
Heights heights_over(const Plane<N, T>& plane, const Ray<N, T>& ray) {
  const Vec<N, double> normal = wide<N, T>(plane.normal);
  const Vec<N, double> direction = wide<N, T>(ray.direction);
  const double climb = dot(normal, direction);
  const double least_climb = tolerance::rounding * dot(abs(normal), abs(direction));
  const Heights origin = heights_over(plane, ray.origin);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {climb < -least_climb ? -infinity : origin.low, climb > least_climb ? infinity : origin.high, origin.slack};
}

template <Dim N, class T, class S>
Relation relation_to_plane(const Plane<N, T>& plane, const S& shape) {
  const Heights heights = heights_over(plane, shape);
  const Relation verdict = verdict_on_gap(std::max(heights.low, -heights.high), heights.slack);
  return is_usual_measure<T>(heights.slack) ? verdict : verdict_in_range_or(verdict, plane, shape);
}

template <Dim N, class T, class S>
Relation relation_to_half_space(const HalfSpace<N, T>& solid, const S& shape) {
  const Heights heights = heights_over(boundary(solid), shape);
  const Relation verdict = verdict_on_gap(heights.low, heights.slack);
  return is_usual_measure<T>(heights.slack) ? verdict : verdict_in_range_or(verdict, solid, shape);
}

template <Dim N, class T, Convex S>
Relation closed_form(const Plane<N, T>& plane, const S& shape) {
  return relation_to_plane(plane, shape);
}

template <Dim N, class T>
Relation closed_form(const Ray<N, T>& ray, const Plane<N, T>& plane) {
  return relation_to_plane(plane, ray);
}

template <Dim N, class T, Convex S>
Relation closed_form(const HalfSpace<N, T>& solid, const S& shape) {
  return relation_to_half_space(solid, shape);
}

template <Dim N, class T>
Relation closed_form(const Ray<N, T>& ray, const HalfSpace<N, T>& solid) {
  return relation_to_half_space(solid, ray);
}

// ---- Pairs of planes and half-spaces

/// Two planes in units of their normals' lengths, if they are parallel up to rounding.
struct Parallel {
  bool parallel;
  bool same_way;  ///< The normals point the same way.
  double first;   ///< The positions of the planes along the first one's normal.
  double second;
  double slack;  ///< Out of range if the planes' numbers are.

  Relation verdict_on(double gap) const { return parallel ? verdict_on_gap(gap, slack) : Relation::overlapping; }
};

template <Dim N, class T>
Parallel compare_planes(const Plane<N, T>& a, const Plane<N, T>& b) {
  const double length_a = length_of_normal<T>(wide<N, T>(a.normal));
  const double length_b = length_of_normal<T>(wide<N, T>(b.normal));
  const Vec<N, double> normal_a = wide<N, T>(a.normal) / length_a;
  const Vec<N, double> normal_b = wide<N, T>(b.normal) / length_b;
  const bool same_way = dot(normal_a, normal_b) > 0;
  const Vec<N, double> turn = same_way ? normal_b - normal_a : normal_b + normal_a;
  const double first = static_cast<double>(a.offset) / length_a;
  const double second = static_cast<double>(b.offset) / length_b;
  const double slack = tolerance::rounding * (std::fabs(first) + std::fabs(second));
  const double none = 0 * (length_a + length_b);  // or NaN, if one of them is infinite
  return {sum_abs(turn) <= tolerance::rounding, same_way, first, same_way ? second : -second, slack + none};
}

/// Planes cross unless they are parallel; the same plane touches itself.
template <Dim N, class T>
Relation closed_form(const Plane<N, T>& a, const Plane<N, T>& b) {
  const Parallel planes = compare_planes(a, b);
  const Relation verdict = planes.verdict_on(std::fabs(planes.second - planes.first));
  return is_usual_measure<T>(planes.slack) ? verdict : verdict_in_range_or(verdict, a, b);
}

template <Dim N, class T>
Relation closed_form(const Plane<N, T>& plane, const HalfSpace<N, T>& solid) {
  const Parallel planes = compare_planes(plane, boundary(solid));
  const double above = planes.first - planes.second;
  const Relation verdict = planes.verdict_on(planes.same_way ? above : -above);
  return is_usual_measure<T>(planes.slack) ? verdict : verdict_in_range_or(verdict, plane, solid);
}

/// Half-spaces are disjoint only if they face opposite ways.
template <Dim N, class T>
Relation closed_form(const HalfSpace<N, T>& a, const HalfSpace<N, T>& b) {
  const Parallel planes = compare_planes(boundary(a), boundary(b));
  const Relation back_to_back = planes.verdict_on(planes.second - planes.first);
  const Relation verdict = planes.same_way ? Relation::overlapping : back_to_back;
  return is_usual_measure<T>(planes.slack) ? verdict : verdict_in_range_or(verdict, a, b);
}

// ---- Rays against rays and bounded shapes

inline Vec<3, double> lifted(const Vec<2, double>& v) { return {v.x, v.y, 0.0}; }
inline Vec<3, double> lifted(const Vec<3, double>& v) { return v; }

/// The direction times a power of two, so that nothing is rounded: the largest coordinate is between 1 and 2.
template <Dim N, class T>
Vec<3, double> direction_of(const Ray<N, T>& ray) {
  const Vec<N, double> direction = wide<N, T>(ray.direction);
  return lifted(PowerOfTwo(-exponent_of(direction))(direction));
}

/// Parallel rays meet if they lie on one line and one runs towards the other's origin.
inline Relation relation_of_parallel_rays(const Vec<3, double>& d, const Vec<3, double>& e, const Vec<3, double>& w) {
  const double slack = tolerance::rounding * sum_abs(w);
  const double off = std::sqrt(std::min(length_squared(accurate_cross(w, d)) / length_squared(d),
                                        length_squared(accurate_cross(w, e)) / length_squared(e)));
  const double behind = dot(d, e) > 0 ? 0 : -dot(w, d);
  if (verdict_on_gap(off, slack) == Relation::apart) return Relation::apart;
  return std::min(verdict_on_gap(behind, slack * std::sqrt(length_squared(d))), Relation::touching);
}

/// Rays o + s d and p + t e, with w = p - o and n = d x e, meet where s n^2 = (w x e) . n and t n^2 = (w x d) . n, if
/// w . n = 0. In 3D rays touch at most.
template <Dim N, class T>
Relation closed_form(const Ray<N, T>& a, const Ray<N, T>& b) {
  const Vec<3, double> d = direction_of(a);
  const Vec<3, double> e = direction_of(b);
  const Vec<3, double> w = lifted(wide<N, T>(b.origin) - wide<N, T>(a.origin));
  if (!is_usual_size<T>(sum_abs(w))) {
    if (const auto verdict = verdict_in_range(a, b)) return *verdict;
  }
  const Vec<3, double> n = accurate_cross(d, e);
  const double length = std::sqrt(length_squared(n));
  const double lengths = std::sqrt(length_squared(d) * length_squared(e));
  if (!(length > tolerance::rounding * lengths)) return relation_of_parallel_rays(d, e, w);
  const double slack = tolerance::rounding * sum_abs(w) * length;
  const double behind_a = -dot(accurate_cross(w, e), n) / std::sqrt(length_squared(e));
  const double behind_b = -dot(accurate_cross(w, d), n) / std::sqrt(length_squared(d));
  const Relation along = verdict_on_gap(std::max(behind_a, behind_b), slack);
  if constexpr (N == 2) return along;
  return std::min(along, verdict_on_gap(std::fabs(dot(w, n)), slack));
}

// ---- The largest absolute coordinates of vectors from a point to a shape, up to rounding.

template <Dim N, class T, Convex S>
Vec<N, double> farthest_from(const Vec<N, T>& point, const S& shape) {
  const Aabb<N, T> box = bounds(shape);
  return max(abs(wide<N, T>(box.min) - wide<N, T>(point)), abs(wide<N, T>(box.max) - wide<N, T>(point)));
}
template <Dim N, class T>
[[gnu::always_inline]] inline Vec<N, double> farthest_from(const Vec<N, T>& point, const Vec<N, T>& other) {
  return abs(wide<N, T>(other) - wide<N, T>(point));
}
template <Dim N, class T>
[[gnu::always_inline]] inline Vec<N, double> farthest_from(const Vec<N, T>& point, const Segment<N, T>& segment) {
  return max(abs(wide<N, T>(segment.start) - wide<N, T>(point)), abs(wide<N, T>(segment.end) - wide<N, T>(point)));
}
template <Dim N, class T>
[[gnu::always_inline]] inline Vec<N, double> farthest_from(const Vec<N, T>& point, const Sphere<N, T>& sphere) {
  return abs(wide<N, T>(sphere.center) - wide<N, T>(point)) + static_cast<double>(sphere.radius);
}
template <Dim N, class T>
[[gnu::always_inline]] inline Vec<N, double> farthest_from(const Vec<N, T>& point, const Aabb<N, T>& box) {
  return max(abs(wide<N, T>(box.min) - wide<N, T>(point)), abs(wide<N, T>(box.max) - wide<N, T>(point)));
}
template <Dim N, class T>
[[gnu::always_inline]] inline Vec<N, double> farthest_from(const Vec<N, T>& point, const Obb<N, T>& box) {
  Vec<N, double> farthest = abs(wide<N, T>(box.center) - wide<N, T>(point));
  for (Dim i = 0; i < N; ++i) farthest += abs(wide<N, T>(box.axes[i])) * static_cast<double>(box.half_extents[i]);
  return farthest;
}
template <Dim N, class T>
[[gnu::always_inline]] inline Vec<N, double> farthest_from(const Vec<N, T>& point, const Triangle<N, T>& triangle) {
  return max(farthest_from(point, Segment<N, T>{triangle.a, triangle.b}),
             abs(wide<N, T>(triangle.c) - wide<N, T>(point)));
}
template <Dim N, class T>
[[gnu::always_inline]] inline Vec<N, double> farthest_from(const Vec<N, T>& point, const Capsule<N, T>& capsule) {
  return farthest_from(point, axis(capsule)) + static_cast<double>(capsule.radius);
}

/// From a ray's origin, the distance along it up to which it can meet anything inside a bounded shape, and slightly
/// more.
template <Dim N, class T, class S>
Vec<N, double> reach_to(const Ray<N, T>& ray, const S& shape) {
  const Vec<N, double> direction = wide<N, T>(ray.direction);
  const Vec<N, double> farthest = farthest_from(ray.origin, shape);
  const double reach = 1.25 * std::sqrt(dot(farthest, farthest));
  return direction * (reach / std::sqrt(dot(direction, direction)));  // a valid direction is not zero
}

// ---- A shape relative to a point, so that the rounding of coordinates does not grow with the distance from zero.

template <Dim N, class T>
Segment<N, double> relative_to(const Vec<N, double>& origin, const Segment<N, T>& segment) {
  return {wide<N, T>(segment.start) - origin, wide<N, T>(segment.end) - origin};
}
template <Dim N, class T>
Ray<N, double> relative_to(const Vec<N, double>& origin, const Ray<N, T>& ray) {
  return {wide<N, T>(ray.origin) - origin, wide<N, T>(ray.direction)};
}
template <Dim N, class T>
Sphere<N, double> relative_to(const Vec<N, double>& origin, const Sphere<N, T>& sphere) {
  return {wide<N, T>(sphere.center) - origin, static_cast<double>(sphere.radius)};
}
template <Dim N, class T>
Aabb<N, double> relative_to(const Vec<N, double>& origin, const Aabb<N, T>& box) {
  return {wide<N, T>(box.min) - origin, wide<N, T>(box.max) - origin};
}
template <Dim N, class T>
Obb<N, double> relative_to(const Vec<N, double>& origin, const Obb<N, T>& box) {
  return {wide<N, T>(box.center) - origin, wide<N, T>(box.half_extents), wide_matrix<N, T>(box.axes)};
}
template <Dim N, class T>
Triangle<N, double> relative_to(const Vec<N, double>& origin, const Triangle<N, T>& triangle) {
  return {wide<N, T>(triangle.a) - origin, wide<N, T>(triangle.b) - origin, wide<N, T>(triangle.c) - origin};
}
template <Dim N, class T>
Capsule<N, double> relative_to(const Vec<N, double>& origin, const Capsule<N, T>& capsule) {
  return {wide<N, T>(capsule.a) - origin, wide<N, T>(capsule.b) - origin, static_cast<double>(capsule.radius)};
}

/// The verdict if a ray cannot be clipped in range.
template <Dim N, class T, class S>
std::optional<Relation> verdict_if_unusual(const Vec<N, double>& reach, const Ray<N, T>& ray, const S& shape) {
  if (is_usual_size<T>(sum_abs(reach))) return std::nullopt;
  return verdict_in_range(ray, shape);
}

template <Dim N, class T, Convex S>
Relation closed_form(const Ray<N, T>& ray, const S& shape) {
  const Vec<N, double> origin = wide<N, T>(ray.origin);
  const Vec<N, double> reach = reach_to(ray, shape);
  if (const auto verdict = verdict_if_unusual(reach, ray, shape)) return *verdict;
  if constexpr (requires { relative_to(origin, shape); }) {
    return closed_form(Segment<N, double>{Vec<N, double>(0.0), reach}, relative_to(origin, shape));
  } else {
    return relation_of_convex(Segment<N, double>{origin, origin + reach}, shape);
  }
}

/// A ray meets a sphere certainly, nearly, or not.
template <Dim N, class T>
Relation closed_form(const Ray<N, T>& ray, const Sphere<N, T>& sphere) {
  const Vec<N, double> to_center = wide<N, T>(sphere.center) - wide<N, T>(ray.origin);
  const auto verdict =
      filter_of_ray_and_sphere<N>(wide<N, T>(ray.direction), to_center, static_cast<double>(sphere.radius));
  if (verdict) return *verdict;
  const Vec<N, double> zero(0.0);
  const Vec<N, double> reach = reach_to(ray, sphere);
  if (const auto rescaled = verdict_if_unusual(reach, ray, sphere)) return *rescaled;
  return closed_form(Segment<N, double>{zero, reach}, Sphere<N, double>{to_center, static_cast<double>(sphere.radius)});
}

template <Dim N, class T>
Relation closed_form(const Segment<N, T>& segment, const Ray<N, T>& ray) {
  const Segment<N, double> seen = relative_to(wide<N, T>(ray.origin), segment);
  const Vec<N, double> reach = reach_to(ray, segment);
  if (!is_usual_size<T>(sum_abs(reach))) {
    if (const auto verdict = verdict_in_range(segment, ray)) return *verdict;
  }
  return closed_form(seen, Segment<N, double>{Vec<N, double>(0.0), reach});
}

}  // namespace graze::detail
