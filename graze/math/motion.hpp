// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <graze/math/pose.hpp>
#include <graze/math/rotation.hpp>
#include <graze/math/vec.hpp>

namespace graze {

/// A rigid motion at constant linear and angular velocity from t = 0 to t = 1: the center moves in a straight line, and
/// the body rotates about it. Default: no motion.
template <Dim N, class T = float>
struct Motion {
  Vec<N, T> linear = Vec<N, T>(T(0));  ///< Displacement of the center from t = 0 to t = 1.
  Turn<N, T> angular = Turn<N, T>(0);  ///< Total rotation from t = 0 to t = 1; may exceed a full turn.
  Vec<N, T> center = Vec<N, T>(T(0));  ///< Center of rotation at t = 0.
};

/// True if no number is infinite or NaN.
template <Dim N, class T>
bool is_finite(const Motion<N, T>& motion) {
  if constexpr (N == 2) {
    return is_finite(motion.linear) && is_finite(motion.center) && std::isfinite(motion.angular);
  } else {
    return is_finite(motion.linear) && is_finite(motion.center) && is_finite(motion.angular);
  }
}

/// The pose at time t, in double: a point that was at x at t = 0 is at rotation * x + position at t.
template <Dim N, class T>
Pose<N, double> pose_at(const Motion<N, T>& motion, double t) {
  const Mat<N, double> rotation = rotation_of(Turn<N, double>(motion.angular) * t);
  const Vec<N, double> center = wide<N, T>(motion.center);
  return {rotation, center + wide<N, T>(motion.linear) * t - rotation * center};
}

namespace detail {

inline double turn_of(const Mat<2, double>& rotation) {
  return std::atan2(rotation[0].y - rotation[1].x, rotation[0].x + rotation[1].y);
}

/// With R = cos + sin [n x] + (1 - cos) n n^T, the skew part of R is sin n, which vanishes for half turns. From a
/// quarter turn on, the axis is taken from the largest column of the symmetric part, which does not vanish.
inline Vec<3, double> turn_of(const Mat<3, double>& rotation) {
  const Mat<3, double>& r = rotation;
  const Vec<3, double> orthonormality_error(r[1].z - r[2].y, r[2].x - r[0].z, r[0].y - r[1].x);  // 2 sin n
  const double twice_sine = std::sqrt(dot(orthonormality_error, orthonormality_error));
  const double twice_cosine = r[0].x + r[1].y + r[2].z - 1;
  const double angle = std::atan2(twice_sine, twice_cosine);
  if (twice_cosine > 0) return twice_sine > 0 ? orthonormality_error * (angle / twice_sine) : Vec<3, double>(0.0);
  Vec<3, double> axis(0.0);
  for (Dim j = 0; j < 3; ++j) {
    const Vec<3, double> row(r[0][j], r[1][j], r[2][j]);
    Vec<3, double> column = (r[j] + row) * 0.5;
    column[j] -= twice_cosine * 0.5;
    if (dot(column, column) > dot(axis, axis)) axis = column;
  }
  axis /= std::sqrt(dot(axis, axis));  // length at least (1 - cos) / sqrt 3
  return axis * (dot(axis, orthonormality_error) < 0 ? -angle : angle);
}

}  // namespace detail

/// The motion that takes a body from `start` to `end`: its origin moves in a straight line, and it rotates the shorter
/// way, by at most half a turn. Queries expect the shapes as they are at `start`, that is transformed(shape, start).
/// The rotations must be orthonormal up to rounding; the motion then ends at `end` up to rounding.
template <Dim N, class T>
Motion<N, T> motion_between(const Pose<N, T>& start, const Pose<N, T>& end) {
  const Mat<N, double> turned = wide_matrix<N, T>(end.rotation) * transpose(wide_matrix<N, T>(start.rotation));
  return {Vec<N, T>(wide<N, T>(end.position) - wide<N, T>(start.position)), Turn<N, T>(detail::turn_of(turned)),
          start.position};
}

}  // namespace graze
