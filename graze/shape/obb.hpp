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
/// orthonormal up to rounding. The set is taken as stored, without making the axes orthonormal again: what you see is
/// what is tested. Zero half extents are valid.
template <Dim N, class T = float>
struct Obb {
  Vec<N, T> center = Vec<N, T>(T(0));
  Vec<N, T> half_extents = Vec<N, T>(T(1));
  Mat<N, T> axes = Mat<N, T>(T(1));

  /// The box turned about its center by an angle in radians, counter-clockwise when y points up; the axes are
  /// orthonormal to rounding. Throws std::invalid_argument for an angle that is not finite.
  static Obb from_angle(const Vec<N, T>& center, const Vec<N, T>& half_extents, double radians) requires(N == 2) {
    return {center, half_extents, Mat<N, T>(rotation_from_angle(radians))};
  }

  /// The box turned about an axis of any length but zero by an angle in radians, right-handed. Throws
  /// std::invalid_argument for an axis of zero, or numbers that are not finite.
  static Obb from_axis_angle(const Vec<N, T>& center, const Vec<N, T>& half_extents, const Vec<N, T>& axis,
                             double radians) requires(N == 3) {
    return {center, half_extents, Mat<N, T>(rotation_from_axis_angle(wide<N, T>(axis), radians))};
  }

  /// The box turned as a quaternion of any length but zero says. Throws std::invalid_argument for a quaternion of zero,
  /// or numbers that are not finite.
  template <Quaternion Q>
  static Obb from_quaternion(const Vec<N, T>& center, const Vec<N, T>& half_extents,
                             const Q& quaternion) requires(N == 3) {
    return {center, half_extents, Mat<N, T>(rotation_from_quaternion(quaternion))};
  }
};

template <class T = float>
using OrientedRect = Obb<2, T>;

namespace detail {
template <Dim N, class T>
inline constexpr auto description_of<Obb<N, T>> = Description("obb", field::point("center", &Obb<N, T>::center),
                                                              field::half_extents("half_extents",
                                                                                  &Obb<N, T>::half_extents),
                                                              field::axes("axes", &Obb<N, T>::axes));
}  // namespace detail

/// The vectors from the center to the middles of the faces: column i is axes[i] * half_extents[i].
template <Dim N, class T>
Mat<N, double> half_edges(const Obb<N, T>& box) {
  Mat<N, double> edges;
  for (Dim i = 0; i < N; ++i) edges[i] = wide<N, T>(box.axes[i]) * static_cast<double>(box.half_extents[i]);
  return edges;
}

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

/// An axis-aligned box that is turned becomes an oriented one.
template <Dim N, class T>
Obb<N, T> transformed(const Aabb<N, T>& box, const Pose<N, T>& pose) {
  const Obb<N, double> upright = oriented(box);
  return transformed(Obb<N, T>{Vec<N, T>(upright.center), Vec<N, T>(upright.half_extents), Mat<N, T>(T(1))}, pose);
}

}  // namespace graze
