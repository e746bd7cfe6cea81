// SPDX-License-Identifier: MIT
// manifold(a, b): the few contact points that hold two shapes apart as all their common patch would: what a solver
// needs so that a box stands on a floor and does not topple.
//
// The normal and the depth are those of contact(a, b), and so is who decides whether there is a contact. If a face of
// one shape looks along the normal (a's, if both do, but a plane's before all), the face of the other that looks most
// against it is laid over it and cut at its sides and at its surface; every corner of what is left is a contact of its
// own depth along the normal. Two parallel edges (of capsules and segments, in space) give the ends of what they share;
// all else gives the point of `contact` alone. So a ball has one point; a capsule two where it lies; boxes, triangles
// and polytopes up to four, of more those that span the patch: the deepest, the farthest from it, and on either side of
// the line between them the one that makes the largest triangle. Rays and users' shapes, which have no faces to speak
// of, and pairs that no translation parts have the point of `contact`.
//
// Each point has an id: which corner, edge or face of a, and which of b, it lies on. It stays the same from frame to
// frame as long as the shapes keep lying on each other the same way, so that a solver can go on with the impulses of
// the last frame. Where points are as good as each other up to 1e-5 of the patch, always the same ones are taken. Faces
// are taken to look along the normal, and edges to be parallel, up to 1e-5 radians.
//
// A compound is its deepest part, which the ids name. Swapping the arguments exchanges everything, up to the order of
// shapes that equal each other. Coordinates as in contact.hpp; points are off by no more than those of `contact`, and
// the depths by `error`; but of faces that are not exactly at right angles to the normal by 1e-5 of their size more.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/clipped_patch.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/manifold_points.hpp>
#include <graze/query/obb_choice.hpp>
#include <graze/query/obb_touch.hpp>
#include <graze/query/patch.hpp>
#include <graze/query/patch_polytope.hpp>
#include <graze/query/status.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/shape.hpp>
#include <graze/shape/visit.hpp>

namespace graze {

/// Which features of two shapes a contact point lies on.
struct ContactId {
  Feature a{};
  Feature b{};
  std::uint32_t part_a = 0;  ///< The place of the part in a compound; 0 without parts.
  std::uint32_t part_b = 0;

  friend bool operator==(const ContactId&, const ContactId&) = default;
};

/// One point of a manifold; as in Contact, but of this point.
template <Dim N, class T = float>
struct ManifoldPoint {
  Vec<N, T> point = Vec<N, T>(T(0));    ///< In the middle between the two below.
  Vec<N, T> point_a = Vec<N, T>(T(0));  ///< Of a's surface.
  Vec<N, T> point_b = Vec<N, T>(T(0));  ///< Of b's surface: point_a - normal * depth.
  T depth = T(0);
  ContactId id;

  friend bool operator==(const ManifoldPoint&, const ManifoldPoint&) = default;
};

/// The contacts of two shapes; none if they are apart.
template <Dim N, class T = float>
struct Manifold {
  static constexpr std::size_t most_points = N == 2 ? 2 : 4;

  std::array<ManifoldPoint<N, T>, most_points> points;
  std::size_t size = 0;  ///< How many of them there are.
  Vec<N, T> normal =
      Vec<N, T>(T(0));  ///< Of length 1, from a to b; zero if nothing parts the shapes, or they are apart.
  Status status = Status::converged;  ///< As in Contact.
  double error = 0;                   ///< As in Contact.

  std::span<const ManifoldPoint<N, T>> contacts() const { return {points.data(), size}; }

  friend bool operator==(const Manifold&, const Manifold&) = default;
};

namespace detail {

/// A manifold in double.
template <Dim N>
struct WideManifold {
  Penetration<N> found;
  std::array<SurfacePair<N>, Manifold<N>::most_points> pairs;
  std::size_t size = 0;
  std::uint32_t part_a = 0;
  std::uint32_t part_b = 0;
};

/// Makes it that of (b, a).
template <Dim N>
void exchange(WideManifold<N>& manifold) {
  manifold.found = exchanged(manifold.found);
  for (std::size_t i = 0; i < manifold.size; ++i) {
    SurfacePair<N>& pair = manifold.pairs[i];
    std::swap(pair.point_a, pair.point_b);
    std::swap(pair.feature_a, pair.feature_b);
  }
  std::swap(manifold.part_a, manifold.part_b);
}

// ---- The patch of a shape's core, seen from an origin.

template <class S>
inline constexpr bool is_polytope = false;
template <Dim N, class T>
inline constexpr bool is_polytope<Polytope<N, T>> = true;

/// The plane itself, without bounds. It is a contact's, so it looks along the normal or against it.
template <Dim N, class T>
Patch<N> unbounded_patch(const Plane<N, T>& plane, const Vec<N, double>& origin, const Vec<N, double>& direction) {
  Patch<N> patch;
  patch.corners[0] = surface_point(plane, origin).point - origin;
  patch.normal = unit_or(wide<N, T>(plane.normal), direction);
  if (dot(patch.normal, direction) < 0) patch.normal = -patch.normal;
  return patch;
}

/// Of rays and users' shapes, which have no faces to speak of, the `point` of the contact.
template <class S>
Patch<dimension_of<S>> patch_seen(const S& shape, const Vec<dimension_of<S>, double>& origin,
                                  const Vec<dimension_of<S>, double>& direction,
                                  const Vec<dimension_of<S>, double>& point) {
  if constexpr (is_level<S>) {
    return unbounded_patch(boundary_of(shape), origin, direction);
  } else if constexpr (is_polytope<S>) {
    return patch_of_polytope(shape, origin, direction);
  } else if constexpr (HasSimpleCore<S> && !is_ray<S>) {
    return patch_of(seen_from(origin, core(shape)), direction);
  } else {
    return patch_of(point - origin, direction);
  }
}

template <class S>
double radius_of_core(const S& shape) {
  if constexpr (!is_level<S>) return core_radius(shape);
  return 0;
}

template <Dim N>
double size_of_patch(const Patch<N>& patch) {
  double size = 0;
  for (std::size_t i = 0; i < patch.size; ++i) size = std::max(size, sum_abs(patch.corners[i]));
  return size;
}

template <Dim N>
void choose_points(const SurfacePairs<N>& from, WideManifold<N>& manifold) {
  manifold.size = std::min(from.size(), manifold.pairs.size());
  for (std::size_t i = 0; i < manifold.size; ++i) manifold.pairs[i] = from[i];
  if constexpr (N == 3) {
    if (from.size() <= manifold.pairs.size()) return;
    auto places = SpanningChoice(from, manifold.found.normal).run();
    std::sort(places.begin(), places.end());
    manifold.size = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (i == 0 || places[i] != places[i - 1]) manifold.pairs[manifold.size++] = from[places[i]];
    }
  }
}

template <Dim N>
void move_points(WideManifold<N>& manifold, const Vec<N, double>& origin) {
  for (std::size_t i = 0; i < manifold.size; ++i) {
    manifold.pairs[i].point_a += origin;
    manifold.pairs[i].point_b += origin;
  }
}

template <class A, class B>
WideManifold<dimension_of<A>> manifold_of_found(const A& a, const B& b, const Penetration<dimension_of<A>>& found) {
  constexpr Dim N = dimension_of<A>;
  WideManifold<N> result;
  result.found = found;
  result.size = 1;
  result.pairs[0] = {found.point_a, found.point_b, found.depth, {}, {}};
  if (std::isinf(found.depth) || (is_level<A> && is_level<B>)) return result;
  const Vec<N, double> origin = found.point_a;
  const Patch<N> patch_a = patch_seen(a, origin, found.normal, found.point_a);
  const Patch<N> patch_b = patch_seen(b, origin, -found.normal, found.point_b);
  const FacingPatches<N> facing{patch_a, patch_b, radius_of_core(a), radius_of_core(b)};
  const double size =
      (size_of_patch(facing.a) + size_of_patch(facing.b)) + (facing.radius_a + facing.radius_b) + found.depth;
  const Penetration<N> seen = moved_by(found, -origin);
  choose_points(surface_pairs(facing, seen, found.error + tolerance::coarse * size), result);
  move_points(result, origin);
  return result;
}

template <class A, class B>
std::optional<WideManifold<dimension_of<A>>> wide_manifold(const A& a, const B& b);

template <Dim N>
std::optional<WideManifold<N>> exchanged(std::optional<WideManifold<N>> manifold) {
  if (manifold) exchange(*manifold);
  return manifold;
}

/// That of the deepest part, the first of several, as `contact` has it. Parts of parts are numbered on.
template <Dim N, class T, class S>
std::optional<WideManifold<N>> manifold_of_parts(const Compound<N, T>& compound, const S& shape) {
  const Aabb<N, T> box = touching_bounds(bounds(shape));
  std::optional<double> depth;
  std::size_t deepest = 0;
  for (std::size_t i = 0; i < compound.parts.size(); ++i) {
    if (!boxes_overlap(touching_bounds(compound.parts[i].box), box)) continue;
    const std::optional<Penetration<N>> candidate = penetration(compound.parts[i].shape, shape);
    if (!candidate || (depth && candidate->depth <= *depth)) continue;
    depth = candidate->depth;
    deepest = i;
  }
  if (!depth) return std::nullopt;
  std::optional<WideManifold<N>> result = wide_manifold(compound.parts[deepest].shape, shape);
  if (result) result->part_a = static_cast<std::uint32_t>(result->part_a * compound.parts.size() + deepest);
  return result;
}

/// Of two simple shapes in the order in which their contact is calculated. That of boxes has their faces at hand.
template <class A, class B>
WideManifold<dimension_of<A>> manifold_in_order(const A& a, const B& b) {
  if constexpr (are_boxes<A, B>) {
    constexpr Dim N = dimension_of<A>;
    const Vec<N, double> origin = reference(a);
    const auto seen_a = seen_from(origin, a);
    const auto seen_b = seen_from(origin, b);
    const BoxesContact<N> contact = contact_of_boxes(seen_a, seen_b);
    WideManifold<N> result;
    result.found = contact.found;
    choose_points(pairs_of_boxes(seen_a, seen_b, contact), result);
    move_points(result, origin);
    return result;
  } else {
    return manifold_of_found(a, b, penetration_in_order(a, b));
  }
}

/// Of two simple shapes that meet.
template <class A, class B>
WideManifold<dimension_of<A>> manifold_of_met(const A& a, const B& b) {
  if constexpr (type_place<A> < type_place<B>) {
    return manifold_in_order(a, b);
  } else if constexpr (type_place<A> > type_place<B>) {
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

#ifdef GRAZE_HAS_LANES
template <class T>
std::optional<WideManifold<3>> manifold_of_obbs(const Obb<3, T>& a, const Obb<3, T>& b);
#endif

template <class A, class B>
std::optional<WideManifold<dimension_of<A>>> wide_manifold(const A& a, const B& b) {
  if constexpr (is_any_shape<A>) {
    return detail::visit([&b](const auto& held) { return wide_manifold(held, b); }, a);
  } else if constexpr (is_any_shape<B>) {
    return detail::visit([&a](const auto& held) { return wide_manifold(a, held); }, b);
  } else if constexpr (is_compound<A> && is_compound<B>) {
    return is_in_order(a, b) ? manifold_of_parts(a, b) : exchanged(manifold_of_parts(b, a));
  } else if constexpr (is_compound<A>) {
    return manifold_of_parts(a, b);
  } else if constexpr (is_compound<B>) {
    return exchanged(manifold_of_parts(b, a));
  } else if constexpr (are_quick_obbs<A, B>) {
    return manifold_of_obbs(a, b);
  } else {
    if (decide(a, b) == Relation::apart) return std::nullopt;
    return manifold_of_met(a, b);
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

/// Every point is made where it stays: to clear them all first takes as long as a quick contact.
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

/// The manifold of two oriented boxes in space: points are rounded as they are found, so that none is copied.
template <class R>
class ObbManifold {
 public:
  /// `result` stays as it is, empty, if the two are apart.
  [[gnu::always_inline]] explicit ObbManifold(Manifold<3, R>& result) : result_(result) {}

  double depth = 0;

  template <class T>
  [[gnu::always_inline]] void find(const Obb<3, T>& a, const Obb<3, T>& b) {
    is_exchanged_ = !is_in_order(a, b);
    find_in_order(is_exchanged_ ? b : a, is_exchanged_ ? a : b);
  }

 private:
  template <class T>
  [[gnu::always_inline]] void find_in_order(const Obb<3, T>& a, const Obb<3, T>& b) {
    const ObbAxes axes = axes_of(a, b);
    if (are_apart(a, b, axes)) return;
    const MeetingObbs met(a, b, axes.candidates);
    depth = met.depth();
    origin_ = PairedVec(reference(a));
    const CarryingFace face = carrying_face(met);
    if (face.is_any) {
      FaceOverFace over = face_over(met, face);
      if (over.run()) take_corners(over, met.normal, face.is_of_b);
    } else {
      const CrossingEdges edges = quick_pair_on_edges(met);
      if (edges.is_known) take(edges.points, is_exchanged_);
    }
    if (result_.size == 0) {
      find_carefully(a, b, met.contact());
      return;
    }
    round(met.normal * (is_exchanged_ ? -1.0 : 1.0), result_.normal);
    result_.error = met.error();
  }

  /// Four of more than four.
  [[gnu::always_inline]] void take_corners(const FaceOverFace& over, const PairedVec& normal, bool is_of_b) {
    unsigned chosen = (1U << over.size()) - 1;
    if (over.size() > result_.points.size()) chosen = LaneChoice(over, normal, is_of_b).run();
    for (; chosen != 0; chosen &= chosen - 1) {
      take(over.pair(static_cast<std::size_t>(std::countr_zero(chosen))), is_exchanged_ != is_of_b);
    }
  }

  /// Without a branch on whose points they are, which would be guessed wrong every other time.
  [[gnu::always_inline]] void take(const PairedPoints& pair, bool turns) {
    ManifoldPoint<3, R>& point = result_.points[result_.size++];
    const PairedVec a = pair.point_a + origin_;
    const PairedVec b = pair.point_b + origin_;
    round(a * 0.5 + b * 0.5, point.point);
    const std::array<Vec<3, R>*, 2> points{&point.point_a, &point.point_b};
    round(a, *points[turns ? 1 : 0]);
    round(b, *points[turns ? 0 : 1]);
    const std::array<Feature*, 2> features{&point.id.a, &point.id.b};
    *features[turns ? 1 : 0] = pair.feature_a;
    *features[turns ? 0 : 1] = pair.feature_b;
    point.depth = static_cast<R>(pair.depth);
  }

  [[gnu::always_inline]] static void round(const PairedVec& v, Vec<3, R>& to) {
    to = Vec<3, R>(plain(v)) + R(0);  // never minus zero
  }

  template <class T>
  [[gnu::noinline]] void find_carefully(const Obb<3, T>& a, const Obb<3, T>& b, const BoxesContact<3>& contact) {
    const Vec<3, double> origin = reference(a);
    WideManifold<3> wide;
    wide.found = contact.found;
    choose_points(pairs_of_boxes(seen_from(origin, a), seen_from(origin, b), contact), wide);
    move_points(wide, origin);
    if (is_exchanged_) exchange(wide);
    result_ = rounded_manifold<R>(wide);
  }

  Manifold<3, R>& result_;
  PairedVec origin_{LanePair{0, 0}, 0};
  bool is_exchanged_ = false;
};

template <class T>
Manifold<3, T> rounded_manifold_of_obbs(const Obb<3, T>& a, const Obb<3, T>& b) {
  Manifold<3, T> result;
  ObbManifold<T>(result).find(a, b);
  return result;
}

template <class T>
std::optional<WideManifold<3>> manifold_of_obbs(const Obb<3, T>& a, const Obb<3, T>& b) {
  Manifold<3, double> manifold;
  ObbManifold<double> finding(manifold);
  finding.find(a, b);
  if (manifold.size == 0) return std::nullopt;
  WideManifold<3> wide;
  wide.found.normal = manifold.normal;
  wide.found.depth = finding.depth;
  wide.found.error = manifold.error;
  for (const ManifoldPoint<3, double>& point : manifold.contacts()) {
    wide.pairs[wide.size++] = {point.point_a, point.point_b, point.depth, point.id.a, point.id.b};
  }
  return wide;
}

#endif

}  // namespace detail

/// The contact points of two valid shapes (asserted) of the same dimension and number type, as described above; none if
/// they are apart. Cheaper where one point is enough: `contact`.
template <Shape A, SameSpace<A> B>
Manifold<dimension_of<A>, scalar_of<A>> manifold(const A& a, const B& b) {
  assert(detail::is_valid_if_known(a) && detail::is_valid_if_known(b));
  if constexpr (detail::are_quick_obbs<A, B>) {
    return detail::rounded_manifold_of_obbs(a, b);
  } else if constexpr (detail::are_simple<A, B>) {
    if (detail::decide(a, b) == Relation::apart) return {};
    return detail::rounded_manifold<scalar_of<A>>(detail::manifold_of_met(a, b));
  } else {
    const auto found = detail::wide_manifold(a, b);
    if (!found) return {};
    return detail::rounded_manifold<scalar_of<A>>(*found);
  }
}

}  // namespace graze
