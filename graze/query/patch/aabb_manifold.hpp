// SPDX-License-Identifier: MIT
// The manifold of two axis-aligned boxes, equal to what manifold_points.hpp calculates for any two faces: the corners
// of the intersection of their faces, which is a rectangle. Include manifold.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/cores/penetration.hpp>
#include <graze/query/patch/clipped.hpp>
#include <graze/query/patch/manifold_points.hpp>
#include <graze/query/patch/patch.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// The bounds along one axis of the intersection of two faces: those of the incident face if they are within the
/// reference face, otherwise those of the reference face.
struct SharedRange {
  std::array<double, 2> end;         ///< The lower and the upper bound.
  std::array<bool, 2> is_reference;  ///< Whether each belongs to the reference face.
};

/// Anything outside of the reference face by up to `slack` counts as within.
template <Dim N>
SharedRange shared_range(const Aabb<N, double>& reference, const Aabb<N, double>& incident, Dim axis, double slack) {
  const bool is_low = incident.min[axis] < reference.min[axis] - slack;
  const bool is_high = incident.max[axis] > reference.max[axis] + slack;
  return {{is_low ? reference.min[axis] : incident.min[axis], is_high ? reference.max[axis] : incident.max[axis]},
          {is_low, is_high}};
}

/// Whether all sides of a box have a nonzero length, so that its faces are not degenerate.
template <Dim N>
bool has_faces(const Aabb<N, double>& box) {
  bool result = true;
  for (Dim i = 0; i < N; ++i) result = result && box.min[i] < box.max[i];
  return result;
}

/// The axis of a face, and the side of its box that it is on, for a normal along an axis.
template <Dim N>
BoxFaceNumbers face_along_axis(const Vec<N, double>& normal) {
  Dim axis = 0;
  while (axis + 1 < N && normal[axis] == 0) ++axis;
  return {axis, normal[axis] > 0};
}

/// In 2D: the ends of the intersection of two edges.
inline std::array<SurfacePair<2>, 2> pairs_of_aabbs(const Aabb<2, double>& a, const Aabb<2, double>& b,
                                                    const Penetration<2>& found, double slack) {
  const BoxFaceNumbers of_a = face_along_axis(found.normal);
  const BoxFaceNumbers of_b{of_a.axis, !of_a.is_far};
  const Dim along = 1 - of_a.axis;
  const SharedRange shared = shared_range(a, b, along, slack);
  const auto vertex = [along](const BoxFaceNumbers& face, std::uint32_t side) {
    return Feature{FeatureKind::vertex,
                   (face.is_far ? 1U : 0U) << static_cast<unsigned>(face.axis) | side << static_cast<unsigned>(along)};
  };
  std::array<SurfacePair<2>, 2> result;
  for (std::uint32_t side = 0; side < 2; ++side) {
    SurfacePair<2>& pair = result[side];
    pair = {
        found.point_a, found.point_b, found.depth, {FeatureKind::edge, of_a.face()}, {FeatureKind::edge, of_b.face()}};
    pair.point_a[along] = pair.point_b[along] = shared.end[side];
    (shared.is_reference[side] ? pair.feature_a : pair.feature_b) =
        vertex(shared.is_reference[side] ? of_a : of_b, side);
  }
  return result;
}

/// The feature of a face that a corner of the intersection lies on, where the corners of both are numbered alike: by
/// whether it is at the face's own end along the next axis and along the last one.
inline Feature feature_of_shared(const BoxFaceNumbers& face, std::uint32_t corner, bool by_x, bool by_y) {
  if (by_x && by_y) return {FeatureKind::vertex, face.vertex(corner)};
  // The sides of a face are numbered by the corner that they begin at: below, right, above, left.
  const bool is_right = ((corner ^ corner >> 1U) & 1U) != 0;
  const bool is_up = corner >> 1U != 0;
  if (by_x) return {FeatureKind::edge, face.edge(is_right ? 1 : 3)};
  if (by_y) return {FeatureKind::edge, face.edge(is_up ? 2 : 0)};
  return {FeatureKind::face, face.face()};
}

/// In 3D: the corners of the intersection of two faces, in order around it.
inline std::array<SurfacePair<3>, 4> pairs_of_aabbs(const Aabb<3, double>& a, const Aabb<3, double>& b,
                                                    const Penetration<3>& found, double slack) {
  const BoxFaceNumbers of_a = face_along_axis(found.normal);
  const BoxFaceNumbers of_b{of_a.axis, !of_a.is_far};
  const SharedRange x = shared_range(a, b, of_a.next(), slack);
  const SharedRange y = shared_range(a, b, of_a.last(), slack);
  std::array<SurfacePair<3>, 4> result;
  for (std::uint32_t corner = 0; corner < 4; ++corner) {
    const std::uint32_t right = (corner ^ corner >> 1U) & 1U;
    const std::uint32_t up = corner >> 1U;
    const bool is_a_x = x.is_reference[right];
    const bool is_a_y = y.is_reference[up];
    SurfacePair<3>& pair = result[corner];
    pair = {found.point_a, found.point_b, found.depth, feature_of_shared(of_a, corner, is_a_x, is_a_y),
            feature_of_shared(of_b, corner, !is_a_x, !is_a_y)};
    pair.point_a[of_a.next()] = pair.point_b[of_a.next()] = x.end[right];
    pair.point_a[of_a.last()] = pair.point_b[of_a.last()] = y.end[up];
  }
  return result;
}

}  // namespace graze::detail
