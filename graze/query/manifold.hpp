// SPDX-License-Identifier: MIT
/// @file
/// manifold(a, b): a few contact points that hold two shapes apart as their whole contact area would. A solver needs
/// them so that a box rests on a floor without toppling.
///
/// The normal and the depth are those of contact(a, b), which also decides whether there is a contact. A face of either
/// shape that is perpendicular to the normal is the reference face; if both shapes have one, a plane's comes first, and
/// otherwise the choice does not depend on the order of the arguments. The face of the other shape that points most
/// against it is projected onto it and clipped at its sides and at its surface. Every corner of the result is a contact
/// with its own depth along the normal. Two parallel edges (of capsules and segments in 3D) give the ends of their
/// common part. Everything else, also rays, users' shapes and pairs that no translation separates, gives the single
/// point of `contact`. So a sphere has one point, a lying capsule two, a box up to four. Of more points, those that
/// span the area are chosen: the deepest, the farthest from it, and on either side of the line between them the one
/// that makes the largest triangle. A face that is tilted against another by up to 1e-5 radians rests on it if no part
/// of it is higher above the other than 1e-5 of half the perimeter of the smaller face; then nothing is clipped at the
/// surface, and corners above it have depth 0.
///
/// Each point has an id that tells on which vertex, edge or face of a, and of b, it lies; no two points of a manifold
/// have the same one. It is stable from frame to frame until a corner crosses a side of the other shape, so a solver
/// can reuse the impulses of the last frame. The index of a feature (see `Feature`) does not depend on the pose of a
/// shape whose corners keep their order, as with `transformed`. Among points that are equally good up to 1e-5 of the
/// area the choice is stable (except for two boxes that cross in an octagon when both rotate far). Faces count as
/// perpendicular to the normal, and edges as parallel, within 1e-5 radians; corners of a polytope that are closer than
/// 1e-5 of its size count as one.
///
/// With a margin, faces are clipped that far above the surface instead of at it, and points that are apart have a
/// negative depth: a box that hovers over a floor has the points on which it will land. The normal of shapes that are
/// apart is that of closest_points or, if a face is perpendicular to it up to rounding, that of the face. So points,
/// depths and normal change continuously as a face lands on another. With a margin, corners above a face on which
/// another rests have their own depth.
///
/// A compound counts as its deepest part, which the ids name. Swapping the arguments swaps everything, except for the
/// order of equal shapes. Any finite coordinates are allowed, as in contact.hpp. Errors of the points are those of
/// `contact`, and errors of the depths are at most `error`; both are larger by 1e-5 of the size for faces that are not
/// exactly perpendicular to the normal or rest on each other, and for polytopes with corners that close to each other.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/compiled/instances.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contact_options.hpp>
#include <graze/query/fast_contact/fast_contact.hpp>
#include <graze/query/fast_contact/obb/choice.hpp>
#include <graze/query/fast_contact/obb/contact.hpp>
#include <graze/query/fast_contact/obb/manifold.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/query/patch/clipped.hpp>
#include <graze/query/patch/pair_manifold.hpp>
#include <graze/query/scaling/wide_manifold.hpp>
#include <graze/query/status.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

/// The features of two shapes on which a contact point lies.
struct ContactId {
  Feature a{};               ///< Corner, edge or face of a.
  Feature b{};               ///< Corner, edge or face of b.
  std::uint32_t part_a = 0;  ///< The index of a's part in a compound; 0 without parts.
  std::uint32_t part_b = 0;  ///< The index of b's part in a compound; 0 without parts.

  friend bool operator==(const ContactId&, const ContactId&) = default;
};

/// One point of a manifold; members as in Contact, but of this point.
template <Dim N, class T = float>
struct ManifoldPoint {
  Vec<N, T> point = Vec<N, T>(T(0));    ///< Midpoint of point_a and point_b.
  Vec<N, T> point_a = Vec<N, T>(T(0));  ///< On the surface of a.
  Vec<N, T> point_b = Vec<N, T>(T(0));  ///< On the surface of b: point_a - normal * depth.
  T depth = T(0);                       ///< Along the normal of the manifold; below zero only with a margin.
  ContactId id;                         ///< Identifies the point across frames.

  friend bool operator==(const ManifoldPoint&, const ManifoldPoint&) = default;
};

/// The contact points of two shapes; none if they are apart, or farther apart than the margin.
template <Dim N, class T = float>
struct Manifold {
  static constexpr std::size_t most_points = N == 2 ? 2 : 4;  ///< 2 in 2D, 4 in 3D.

  std::array<ManifoldPoint<N, T>, most_points> points;  ///< The first `size` are contacts; see `contacts()`.
  std::size_t size = 0;                                 ///< Number of contacts; 0 if the shapes are apart.
  Vec<N, T> normal =
      Vec<N, T>(T(0));  ///< Of length 1, from a to b; zero if nothing separates the shapes, or they are apart.
  Status status = Status::converged;  ///< As in Contact.
  double error = 0;                   ///< As in Contact.

  /// The contacts; empty if the shapes are apart. A view of this manifold.
  std::span<const ManifoldPoint<N, T>> contacts() const { return {points.data(), size}; }

  friend bool operator==(const Manifold&, const Manifold&) = default;
};

namespace detail {

template <class A, class B>
std::optional<WideManifold<dimension_of<A>>> wide_manifold(const A& a, const B& b, double margin = 0);

template <Dim N>
std::optional<WideManifold<N>> exchanged(std::optional<WideManifold<N>> manifold) {
  if (manifold) exchange(*manifold);
  return manifold;
}

/// The manifold of the deepest part, of several the first, as in `contact`. Nested parts are numbered consecutively.
template <HasParts Whole, class S>
std::optional<WideManifold<dimension_of<S>>> manifold_of_parts(const Whole& whole, const S& shape, double margin) {
  using Result = std::optional<WideManifold<dimension_of<S>>>;
  const auto manifold_of = [&](const auto& found, std::size_t index,
                               [[maybe_unused]] const auto* half_space) -> Result {
    if (!found) return std::nullopt;
    Result result;
    if constexpr (dimension_of<S> == 3 && is_mesh<Whole>) {
      if (half_space != nullptr) result = wide_manifold(*half_space, shape, margin);
    }
    if (!result) result = wide_manifold(part_of(whole, index), shape, margin);
    if (result) result->part_a = static_cast<std::uint32_t>(result->part_a * count_of_parts(whole) + index);
    return result;
  };
  return with_deciding_contact(
      whole, shape, inflated(touching_bounds(shape), round_up<scalar_of<S>>(margin)),
      [&](const auto& part) { return penetration_within(part, shape, margin); }, manifold_of);
}

/// For two shapes that are out of range, if they meet or are up to `margin` apart; none for others.
template <class A, class B>
[[gnu::noinline, gnu::cold]] std::optional<std::optional<WideManifold<dimension_of<A>>>> manifold_in_range(
    const A& a, const B& b, double margin = 0) {
  using Found = std::optional<WideManifold<dimension_of<A>>>;
  return answer_in_range<Found>(
      [](const auto& power, const auto& scaled_a, const auto& scaled_b, const auto& scaled_margin) {
        Found found = wide_manifold(scaled_a, scaled_b, max_abs(scaled_margin));
        if (found) resize(*found, power.inverse());
        return found;
      },
      a, b, Vec<dimension_of<A>, double>(margin));
}

/// For two simple shapes that meet or are up to `margin` apart: from their faces in any case, so that the points change
/// continuously as a gap closes.
template <class A, class B>
[[gnu::noinline]] std::optional<WideManifold<dimension_of<A>>> manifold_within(const A& a, const B& b, double margin) {
  const bool are_in_range = are_usual(a, b, Vec<dimension_of<A>, double>(margin));
  if (!are_in_range) {
    if (const auto rescaled = manifold_in_range(a, b, margin)) return *rescaled;
  }
  const auto found = penetration_within(a, b, margin);
  if (!found) return std::nullopt;
  if (!are_in_range && are_mixed(a, b)) return manifold_of_one_point(*found);
  if constexpr (are_exchanged<A, B> || are_in_either_order<A, B>) {
    if (!is_in_order(a, b)) {
      WideManifold<dimension_of<A>> result = manifold_of_found(b, a, exchanged(*found), margin);
      exchange(result);
      return result;
    }
  }
  return manifold_of_found(a, b, *found, margin);
}

/// For two simple shapes that meet.
template <class A, class B>
WideManifold<dimension_of<A>> manifold_of_met(const A& a, const B& b) {
  constexpr bool are_along_axes = is_a<Aabb, A> && is_a<Aabb, B>;  // needs no multiplications
  if (!are_along_axes && !are_usual(a, b)) {
    const auto rescaled = manifold_in_range(a, b);
    if (rescaled && *rescaled) return **rescaled;
    if (are_mixed(a, b)) return manifold_of_one_point(penetration_of_met(a, b));
  }
  return manifold_in_any_order(a, b);
}

// Not defined without vector lanes, and so without `are_quick_obbs`; compilers look the names up anyway.
template <class A, class B>
std::optional<WideManifold<3>> manifold_of_obbs(const A& a, const B& b);
template <class A, class B>
Manifold<3, scalar_of<A>> rounded_manifold_of_obbs(const A& a, const B& b);

template <class A, class B>
std::optional<WideManifold<dimension_of<A>>> wide_manifold(const A& a, const B& b, double margin) {
  if constexpr (is_any_shape<A>) {
    return detail::visit([&b, margin](const auto& held) { return wide_manifold(held, b, margin); }, a);
  } else if constexpr (is_any_shape<B>) {
    return detail::visit([&a, margin](const auto& held) { return wide_manifold(a, held, margin); }, b);
  } else if constexpr (HasParts<A> && HasParts<B>) {
    return is_in_order(a, b) ? manifold_of_parts(a, b, margin) : exchanged(manifold_of_parts(b, a, margin));
  } else if constexpr (HasParts<A>) {
    return manifold_of_parts(a, b, margin);
  } else if constexpr (HasParts<B>) {
    return exchanged(manifold_of_parts(b, a, margin));
  } else if constexpr (are_contacts_exchanged<A, B>) {
    return exchanged(wide_manifold(b, a, margin));
  } else if constexpr (are_quick_obbs<A, B>) {
    return margin > 0 ? manifold_within(a, b, margin) : manifold_of_obbs(a, b);
  } else {
    if (margin > 0) return manifold_within(a, b, margin);
    if constexpr (has_fast_contact<A, B>) {
      const auto quick = fast_contact(a, b);
      if (quick.is_known && is_usual_error<scalar_of<A>>(quick.found.error)) {
        return quick.meets ? std::optional(manifold_of_look(a, b, quick)) : std::nullopt;
      }
    }
    if constexpr (are_for_epa<A, B>) {
      if (!are_usual(a, b)) {
        if (const auto rescaled = manifold_in_range(a, b)) return *rescaled;
      }
      const auto found = penetration_if_met(a, b);
      if (found && !are_usual(a, b) && are_mixed(a, b)) return manifold_of_one_point(*found);
      return found ? std::optional(manifold_of_asked(a, b, *found)) : std::nullopt;
    } else {
      if (decide(a, b) == Relation::apart) return std::nullopt;
      return manifold_of_met(a, b);
    }
  }
}

/// Empty if the manifold has no more points.
template <Scalar T, Dim N>
ManifoldPoint<N, T> rounded_point(const WideManifold<N>& exact, std::size_t place) {
  if (place >= exact.size) return {};
  const SurfacePair<N>& pair = exact.pairs[place];
  return {Vec<N, T>(pair.point_a * 0.5 + pair.point_b * 0.5) + T(0),  // never minus zero
          Vec<N, T>(pair.point_a) + T(0),
          Vec<N, T>(pair.point_b) + T(0),
          static_cast<T>(pair.depth),
          {pair.feature_a, pair.feature_b, exact.part_a, exact.part_b}};
}

/// Constructs every point in place: to clear them all first takes as long as a fast contact.
template <Scalar T, Dim N, std::size_t... places>
Manifold<N, T> rounded_manifold(const WideManifold<N>& exact, std::index_sequence<places...>) {
  return {{{rounded_point<T>(exact, places)...}},
          exact.size,
          Vec<N, T>(exact.found.normal) + T(0),
          exact.found.status,
          exact.found.error};
}

template <Scalar T, Dim N>
Manifold<N, T> rounded_manifold(const WideManifold<N>& exact) {
  return rounded_manifold<T>(exact, std::make_index_sequence<Manifold<N, T>::most_points>());
}

#ifdef GRAZE_HAS_LANES

/// For two boxes in the order of their contact, or `turned`.
template <class R, class Seen>
[[gnu::noinline]] Manifold<3, R> careful_manifold_of_obbs(const Seen& seen, const BoxesContact<3>& contact,
                                                          bool turned) {
  WideManifold<3> wide;
  wide.found = contact.found;
  choose_points(pairs_of_boxes(seen.first_local(), seen.second_local(), contact), wide);
  move_points(wide, seen.origin());
  if (turned) exchange(wide);
  return rounded_manifold<R>(wide);
}

/// Chooses four corners if there are more.
[[gnu::always_inline]] inline unsigned chosen_corners(const FaceOverFace& over, const PairedVec& normal, bool is_of_b) {
  if (over.size() > Manifold<3>::most_points) return LaneChoice(over, normal, is_of_b).run();
  return over.left();
}

/// For two boxes that meet, in the order of their contact, or `turned`.
template <class R, class Seen>
[[gnu::always_inline]] inline Manifold<3, R> manifold_of_met_obbs(const Seen& seen, const MeetingObbs& met,
                                                                  bool turned) {
  using Point = ManifoldPoint<3, R>;
  const PairedVec origin(seen.origin());
  const ReferenceFace face = reference_face(met);
  const Vec<3, R> normal = rounded_vec<R>(met.normal * (turned ? -1.0 : 1.0));
  if (face.is_any) {
    FaceOverFace over = face_over(met, face, tolerance::aligned);
    if (over.run() && over.size() > 0) {
      const ObbPoints<Point> points(origin, turned != face.is_of_b);
      CornersInTurn<Point> corners(over, chosen_corners(over, met.normal, face.is_of_b), points);
      return {{{corners.next(), corners.next(), corners.next(), corners.next()}},
              corners.count(),
              normal,
              Status::converged,
              met.error()};
    }
  } else if (const CrossingEdges edges = crossing_of_edges(met); edges.is_known) {
    return {{{ObbPoints<Point>(origin, turned).rounded(edges.points), no_point<Point>(), no_point<Point>(),
              no_point<Point>()}},
            1,
            normal,
            Status::converged,
            met.error()};
  }
  return careful_manifold_of_obbs<R>(seen, met.contact(), turned);
}

template <class R, class Seen>
[[gnu::always_inline]] inline Manifold<3, R> quick_manifold_of_obbs(const Seen& seen, bool turned) {
  using Point = ManifoldPoint<3, R>;
  const ObbAxes axes = seen.axes();
  if (are_apart(seen, axes)) return {{{no_point<Point>(), no_point<Point>(), no_point<Point>(), no_point<Point>()}}};
  return manifold_of_met_obbs<R>(seen, MeetingObbs(seen, axes.candidates), turned);
}

template <class A, class B>
Manifold<3, scalar_of<A>> rounded_manifold_of_obbs(const A& a, const B& b) {
  using T = scalar_of<A>;
  const bool turned = are_turned(a, b);
  Manifold<3, T> result = quick_manifold_of_obbs<T>(seen_in_order(a, b, turned), turned);
  if (result.size > 0 && !is_usual_error<T>(result.error)) {
    const auto rescaled = manifold_in_range(a, b);
    if (rescaled && *rescaled) result = rounded_manifold<T>(**rescaled);
  }
  return result;
}

template <class A, class B>
std::optional<WideManifold<3>> manifold_of_obbs(const A& a, const B& b) {
  const bool turned = are_turned(a, b);
  const Manifold<3, double> manifold = quick_manifold_of_obbs<double>(seen_in_order(a, b, turned), turned);
  if (manifold.size == 0) return std::nullopt;
  if (!is_usual_error<scalar_of<A>>(manifold.error)) {
    const auto rescaled = manifold_in_range(a, b);
    if (rescaled && *rescaled) return *rescaled;
  }
  WideManifold<3> wide;
  wide.found.normal = manifold.normal;
  wide.found.error = manifold.error;
  for (const ManifoldPoint<3, double>& point : manifold.contacts()) {
    wide.found.depth = std::max(wide.found.depth, point.depth);
    wide.pairs[wide.size++] = {point.point_a, point.point_b, point.depth, point.id.a, point.id.b};
  }
  return wide;
}

#endif

}  // namespace detail

/// The contact points of two valid shapes (asserted) of the same dimension and number type; none if they are apart. See
/// the top of this file for what they are and how exact. `contact` is cheaper if one point is enough.
template <Shape A, SameSpace<A> B>
Manifold<dimension_of<A>, scalar_of<A>> manifold(const A& a, const B& b) {
  assert(detail::is_valid_if_known(a) && detail::is_valid_if_known(b));
  if constexpr (detail::are_quick_obbs<A, B>) {
    return detail::rounded_manifold_of_obbs(a, b);
  } else if constexpr (detail::are_simple<A, B>) {
    if constexpr (detail::has_fast_contact<A, B>) {
      const auto quick = detail::fast_contact(a, b);
      if (quick.is_known && detail::is_usual_error<scalar_of<A>>(quick.found.error)) {
        if (!quick.meets) return {};
        return detail::rounded_manifold<scalar_of<A>>(detail::manifold_of_look(a, b, quick));
      }
    }
    if (detail::decide(a, b) == Relation::apart) return {};
    return detail::rounded_manifold<scalar_of<A>>(detail::manifold_of_met(a, b));
  } else {
    if (const auto found = detail::wide_manifold(a, b)) return detail::rounded_manifold<scalar_of<A>>(*found);
    return {};
  }
}

/// The same with options: with a margin, also for shapes that are up to that far apart. See the top of this file.
/// Without a margin, the result is the same to the last bit.
template <Shape A, SameSpace<A> B>
Manifold<dimension_of<A>, scalar_of<A>> manifold(const A& a, const B& b, ContactOptions options) {
  assert(detail::is_valid_if_known(a) && detail::is_valid_if_known(b) && options.margin >= 0);
  if (!(options.margin > 0)) return manifold(a, b);
  const auto found = detail::wide_manifold(a, b, options.margin);
  return found ? detail::rounded_manifold<scalar_of<A>>(*found) : Manifold<dimension_of<A>, scalar_of<A>>{};
}

GRAZE_DECLARE_INSTANCES(GRAZE_MANIFOLD_INSTANCES)

}  // namespace graze
