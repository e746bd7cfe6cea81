// SPDX-License-Identifier: MIT
// The manifolds of two simple shapes of given types, in double. Include manifold.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/fast_contact/fast_contact.hpp>
#include <graze/query/patch/aabb_manifold.hpp>
#include <graze/query/patch/manifold_points.hpp>
#include <graze/query/patch/of_shape.hpp>
#include <graze/query/patch/patch.hpp>
#include <graze/query/scaling/wide_manifold.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// Whether a face is perpendicular to the direction between cores that are this far apart, as far as rounding lets one
/// tell: it turns the direction by up to the error of the distance over the distance.
template <Dim N>
bool faces_along(const Patch<N>& patch, const Vec<N, double>& direction, double distance, double error) {
  const Vec<N, double> turn = patch.normal - direction;
  return std::sqrt(dot(turn, turn)) <= std::min(0.5, std::max(tolerance::aligned, 2 * error / distance));
}

/// The normal of shapes that are apart, up to rounding: between faces that of the faces, as if they met. Without that
/// it would lose its direction as the gap closes.
template <Dim N>
Vec<N, double> normal_of_apart(const FacingPatches<N>& facing, const Penetration<N>& found) {
  const double distance = facing.radius_a + facing.radius_b - found.depth;
  if (faces_along(facing.a, found.normal, distance, found.error)) return facing.a.normal;
  if (faces_along(facing.b, -found.normal, distance, found.error)) return -facing.b.normal;
  return found.normal;
}

/// With points up to `margin` apart.
template <class A, class B>
WideManifold<dimension_of<A>> manifold_of_found(const A& a, const B& b, const Penetration<dimension_of<A>>& found,
                                                double margin = 0) {
  constexpr Dim N = dimension_of<A>;
  WideManifold<N> result = manifold_of_one_point(found);
  if (std::isinf(found.depth) || (is_plane_or_half_space<A> && is_plane_or_half_space<B>)) return result;
  const Vec<N, double> origin = found.point_a;
  const Patch<N> patch_a = patch_seen(a, origin, found.normal, found.point_a);
  const Patch<N> patch_b = patch_seen(b, origin, -found.normal, found.point_b);
  const FacingPatches<N> facing{patch_a, patch_b, radius_of_core(a), radius_of_core(b), tolerance::aligned, margin};
  if (found.depth < 0) result.found.normal = normal_of_apart(facing, found);
  const double size = (size_of_patch(facing.a) + size_of_patch(facing.b)) + (facing.radius_a + facing.radius_b) +
                      std::fabs(found.depth);
  const Penetration<N> seen = moved_by(result.found, -origin);
  choose_points(surface_pairs(facing, seen, found.error + tolerance::coarse * size), result);
  move_points(result, origin);
  return result;
}

/// For two axis-aligned boxes that meet.
template <Dim N, class T>
WideManifold<N> manifold_of_aabbs(const Aabb<N, T>& a, const Aabb<N, T>& b) {
  const Penetration<N> found = penetration_in_order(a, b);
  const Aabb<N, double> box_a = relative_to(Vec<N, double>(0.0), a);
  const Aabb<N, double> box_b = relative_to(Vec<N, double>(0.0), b);
  if (!has_faces(box_a) || !has_faces(box_b)) return manifold_of_found(a, b, found);
  WideManifold<N> result;
  result.found = found;
  result.pairs = pairs_of_aabbs(box_a, box_b, found,
                                tolerance::coarse * (sum_abs(box_a.max - box_a.min) + sum_abs(box_b.max - box_b.min)));
  result.size = result.pairs.size();
  return result;
}

/// For two simple shapes in the order in which their contact is calculated. That of boxes has their faces ready.
template <class A, class B>
WideManifold<dimension_of<A>> manifold_in_order(const A& a, const B& b) {
  if constexpr (is_a<Aabb, A> && is_a<Aabb, B>) {
    return manifold_of_aabbs(a, b);
  } else if constexpr (are_boxes<A, B>) {
    constexpr Dim N = dimension_of<A>;
    const Vec<N, double> origin = reference(a);
    const auto local_a = relative_to(origin, a);
    const auto local_b = relative_to(origin, b);
    const BoxesContact<N> contact = contact_of_boxes(local_a, local_b);
    WideManifold<N> result;
    result.found = contact.found;
    choose_points(pairs_of_boxes(local_a, local_b, contact), result);
    move_points(result, origin);
    return result;
  } else {
    return manifold_of_found(a, b, penetration_in_order(a, b));
  }
}

/// For two simple shapes in the order of their contact, which is known.
template <class A, class B>
WideManifold<dimension_of<A>> manifold_in_frame(const A& a, const B& b, const Penetration<dimension_of<A>>& found) {
  if constexpr (is_box<A> && is_plane_or_half_space<B>) {
    if (const auto pairs = corners_on_boundary(a, found)) {
      WideManifold<dimension_of<A>> result;
      result.found = found;
      result.pairs = *pairs;
      result.size = pairs->size();
      return result;
    }
  }
  return manifold_of_found(a, b, found);
}

/// For two simple shapes in any order, whose contact is known.
template <class A, class B>
WideManifold<dimension_of<A>> manifold_of_asked(const A& a, const B& b, const Penetration<dimension_of<A>>& found) {
  if constexpr (are_exchanged<A, B> || are_in_either_order<A, B>) {
    if (!is_in_order(a, b)) {
      WideManifold<dimension_of<A>> result = manifold_in_frame(b, a, exchanged(found));
      exchange(result);
      return result;
    }
  }
  return manifold_in_frame(a, b, found);
}

/// For two simple shapes that a fast test shows to meet.
template <class A, class B, class Look>
WideManifold<dimension_of<A>> manifold_of_look(const A& a, const B& b, const Look& look) {
  WideManifold<dimension_of<A>> result;
  result.found = look.found;
  result.size = look.put_points(result.pairs.data());
  if (result.size == 0) result = manifold_of_asked(a, b, look.found);
  return result;
}

/// For two simple shapes that meet and are in range.
template <class A, class B>
WideManifold<dimension_of<A>> manifold_in_any_order(const A& a, const B& b) {
  if constexpr (contact_place<A> < contact_place<B>) {
    return manifold_in_order(a, b);
  } else if constexpr (are_contacts_exchanged<A, B>) {
    WideManifold<dimension_of<A>> result = manifold_in_order(b, a);
    exchange(result);
    return result;
  } else {
    const bool turns = !is_in_order(a, b);
    WideManifold<dimension_of<A>> result = manifold_in_order(turns ? b : a, turns ? a : b);
    if (turns) exchange(result);
    return result;
  }
}

}  // namespace graze::detail
