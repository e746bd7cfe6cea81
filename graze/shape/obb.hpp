// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/fields/defect.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/transformed.hpp>

namespace graze {

/// An oriented box: all center + axes * u with |u[i]| <= half_extents[i]. The columns of `axes` are its axes,
/// orthonormal up to rounding. Queries use the axes as stored and do not orthonormalize them again. Zero half extents
/// are valid.
template <Dim N, class T = float>
struct Obb {
  Vec<N, T> center = Vec<N, T>(T(0));        ///< Center of the box.
  Vec<N, T> half_extents = Vec<N, T>(T(1));  ///< Half the size along each axis; at least zero.
  Mat<N, T> axes = Mat<N, T>(T(1));          ///< Column i is axis i, of length 1; axes are at right angles, up to 1e-4.

  /// The box rotated about its center by an angle in radians, counter-clockwise when y points up. The axes are
  /// orthonormal up to rounding. Throws std::invalid_argument if the angle is not finite.
  static Obb from_angle(const Vec<N, T>& center, const Vec<N, T>& half_extents, double radians) requires(N == 2) {
    return {center, half_extents, Mat<N, T>(rotation_from_angle(radians))};
  }

  /// The box rotated right-handed about its center, around an axis of any nonzero length, by an angle in radians.
  /// Throws std::invalid_argument if the axis is zero or a number is not finite.
  static Obb from_axis_angle(const Vec<N, T>& center, const Vec<N, T>& half_extents, const Vec<N, T>& axis,
                             double radians) requires(N == 3) {
    return {center, half_extents, Mat<N, T>(rotation_from_axis_angle(wide<N, T>(axis), radians))};
  }

  /// The box rotated about its center by a quaternion of any nonzero length. Throws std::invalid_argument if the
  /// quaternion is zero or a number is not finite.
  template <Quaternion Q>
  static Obb from_quaternion(const Vec<N, T>& center, const Vec<N, T>& half_extents,
                             const Q& quaternion) requires(N == 3) {
    return {center, half_extents, Mat<N, T>(rotation_from_quaternion(quaternion))};
  }
};

/// The oriented rectangle: a 2D Obb.
template <class T = float>
using OrientedRect = Obb<2, T>;

namespace detail {
template <Dim N, class T>
inline constexpr auto description_of<Obb<N, T>> = Description("obb", field::point("center", &Obb<N, T>::center),
                                                              field::half_extents("half_extents",
                                                                                  &Obb<N, T>::half_extents),
                                                              field::axes("axes", &Obb<N, T>::axes));
}  // namespace detail

/// The vectors from the center to the centers of the faces, in double: column i is axes[i] * half_extents[i].
template <Dim N, class T>
Mat<N, double> half_edges(const Obb<N, T>& box) {
  Mat<N, double> edges;
  for (Dim i = 0; i < N; ++i) edges[i] = wide<N, T>(box.axes[i]) * static_cast<double>(box.half_extents[i]);
  return edges;
}

/// The corner that is farthest along `direction` (any nonzero length), in double, with a few roundings. If the
/// direction is at right angles to an axis, the lower end of that axis.
template <Dim N, class T>
Vec<N, double> support(const Obb<N, T>& box, const std::type_identity_t<Vec<N, double>>& direction) {
  Vec<N, double> corner = wide<N, T>(box.center);
  const Mat<N, double> edges = half_edges(box);
  for (Dim i = 0; i < N; ++i) corner += dot(edges[i], direction) > 0 ? edges[i] : -edges[i];
  return corner;
}

/// The oriented box that equals an axis-aligned one, up to the rounding of its center and half extents.
template <Dim N, class T>
Obb<N, double> oriented(const Aabb<N, T>& box) {
  const Vec<N, double> min = wide<N, T>(box.min);
  const Vec<N, double> max = wide<N, T>(box.max);
  return {min * 0.5 + max * 0.5, max * 0.5 - min * 0.5, Mat<N, double>(1.0)};
}

/// A rigidly transformed axis-aligned box, which is an oriented one. Center and half extents are rounded to T. To only
/// move a box, use `translated`, which keeps it axis-aligned.
template <Dim N, class T>
Obb<N, T> transformed(const Aabb<N, T>& box, const Pose<N, T>& pose) {
  const Obb<N, double> upright = oriented(box);
  return transformed(Obb<N, T>{Vec<N, T>(upright.center), Vec<N, T>(upright.half_extents), Mat<N, T>(T(1))}, pose);
}

}  // namespace graze
