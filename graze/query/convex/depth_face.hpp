// SPDX-License-Identifier: MIT
// The face of the Minkowski difference in which EPA ends, solved in closed form: its normal is calculated from exact
// differences of the shapes' own points, so that it is accurate however thin the face is.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/math/exact/twofold.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/growing_hull.hpp>

namespace graze::detail {

/// Perpendicular to an edge, on its right.
inline Vec<2, double> outward_normal(const std::array<TwofoldVec<2>, 2>& corners) {
  return of_moderate_size(-perpendicular(rounded(twofold_difference(corners[1], corners[0]))));
}

inline Vec<3, double> outward_normal(const std::array<TwofoldVec<3>, 3>& corners) {
  return rounded(
      twofold_normal(twofold_difference(corners[1], corners[0]), twofold_difference(corners[2], corners[0])));
}

/// The projection of the origin onto the plane of a face is normal * height.
template <Dim N>
struct DepthFace {
  Vec<N, double> normal;  ///< Outward and of length one; zero if the face has none.
  double height = 0;
  double outside = 0;  ///< The distance of the projection from the face, 0 inside it.
};

/// From exact corners, in the order of HullFaceCorners.
template <Dim N>
DepthFace<N> depth_face(const std::array<TwofoldVec<N>, static_cast<std::size_t>(N)>& corners) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Vec<N, double> normal = outward_normal(corners);
  const double size = std::sqrt(dot(normal, normal));
  if (!(size > 0)) return {Vec<N, double>(0.0), 0, infinity};
  DepthFace<N> face{normal / size};
  face.height = dot(face.normal, rounded(corners[0]));
  const Vec<N, double> foot = face.normal * face.height;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec<N, double> corner = rounded(corners[i]);
    const Vec<N, double> edge = rounded(corners[(i + 1) % corners.size()]) - corner;
    Vec<N, double> along_face = edge;  // outward from the edge in 3D, from its start in 2D
    if constexpr (N == 3) along_face = cross(edge, face.normal);
    if constexpr (N == 2) along_face = -edge;
    const double beyond = dot(along_face, foot - corner);
    if (beyond > 0) face.outside = std::max(face.outside, beyond / std::sqrt(dot(along_face, along_face)));
  }
  return face;
}

}  // namespace graze::detail
