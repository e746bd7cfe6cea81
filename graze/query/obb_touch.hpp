// SPDX-License-Identifier: MIT
// The points at which two oriented boxes in space touch, of most pairs: pairs_of_boxes in penetration_boxes.hpp with
// what is known of boxes that are not flat, whose faces lie neither nearly along the same planes nor at equal angles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/obb_axes.hpp>
#include <graze/query/obb_faces.hpp>
#include <graze/query/patch.hpp>
#include <graze/query/penetration.hpp>
#include <graze/query/penetration_boxes.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/obb.hpp>

namespace graze::detail {

/// Two oriented boxes in space, for which there is a quick way.
template <class A, class B>
inline constexpr bool are_quick_obbs = false;

#ifdef GRAZE_HAS_LANES

template <class T>
inline constexpr bool are_quick_obbs<Obb<3, T>, Obb<3, T>> = true;

/// Cosines of angles between a direction and a box' axes are those with its normals up to this.
inline constexpr double doubt_of_cosines = 16 * tolerance::orthonormal;

/// The face of a box that looks most along a direction, as side_along chooses it. Without branches but for doubt.
inline BoxFaceNumbers looking_face(const Mat<3, double>& axes, const Vec<3, double>& direction) {
  const std::array<double, 3> along{dot(axes[0], direction), dot(axes[1], direction), dot(axes[2], direction)};
  const std::array<double, 3> size{std::fabs(along[0]), std::fabs(along[1]), std::fabs(along[2])};
  const double larger = std::max(size[0], size[1]);
  const double second = std::max(std::min(size[0], size[1]), std::min(larger, size[2]));
  if (!(std::max(larger, size[2]) - second > doubt_of_cosines)) {
    const BoxSide<3> side = side_along<3>(face_normals(axes), direction);
    return {side.axis, side.is_far};
  }
  const auto is_second = static_cast<unsigned>(size[1] > size[0]);
  const auto is_third = static_cast<unsigned>(size[2] > larger);
  const unsigned best = is_third << 1U | (is_second & ~is_third);
  return {static_cast<Dim>(best), along[best] > 0};
}

/// Whether a face may look straight along a direction.
inline bool may_be_aligned(const Mat<3, double>& axes, const Vec<3, double>& direction) {
  const double most = std::max(std::max(std::fabs(dot(axes[0], direction)), std::fabs(dot(axes[1], direction))),
                               std::fabs(dot(axes[2], direction)));
  return most > 1 - doubt_of_cosines;
}

/// Two oriented boxes in space that meet, seen from the first one's center, and the axis that parts them.
struct MeetingObbs {
  BoxSides<3> a;
  BoxSides<3> b;
  BoxesContact<3> contact;

  template <class T>
  MeetingObbs(const Obb<3, T>& first, const Obb<3, T>& second, BoxesAxes candidates)
      : a{{Vec<3, double>(0.0), half_edges(first)}, wide_matrix<3, T>(first.axes)},
        b{{reference(second) - reference(first), half_edges(second)}, wide_matrix<3, T>(second.axes)},
        contact(contact_of_sides(a, b, candidates)) {}
};

/// A face that the points of a contact are laid on, with its own normal.
struct CarryingFace {
  bool is_of_b;
  BoxFaceNumbers numbers;
  Vec<3, double> normal;
};

/// The face of a box that looks straight along a direction, if any does.
inline std::optional<CarryingFace> face_along(const BoxSides<3>& box, const Vec<3, double>& direction, bool is_of_b) {
  if (!may_be_aligned(box.directions, direction)) return std::nullopt;
  const BoxFaceNumbers face = looking_face(box.directions, direction);
  const Vec<3, double> side = box.normal(face.axis);
  const Vec<3, double> normal = dot(side, direction) < 0 ? -side : side;
  if (!is_aligned(normal, direction)) return std::nullopt;
  return CarryingFace{is_of_b, face, normal};
}

/// The face that the axis is the normal of.
inline CarryingFace face_of_axis(const MeetingObbs& met) {
  const bool is_of_b = met.contact.axis.is_of_b;
  const Vec<3, double> up = is_of_b ? -met.contact.found.normal : met.contact.found.normal;
  const Dim axis = met.contact.axis.face;
  const Vec<3, double>& direction = (is_of_b ? met.b : met.a).directions[axis];
  return {is_of_b, {axis, dot(direction, up) > 0}, up};
}

/// The face that carries the points of a manifold: face_pairs in manifold_points.hpp.
inline std::optional<CarryingFace> carrying_face(const MeetingObbs& met) {
  const Vec<3, double>& normal = met.contact.found.normal;
  if (!met.contact.axis.edges && !met.contact.axis.is_of_b) return face_of_axis(met);
  if (const auto face = face_along(met.a, normal, false)) return face;
  return met.contact.axis.edges ? face_along(met.b, -normal, true) : face_of_axis(met);
}

/// The other box' face on a carrying face.
inline FaceOverFace face_over(const MeetingObbs& met, const CarryingFace& face) {
  const BoxSides<3>& box = face.is_of_b ? met.b : met.a;
  const BoxSides<3>& other = face.is_of_b ? met.a : met.b;
  const Vec<3, double> up = face.is_of_b ? -met.contact.found.normal : met.contact.found.normal;
  return {face_of_box(other.frame, looking_face(other.directions, -up)), face_of_box(box.frame, face.numbers), up,
          face.normal, tolerance::coarse * met.contact.size};
}

/// The edge along `axis` that is farthest along a direction, by its number and its middle.
struct NumberedEdge {
  std::uint32_t number;
  Vec<3, double> middle;
  Vec<3, double> half;
};

inline NumberedEdge farthest_numbered(const BoxFrame<3>& box, Dim axis, const Vec<3, double>& direction) {
  NumberedEdge edge{static_cast<std::uint32_t>(4 * axis), box.center, box.half_edges[axis]};
  for (const Dim turn : {1, 2}) {
    const Vec<3, double>& half = box.half_edges[(axis + turn) % 3];
    const double side = sign_of(dot(half, direction));
    edge.middle += half * side;
    edge.number += side > 0 ? static_cast<std::uint32_t>(turn) : 0;
  }
  return edge;
}

/// Where two edges cross, if neither is near its end: with u and v halves of the edges and w from middle to middle, n =
/// u x v, at s n^2 = (w x v) . n and t n^2 = (w x u) . n.
inline std::optional<SurfacePair<3>> quick_pair_on_edges(const MeetingObbs& met) {
  const Vec<3, double>& normal = met.contact.found.normal;
  constexpr double least_sine = 1.0 / 8;
  constexpr double farthest = 1 - 0x1p-20;
  constexpr double least_share = 1e-6;  // of the size: of an edge that is not taken for a point
  const auto [i, j] = *met.contact.axis.edges;
  const NumberedEdge edge_a = farthest_numbered(met.a.frame, i, normal);
  const NumberedEdge edge_b = farthest_numbered(met.b.frame, j, -normal);
  const double shortest = std::min({max_abs(met.a.frame.half_edges[0]), max_abs(met.a.frame.half_edges[1]),
                                    max_abs(met.a.frame.half_edges[2]), max_abs(met.b.frame.half_edges[0]),
                                    max_abs(met.b.frame.half_edges[1]), max_abs(met.b.frame.half_edges[2])});
  if (!(shortest > least_share * met.contact.size)) return std::nullopt;
  const Vec<3, double> across = cross(edge_a.half, edge_b.half);
  const double squared = dot(across, across);
  if (!(squared > least_sine * least_sine * dot(edge_a.half, edge_a.half) * dot(edge_b.half, edge_b.half))) {
    return std::nullopt;
  }
  const Vec<3, double> between = edge_b.middle - edge_a.middle;
  const double on_a = dot(cross(between, edge_b.half), across) / squared;
  const double on_b = dot(cross(between, edge_a.half), across) / squared;
  if (!(std::max(std::fabs(on_a), std::fabs(on_b)) < farthest)) return std::nullopt;
  return SurfacePair<3>{edge_a.middle + edge_a.half * on_a,
                        edge_b.middle + edge_b.half * on_b,
                        met.contact.found.depth,
                        {FeatureKind::edge, edge_a.number},
                        {FeatureKind::edge, edge_b.number}};
}

/// Whether two boxes are apart, at whose axes one has looked.
template <class T>
bool are_apart(const Obb<3, T>& a, const Obb<3, T>& b, const ObbAxes& axes) {
  return (axes.verdict ? *axes.verdict : decide(a, b)) == Relation::apart;
}

/// The deepest of the points over the face that the axis is the normal of, the first of several; or that on two edges.
/// None of pairs that touching_pair has to look at.
inline std::optional<SurfacePair<3>> quick_pair(const MeetingObbs& met) {
  if (met.contact.axis.edges) return quick_pair_on_edges(met);
  const CarryingFace face = face_of_axis(met);
  FaceOverFace over = face_over(met, face);
  if (!over.run() || over.size() == 0) return std::nullopt;
  std::size_t deepest = 0;
  for (std::size_t i = 1; i < over.size(); ++i) {
    if (over.depth(i) > over.depth(deepest)) deepest = i;
  }
  return face.is_of_b ? exchanged(over.pair(deepest)) : over.pair(deepest);
}

/// The penetration of two that meet, in the order of their numbers.
template <class T>
std::optional<Penetration<3>> penetration_of_obbs(const Obb<3, T>& a, const Obb<3, T>& b) {
  const ObbAxes axes = axes_of(a, b);
  if (are_apart(a, b, axes)) return std::nullopt;
  const MeetingObbs met(a, b, axes.candidates);
  const Vec<3, double> origin = reference(a);
  auto pair = quick_pair(met);
  if (!pair) {
    const auto seen_a = seen_from(origin, a);
    const auto seen_b = seen_from(origin, b);
    pair = touching_pair(seen_a, seen_b, facing_boxes(seen_a, seen_b, met.contact), met.contact);
  }
  Penetration<3> result = met.contact.found;
  result.point_a = pair->point_a + origin;
  result.point_b = pair->point_b + origin;
  return result;
}

#endif

}  // namespace graze::detail
