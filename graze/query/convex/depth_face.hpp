// SPDX-License-Identifier: MIT
// The face of a set of differences in which EPA ends, solved in closed form: its normal is made of exact differences of
// the shapes' own points, so that it is right however thin the face is.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/growing_hull.hpp>

namespace graze::detail {

/// At right angles to an edge, on its right.
inline Vec<2, double> outward_normal(const std::array<RoundedVec<2>, 2>& corners) {
  const RoundedVec<2> edge = corners[1] - corners[0];
  return -perpendicular(edge.value + edge.error);
}

/// The products of what rounding has left of two sides are too small to matter.
inline Vec<3, double> outward_normal(const std::array<RoundedVec<3>, 3>& corners) {
  const RoundedVec<3> u = corners[1] - corners[0];
  const RoundedVec<3> v = corners[2] - corners[0];
  return accurate_cross(u.value, v.value) + (cross(u.value, v.error) + cross(u.error, v.value));
}

/// The foot of the origin's perpendicular on the plane of a face is normal * height.
template <Dim N>
struct DepthFace {
  Vec<N, double> normal;  ///< Outward and of length one; zero if the face has none.
  double height = 0;
  double outside = 0;  ///< How far the foot is outside the face.
};

/// By exact corners in the order of HullFaceCorners.
template <Dim N>
DepthFace<N> depth_face(const std::array<RoundedVec<N>, static_cast<std::size_t>(N)>& corners) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Vec<N, double> normal = of_moderate_size(outward_normal(corners));
  const double size = std::sqrt(dot(normal, normal));
  if (!(size > 0)) return {Vec<N, double>(0.0), 0, infinity};
  DepthFace<N> face{normal / size};
  face.height = dot(face.normal, corners[0].value);
  const Vec<N, double> foot = face.normal * face.height;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec<N, double>& corner = corners[i].value;
    const Vec<N, double> edge = corners[(i + 1) % corners.size()].value - corner;
    Vec<N, double> along_face = edge;  // outward from the edge in 3D, from its start in 2D
    if constexpr (N == 3) along_face = cross(edge, face.normal);
    if constexpr (N == 2) along_face = -edge;
    const double beyond = dot(along_face, foot - corner);
    if (beyond > 0) face.outside = std::max(face.outside, beyond / std::sqrt(dot(along_face, along_face)));
  }
  return face;
}

}  // namespace graze::detail
