// SPDX-License-Identifier: MIT
// Clips one face to another: Sutherland and Hodgman, "Reentrant polygon clipping" (1974), with the features that every
// new corner lies on.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/patch/patch.hpp>

namespace graze {

/// The kind of a feature of a shape.
enum class FeatureKind : std::uint8_t { vertex, edge, face };

/// A vertex, edge or face of a shape.
///
/// Vertices of boxes: bit i of the index is set on the far side of axis i. Vertices of segments, triangles and
/// polytopes are in the order of their points. A sphere has one vertex; a capsule has two and an edge between them.
///
/// Edges of a 3D box: 4 * axis, plus 1 on the far side of the next axis, plus 2 on the far side of the axis after it.
/// Edges of triangles and polygons have the index of their first vertex; the edge of a segment is 0. The edge between
/// vertices i < j of a 3D polytope with n vertices is n * i + j.
///
/// Sides of boxes, which are edges in 2D and faces in 3D: 2 * axis, plus 1 on the far side. The face of a triangle is
/// 0. A face of a 3D polytope is n * i + j if i is its least vertex and j the next one around it, counter-clockwise
/// seen from outside. With more than 65,535 vertices these indices are taken modulo 2^32 and may repeat.
struct Feature {
  FeatureKind kind;     ///< Vertex, edge or face.
  std::uint32_t index;  ///< Distinguishes features of the same kind.

  friend bool operator==(const Feature&, const Feature&) = default;
};

namespace detail {

/// A corner of an incident face clipped to a reference face.
template <Dim N>
struct ClippedCorner {
  Vec<N, double> point;
  Feature reference;
  Feature incident;
  /// The features of the side from here to the next corner: either an edge of the reference face and ...
  Feature next_reference;
  Feature next_incident;  ///< ... the incident face, or the reference face and an edge of the incident one.
};

/// The incident patch while it is clipped, corner by corner.
template <Dim N>
class ClippedPatch {
 public:
  static constexpr std::size_t most_corners = N == 2 ? 2 : 2 * Patch<N>::most_corners + 1;

  ClippedPatch(const Patch<N>& incident, const Patch<N>& reference)
      : reference_(reference),
        incident_face_(face_of(incident)),
        // GCC 12 warns about larger sizes, which are impossible
        size_(std::min(incident.size, Patch<N>::most_corners)) {
    const Feature over = face_of(reference);
    for (std::size_t i = 0; i < size_; ++i) {
      corners_[i] = {incident.corners[i],
                     over,
                     {FeatureKind::vertex, incident.vertices[i]},
                     over,
                     {FeatureKind::edge, incident.edges[i]}};
    }
  }

  std::size_t size() const { return size_; }
  const ClippedCorner<N>& operator[](std::size_t i) const { return corners_[i]; }

  /// The same for a plane whose normal has any length; a square root is seldom worth it, because most sides clip
  /// nothing. If all corners are below the plane, rounding hides less than `slack`, which must exceed that.
  void cut_across(const Vec<N, double>& outward, const Vec<N, double>& through, std::size_t side, double slack) {
    bool is_above = false;
    for (std::size_t i = 0; i < size_; ++i) is_above = is_above || dot(outward, corners_[i].point - through) > 0;
    if (is_above) cut(unit_or(outward, Vec<N, double>(0.0)), through, side, slack);
  }

  /// Removes what is above a plane through `side` of the reference patch: edges 0, 1, ..., or, for the patch's size,
  /// the face itself. Corners up to `slack` above are kept.
  void cut(const Vec<N, double>& normal, const Vec<N, double>& through, std::size_t side, double slack) {
    std::array<double, most_corners> heights;
    bool is_cut = false;
    for (std::size_t i = 0; i < size_; ++i) {
      heights[i] = dot(normal, corners_[i].point - through);
      is_cut = is_cut || heights[i] > slack;
    }
    if (!is_cut) return;
    std::array<ClippedCorner<N>, most_corners> kept;
    std::size_t count = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const std::size_t next = i + 1 < size_ ? i + 1 : 0;
      const bool is_inside = heights[i] <= slack;
      const bool is_next_inside = heights[next] <= slack;
      if (is_inside && count < most_corners) kept[count++] = corners_[i];
      const bool is_side = size_ > 2 || next > i;  // a single edge has no side back
      if (!is_side || is_inside == is_next_inside || count == most_corners) continue;
      ClippedCorner<N> corner = crossing(i, next, heights[i] / (heights[i] - heights[next]), side);
      if (is_inside) {  // leaves the inside: from here the plane is the side
        corner.next_reference = side_of(side);
        corner.next_incident = incident_face_;
      }
      kept[count++] = corner;
    }
    std::copy(kept.begin(), kept.begin() + count, corners_.begin());
    size_ = count;
  }

 private:
  static constexpr FeatureKind face_kind = N == 2 ? FeatureKind::edge : FeatureKind::face;

  static Feature face_of(const Patch<N>& patch) {
    if (patch.size == 1) return {FeatureKind::vertex, patch.vertices[0]};
    return {patch.size == 2 ? FeatureKind::edge : face_kind, patch.face};
  }

  bool is_edge_of_reference(const Feature& feature) const { return !(feature == face_of(reference_)); }

  Feature side_of(std::size_t side) const {
    if (side == reference_.size) return face_of(reference_);
    // The sides of an edge are its ends.
    if (reference_.size == 2) return {FeatureKind::vertex, reference_.vertices[side]};
    return {FeatureKind::edge, reference_.edges[side]};
  }

  /// Where the side between two corners intersects the plane, at this share of the side.
  ClippedCorner<N> crossing(std::size_t from, std::size_t to, double share, std::size_t side) const {
    ClippedCorner<N> result = corners_[from];
    result.point += (corners_[to].point - corners_[from].point) * std::clamp(share, 0.0, 1.0);
    result.incident = result.next_incident;
    result.reference = side_of(side);
    if (is_edge_of_reference(corners_[from].next_reference)) {
      result.reference =
          side == reference_.size ? corners_[from].next_reference : corner_between(corners_[from].next_reference, side);
    }
    return result;
  }

  /// The corner of the reference patch where two of its edges meet.
  Feature corner_between(const Feature& edge, std::size_t side) const {
    const std::size_t next = side + 1 < reference_.size ? side + 1 : 0;
    const bool is_before = edge.index == reference_.edges[side == 0 ? reference_.size - 1 : side - 1];
    return {FeatureKind::vertex, reference_.vertices[is_before ? side : next]};
  }

  const Patch<N>& reference_;
  Feature incident_face_;
  std::array<ClippedCorner<N>, most_corners> corners_;
  std::size_t size_;
};

/// At a tip sharper than `slack` can resolve, two sides do not clip what lies beyond it: that is clipped
/// perpendicularly to the longest edge, past the last corners along it. `turn` is perpendicular to the patch, and its
/// length is twice the area.
inline void cut_at_tips(ClippedPatch<3>& patch, const Patch<3>& reference, const Vec<3, double>& turn, double slack) {
  const auto& corners = reference.corners;
  Vec<3, double> way(0.0);
  for (std::size_t i = 0; i < reference.size; ++i) {
    const Vec<3, double> edge = corners[i + 1 < reference.size ? i + 1 : 0] - corners[i];
    if (dot(edge, edge) > dot(way, way)) way = edge;
  }
  const double most = slack / tolerance::aligned;
  if (dot(turn, turn) > most * most * dot(way, way)) return;
  const Vec<3, double> unit = unit_or(way, Vec<3, double>(0.0));
  std::size_t low = 0;
  std::size_t high = 0;
  for (std::size_t i = 1; i < reference.size; ++i) {
    if (dot(unit, corners[i] - corners[low]) < 0) low = i;
    if (dot(unit, corners[i] - corners[high]) > 0) high = i;
  }
  patch.cut(-unit, corners[low], low, slack);
  patch.cut(unit, corners[high], high, slack);
}

/// Clips an incident patch at the sides of a reference patch, projected along its unit normal `up`. A patch without
/// bounds does not clip.
template <Dim N>
ClippedPatch<N> clipped(const Patch<N>& incident, const Patch<N>& reference, const Vec<N, double>& up, double slack) {
  ClippedPatch<N> result(incident, reference);
  const auto& corners = reference.corners;
  if (reference.size == 2) {
    const Vec<N, double> way = unit_or(corners[1] - corners[0], Vec<N, double>(0.0));
    result.cut(-way, corners[0], 0, slack);
    result.cut(way, corners[1], 1, slack);
  } else if constexpr (N == 3) {
    Vec<3, double> turn(0.0);
    for (std::size_t i = 2; i < reference.size; ++i) {
      turn += cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    }
    const Vec<3, double> axis = dot(turn, up) < 0 ? -up : up;
    for (std::size_t i = 0; i < reference.size; ++i) {
      const Vec<3, double> edge = corners[i + 1 < reference.size ? i + 1 : 0] - corners[i];
      result.cut_across(cross(edge, axis), corners[i], i, slack);
    }
    if (reference.size > 2) cut_at_tips(result, reference, turn, slack);
  }
  return result;
}

}  // namespace detail
}  // namespace graze
