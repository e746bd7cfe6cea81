// SPDX-License-Identifier: MIT
#pragma once

#include <graze/math/rotation.hpp>
#include <graze/math/vec.hpp>

namespace graze {

/// A rigid transform: maps x to rotation * x + position. Default: the identity.
template <Dim N, class T = float>
struct Pose {
  Mat<N, T> rotation = Mat<N, T>(T(1));  ///< Orthonormal columns; not checked or restored here.
  Vec<N, T> position = Vec<N, T>(T(0));  ///< Image of the origin.

  /// Rotates by an angle in radians, counter-clockwise when y points up, then translates. Throws std::invalid_argument
  /// if the angle is not finite.
  static Pose from_angle(const Vec<N, T>& position, double radians) requires(N == 2) {
    return {Mat<N, T>(rotation_from_angle(radians)), position};
  }

  /// Rotates right-handed about an axis of any nonzero length by an angle in radians, then translates. Throws
  /// std::invalid_argument if the axis is zero or a number is not finite.
  static Pose from_axis_angle(const Vec<N, T>& position, const Vec<N, T>& axis, double radians) requires(N == 3) {
    return {Mat<N, T>(rotation_from_axis_angle(wide<N, T>(axis), radians)), position};
  }

  /// Rotates by a quaternion of any nonzero length, then translates. Throws std::invalid_argument if the quaternion is
  /// zero or a number is not finite.
  template <Quaternion Q>
  static Pose from_quaternion(const Vec<N, T>& position, const Q& quaternion) requires(N == 3) {
    return {Mat<N, T>(rotation_from_quaternion(quaternion)), position};
  }
};

/// The image of a point. Calculated in double and rounded once.
template <Dim N, class T>
Vec<N, T> transformed(const Vec<N, T>& point, const Pose<N, T>& pose) {
  return Vec<N, T>(wide_matrix<N, T>(pose.rotation) * wide<N, T>(point) + wide<N, T>(pose.position));
}

/// The image of a direction: rotated, not translated.
template <Dim N, class T>
Vec<N, T> rotated(const Vec<N, T>& direction, const Pose<N, T>& pose) {
  return Vec<N, T>(wide_matrix<N, T>(pose.rotation) * wide<N, T>(direction));
}

/// The image of a frame of axes (columns): rotated, not translated.
template <Dim N, class T>
Mat<N, T> rotated(const Mat<N, T>& axes, const Pose<N, T>& pose) {
  Mat<N, T> result;
  for (Dim j = 0; j < N; ++j) result[j] = rotated<N, T>(axes[j], pose);
  return result;
}

}  // namespace graze
