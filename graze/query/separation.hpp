// SPDX-License-Identifier: MIT
// separation(a, b): the signed distance of any two shapes of one space, which goes on through touching into depth.
#pragma once

#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

/// How far apart two valid shapes (asserted) of the same dimension and number type are, negative where they are in each
/// other. Where they are apart, all is what `closest_points` says. Where they meet, `distance` is minus the depth of
/// `contact`, zero for shapes that only touch up to `error`, minus infinity for those that no translation parts; the
/// points are of the two surfaces, each the deepest in the other shape, and normal, status and error those of the
/// contact. So everywhere to move b by normal * -distance leaves the two touching within the error, and point_b is
/// point_a + normal * distance, as far as the numbers of T go; but for a normal that is zero (shapes apart by less than
/// the error, or with no way out).
///
/// `distance` is above zero if and only if `intersects(a, b)` says no. Swapping the arguments swaps the points and
/// negates the normal, and changes no bit of anything else, where that holds of both queries: see closest_points.hpp
/// and contact.hpp, also for what finds it and how exactly. A compound is its nearest part, or where it is met its
/// deepest; without parts it is infinitely far from everything.
///
/// Of a shape and a point `signed_distance` says how far the point is from the surface. It is the same but for planes,
/// where it tells one side from the other by its sign.
template <Shape A, SameSpace<A> B>
Proximity<dimension_of<A>, scalar_of<A>> separation(const A& a, const B& b) {
  using T = scalar_of<A>;
  Proximity<dimension_of<A>, T> result = closest_points(a, b);
  if (result.relation == Relation::apart) return result;
  const auto met = contact(a, b);
  result.distance = T(0) - met->depth;
  result.point_a = met->point_a;
  result.point_b = met->point_b;
  result.normal = met->normal;
  result.status = met->status;
  result.error = met->error;
  return result;
}

}  // namespace graze
