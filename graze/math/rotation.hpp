// SPDX-License-Identifier: MIT
/// @file
/// Angles and rotations, calculated only with operations that every machine rounds identically: std::cos and std::sin
/// differ in the last bit between C libraries, and so would every result about rotated shapes.
#pragma once

#include <cmath>
#include <concepts>
#include <numbers>
#include <stdexcept>
#include <type_traits>

#include <graze/math/platform/throw.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>

namespace graze {

/// A rotation as a number or vector. In 2D an angle in radians, counter-clockwise when y points up; in 3D a vector
/// along the axis whose length is the angle, right-handed.
template <Dim N, class T = float>
using Turn = std::conditional_t<N == 2, T, Vec<N, T>>;

/// A quaternion type of any library; w is the real part. glm::quat qualifies, and so does a vector of four.
template <class Q>
concept Quaternion = requires(const Q& q) {
  { static_cast<double>(q.x) } -> std::same_as<double>;
  { static_cast<double>(q.y) } -> std::same_as<double>;
  { static_cast<double>(q.z) } -> std::same_as<double>;
  { static_cast<double>(q.w) } -> std::same_as<double>;
};

namespace detail {

/// Cosine (x) and sine (y) of an angle of at most a quarter of pi, by their power series. The truncated terms are below
/// 1e-19; the error is below one ulp.
inline Vec<2, double> cosine_sine_of_small(double radians) {
  const double square = radians * radians;
  double sine = 0;    // (sin(x) - x) / x, from its last term on
  double cosine = 0;  // cos(x) - 1 + x^2 / 2, likewise
  for (int n = 18; n >= 2; n -= 2) sine = -square / (n * (n + 1)) * (1 + sine);
  for (int n = 18; n >= 4; n -= 2) cosine = -square / ((n - 1) * n) * (1 + cosine);
  const double half = 0.5 * square;
  const double near = 1 - half;
  return {near + ((1 - near) - half - half * cosine), radians + radians * sine};
}

/// `turn` rotated by a whole number of quarter turns.
inline Vec<2, double> turned_by_quarters(const Vec<2, double>& turn, double quarters) {
  if (quarters == 0) return turn;  // the usual case
  switch ((static_cast<int>(std::fmod(quarters, 4.0)) + 4) % 4) {
    case 0:
      return turn;
    case 1:
      return {-turn.y, turn.x};
    case 2:
      return -turn;
    default:
      return {turn.y, -turn.x};
  }
}

/// The unit vector along any vector but zero.
inline Vec<3, double> unit_of(const Vec<3, double>& axis) {
  const Vec<3, double> direction = of_moderate_size(axis);
  return direction / std::sqrt(dot(direction, direction));
}

/// Rodrigues' formula, for an axis of length 1 and the cosine (x) and sine (y) of the angle.
inline Mat<3, double> rotation_about(const Vec<3, double>& unit, const Vec<2, double>& turn) {
  Mat<3, double> result;
  for (Dim j = 0; j < 3; ++j) {
    const Vec<3, double> column = unit_axis<3>(j);
    result[j] = turn.x * column + turn.y * cross(unit, column) + (1 - turn.x) * unit[j] * unit;
  }
  return result;
}

}  // namespace detail

/// Cosine (x) and sine (y) of an angle in radians. The angle must be finite. The error is at most two epsilon up to a
/// million radians; above, it is the change caused by half an ulp of the angle.
inline Vec<2, double> cosine_sine(double radians) {
  if (std::fabs(radians) > 1e6) radians = std::remainder(radians, 2 * std::numbers::pi);
  constexpr double quarter = 0x1.921fb54400000p+0;        // of pi * 2: 33 bits, so that products with it are exact
  constexpr double quarter_rest = 0x1.0b4611a626331p-34;  // what they leave of it
  const double quarters = std::nearbyint(radians / (quarter + quarter_rest));
  const double rest = (radians - quarters * quarter) - quarters * quarter_rest;
  return detail::turned_by_quarters(detail::cosine_sine_of_small(rest), quarters);
}

/// Cosine (x) and sine (y) of an angle in degrees, which must be finite. Exact at multiples of 90.
inline Vec<2, double> cosine_sine_of_degrees(double degrees) {
  constexpr double radians_per_degree = std::numbers::pi / 180;
  const double turn = std::fmod(degrees, 360.0);
  const double quarters = std::nearbyint(turn / 90.0);
  const double rest = (turn - 90.0 * quarters) * radians_per_degree;
  return detail::turned_by_quarters(detail::cosine_sine_of_small(rest), quarters);
}

/// The 2D rotation by `degrees`, counter-clockwise when y points up. Exact at multiples of 90.
inline Mat<2, double> rotation_matrix(double degrees) {
  const Vec<2, double> turn = cosine_sine_of_degrees(degrees);
  return Mat<2, double>(turn, perpendicular(turn));
}

/// The 3D rotation about `axis`, of any nonzero length, by `degrees`, right-handed.
inline Mat<3, double> rotation_matrix(const Vec<3, double>& axis, double degrees) {
  return detail::rotation_about(detail::unit_of(axis), cosine_sine_of_degrees(degrees));
}

/// The matrix of a 2D rotation by an angle in radians.
inline Mat<2, double> rotation_of(double turn) {
  const Vec<2, double> by = cosine_sine(turn);
  return Mat<2, double>(by, perpendicular(by));
}

/// The matrix of a 3D rotation. Zero gives the identity.
inline Mat<3, double> rotation_of(const Vec<3, double>& turn) {
  const double angle = std::sqrt(dot(turn, turn));
  return angle == 0 ? Mat<3, double>(1.0) : detail::rotation_about(turn / angle, cosine_sine(angle));
}

/// The 3D rotation about `axis` by an angle in radians, right-handed; orthonormal to a few epsilon. The axis may have
/// any nonzero length. Throws std::invalid_argument if the axis is zero or a number is not finite.
inline Mat<3, double> rotation_from_axis_angle(const Vec<3, double>& axis, double radians) {
  if (!is_finite(axis))
    GRAZE_THROW(std::invalid_argument("rotation_from_axis_angle: the axis has a coordinate that is not finite"));
  if (axis == Vec<3, double>(0.0))
    GRAZE_THROW(std::invalid_argument("rotation_from_axis_angle: the axis is zero and has no direction"));
  if (!std::isfinite(radians)) GRAZE_THROW(std::invalid_argument("rotation_from_axis_angle: the angle is not finite"));
  return detail::rotation_about(detail::unit_of(axis), cosine_sine(radians));
}

/// The 2D rotation by an angle in radians, counter-clockwise when y points up. Throws std::invalid_argument if the
/// angle is not finite.
inline Mat<2, double> rotation_from_angle(double radians) {
  if (!std::isfinite(radians)) GRAZE_THROW(std::invalid_argument("rotation_from_angle: the angle is not finite"));
  return rotation_of(radians);
}

/// The 3D rotation of a quaternion, orthonormal to a few epsilon. The quaternion's length and sign do not matter.
/// Throws std::invalid_argument if the quaternion is zero or a number is not finite.
template <Quaternion Q>
Mat<3, double> rotation_from_quaternion(const Q& quaternion) {
  Vec<3, double> v(static_cast<double>(quaternion.x), static_cast<double>(quaternion.y),
                   static_cast<double>(quaternion.z));
  double w = static_cast<double>(quaternion.w);
  if (!is_finite(v) || !std::isfinite(w)) {
    GRAZE_THROW(std::invalid_argument("rotation_from_quaternion: the quaternion has a number that is not finite"));
  }
  const double scale = scale_to_moderate(std::fmax(max_abs(v), std::fabs(w)));
  v *= scale;
  w *= scale;
  const double square = dot(v, v) + w * w;
  if (square == 0) GRAZE_THROW(std::invalid_argument("rotation_from_quaternion: the quaternion is zero"));
  Mat<3, double> result;
  for (Dim j = 0; j < 3; ++j) {
    // Rodrigues' formula for the half angle: x + 2 (v x (v x x) + w v x x) / |q|^2
    const Vec<3, double> across = cross(v, unit_axis<3>(j));
    result[j] = unit_axis<3>(j) + (2 / square) * (cross(v, across) + w * across);
  }
  return result;
}

/// The deviation of a matrix' columns from orthonormal: the largest |dot(column i, column j) - (i == j)|.
template <Dim N, class T>
double orthonormal_error(const Mat<N, T>& axes) {
  double error = 0;
  for (Dim i = 0; i < N; ++i) {
    for (Dim j = i; j < N; ++j) {
      const double deviation = std::fabs(dot(wide<N, T>(axes[i]), wide<N, T>(axes[j])) - (i == j ? 1.0 : 0.0));
      if (!(deviation <= error)) error = deviation;
    }
  }
  return error;
}

}  // namespace graze
