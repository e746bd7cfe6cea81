// SPDX-License-Identifier: MIT
/// @file
/// separation(a, b): the signed distance of any two shapes of the same dimension and number type, negative where they
/// overlap.
#pragma once

#include <cassert>

#include <graze/query/closest_points.hpp>
#include <graze/query/compiled/instances.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

/// The signed distance of two valid shapes (asserted) of the same dimension and number type. If they are apart, the
/// result is that of `closest_points`. If they meet, `distance` is minus the depth of `contact`: zero, up to `error`,
/// if they only touch, and minus infinity if no translation separates them. The points are then the deepest point of
/// each surface in the other shape; normal, status and error are those of the contact. So moving b by normal *
/// -distance leaves the shapes touching within the error, and point_b is point_a + normal * distance up to rounding to
/// T, unless the normal is zero (the gap is below the error, or nothing separates the shapes).
///
/// `distance` is above zero if and only if `intersects(a, b)` is false. Swapping the arguments swaps the points,
/// negates the normal and changes nothing else, as far as both queries guarantee it: see closest_points.hpp and
/// contact.hpp, also for algorithms and errors. A compound counts as its nearest part, or its deepest if it is met;
/// without parts it is infinitely far from everything.
///
/// For a shape and a point, `signed_distance` is the distance from the surface. It is the same except for planes, whose
/// two sides it distinguishes by the sign.
template <Shape A, SameSpace<A> B>
Proximity<dimension_of<A>, scalar_of<A>> separation(const A& a, const B& b) {
  using T = scalar_of<A>;
  Proximity<dimension_of<A>, T> result = closest_points(a, b);
  if (result.relation == Relation::apart) return result;
  const auto met = contact(a, b);
  assert(met.has_value());  // relation decides both
  result.distance = T(0) - met->depth;
  result.point_a = met->point_a;
  result.point_b = met->point_b;
  result.normal = met->normal;
  result.status = met->status;
  result.error = met->error;
  return result;
}

GRAZE_DECLARE_INSTANCES(GRAZE_SEPARATION_INSTANCES)

}  // namespace graze
