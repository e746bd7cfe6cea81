// SPDX-License-Identifier: MIT
/// @file
/// contains(shape, point): whether a point belongs to a shape, its surface included.
///
/// What decides it, and how far outside a point still counts as contained (no inside point is ever missed):
///
///     point, aabb                     comparisons              nothing: exact
///     sphere, capsule, obb            closed form in double    a few epsilon of the pair's own size, wherever it is
///     half-space                      closed form in double    a few epsilon of the largest coordinate
///     triangle, polytope, in 2D       exact orientations       a few epsilon of the pair's own size
///     polytope in 3D                  GJK, then EPA            a few epsilon of the largest coordinate
///     user's convex shape             GJK, then EPA            the same, but epsilon of T if its `support` uses T
///     segment, ray, plane,            closed form in double    tolerance::surface<T>, 8 epsilon of T, of the largest
///       triangle in 3D                                           coordinate
///     compound                        part by part             that of the part
///
/// Epsilon is that of double unless T is named. Hardly any point of T lies exactly on a set without thickness, hence
/// the tolerance there. A solid thinner than the tolerance (a flat box, a capsule of radius 1e-9 at coordinate 1 in
/// float) is tested as if it were that thick. No shape contains a point with a NaN. Coordinates may be any finite
/// numbers; see range.hpp for sizes that differ by more than a factor of 2^900.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest/surface_point_convex.hpp>
#include <graze/query/compiled/instances.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/cores/surface_point_box.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/query/parts/may_be_near.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/query/relation/triangle_filter.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/winding_number.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

/// A point with the dimension and number type of a shape.
template <Shape S>
using PointOf = Vec<dimension_of<S>, scalar_of<S>>;

/// A type that is the PointOf of a shape.
template <class P, class S>
concept PointIn = Shape<S> && std::same_as<P, PointOf<S>>;

namespace detail {

/// Whether a point at this squared distance from a set is on it as far as T can resolve, if the set extends at least
/// `thickness` on either side of its middle.
template <Scalar T>
bool is_within_surface(double distance_squared, double largest_coordinate, double thickness = 0) {
  const double reach = tolerance::surface<T> * largest_coordinate - thickness;
  return reach >= 0 && distance_squared <= reach * reach;
}

/// Whether a shape contains a point, and the number by which `is_usual_measure` decides whether that was calculated in
/// range.
struct Containment {
  bool is_inside;
  double measure;
};

// ---- Sets without thickness

/// Exact.
template <Dim N, class T>
Containment contained(const Vec<N, T>& shape, const Vec<N, T>& point) {
  return {shape == point, 1};
}

template <Dim N, class T>
Containment contained(const Segment<N, T>& segment, const Vec<N, T>& point) {
  const double largest = static_cast<double>(std::max(max_abs(segment.start), max_abs(segment.end)));
  return {is_within_surface<T>(squared(closest_on(segment, wide<N, T>(point))), largest), largest};
}

template <Dim N, class T>
Containment contained(const Ray<N, T>& ray, const Vec<N, T>& point) {
  const double largest = static_cast<double>(std::max(max_abs(ray.origin), max_abs(point)));
  const ClosestOnCore<N> closest = closest_on(ray, wide<N, T>(point));
  return {is_within_surface<T>(squared(closest), largest), is_usual_measure<T>(closest.whole) ? largest : 0};
}

template <Dim N, class T>
Containment contained(const Plane<N, T>& plane, const Vec<N, T>& point) {
  const Vec<N, double> normal = wide<N, T>(plane.normal);
  const double height = height_over(plane, wide<N, T>(point));
  const double whole = dot(normal, normal);  // a valid normal is not zero
  const auto largest = static_cast<double>(max_abs(point));
  return {is_within_surface<T>(height * height / whole, largest), is_usual_measure<T>(whole) ? largest : 0};
}

template <class T>
double largest_coordinate(const Triangle<3, T>& triangle) {
  return static_cast<double>(std::max(std::max(max_abs(triangle.a), max_abs(triangle.b)), max_abs(triangle.c)));
}

/// For a point near the triangle.
template <class T>
bool is_on(const Triangle<3, T>& triangle, const Vec<3, T>& point) {
  const double distance = surface_point(triangle, wide<3, T>(point)).distance;
  return is_within_surface<T>(distance * distance, largest_coordinate(triangle));
}

template <class T>
Containment contained(const Triangle<3, T>& triangle, const Vec<3, T>& point) {
  const Vec<3, double> corner = wide<3, T>(triangle.a);
  const double largest = largest_coordinate(triangle);
  const double reach = tolerance::surface<T> * largest;
  const auto quick = filter_of_triangle_and_sphere(corner - wide<3, T>(point), wide<3, T>(triangle.b) - corner,
                                                   wide<3, T>(triangle.c) - corner, reach);
  if (quick) return {*quick != Relation::apart, 1};  // the filter has checked the range
  return {is_on(triangle, point), largest + static_cast<double>(max_abs(point))};
}

// ---- Solids

/// A point farther out than sqrt(2) radii is outside for any rounding.
template <Dim N, class T>
[[gnu::always_inline]] inline Containment contained(const Sphere<N, T>& sphere, const Vec<N, T>& point) {
  const Vec<N, double> off = wide<N, T>(point) - wide<N, T>(sphere.center);
  const auto radius = static_cast<double>(sphere.radius);
  const double squared_way = dot(off, off);
  const double squared_radius = radius * radius;
  if (squared_way > 2 * squared_radius) return {false, squared_way};
  const double reach = radius + tolerance::rounding * (sum_abs(off) + radius);
  return {squared_way <= reach * reach, squared_radius};
}

/// Exact.
template <Dim N, class T>
[[gnu::always_inline]] inline Containment contained(const Aabb<N, T>& box, const Vec<N, T>& point) {
  for (Dim i = 0; i < N; ++i) {
    if (!(box.min[i] <= point[i] && point[i] <= box.max[i])) return {false, 1};
  }
  return {true, 1};
}

/// For a point near the surface.
template <Dim N, class T>
bool holds_nearly(const Obb<N, T>& box, const Vec<N, double>& p) {
  const double beyond_true_faces = beyond_faces(box, p);
  if (beyond_true_faces <= 0) return true;
  const double slack = slack_of(box, p);
  const double largest = largest_coordinate(box);
  if (beyond_true_faces > 2 * std::max(slack, tolerance::surface<T> * largest - thickness_of(box))) return false;
  const PlaceInBox<N> nearest = place_in(box, p);
  const double distance_squared = dot(nearest.off, nearest.off);
  if (distance_squared <= slack * slack) return true;
  return is_within_surface<T>(distance_squared, largest, thickness_of(box));
}

/// Projected on axes that are orthonormal up to tolerance::orthonormal = e, a point of the box is at most e (|u_0| +
/// ... ) away from its place u, and that sum is at most sqrt(N) (1 + e) times its distance from the center. Points that
/// are inside or outside by more than that need no closer test.
template <Dim N, class T>
Containment contained(const Obb<N, T>& box, const Vec<N, T>& point) {
  const Vec<N, double> p = wide<N, T>(point);
  const Vec<N, double> off = p - wide<N, T>(box.center);
  const Vec<N, double> halves = wide<N, T>(box.half_extents);
  const double own_size = sum_abs(off) + sum_abs(halves);
  const double size = static_cast<double>(max_abs(box.center)) + own_size;
  const double margin = 2 * (2 * tolerance::orthonormal * sum_abs(off) + tolerance::surface<T> * size);
  double beyond = -std::numeric_limits<double>::infinity();
  for (Dim i = 0; i < N; ++i) {
    beyond = std::max(beyond, std::fabs(dot(off, wide<N, T>(box.axes[i]))) - halves[i]);
  }
  if (!(beyond <= margin) || std::isnan(margin)) return {false, own_size};  // NaN
  if (beyond < -margin) return {true, own_size};
  return {holds_nearly(box, p), own_size};
}

/// The measure is in units of the normal. It is NaN, out of range, if the height is.
template <Dim N, class T>
Containment contained(const HalfSpace<N, T>& solid, const Vec<N, T>& point) {
  const double magnitude = dot(abs(wide<N, T>(solid.normal)), abs(wide<N, T>(point)));
  const double size = magnitude + std::fabs(static_cast<double>(solid.offset));
  const double height = height_over(boundary(solid), wide<N, T>(point));
  return {height <= tolerance::convex * size, size + std::fabs(height)};
}

/// A capsule of any thickness contains a sphere around each point of its axis; so the tolerance applies to the axis.
template <Dim N, class T>
Containment contained(const Capsule<N, T>& capsule, const Vec<N, T>& point) {
  const Vec<N, double> p = wide<N, T>(point);
  const Vec<N, double> start = wide<N, T>(capsule.a);
  const auto radius = static_cast<double>(capsule.radius);
  const double extent = sum_abs(wide<N, T>(capsule.b) - start);
  const double size = sum_abs(p - start) + extent + radius;
  const double reach = radius + tolerance::rounding * size;
  const double distance_squared = squared(closest_on(axis(capsule), p));
  if (distance_squared <= reach * reach) return {true, size};
  const T largest = std::max(max_abs(capsule.a), max_abs(capsule.b));
  return {is_within_surface<T>(distance_squared, static_cast<double>(largest)), size};
}

/// The distance of the middle from the nearest edge: zero if the polygon is flat.
template <class T>
double thickness_of(Corners<T> corners) {
  const Vec<2, double> middle = middle_of(corners);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec<2, T>& next = corners[i + 1 < corners.size() ? i + 1 : 0];
    const Vec<2, double> edge = wide<2, T>(next) - wide<2, T>(corners[i]);
    const double area = std::fabs(cross_2d<double>(edge, middle - wide<2, T>(corners[i])));
    const double length = std::sqrt(dot(edge, edge));
    least = std::min(least, length > 0 ? area / length : 0.0);
  }
  return least;
}

/// `distance`: the signed distance of the point from the outline, negative inside.
template <class T>
bool polygon_holds(Corners<T> corners, const Vec<2, T>& point, double distance) {
  const Vec<2, double> p = wide<2, T>(point);
  if (distance <= 0) return true;
  double own_size = 0;
  double largest = 0;
  for (const Vec<2, T>& corner : corners) {
    own_size = std::max(own_size, sum_abs(p - wide<2, T>(corner)));
    largest = std::max(largest, static_cast<double>(max_abs(corner)));
  }
  if (distance <= tolerance::rounding * own_size) return true;
  // The thickness takes longer and is calculated only next to the polygon.
  const bool is_near = is_within_surface<T>(distance * distance, largest);
  return is_near && is_within_surface<T>(distance * distance, largest, thickness_of<T>(corners));
}

template <class T>
Containment contained(const Triangle<2, T>& triangle, const Vec<2, T>& point) {
  const SurfacePoint<2> at = surface_point(triangle, wide<2, T>(point));
  return {polygon_holds<T>(counter_clockwise(triangle), point, at.distance), at.measure};
}

template <class T>
Containment contained(const Polytope<2, T>& polygon, const Vec<2, T>& point) {
  const SurfacePoint<2> at = surface_point(polygon, wide<2, T>(point));
  return {polygon_holds<T>(polygon.vertices(), point, at.distance), at.measure};
}

// ---- Any convex shape

/// The distance of the middle of a shape from its surface.
template <Convex S>
double thickness_of(const S& shape) {
  const Vec<dimension_of<S>, double> middle = middle_of(shape);
  return usual_epa(middle, shape, usual_gjk(middle, shape).simplex).lower;
}

/// For a point outside the shape: whether it is on it, as far as T can resolve.
template <Convex S>
bool is_on_thin(const S& shape, const PointOf<S>& point) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  const double distance = surface_point_outside(shape, wide<N, T>(point)).distance;
  const Aabb<N, T> box = bounds(shape);
  const auto largest = static_cast<double>(std::max(max_abs(box.min), max_abs(box.max)));
  const bool is_near = is_within_surface<T>(distance * distance, largest);
  return is_near && is_within_surface<T>(distance * distance, largest, thickness_of(shape));
}

template <Convex S>
Containment contained(const S& shape, const PointOf<S>& point) {
  const auto distance = usual_gjk(point, shape, GjkOptions{0});
  const double measure = measure_of(distance);
  if (!(distance.upper >= 0)) return {false, measure};  // NaN
  if (distance.lower > distance.resolution) return {is_on_thin(shape, point), measure};
  const auto depth = usual_epa(point, shape, distance.simplex, EpaOptions{0});
  return {!(depth.gap > depth.resolution) || is_on_thin(shape, point), measure};
}

// ---- Numbers out of range

/// For numbers in range.
template <Shape S>
bool holds(const S& shape, const PointOf<S>& point) {
  return contained(shape, point).is_inside;
}

template <Shape S>
bool is_held(const S& shape, const PointOf<S>& point);

/// The result of rescaled shapes if a number is out of range, otherwise `found`.
template <Shape S>
[[gnu::noinline, gnu::cold]] bool is_held_in_range_or(bool found, const S& shape, const PointOf<S>& point) {
  const auto answer =
      answer_in_range<bool>([](const auto&, const auto& scaled_shape,
                               const auto& scaled_point) { return is_held(scaled_shape, scaled_point); },
                            shape, point);
  return answer.value_or(found);
}

/// As `holds`, for numbers of any size.
template <Shape S>
[[gnu::always_inline]] inline bool is_held(const S& shape, const PointOf<S>& point) {
  const Containment found = contained(shape, point);
  if (is_usual_measure<scalar_of<S>>(found.measure)) return found.is_inside;
  return is_held_in_range_or(found.is_inside, shape, point);
}

// ---- Compounds and variants

template <Dim N, class T>
bool is_held(const Compound<N, T>& compound, const Vec<N, T>& point);
template <Dim N, class T>
bool is_held(const Mesh<N, T>& mesh, const Vec<N, T>& point);

template <Dim N, class T>
bool is_held(const AnyShape<N, T>& shape, const Vec<N, T>& point) {
  return detail::visit([&point](const auto& held) { return is_held(held, point); }, shape);
}

template <Dim N, class T>
bool is_held(const Compound<N, T>& compound, const Vec<N, T>& point) {
  bool is_found = false;
  const MayBeNear<N, T> may_be_near{point};
  visit_parts(compound, may_be_near, ByKey(), [&](const Part<N, T>& part, std::size_t) {
    is_found = is_held(part.shape, point);
    return !is_found;
  });
  return is_found;
}

/// Whether a point is on a face, up to the tolerance.
template <Dim N, class T>
bool is_on_face(const Mesh<N, T>& mesh, const Vec<N, T>& point) {
  bool is_found = false;
  const MayBeNear<N, T> may_be_near{point};
  visit_parts(mesh, may_be_near, ByKey(), [&](const FacePart<N, T>& face, std::size_t) {
    is_found = is_held(face.shape, point);
    return !is_found;
  });
  return is_found;
}

/// The same for a point at this distance from the nearest face.
template <Dim N, class T>
bool is_on_face(const Mesh<N, T>& mesh, const Vec<N, T>& point, double distance) {
  return distance <= 2 * forgiven_outside(placed(mesh).box(), point) && is_on_face(mesh, point);
}

/// A point on a face is contained even if it is outside by a rounding error.
template <Dim N, class T>
bool is_held(const Mesh<N, T>& mesh, const Vec<N, T>& point) {
  return is_inside(mesh, point) || is_on_face(mesh, point);
}

/// Whether the query accepts the shape. A user's type without `defect` counts as valid.
template <Shape S>
bool is_accepted(const S& shape) {
  if constexpr (requires { defect(shape); }) return is_valid(shape);
  return true;
}

}  // namespace detail

/// True if the point belongs to the closed set; the surface counts. For any valid shape (asserted), up to the
/// tolerances in the table at the top of this file. A compound is the union of its parts.
template <Shape S, PointIn<S> P = PointOf<S>>
bool contains(const S& shape, const P& point) {
  assert(detail::is_accepted(shape));
  return detail::is_held(shape, point);
}

GRAZE_DECLARE_INSTANCES(GRAZE_CONTAINS_INSTANCES)

}  // namespace graze
