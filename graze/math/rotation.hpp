// SPDX-License-Identifier: MIT
// Angles and turns with nothing but what every machine rounds alike: std::cos and std::sin differ in the last bit from
// one C library to the next, and with them would all answers about what is turned.
#pragma once

#include <cmath>
#include <numbers>
#include <type_traits>

#include <graze/math/vec.hpp>

namespace graze {

/// How far something turns: in the plane an angle in radians, counter-clockwise when y points up; in space a vector
/// along the axis, as long as the angle, right-handed.
template <Dim N, class T = float>
using Turn = std::conditional_t<N == 2, T, Vec<N, T>>;

namespace detail {

/// Cosine (x) and sine (y) of an angle of at most a quarter of pi, by their power series. What is left out of the
/// series is below 1e-19; the error is less than one ulp.
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

/// Turned on by `quarters` quarter turns, which is a whole number.
inline Vec<2, double> turned_by_quarters(const Vec<2, double>& turn, double quarters) {
  if (quarters == 0) return turn;  // as of most turns
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

/// Cosine (x) and sine (y) of an angle in radians, to two epsilon where it is under a million. The angle must be
/// finite.
inline Vec<2, double> cosine_sine(double radians) {
  constexpr double quarter = 0x1.921fb54400000p+0;        // of pi * 2: 33 bits, so that products with it are exact
  constexpr double quarter_rest = 0x1.0b4611a626331p-34;  // what they leave of it
  const double quarters = std::nearbyint(radians / (quarter + quarter_rest));
  const double rest = (radians - quarters * quarter) - quarters * quarter_rest;
  return detail::turned_by_quarters(detail::cosine_sine_of_small(rest), quarters);
}

/// Cosine (x) and sine (y) of an angle in degrees; exact at the multiples of 90. The angle must be finite.
inline Vec<2, double> cosine_sine_of_degrees(double degrees) {
  constexpr double radians_per_degree = std::numbers::pi / 180;
  const double turn = std::fmod(degrees, 360.0);
  const double quarters = std::nearbyint(turn / 90.0);
  const double rest = (turn - 90.0 * quarters) * radians_per_degree;
  return detail::turned_by_quarters(detail::cosine_sine_of_small(rest), quarters);
}

/// The turn of the plane by `degrees`, counter-clockwise when y points up; exact for multiples of 90.
inline Mat<2, double> rotation_matrix(double degrees) {
  const Vec<2, double> turn = cosine_sine_of_degrees(degrees);
  return Mat<2, double>(turn, perpendicular(turn));
}

/// The turn of space about `axis` (any length but zero) by `degrees`, right-handed.
inline Mat<3, double> rotation_matrix(const Vec<3, double>& axis, double degrees) {
  return detail::rotation_about(axis / std::sqrt(dot(axis, axis)), cosine_sine_of_degrees(degrees));
}

/// A turn as a matrix.
inline Mat<2, double> rotation_of(double turn) {
  const Vec<2, double> by = cosine_sine(turn);
  return Mat<2, double>(by, perpendicular(by));
}

/// The same in space; a turn of zero has no axis and needs none.
inline Mat<3, double> rotation_of(const Vec<3, double>& turn) {
  const double angle = std::sqrt(dot(turn, turn));
  return angle == 0 ? Mat<3, double>(1.0) : detail::rotation_about(turn / angle, cosine_sine(angle));
}

}  // namespace graze
