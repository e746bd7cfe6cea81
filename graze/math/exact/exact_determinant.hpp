// SPDX-License-Identifier: MIT
// The exact sign of a determinant of differences, in 128-bit integers. Intermediate results have few more bits than
// doubles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <graze/math/platform/bit_cast.hpp>
#include <graze/math/vec.hpp>

// Without 128-bit integers, these functions return nothing and callers use their other methods.
#ifdef __SIZEOF_INT128__
#define GRAZE_HAS_INT128
#endif

namespace graze::detail {

#ifdef GRAZE_HAS_INT128

__extension__ using Int128 = __int128;

/// A power of two that scales all coordinates of some points below 2^61; zero if some are beyond 1e90 or all are below
/// 1e-90.
inline double integer_unit(double largest) {
  constexpr int exponent_of_one = 1023;
  constexpr int bits = 60;
  constexpr int most = 300;
  const int exponent = static_cast<int>(bit_cast<std::uint64_t>(largest) >> 52U) - exponent_of_one;
  if (exponent < -most || exponent > most) return 0;
  return bit_cast<double>(static_cast<std::uint64_t>(exponent_of_one + bits - exponent) << 52U);
}

using IntegerVec = std::array<std::int64_t, 3>;

/// Integers of up to 125 bits, split into halves: high * 2^64 + low.
struct HalvedVec {
  std::array<std::int64_t, 3> high{};
  std::array<std::uint64_t, 3> low{};
};

/// The rounded number, with the same sign. The built-in conversion is a library call.
inline double rough(Int128 number) {
  const auto low = static_cast<std::int64_t>(number);
  if (number == low) return static_cast<double>(low);
  return static_cast<double>(static_cast<std::int64_t>(number >> 64U)) * 0x1p64 +
         static_cast<double>(static_cast<std::uint64_t>(number));
}

/// The dot product of numbers of up to 62 bits and numbers of up to 125 bits, in units of 2^64. The sign is exact and
/// the size is approximate; results below one unit are returned as 0.5.
inline double approximate_dot(const IntegerVec& a, const HalvedVec& m) {
  Int128 high = 0;
  for (std::size_t i = 0; i < 3; ++i) high += Int128(a[i]) * m.high[i];
  // The low halves add up to less than 3 * 2^62 of these units.
  constexpr Int128 most_of_low = Int128{3} << 62U;
  if (high > most_of_low || high < -most_of_low) return rough(high);
  Int128 low = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Int128 product = Int128(a[i]) * m.low[i];
    high += product >> 64U;
    low += static_cast<std::uint64_t>(product);
  }
  high += low >> 64U;
  if (high != 0) return rough(high);
  return static_cast<std::uint64_t>(low) != 0 ? 0.5 : 0;
}

inline int ternary_sign(double number) { return number > 0 ? 1 : (number < 0 ? -1 : 0); }

/// A point in integer units. `is_integer` is false if a coordinate is not an integer or not below 2^61.
struct IntegerPoint {
  IntegerVec at{};
  bool is_integer = true;

  IntegerPoint(const Vec<3, double>& point, double unit) {
    constexpr double end = 0x1p61;
    for (Dim i = 0; i < 3; ++i) {
      const double scaled = point[i] * unit;
      const bool is_in_range = std::fabs(scaled) < end;
      const auto number = static_cast<std::int64_t>(is_in_range ? scaled : 0);
      is_integer = is_integer && is_in_range && static_cast<double>(number) == scaled;
      at[static_cast<std::size_t>(i)] = number;
    }
  }
};

inline IntegerVec difference(const IntegerVec& a, const IntegerVec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// The cross product of numbers of up to 62 bits.
inline HalvedVec integer_cross(const IntegerVec& a, const IntegerVec& b) {
  HalvedVec result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const Int128 number = Int128(a[j]) * b[k] - Int128(a[k]) * b[j];
    result.high[i] = static_cast<std::int64_t>(number >> 64U);
    result.low[i] = static_cast<std::uint64_t>(number);
  }
  return result;
}

/// The sign of det(a - o, b - o, c - o) if all coordinates are multiples of about 2^-60 of the largest; none otherwise.
/// This holds for most floats, and for doubles of similar sizes. Coordinates must be zero or have a magnitude from
/// 1e-90 to 1e90.
inline std::optional<int> sign_of_exact_determinant(const std::array<Vec<3, double>, 3>& points,
                                                    const Vec<3, double>& origin) {
  double largest = max_abs(origin);
  for (const Vec<3, double>& point : points) largest = std::max(largest, max_abs(point));
  const double unit = integer_unit(largest);
  if (unit == 0) return std::nullopt;
  const IntegerPoint from(origin, unit);
  const std::array<IntegerPoint, 3> at = {IntegerPoint(points[0], unit), IntegerPoint(points[1], unit),
                                          IntegerPoint(points[2], unit)};
  if (!from.is_integer || !at[0].is_integer || !at[1].is_integer || !at[2].is_integer) return std::nullopt;
  const auto way = [&](std::size_t i) { return difference(at[i].at, from.at); };
  return ternary_sign(approximate_dot(way(0), integer_cross(way(1), way(2))));
}

/// The plane through three points in integer units, calculated once to test many points.
class IntegerPlane {
 public:
  /// `unit` must scale coordinates to integers below 2^61. If it is zero or a point is not whole, `height_of` returns
  /// none.
  IntegerPlane(const std::array<IntegerPoint, 3>& points, double unit)
      : is_whole_(unit != 0 && points[0].is_integer && points[1].is_integer && points[2].is_integer),
        from_(points[0].at) {
    if (is_whole_) normal_ = integer_cross(difference(points[1].at, from_), difference(points[2].at, from_));
  }

  /// A number with the exact sign of `orientation` of the three points and this one, approximately proportional to the
  /// height of the point above the plane; or none.
  std::optional<double> height_of(const IntegerPoint& point) const {
    if (!is_whole_ || !point.is_integer) return std::nullopt;
    return approximate_dot(difference(point.at, from_), normal_);
  }

 private:
  bool is_whole_;
  IntegerVec from_{};
  HalvedVec normal_;
};

#else

inline std::optional<int> sign_of_exact_determinant(const std::array<Vec<3, double>, 3>& /*points*/,
                                                    const Vec<3, double>& /*origin*/) {
  return std::nullopt;
}

struct IntegerPoint {
  IntegerPoint(const Vec<3, double>& /*point*/, double /*unit*/) {}
};

class IntegerPlane {
 public:
  IntegerPlane(const std::array<IntegerPoint, 3>& /*points*/, double /*unit*/) {}

  std::optional<double> height_of(const IntegerPoint& /*point*/) const { return std::nullopt; }
};

inline double integer_unit(double /*largest*/) { return 0; }

#endif

}  // namespace graze::detail
