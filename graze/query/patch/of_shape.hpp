// SPDX-License-Identifier: MIT
// patch_seen(shape, origin, direction, point): the patch of any shape's core, relative to an origin near a contact.
#pragma once

#include <graze/math/vec.hpp>
#include <graze/query/closest/unbounded.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/patch/of_polytope.hpp>
#include <graze/query/patch/patch.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/polytope.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

template <class S>
inline constexpr bool is_polytope = false;
template <Dim N, class T>
inline constexpr bool is_polytope<Polytope<N, T>> = true;

/// The plane itself, without bounds. It belongs to a contact, so its normal is along the contact's normal or opposite.
template <Dim N, class T>
Patch<N> unbounded_patch(const Plane<N, T>& plane, const Vec<N, double>& origin, const Vec<N, double>& direction) {
  Patch<N> patch;
  patch.corners[0] = surface_point(plane, origin).point - origin;
  patch.normal = unit_or(wide<N, T>(plane.normal), direction);
  if (dot(patch.normal, direction) < 0) patch.normal = -patch.normal;
  return patch;
}

/// For rays and users' shapes, which have no known faces, the `point` of the contact.
template <class S>
Patch<dimension_of<S>> patch_seen(const S& shape, const Vec<dimension_of<S>, double>& origin,
                                  const Vec<dimension_of<S>, double>& direction,
                                  const Vec<dimension_of<S>, double>& point) {
  if constexpr (is_plane_or_half_space<S>) {
    return unbounded_patch(boundary_of(shape), origin, direction);
  } else if constexpr (is_polytope<S>) {
    return patch_of_polytope(shape, origin, direction);
  } else if constexpr (HasSimpleCore<S> && !is_ray<S>) {
    return patch_of(relative_to(origin, core(shape)), direction);
  } else {
    return patch_of(point - origin, direction);
  }
}

template <class S>
double radius_of_core(const S& shape) {
  if constexpr (!is_plane_or_half_space<S>) return core_radius(shape);
  return 0;
}

}  // namespace graze::detail
