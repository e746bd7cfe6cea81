// SPDX-License-Identifier: MIT
/// @file
/// contact(a, b): how deep two shapes that meet overlap, where, and in which direction they separate with the shortest
/// translation.
///
/// What finds it. C: closed form. S: the supports along the plane's normal, a closed form for every convex shape. P:
/// part by part. G: GJK if the cores are apart, EPA if they meet.
///
///                 segment ray sphere aabb obb plane half-space triangle capsule polytope compound user's
///     point          C     C    C     C    C    S       S         C        C       G        P       G
///     segment        C     C    C     C    C    S       S         C        C       G        P       G
///     ray                  C    C     C    C    C       C         C        C       G        P       G
///     sphere                    C     C    C    S       S         C        C       G        P       G
///     aabb                            C    C    S       S         C        C       G        P       G
///     obb                                  C    S       S         C        C       G        P       G
///     plane                                     C       C         S        S       S        P       S
///     half-space                                        C         S        S       S        P       S
///     triangle                                                    C        C       G        P       G
///     capsule                                                              C       G        P       G
///     polytope                                                                     G        P       G
///     compound                                                                              P       P
///
/// relation(a, b) decides whether there is a contact. Moving b by normal * depth is the shortest translation that
/// leaves the shapes touching; point_b moves onto point_a. A round shape is a core (a center or an axis) and a radius.
/// If the cores are apart, the normal is along the vector between their nearest points. If they meet, it is the normal
/// of the nearest face of the Minkowski difference a - b, which is a face of one shape or spanned by an edge of each.
/// Among directions that are equally good up to rounding the order is: face normals before pairs of edges, those of a
/// before those of b, coordinate axes and boxes' axes in their order, forward before backward.
///
/// Shapes whose differences fill no volume (in 2D: no area) only touch: their depth is 0, and the normal is
/// perpendicular to all differences. For two coplanar triangles or segments it is the normal of their plane, for two
/// collinear segments perpendicular to their line, for a point on a point x. It is also x for concentric spheres, and
/// perpendicular to the axes for capsules whose axes are collinear.
///
/// No translation separates planes and half-spaces that are not parallel, half-spaces that do not face each other, or a
/// half-space and a ray that runs into it. For these the depth is infinite, the normal zero, and both points are a
/// common point.
///
/// With ContactOptions::margin, shapes that are up to that far apart have a contact as well. Its depth is minus their
/// distance, so it changes continuously as they meet. Points, normal, status and error are those of closest_points.hpp.
///
/// A compound counts as its deepest part, of several the first; where parts overlap, the way out of one may lead deeper
/// into another. A mesh counts as the compound of its faces. But a solid in 3D that holds the center of the shape's box
/// pushes the shape out to the plane of a face, with its normal rounded to T: the least deep of those that it touches
/// and the one nearest to the center. So the move takes a shape out of the faces nearby, but perhaps into others. Where
/// a face nearby is turned around or flat, a shape that touches none is pushed straight to the nearest. A ray in an
/// open solid may run into such a plane; then its depth is infinite.
///
/// Swapping the arguments swaps the points, negates the normal and changes no bit of anything else, except for two
/// equal shapes.
///
/// `error` bounds the error of the depth before rounding to T, and the overlap or gap that remains after the move. C: a
/// few epsilon of double of the pair's own size, however far from the origin (for rays: of the larger of the other
/// shape's size and its distance from the ray's origin). S and G: a few epsilon of the largest coordinate (of T for a
/// user's shape that calculates in T). G adds the gap between the bounds that GJK or EPA has proved; the status tells
/// if it exceeds 1e-12 of the depth. Coordinates may be any finite numbers; see range.hpp for sizes that differ by more
/// than a factor of 2^900.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/compiled/instances.hpp>
#include <graze/query/contact/convex.hpp>
#include <graze/query/contact/cores.hpp>
#include <graze/query/contact/deciding_contact.hpp>
#include <graze/query/contact/unbounded.hpp>
#include <graze/query/contact_options.hpp>
#include <graze/query/cores/penetration.hpp>
#include <graze/query/fast_contact/fast_contact.hpp>
#include <graze/query/fast_contact/obb/contact.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/status.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/nan_check.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

/// The penetration of two shapes that meet, or the gap between two that are near.
template <Dim N, class T = float>
struct Contact {
  Vec<N, T> point = Vec<N, T>(T(0));    ///< Midpoint of point_a and point_b.
  Vec<N, T> normal = Vec<N, T>(T(0));   ///< Of length 1, from a to b; zero if no translation separates them.
  T depth = T(0);                       ///< How far b must move along the normal until the shapes only touch;
                                        ///< below zero if they are apart, which only a margin allows.
  Vec<N, T> point_a = Vec<N, T>(T(0));  ///< On the surface of a, deepest in b: point_b + normal * depth.
  Vec<N, T> point_b = Vec<N, T>(T(0));  ///< On the surface of b, deepest in a.
  Status status = Status::converged;    ///< Always `converged` for closed forms.
  double error = 0;                     ///< Largest error of `depth` before rounding to T.

  friend bool operator==(const Contact&, const Contact&) = default;
};

namespace detail {

/// Constructed in place: a copy would wait for the stores.
template <Scalar T, Dim N>
std::optional<Contact<N, T>> rounded_contact(const Penetration<N>& exact) {
  std::optional<Contact<N, T>> result;
  Contact<N, T>& contact = result.emplace();
  contact.point = Vec<N, T>(exact.point_a * 0.5 + exact.point_b * 0.5) + T(0);  // never minus zero
  contact.normal = Vec<N, T>(exact.normal) + T(0);
  contact.depth = static_cast<T>(exact.depth);
  contact.point_a = Vec<N, T>(exact.point_a) + T(0);
  contact.point_b = Vec<N, T>(exact.point_b) + T(0);
  contact.status = exact.status;
  contact.error = exact.error;
  return result;
}

/// For two simple shapes that meet, in the order of AnyShape.
template <class A, class B>
Penetration<dimension_of<A>> penetration_in_order(const A& a, const B& b) {
  if constexpr (is_plane_or_half_space<A> && is_plane_or_half_space<B>) {
    return penetration_of_half_spaces(a, b);
  } else if constexpr (is_ray<A> && is_plane_or_half_space<B>) {
    return penetration_of_ray(a, b);
  } else if constexpr (is_plane_or_half_space<B>) {
    return exchanged(penetration_in_half_space(b, a));
  } else if constexpr (is_plane_or_half_space<A>) {
    return penetration_in_half_space(a, b);
  } else if constexpr (is_ray<A> && is_ray<B>) {
    return penetration_of_rays(a, b);
  } else if constexpr (HasSimpleCore<A> && HasSimpleCore<B>) {
    return penetration_of_simple(a, b);
  } else {
    return penetration_of_convex(a, b);
  }
}

/// True if neither shape is a compound or a variant.
template <class A, class B>
inline constexpr bool are_simple = !is_any_shape<A> && !is_any_shape<B> && !HasParts<A> && !HasParts<B>;

/// The rank of a type in the order of contacts: that of AnyShape, but oriented boxes before axis-aligned ones, which
/// follow each other there, because fast_contact/obb/boxes_in_frame.hpp takes both relative to the center of the
/// oriented one.
template <class S>
inline constexpr std::size_t contact_place = 2 * type_place<S> + (is_a<Aabb, S> ? 3 : 0);
template <class A, class B>
inline constexpr bool are_contacts_exchanged = (contact_place<A>) > contact_place<B>;

template <Dim N>
std::optional<Penetration<N>> exchanged(std::optional<Penetration<N>> penetration) {
  if (penetration) penetration = exchanged(*penetration);
  return penetration;
}

/// For two simple shapes that meet and are in range.
template <class A, class B>
Penetration<dimension_of<A>> penetration_in_any_order(const A& a, const B& b) {
  if constexpr (contact_place<A> < contact_place<B>) {
    return penetration_in_order(a, b);
  } else if constexpr (are_contacts_exchanged<A, B>) {
    return exchanged(penetration_in_order(b, a));
  } else {
    return is_in_order(a, b) ? penetration_in_order(a, b) : exchanged(penetration_in_order(b, a));
  }
}

/// Whether a result was calculated from numbers in range. Axis-aligned boxes may have depths of any size. A ray that
/// has no part beside the other shape is cut somewhere.
template <class A, class B>
bool is_in_range(const Penetration<dimension_of<A>>& found, const A& a, const B& b) {
  if constexpr (is_a<Aabb, A> && is_a<Aabb, B>) return found.depth < 0x1p1000;
  if constexpr (is_ray<A> || is_ray<B> || (is_plane_or_half_space<A> && is_plane_or_half_space<B>))
    return are_usual(a, b);
  return is_usual_error<scalar_of<A>>(found.error) && has_usual_normal(a) && has_usual_normal(b);
}

/// For two simple shapes that meet.
template <class A, class B>
Penetration<dimension_of<A>> penetration_of_met(const A& a, const B& b) {
  if constexpr (is_found_by_support<A, B>) {
    if (!are_usual(a, b)) {
      const auto rescaled = penetration_in_range(a, b);
      if (rescaled && *rescaled) return **rescaled;
    }
  }
  Penetration<dimension_of<A>> found = penetration_in_any_order(a, b);
  if (!is_in_range(found, a, b)) {
    const auto rescaled = penetration_in_range(a, b);
    if (rescaled && *rescaled) found = **rescaled;
  }
  return found;
}

/// True if GJK and EPA decide whether two shapes meet, and how deep.
template <class A, class B>
inline constexpr bool are_for_epa =
    !HasClosedForm<A, B> && !HasClosedForm<B, A> && !is_point<A> && !is_point<B> && !is_ray<A> && !is_ray<B> &&
    !is_plane_or_half_space<A> && !is_plane_or_half_space<B>;

/// For two simple shapes; none if they are apart.
template <class A, class B>
std::optional<Penetration<dimension_of<A>>> penetration_if_met(const A& a, const B& b) {
  if constexpr (are_contacts_exchanged<A, B>) {
    return exchanged(penetration_if_met(b, a));
  } else if constexpr (are_for_epa<A, B>) {
    if (any_nan(a, b)) return std::nullopt;
    if (!are_usual(a, b)) {
      if (const auto rescaled = penetration_in_range(a, b)) return *rescaled;
    }
    const auto ask = [](const auto& first, const auto& second) { return penetration_of_convex_if_met(first, second); };
    return answer_in_order(a, b, ask, [](const auto& found) { return exchanged(found); });
  } else {
    if (decide(a, b) == Relation::apart) return std::nullopt;
    return penetration_of_met(a, b);
  }
}

template <HasParts Whole, class S>
std::optional<Penetration<dimension_of<S>>> penetration_of_parts(const Whole& whole, const S& shape) {
  return with_deciding_contact(
      whole, shape, touching_bounds(shape), [&shape](const auto& part) { return penetration(part, shape); },
      [](const auto& found, std::size_t, const auto*) { return found; });
}

template <class A, class B>
std::optional<Penetration<dimension_of<A>>> penetration(const A& a, const B& b) {
  if constexpr (is_any_shape<A>) {
    return detail::visit([&b](const auto& held) { return penetration(held, b); }, a);
  } else if constexpr (is_any_shape<B>) {
    return detail::visit([&a](const auto& held) { return penetration(a, held); }, b);
  } else if constexpr (HasParts<A> && HasParts<B>) {
    return is_in_order(a, b) ? penetration_of_parts(a, b) : exchanged(penetration_of_parts(b, a));
  } else if constexpr (HasParts<A>) {
    return penetration_of_parts(a, b);
  } else if constexpr (HasParts<B>) {
    return exchanged(penetration_of_parts(b, a));
  } else if constexpr (are_contacts_exchanged<A, B>) {
    return exchanged(penetration(b, a));
  } else if constexpr (are_quick_obbs<A, B>) {
    const bool turned = are_turned(a, b);
    const auto found = penetration_of_obbs(seen_in_order(a, b, turned));
    if (found && !is_usual_error<scalar_of<A>>(found->error)) {
      const auto rescaled = penetration_in_range(a, b);
      if (rescaled && *rescaled) return *rescaled;
    }
    return turned ? exchanged(found) : found;
  } else {
    if constexpr (has_fast_contact<A, B>) {
      const auto quick = fast_contact(a, b);
      if (quick.is_known && is_usual_error<scalar_of<A>>(quick.found.error)) {
        return quick.meets ? std::optional(quick.found) : std::nullopt;
      }
    }
    return penetration_if_met(a, b);
  }
}

/// Whether a number of a shape, or of any of its parts, is NaN. Users' shapes are not checked.
template <class S>
bool has_nan(const S& shape) {
  if constexpr (is_any_shape<S>) {
    return detail::visit([](const auto& held) { return has_nan(held); }, shape);
  } else if constexpr (is_compound<S>) {
    return std::any_of(shape.parts.begin(), shape.parts.end(), [](const auto& part) { return has_nan(part.shape); });
  } else {
    return std::isnan(numbers_of(shape));
  }
}

/// For shapes that do not meet but are up to `margin` apart: with their distance as a negative depth. Not inlined, so
/// that it costs calls without a margin nothing; likewise what calls it.
template <class A, class B>
[[gnu::noinline]] std::optional<Penetration<dimension_of<A>>> penetration_of_near(const A& a, const B& b,
                                                                                  double margin) {
  if (!(margin > 0) || has_nan(a) || has_nan(b)) return std::nullopt;
  const Proximity<dimension_of<A>, double> near = proximity(a, b);
  if (!(near.distance <= margin) || std::isinf(near.distance)) return std::nullopt;
  return Penetration<dimension_of<A>>{near.normal, -near.distance, near.point_a, near.point_b, near.status, near.error};
}

/// For shapes that meet or are up to `margin` apart.
template <class A, class B>
std::optional<Penetration<dimension_of<A>>> penetration_within(const A& a, const B& b, double margin) {
  auto found = penetration(a, b);
  if (!found && margin > 0) found = penetration_of_near(a, b, margin);
  return found;
}

/// For two boxes in 3D, at least one of them oriented; rounded in place, so that nothing is copied. Declared even
/// without vector lanes, and so without `are_quick_obbs`, because compilers look the name up anyway.
template <class A, class B>
std::optional<Contact<3, scalar_of<A>>> rounded_contact_of_obbs(const A& a, const B& b);

#ifdef GRAZE_HAS_LANES
template <class A, class B>
std::optional<Contact<3, scalar_of<A>>> rounded_contact_of_obbs(const A& a, const B& b) {
  using T = scalar_of<A>;
  std::optional<Contact<3, T>> result;
  const bool turns = are_turned(a, b);
  const auto seen = seen_in_order(a, b, turns);
  const ObbAxes axes = seen.axes();
  if (are_apart(seen, axes)) return result;
  const MeetingObbs met(seen, axes.candidates);
  const TouchingPoints points = touching_points(seen, met);
  const auto rounded = [](const PairedVec& v) { return Vec<3, T>(plain(v)) + T(0); };  // never minus zero
  Contact<3, T>& contact = result.emplace();
  contact.point = rounded(points.of[0] * 0.5 + points.of[1] * 0.5);
  contact.normal = rounded(met.normal * (turns ? -1.0 : 1.0));
  contact.depth = static_cast<T>(met.depth());
  contact.point_a = rounded(points.of[turns ? 1 : 0]);
  contact.point_b = rounded(points.of[turns ? 0 : 1]);
  contact.error = met.error();
  if (!is_usual_error<T>(contact.error)) {
    const auto rescaled = penetration_in_range(a, b);
    if (rescaled && *rescaled) result = rounded_contact<T>(**rescaled);
  }
  return result;
}
#endif

}  // namespace detail

/// The contact of two valid shapes (asserted) of the same dimension and number type, or none if they are apart. See the
/// top of this file for what it is and how exact. `intersects` is cheaper if only the yes or no matters; `manifold`
/// returns all contact points.
template <Shape A, SameSpace<A> B>
std::optional<Contact<dimension_of<A>, scalar_of<A>>> contact(const A& a, const B& b) {
  assert(detail::is_valid_if_known(a) && detail::is_valid_if_known(b));
  if constexpr (detail::are_quick_obbs<A, B>) {
    return detail::rounded_contact_of_obbs(a, b);
  } else if constexpr (detail::are_simple<A, B>) {
    if constexpr (detail::has_fast_contact<A, B>) {
      const auto quick = detail::fast_contact(a, b);
      if (quick.is_known && detail::is_usual_error<scalar_of<A>>(quick.found.error)) {
        if (!quick.meets) return std::nullopt;
        return detail::rounded_contact<scalar_of<A>>(quick.found);
      }
    }
    const auto found = detail::penetration_if_met(a, b);
    if (!found) return std::nullopt;
    return detail::rounded_contact<scalar_of<A>>(*found);
  } else {
    const auto found = detail::penetration(a, b);
    if (!found) return std::nullopt;
    return detail::rounded_contact<scalar_of<A>>(*found);
  }
}

/// The same with options: with a margin, also for shapes that are up to that far apart. Their depth is minus their
/// distance, and points, normal, status and error are those of `closest_points`. Without a margin, the result is the
/// same to the last bit.
template <Shape A, SameSpace<A> B>
std::optional<Contact<dimension_of<A>, scalar_of<A>>> contact(const A& a, const B& b, ContactOptions options) {
  using T = scalar_of<A>;
  assert(options.margin >= 0);
  auto found = contact(a, b);
  if (found) return found;
  const auto near = detail::penetration_of_near(a, b, options.margin);
  if (!near) return std::nullopt;
  found = detail::rounded_contact<T>(*near);
  found->depth = T(0) - detail::rounded_distance<T>(-near->depth, Relation::apart);  // below zero, however small
  return found;
}

GRAZE_DECLARE_INSTANCES(GRAZE_CONTACT_INSTANCES)

}  // namespace graze
