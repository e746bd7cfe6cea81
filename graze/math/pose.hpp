// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <graze/math/vec.hpp>

namespace graze {

/// A rigid motion: x goes to rotation * x + position. Default: the identity.
template <Dim N, class T = float>
struct Pose {
  Mat<N, T> rotation = Mat<N, T>(T(1));
  Vec<N, T> position = Vec<N, T>(T(0));
};

/// The image of a point. Calculated in double, rounded once.
template <Dim N, class T>
Vec<N, T> transformed(const Vec<N, T>& point, const Pose<N, T>& pose) {
  return Vec<N, T>(wide_matrix<N, T>(pose.rotation) * wide<N, T>(point) + wide<N, T>(pose.position));
}

/// The image of a direction: turned, not moved.
template <Dim N, class T>
Vec<N, T> rotated(const Vec<N, T>& direction, const Pose<N, T>& pose) {
  return Vec<N, T>(wide_matrix<N, T>(pose.rotation) * wide<N, T>(direction));
}

/// The image of a frame of axes (columns): turned, not moved.
template <Dim N, class T>
Mat<N, T> rotated(const Mat<N, T>& axes, const Pose<N, T>& pose) {
  Mat<N, T> result;
  for (Dim j = 0; j < N; ++j) result[j] = rotated<N, T>(axes[j], pose);
  return result;
}

namespace detail {

/// Cosine (x) and sine (y) of an angle of at most a quarter of pi, by their power series: std::cos and std::sin differ
/// in the last bit from one C library to the next, and with them would all answers about what is turned. What is left
/// out of the series is below 1e-19; the error is less than one ulp.
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

}  // namespace detail

/// Cosine (x) and sine (y) of an angle in degrees; exact at the multiples of 90, and the same on every machine. The
/// angle must be finite.
inline Vec<2, double> cosine_sine_of_degrees(double degrees) {
  constexpr double radians_per_degree = 3.14159265358979323846 / 180;
  const double turn = std::fmod(degrees, 360.0);
  const double quarters = std::nearbyint(turn / 90.0);
  const double rest = (turn - 90.0 * quarters) * radians_per_degree;
  const Vec<2, double> first = detail::cosine_sine_of_small(rest);
  switch ((static_cast<int>(quarters) + 4) % 4) {
    case 0:
      return first;
    case 1:
      return {-first.y, first.x};
    case 2:
      return -first;
    default:
      return {first.y, -first.x};
  }
}

/// The turn of the plane by `degrees`, counter-clockwise when y points up; exact for multiples of 90.
inline Mat<2, double> rotation_matrix(double degrees) {
  const Vec<2, double> turn = cosine_sine_of_degrees(degrees);
  return Mat<2, double>(turn, perpendicular(turn));
}

/// The turn of space about `axis` (any length but zero) by `degrees`, right-handed. Rodrigues' formula.
inline Mat<3, double> rotation_matrix(const Vec<3, double>& axis, double degrees) {
  const Vec<2, double> turn = cosine_sine_of_degrees(degrees);
  const Vec<3, double> unit = axis / std::sqrt(dot(axis, axis));
  Mat<3, double> result;
  for (Dim j = 0; j < 3; ++j) {
    const Vec<3, double> column = unit_axis<3>(j);
    result[j] = turn.x * column + turn.y * cross(unit, column) + (1 - turn.x) * unit[j] * unit;
  }
  return result;
}

}  // namespace graze
