// SPDX-License-Identifier: MIT
/// @file
/// closest_boundary_point(shape, point): the point of a shape's surface nearest to a point outside or inside.
///
///     point, segment, ray, sphere, aabb, obb, plane, half-space, triangle, capsule  closed form
///     polytope in 2D                                                                closed form
///     polytope in 3D, user's convex shape                                           GJK from outside, EPA from inside
///     compound                           of the part that is nearest, or that the point is deepest in
///     mesh                               of the nearest face
///
/// From outside, and for shapes without an inside, it is closest_point(shape, point). If there are several nearest
/// points, the choice is fixed: from the center of a sphere the point in direction x; from the axis of a capsule a
/// point perpendicular to it; in boxes the first face by axes, the lower side before the upper; in polygons the first
/// edge. Rounded to T as in closest_point, so that the shape contains it, with the same error. From inside, EPA's
/// result is off by up to 1e-12 of the depth plus a few epsilon of the largest coordinate; more inside a curved user's
/// shape, for which EPA may reach its step limit (a cone in float: 4e-4 of the depth).
#pragma once

#include <cassert>

#include <graze/math/vec.hpp>
#include <graze/query/closest/surface_point_convex.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/compiled/instances.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/cores/surface_point_box.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

namespace detail {

template <Shape S>
[[gnu::always_inline]] inline PointOf<S> closest_boundary_point_of(const S& shape, const PointOf<S>& point) {
  using T = scalar_of<S>;
  const auto at = surface_point(shape, wide<dimension_of<S>, T>(point));
  if (is_usual_measure<T>(at.measure)) return settled(shape, at);
  return point_in_range_or(at, shape, point,
                           [](const auto& s, const auto& p) { return closest_boundary_point_of(s, p); });
}

template <Dim N, class T>
Vec<N, T> closest_boundary_point_of(const Compound<N, T>& compound, const Vec<N, T>& point);
template <Dim N, class T>
Vec<N, T> closest_boundary_point_of(const Mesh<N, T>& mesh, const Vec<N, T>& point);

template <Dim N, class T>
Vec<N, T> closest_boundary_point_of(const AnyShape<N, T>& shape, const Vec<N, T>& point) {
  return detail::visit([&point](const auto& held) { return closest_boundary_point_of(held, point); }, shape);
}

template <Dim N, class T, template <Dim, class> class Whole>
Vec<N, T> closest_boundary_point_of_parts(const Whole<N, T>& whole, const Vec<N, T>& point) {
  const DecidingPart found = deciding_part(whole, point);
  return found.index != DecidingPart::no_part ? closest_boundary_point_of(part_of(whole, found.index), point)
                                              : nowhere<N, T>();
}

template <Dim N, class T>
Vec<N, T> closest_boundary_point_of(const Compound<N, T>& compound, const Vec<N, T>& point) {
  return closest_boundary_point_of_parts(compound, point);
}
template <Dim N, class T>
Vec<N, T> closest_boundary_point_of(const Mesh<N, T>& mesh, const Vec<N, T>& point) {
  return closest_boundary_point_of_parts(mesh, point);
}

}  // namespace detail

/// The nearest point on the surface of a valid shape (asserted). Inside a compound it is that of the part in which the
/// point is deepest; where parts overlap, it may lie inside another part. For a compound without parts every coordinate
/// is NaN. `closest_point` is cheaper if points inside need no answer.
template <Shape S, PointIn<S> P = PointOf<S>>
P closest_boundary_point(const S& shape, const P& point) {
  assert(detail::is_accepted(shape));
  return detail::closest_boundary_point_of(shape, point);
}

GRAZE_DECLARE_INSTANCES(GRAZE_CLOSEST_BOUNDARY_POINT_INSTANCES)

}  // namespace graze
