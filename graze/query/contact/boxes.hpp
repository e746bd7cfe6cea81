// SPDX-License-Identifier: MIT
// Two boxes of any kind, at least one of them oriented: separating_axis.hpp with shortcuts for boxes, and the contact
// points from the faces and edges that the axis belongs to. Include contact.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/cores/closest.hpp>
#include <graze/query/cores/features.hpp>
#include <graze/query/cores/penetration.hpp>
#include <graze/query/cores/separating_axis.hpp>
#include <graze/query/patch/manifold_points.hpp>
#include <graze/query/patch/patch.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/segment.hpp>

namespace graze::detail {

/// A box in the form of the axis search.
template <Dim N>
struct BoxSides {
  BoxFrame<N> frame;
  Mat<N, double> directions;  ///< Of the edges, of length about 1.

  /// The unit normal of the faces perpendicular to an edge.
  Vec<N, double> normal(Dim i) const {
    const Vec<N, double> normal = adjoint_column(directions, i);
    return normal * (1 / std::sqrt(dot(normal, normal)));  // about 1
  }
};

template <Dim N>
BoxSides<N> sides_of(const Aabb<N, double>& box) {
  return {frame_of(box), Mat<N, double>(1.0)};
}

template <Dim N>
BoxSides<N> sides_of(const Obb<N, double>& box) {
  return {frame_of(box), box.axes};
}

/// Some of the axes of two boxes, as bits in the order in which they are tried: the faces of the first, those of the
/// second, and in 3D the pairs of edges, those of the first edge of the first box before others.
using BoxesAxes = unsigned;
template <Dim N>
inline constexpr BoxesAxes all_boxes_axes = N == 2 ? 0xf : 0x7fff;

/// Two axes are the same if the angle between them is certainly no more than this.
inline constexpr double same_axis = 3 * tolerance::rounding;

/// The orthonormality error of three axes, as orthonormal_error.
template <class Axes>
double orthonormality_error_of_axes(const Axes& axes) {
  double orthonormality_error = 0;
  for (Dim i = 0; i < 3; ++i) {
    orthonormality_error = std::max(orthonormality_error, std::fabs(dot(axes[i], axes[i]) - 1));
    orthonormality_error = std::max(orthonormality_error, std::fabs(dot(axes[i], axes[(i + 1) % 3])));
  }
  return orthonormality_error;
}

/// The axes of two 3D boxes that repeat a face's normal, or are across parallel edges: stacked boxes have six of them.
/// With perpendicular unit edges, b's edge j is in a's plane perpendicular to k if their cosine c is zero, and then a's
/// edge i x b's edge j is the normal perpendicular to k; otherwise an angle of c divided by the sine of the two edges
/// remains, and deviations of the edges from right angles count as c does. For parallel edges both such cosines are
/// zero: an axis across them is between normals of faces, and not wider than these by more than the angle.
template <class Axes>
BoxesAxes repeated_axes(const Axes& a, const Axes& b) {
  double cosines[3][3];
  double least = std::numeric_limits<double>::infinity();
  for (Dim i = 0; i < 3; ++i) {
    for (Dim j = 0; j < 3; ++j) {
      cosines[j][i] = std::fabs(dot(a[i], b[j]));
      least = std::min(least, cosines[j][i]);
    }
  }
  if (least > 2 * same_axis) return 0;  // true for nearly all axes that were rounded to float
  const double orthonormality_error = 1.5 * std::max(orthonormality_error_of_axes(a), orthonormality_error_of_axes(b));
  BoxesAxes result = 0;
  for (Dim j = 0; j < 3; ++j) {
    const auto& c = cosines[j];
    for (Dim i = 0; i < 3; ++i) {
      const BoxesAxes along{1.5 * (std::max(c[(i + 1) % 3], c[(i + 2) % 3]) + orthonormality_error) <= same_axis};
      result |= along << (3 + j) | along << (6 + 3 * i + j);
      const double in_a = std::min(c[(i + 1) % 3], c[(i + 2) % 3]);
      const double in_b = std::min(cosines[(j + 1) % 3][i], cosines[(j + 2) % 3][i]);
      const double off = std::min(in_a, in_b) + orthonormality_error;
      result |= BoxesAxes{off * off <= same_axis * same_axis * (1 - c[i] * c[i])} << (6 + 3 * i + j);
    }
  }
  return result;
}

/// Removes those: the gaps along them are as wide as that along the face's normal, up to same_axis times the size.
/// Returns all if nothing else is left.
inline BoxesAxes distinct_axes(BoxesAxes candidates, BoxesAxes repeated) {
  const BoxesAxes left = candidates & ~repeated;
  return left != 0 ? left : candidates;
}

/// How much deeper two boxes may be than the depth found, relative to their size: gaps have rounding errors, an axis is
/// preferred to one that is wider by no more than that, and repeated axes are not tried.
inline constexpr double boxes_error = 2 * tolerance::rounding + same_axis;

/// The axis, and what it is the normal of: the face of one box, or two edges.
template <Dim N>
struct BoxesAxis {
  SeparatingAxis<N> axis;
  bool is_of_b = false;
  Dim face = 0;  ///< If it is one: which of the box's axes it is perpendicular to.
  std::optional<std::array<Dim, 2>> edges;
};

/// 1 or -1, and 1 for zero of either sign; branch-free, because a branch would be mispredicted half of the time.
inline double sign_of(double number) { return std::copysign(1.0, number + 0.0); }

/// The extent of a box along a face's normal is its own half extent; an axis across an edge omits that edge. Pairs of
/// edges are compared by squares: only the winner needs a square root.
template <Dim N>
class BoxesSearch {
 public:
  BoxesSearch(const BoxSides<N>& a, const BoxSides<N>& b, double size)
      : a_(a), b_(b), between_(b.frame.center - a.frame.center), margin_(tolerance::rounding * size) {}

  /// `candidates` must include all axes except those known to be wider by more than rounding.
  BoxesAxis<N> run(BoxesAxes candidates = all_boxes_axes<N>) {
    if constexpr (N == 3) candidates = distinct_axes(candidates, repeated_axes(a_.directions, b_.directions));
    for (; candidates != 0; candidates &= candidates - 1) {
      const auto place = static_cast<Dim>(std::countr_zero(candidates));
      if constexpr (N == 3) {
        if (place >= 2 * N) {
          try_edges((place - 2 * N) / N, (place - 2 * N) % N);
          continue;
        }
      }
      const bool is_of_b = place >= N;
      try_face(is_of_b ? b_ : a_, is_of_b ? a_ : b_, is_of_b ? place - N : place, is_of_b);
    }
    return best_;
  }

 private:
  void try_face(const BoxSides<N>& own, const BoxSides<N>& other, Dim i, bool is_of_b) {
    const Vec<N, double> normal = own.normal(i);
    double reach = std::fabs(dot(normal, own.frame.half_edges[i]));
    for (Dim j = 0; j < N; ++j) reach += std::fabs(dot(normal, other.frame.half_edges[j]));
    const double ahead = dot(normal, between_);
    const double gap = std::fabs(ahead) - reach;
    if (!(gap > best_.axis.gap + margin_)) return;
    best_.axis = {normal * sign_of(ahead), gap};
    best_.is_of_b = is_of_b;
    best_.face = i;
  }

  void try_edges(Dim i, Dim j) {
    const Vec<3, double> across_both = cross_of_directions(a_.directions[i], b_.directions[j]);
    const double squared = dot(across_both, across_both);
    if (!(squared > 0)) return;
    const double reach = reach_without(a_.frame, i, across_both) + reach_without(b_.frame, j, across_both);
    const double ahead = dot(across_both, between_);
    const double gap = std::fabs(ahead) - reach;  // times the axis's length
    const double least = best_.axis.gap + margin_;
    const bool is_better =
        gap >= 0 ? least < 0 || gap * gap > least * least * squared : least < 0 && gap * gap < least * least * squared;
    if (!is_better) return;
    const double inverse = 1 / std::sqrt(squared);
    best_.axis = {across_both * (sign_of(ahead) * inverse), gap * inverse};
    best_.edges = {i, j};
  }

  static double reach_without(const BoxFrame<3>& box, Dim i, const Vec<3, double>& axis) {
    return std::fabs(dot(axis, box.half_edges[(i + 1) % 3])) + std::fabs(dot(axis, box.half_edges[(i + 2) % 3]));
  }

  const BoxSides<N>& a_;
  const BoxSides<N>& b_;
  Vec<N, double> between_;
  double margin_;
  BoxesAxis<N> best_;
};

/// The edge along `axis` that is farthest along a direction.
inline Segment<3, double> farthest_edge(const BoxFrame<3>& box, Dim axis, const Vec<3, double>& direction) {
  Vec<3, double> middle = box.center;
  for (const Dim i : {(axis + 1) % 3, (axis + 2) % 3}) {
    middle += dot(box.half_edges[i], direction) < 0 ? -box.half_edges[i] : box.half_edges[i];
  }
  return {middle - box.half_edges[axis], middle + box.half_edges[axis]};
}

/// The nearest points of the lines of the two edges; none for edges of length zero.
inline std::optional<SurfacePair<3>> pair_on_edges(const BoxFrame<3>& a, const BoxFrame<3>& b,
                                                   const BoxesAxis<3>& found) {
  const Segment<3, double> edge_a = farthest_edge(a, (*found.edges)[0], found.axis.normal);
  const Segment<3, double> edge_b = farthest_edge(b, (*found.edges)[1], -found.axis.normal);
  const Perpendicular<3> perpendicular(edge_a, edge_b);
  if (!perpendicular.is_any()) return std::nullopt;
  SurfacePair<3> pair{};
  pair.point_a = edge_a.start + (edge_a.end - edge_a.start) * perpendicular.on_a();
  pair.point_b = edge_b.start + (edge_b.end - edge_b.start) * perpendicular.on_b();
  return pair;
}

template <Dim N>
double size_of_box(const BoxFrame<N>& box) {
  Vec<N, double> reach = abs(box.center);
  for (Dim i = 0; i < N; ++i) reach += abs(box.half_edges[i]);
  return sum_abs(reach);
}

/// The penetration of two boxes, relative to a point near the pair, without its points.
template <Dim N>
struct BoxesContact {
  BoxesAxis<N> axis;
  double size;  ///< Of both boxes.
  Penetration<N> found;
};

template <Dim N>
BoxesContact<N> contact_of_sides(const BoxSides<N>& a, const BoxSides<N>& b, BoxesAxes candidates = all_boxes_axes<N>) {
  BoxesContact<N> result;
  result.size = size_of_box(a.frame) + size_of_box(b.frame);
  result.axis = BoxesSearch<N>(a, b, result.size).run(candidates);
  const double gap = result.axis.axis.gap;
  result.found.normal = result.axis.axis.normal;
  result.found.depth = std::max(0.0, -gap);
  result.found.error = std::max(0.0, gap) + boxes_error * result.size;
  return result;
}

template <class A, class B>
BoxesContact<dimension_of<A>> contact_of_boxes(const A& a, const B& b) {
  return contact_of_sides(sides_of(a), sides_of(b));
}

/// The deepest of the points over the face that the axis is the normal of; the first of several. None for a side
/// without length or width.
template <class A, class B>
std::optional<SurfacePair<dimension_of<A>>> deepest_on_face(const A& a, const B& b,
                                                            const BoxesContact<dimension_of<A>>& contact) {
  constexpr Dim N = dimension_of<A>;
  const Vec<N, double>& normal = contact.found.normal;
  const Patch<N> patch_a = patch_of(a, normal);
  const Patch<N> patch_b = patch_of(b, -normal);
  const FacingPatches<N> facing{patch_a, patch_b, 0, 0};
  const bool is_of_b = contact.axis.is_of_b;
  if (!(max_abs(is_of_b ? patch_b.normal : patch_a.normal) > 0)) return std::nullopt;
  const double slack = tolerance::coarse * contact.size;
  const SurfacePairs<N> pairs = is_of_b ? pairs_over_b(facing, normal, slack) : pairs_over(facing, normal, slack);
  if (pairs.empty()) return std::nullopt;
  std::size_t deepest = 0;
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    if (pairs[i].depth > pairs[deepest].depth) deepest = i;
  }
  return pairs[deepest];
}

/// Where the boxes touch after b has been moved out of a.
template <class A, class B>
SurfacePair<dimension_of<A>> touching_pair(const A& a, const B& b, const BoxesContact<dimension_of<A>>& contact) {
  constexpr Dim N = dimension_of<A>;
  std::optional<SurfacePair<N>> pair;
  if (!contact.axis.edges) {
    pair = deepest_on_face(a, b, contact);
  } else if constexpr (N == 3) {
    pair = pair_on_edges(frame_of(a), frame_of(b), contact.axis);
  }
  if (pair) return *pair;
  const ClosestPair<N> cores = points_along(a, b, contact.axis.axis, contact.size);
  SurfacePair<N> result{};
  result.point_a = cores.on_a;
  result.point_b = cores.on_b;
  return result;
}

template <class A, class B>
Penetration<dimension_of<A>> penetration_of_boxes(const A& a, const B& b) {
  BoxesContact<dimension_of<A>> contact = contact_of_boxes(a, b);
  const auto pair = touching_pair(a, b, contact);
  contact.found.point_a = pair.point_a;
  contact.found.point_b = pair.point_b;
  return contact.found;
}

/// The points of a manifold.
template <class A, class B>
SurfacePairs<dimension_of<A>> pairs_of_boxes(const A& a, const B& b, const BoxesContact<dimension_of<A>>& contact) {
  constexpr Dim N = dimension_of<A>;
  const double slack = tolerance::coarse * contact.size;
  const Patch<N> patch_a = patch_of(a, contact.found.normal);
  const Patch<N> patch_b = patch_of(b, -contact.found.normal);
  const FacingPatches<N> facing{patch_a, patch_b, 0, 0, tolerance::aligned};
  SurfacePairs<N> pairs = face_pairs(facing, contact.found.normal, slack);
  if (!pairs.empty()) return pairs;
  const SurfacePair<N> pair = touching_pair(a, b, contact);
  Penetration<N> alone = contact.found;
  alone.point_a = pair.point_a;
  alone.point_b = pair.point_b;
  pairs = single_pair(facing, alone, slack);
  return pairs;
}

}  // namespace graze::detail
