// SPDX-License-Identifier: MIT
// Contact points of two 3D boxes, at least one of them oriented, for most pairs: pairs_of_boxes in contact/boxes.hpp,
// simplified for boxes that are not flat and whose faces are neither nearly coplanar nor at equal angles.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact/boxes.hpp>
#include <graze/query/cores/penetration.hpp>
#include <graze/query/fast_contact/obb/axes.hpp>
#include <graze/query/fast_contact/obb/boxes_in_frame.hpp>
#include <graze/query/fast_contact/obb/faces.hpp>
#include <graze/query/patch/patch.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>

namespace graze::detail {

/// Two 3D boxes, at least one of them oriented, for which there is a fast contact.
template <class A, class B>
inline constexpr bool are_quick_obbs = false;

#ifdef GRAZE_HAS_LANES

template <class T>
inline constexpr bool are_quick_obbs<Obb<3, T>, Obb<3, T>> = true;
template <class T>
inline constexpr bool are_quick_obbs<Aabb<3, T>, Obb<3, T>> = true;
template <class T>
inline constexpr bool are_quick_obbs<Obb<3, T>, Aabb<3, T>> = true;

/// Cosines of angles between a direction and a box's axes equal those with its normals up to this.
inline constexpr double doubt_of_cosines = 16 * tolerance::orthonormal;

inline Mat<3, double> axes_matrix(const PairedBox& box) {
  return {plain(box.axes[0]), plain(box.axes[1]), plain(box.axes[2])};
}

inline BoxSides<3> sides_of(const PairedBox& box) {
  return {{plain(box.center), {plain(box.half_edges[0]), plain(box.half_edges[1]), plain(box.half_edges[2])}},
          axes_matrix(box)};
}

/// The face of a box that faces most along a direction, if two of them do so almost equally.
[[gnu::noinline]] inline BoxFaceNumbers facing_side(const PairedBox& box, const PairedVec& direction) {
  const BoxSide<3> side = side_along<3>(face_normals(axes_matrix(box)), plain(direction));
  return {side.axis, side.is_far};
}

/// The face of a box that faces most along a direction, as side_along selects it. Branch-free unless it is uncertain.
[[gnu::always_inline]] inline BoxFaceNumbers facing_face(const PairedBox& box, const PairedVec& direction) {
  const double x = dot(box.axes[0], direction);
  const double y = dot(box.axes[1], direction);
  const double z = dot(box.axes[2], direction);
  const double larger = std::max(std::fabs(x), std::fabs(y));
  const double second = std::max(std::min(std::fabs(x), std::fabs(y)), std::min(larger, std::fabs(z)));
  if (!(std::max(larger, std::fabs(z)) - second > doubt_of_cosines)) return facing_side(box, direction);
  const auto is_second = static_cast<unsigned>(std::fabs(y) > std::fabs(x));
  const auto is_third = static_cast<unsigned>(std::fabs(z) > larger);
  const unsigned best = is_third << 1U | (is_second & ~is_third);
  const unsigned far =
      static_cast<unsigned>(x > 0) | static_cast<unsigned>(y > 0) << 1U | static_cast<unsigned>(z > 0) << 2U;
  return {static_cast<Dim>(best), (far >> best & 1U) != 0};
}

/// Whether a face may be perpendicular to a direction.
[[gnu::always_inline]] inline bool may_be_aligned(const PairedBox& box, const PairedVec& direction) {
  const double most = std::max(std::max(std::fabs(dot(box.axes[0], direction)), std::fabs(dot(box.axes[1], direction))),
                               std::fabs(dot(box.axes[2], direction)));
  return most > 1 - doubt_of_cosines;
}

/// The axis perpendicular to an edge of each of two boxes, and values that also determine where they cross.
struct AxisAcrossEdges {
  PairedVec across;     ///< The first box's edge x the second's.
  double squared;       ///< Its squared length.
  double ahead;         ///< The second center's coordinate along it.
  LanePair heights[2];  ///< For each box, those of the half edges along the next axis and the one after it.
};

/// The least squared sine of an angle between two edges whose cross product needs no special care, as in
/// cross_of_directions, for edges of any length close to 1.
inline constexpr double least_squared_sine = 1.001 / 64;

/// Two 3D boxes that meet, as ObbsInFrame or ObbAndAabbInFrame represents them, and the axis of least depth: across a
/// face of one of them, or across an edge of each.
struct MeetingObbs {
  PairedBox box[2];
  double size;  ///< Of both.
  PairedVec normal;
  double gap;
  bool is_on_edges;
  bool is_of_b;  ///< The face.
  Dim axis;      ///< Across which the face lies, or along which a's edge lies.
  Dim edge_b;
  AxisAcrossEdges edges;  ///< Meaningless across a face.

  template <class Seen>
  [[gnu::always_inline]] MeetingObbs(const Seen& seen, BoxesAxes candidates)
      : box{paired_box(seen.first(), seen.first_center()), paired_box(seen.second(), seen.second_center())},
        size(size_of(box[0]) + size_of(box[1])),
        normal(box[1].center),
        edges{box[1].center, 0, 0, {}} {
    const auto place = static_cast<Dim>(std::countr_zero(candidates));
    if ((candidates & (candidates - 1)) != 0) {
      search(candidates);
    } else if (place < 6) {
      const bool of_b = place >= 3;
      const Dim i = of_b ? place - 3 : place;
      take_face(of_b, i, face_axis(of_b, i));
    } else {
      const Dim i = (place - 6) / 3;
      const Dim j = (place - 6) % 3;
      const PairedVec across = cross(box[0].axes[i], box[1].axes[j]);
      const double squared = dot(across, across);
      if (squared > least_squared_sine) [[likely]]
        take_edges(i, j, edges_axis(i, j, across, squared));
      else
        search(candidates);
    }
  }

  double depth() const { return std::max(0.0, -gap); }
  double error() const { return std::max(0.0, gap) + boxes_error * size; }

  /// The same as in contact/boxes.hpp.
  BoxesContact<3> contact() const {
    BoxesContact<3> result{{{plain(normal), gap}, is_of_b, axis, std::nullopt}, size, {}};
    if (is_on_edges) result.axis.edges = {axis, edge_b};
    result.found.normal = plain(normal);
    result.found.depth = depth();
    result.found.error = error();
    return result;
  }

 private:
  [[gnu::always_inline]] static double size_of(const PairedBox& seen) {
    return sum_of_coordinates(magnitude(seen.center) + magnitude(seen.half_edges[0]) + magnitude(seen.half_edges[1]) +
                              magnitude(seen.half_edges[2]));
  }

  // Bit-identical to the calculations of BoxesSearch.

  struct FaceAxis {
    PairedVec normal;
    double gap;
  };

  [[gnu::always_inline]] FaceAxis face_axis(bool of_b, Dim i) const {
    const PairedBox& own = box[of_b ? 1 : 0];
    const PairedBox& other = box[of_b ? 0 : 1];
    const PairedVec adjoint = cross(own.axes[(i + 1) % 3], own.axes[(i + 2) % 3]);
    const PairedVec across = adjoint * (1 / std::sqrt(dot(adjoint, adjoint)));  // about 1
    const double reach = std::fabs(dot(across, own.half_edges[i])) + std::fabs(dot(across, other.half_edges[0])) +
                         std::fabs(dot(across, other.half_edges[1])) + std::fabs(dot(across, other.half_edges[2]));
    const double ahead = dot(across, box[1].center - box[0].center);
    return {across * sign_of(ahead), std::fabs(ahead) - reach};
  }

  [[gnu::always_inline]] void take_face(bool of_b, Dim i, const FaceAxis& found) {
    normal = found.normal;
    gap = found.gap;
    is_on_edges = false;
    is_of_b = of_b;
    axis = i;
    edge_b = 0;
  }

  /// The axis itself, if `across` is precise.
  [[gnu::always_inline]] AxisAcrossEdges edges_axis(Dim i, Dim j, const PairedVec& across, double squared) const {
    const auto heights = [&across](const PairedBox& seen, Dim along) {
      return LanePair{dot(across, seen.half_edges[(along + 1) % 3]), dot(across, seen.half_edges[(along + 2) % 3])};
    };
    return {across, squared, dot(across, box[1].center - box[0].center), {heights(box[0], i), heights(box[1], j)}};
  }

  /// Multiplied by its length.
  [[gnu::always_inline]] static double gap_across(const AxisAcrossEdges& found) {
    const LanePair reach_a = magnitude(found.heights[0]);
    const LanePair reach_b = magnitude(found.heights[1]);
    return std::fabs(found.ahead) - ((reach_a[0] + reach_a[1]) + (reach_b[0] + reach_b[1]));
  }

  [[gnu::always_inline]] void take_edges(Dim i, Dim j, const AxisAcrossEdges& found) {
    const double inverse = 1 / std::sqrt(found.squared);
    normal = found.across * (sign_of(found.ahead) * inverse);
    gap = gap_across(found) * inverse;
    is_on_edges = true;
    is_of_b = false;
    axis = i;
    edge_b = j;
    edges = found;
  }

  /// Of several axes, or of one that needs care.
  [[gnu::noinline]] void search(BoxesAxes candidates) {
    const double margin = tolerance::rounding * size;
    candidates = distinct_axes(candidates, repeated_axes(box[0].axes, box[1].axes));
    take_face(false, 0, {PairedVec(LanePair{1, 0}, 0), -std::numeric_limits<double>::infinity()});
    for (; candidates != 0; candidates &= candidates - 1) {
      const auto place = static_cast<Dim>(std::countr_zero(candidates));
      if (place < 6) {
        const bool of_b = place >= 3;
        const FaceAxis found = face_axis(of_b, place % 3);
        if (found.gap > gap + margin) take_face(of_b, place % 3, found);
      } else {
        try_edges((place - 6) / 3, (place - 6) % 3, margin);
      }
    }
  }

  [[gnu::always_inline]] void try_edges(Dim i, Dim j, double margin) {
    PairedVec across = cross(box[0].axes[i], box[1].axes[j]);
    double squared = dot(across, across);
    if (!(squared > least_squared_sine)) {
      const Vec<3, double> along_a = plain(box[0].axes[i]);
      const Vec<3, double> along_b = plain(box[1].axes[j]);
      if (along_a == along_b) return;  // frequent for boxes lying on boxes
      across = PairedVec(cross_of_directions(along_a, along_b));
      squared = dot(across, across);
      if (!(squared > 0)) return;
    }
    const AxisAcrossEdges found = edges_axis(i, j, across, squared);
    const double found_gap = gap_across(found);
    const double least = gap + margin;
    const double squares = least * least * squared;
    const bool is_better =
        found_gap >= 0 ? least < 0 || found_gap * found_gap > squares : least < 0 && found_gap * found_gap < squares;
    if (is_better) take_edges(i, j, found);
  }
};

/// A face that the points of a contact are projected onto, with its own normal; or none.
struct ReferenceFace {
  bool is_any;
  bool is_of_b;
  BoxFaceNumbers numbers;
  PairedVec normal;
};

/// The face of a box that is perpendicular to a direction, if any.
[[gnu::noinline]] inline ReferenceFace aligned_face(const PairedBox& box, const PairedVec& direction, bool is_of_b) {
  const BoxFaceNumbers face = facing_face(box, direction);
  const Vec<3, double> side = sides_of(box).normal(face.axis);
  const Vec<3, double> normal = dot(side, plain(direction)) < 0 ? -side : side;
  return {is_aligned(normal, plain(direction)), is_of_b, face, PairedVec(normal)};
}

[[gnu::always_inline]] inline ReferenceFace face_along(const PairedBox& box, const PairedVec& direction, bool is_of_b) {
  if (may_be_aligned(box, direction)) [[unlikely]]
    return aligned_face(box, direction, is_of_b);
  return {false, is_of_b, {}, direction};
}

/// The face whose normal is the axis.
[[gnu::always_inline]] inline ReferenceFace face_of_axis(const MeetingObbs& met) {
  const PairedVec up = met.normal * (met.is_of_b ? -1.0 : 1.0);
  return {true, met.is_of_b, {met.axis, dot(met.box[met.is_of_b ? 1 : 0].axes[met.axis], up) > 0}, up};
}

/// Whether the axis across two edges may be the normal of a face: if it is nearly perpendicular to one edge of a box,
/// it is along the other.
[[gnu::always_inline]] inline bool may_be_along_face(const MeetingObbs& met) {
  constexpr double least_cosine = 1.0 / 16;  // at least the sine^2 + cosine^2 of axes, more than the uncertain sine
  const double least = least_cosine * std::sqrt(met.edges.squared);
  const auto is_low = [least](const PairedBox& box, Dim along, LanePair heights) {
    return std::fabs(heights[0]) <= least * box.half[(along + 1) % 3] ||
           std::fabs(heights[1]) <= least * box.half[(along + 2) % 3];
  };
  return is_low(met.box[0], met.axis, met.edges.heights[0]) || is_low(met.box[1], met.edge_b, met.edges.heights[1]);
}

/// The reference face of a manifold: face_pairs in manifold_points.hpp.
[[gnu::always_inline]] inline ReferenceFace reference_face(const MeetingObbs& met) {
  if (met.is_on_edges) {
    if (!may_be_along_face(met)) [[likely]]
      return {false, false, {}, met.normal};
    const ReferenceFace face = face_along(met.box[0], met.normal, false);
    return face.is_any ? face : face_along(met.box[1], -met.normal, true);
  }
  if (met.is_of_b) {
    const ReferenceFace face = face_along(met.box[0], met.normal, false);
    if (face.is_any) return face;
  }
  return face_of_axis(met);
}

/// The other box's face over a reference face, `flush` as in FacingPatches.
[[gnu::always_inline]] inline FaceOverFace face_over(const MeetingObbs& met, const ReferenceFace& face, double flush) {
  const PairedBox& box = met.box[face.is_of_b ? 1 : 0];
  const PairedBox& other = met.box[face.is_of_b ? 0 : 1];
  const PairedVec up = met.normal * (face.is_of_b ? -1.0 : 1.0);
  return {face_of_box(other, facing_face(other, -up)),
          face_of_box(box, face.numbers),
          up,
          face.normal,
          tolerance::coarse * met.size,
          flush};
}

/// The edge along `axis` that is farthest in a direction, with its number and its middle.
struct NumberedEdge {
  std::uint32_t number;
  PairedVec middle;
};

/// From the heights along the direction of the half edges along the next axis and the last one.
[[gnu::always_inline]] inline NumberedEdge farthest_numbered(const PairedBox& box, Dim axis, LanePair heights) {
  const double side_of_next = sign_of(heights[0]);
  const double side_of_last = sign_of(heights[1]);
  return {static_cast<std::uint32_t>(4 * axis) + (heights[0] >= 0 ? 1U : 0U) + (heights[1] >= 0 ? 2U : 0U),
          box.center + box.half_edges[(axis + 1) % 3] * side_of_next + box.half_edges[(axis + 2) % 3] * side_of_last};
}

[[gnu::always_inline]] inline double shortest_half_edge(const PairedBox& box) {
  return std::min(std::min(box.half[0], box.half[1]), box.half[2]);
}

/// Where two edges cross, if neither crosses near its end or is hardly longer than wide.
struct CrossingEdges {
  bool is_known;
  PairedPoints points;
};

/// With u and v along the edges and w from middle to middle, n = u x v, at s n^2 = (w x v) . n and t n^2 = (w x u) . n.
[[gnu::always_inline]] inline CrossingEdges crossing_of_edges(const MeetingObbs& met) {
  constexpr double farthest = 1 - 0x1p-20;
  constexpr double least_share = 2e-6;  // relative to the size: of an edge that does not count as a point
  const auto& [across, squared, ahead, heights] = met.edges;
  const double side = sign_of(ahead);
  const NumberedEdge edge_a = farthest_numbered(met.box[0], met.axis, heights[0] * side);
  const NumberedEdge edge_b = farthest_numbered(met.box[1], met.edge_b, heights[1] * -side);
  const PairedVec& along_a = met.box[0].axes[met.axis];
  const PairedVec& along_b = met.box[1].axes[met.edge_b];
  const PairedVec between = edge_b.middle - edge_a.middle;
  const LanePair on_edges =
      LanePair{dot(cross(between, along_b), across), dot(cross(between, along_a), across)} * (1 / squared);
  const bool is_known =
      std::min(shortest_half_edge(met.box[0]), shortest_half_edge(met.box[1])) > least_share * met.size &&
      squared > least_squared_sine && std::fabs(on_edges[0]) < farthest * met.box[0].half[met.axis] &&
      std::fabs(on_edges[1]) < farthest * met.box[1].half[met.edge_b];
  return {is_known,
          {edge_a.middle + along_a * on_edges[0],
           edge_b.middle + along_b * on_edges[1],
           met.depth(),
           {FeatureKind::edge, edge_a.number},
           {FeatureKind::edge, edge_b.number}}};
}

/// Whether two boxes are disjoint, after their axes were tested.
template <class Seen>
[[gnu::always_inline]] inline bool are_apart(const Seen& seen, const ObbAxes& axes) {
  if (axes.verdict != Relation::touching) [[likely]]
    return axes.verdict == Relation::apart;
  return seen.are_apart_for_certain();
}

/// The contact points, on a's surface and on b's.
struct TouchingPoints {
  PairedVec of[2];
};

/// The general algorithm.
template <class Seen>
[[gnu::noinline]] void find_points_carefully(const Seen& seen, const BoxesContact<3>& contact, TouchingPoints& points) {
  const auto pair = touching_pair(seen.first_local(), seen.second_local(), contact);
  points.of[0] = PairedVec(pair.point_a + seen.origin());
  points.of[1] = PairedVec(pair.point_b + seen.origin());
}

/// The deepest corner of the other box, if it lies clearly over the face whose normal is the axis: no other point is
/// deeper, and no clipping is necessary.
struct CornerOverFace {
  bool is_any;
  PairedVec corner;
  PairedVec on_face;
};

[[gnu::always_inline]] inline CornerOverFace corner_over_face(const MeetingObbs& met) {
  const PairedBox& own = met.box[met.is_of_b ? 1 : 0];
  const PairedBox& other = met.box[met.is_of_b ? 0 : 1];
  const PairedVec up = met.normal * (met.is_of_b ? -1.0 : 1.0);
  PairedVec corner = other.center;
#pragma GCC unroll 3
  for (const PairedVec& half : other.half_edges) corner = corner - half * sign_of(dot(half, up));
  const PairedVec way = corner - own.center;
  const Dim next = (met.axis + 1) % 3;
  const Dim last = (met.axis + 2) % 3;
  const double doubt = 4 * tolerance::orthonormal * met.size;
  const bool is_over = std::fabs(dot(way, own.axes[next])) < own.half[next] - doubt &&
                       std::fabs(dot(way, own.axes[last])) < own.half[last] - doubt;
  return {is_over, corner, corner + up * met.depth()};
}

/// Where the two edges cross; or the deepest of the points over the face whose normal is the axis, the first of
/// several.
template <class Seen>
[[gnu::always_inline]] inline TouchingPoints touching_points(const Seen& seen, const MeetingObbs& met) {
  const PairedVec origin(seen.origin());
  TouchingPoints points{{origin, origin}};
  bool is_known = false;
  if (met.is_on_edges) {
    const CrossingEdges edges = crossing_of_edges(met);
    points.of[0] = edges.points.point_a + origin;
    points.of[1] = edges.points.point_b + origin;
    is_known = edges.is_known;
  } else if (const CornerOverFace over = corner_over_face(met); over.is_any) {
    points.of[met.is_of_b ? 1 : 0] = over.on_face + origin;
    points.of[met.is_of_b ? 0 : 1] = over.corner + origin;
    is_known = true;
  } else {
    FaceOverFace cut = face_over(met, face_of_axis(met), 0);
    is_known = cut.run() && cut.size() > 0;
    if (is_known) {
      const PairedPoints pair = cut.pair(cut.deepest());
      points.of[met.is_of_b ? 1 : 0] = pair.point_a + origin;
      points.of[met.is_of_b ? 0 : 1] = pair.point_b + origin;
    }
  }
  if (!is_known) [[unlikely]]
    find_points_carefully(seen, met.contact(), points);
  return points;
}

/// The penetration of two boxes that meet, in the order of their contact.
template <class Seen>
std::optional<Penetration<3>> penetration_of_obbs(const Seen& seen) {
  const ObbAxes axes = seen.axes();
  if (are_apart(seen, axes)) return std::nullopt;
  const MeetingObbs met(seen, axes.candidates);
  const TouchingPoints points = touching_points(seen, met);
  return Penetration<3>{plain(met.normal),   met.depth(),       plain(points.of[0]),
                        plain(points.of[1]), Status::converged, met.error()};
}

#endif

}  // namespace graze::detail
