// SPDX-License-Identifier: MIT
// The sign of a determinant of differences in whole numbers, of which few bits are more than doubles have.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <graze/math/bit_cast.hpp>
#include <graze/math/vec.hpp>

// Without integers of 128 bits nothing is whole, and all else has to tell signs.
#ifdef __SIZEOF_INT128__
#define GRAZE_HAS_INT128
#endif

namespace graze::detail {

#ifdef GRAZE_HAS_INT128

__extension__ using Int128 = __int128;

/// A power of two times which all coordinates of some points are below 2^61; zero where they are beyond 1e90 or all are
/// below 1e-90.
inline double unit_of_whole(double largest) {
  constexpr int exponent_of_one = 1023;
  constexpr int bits = 60;
  constexpr int most = 300;
  const int exponent = static_cast<int>(bit_cast<std::uint64_t>(largest) >> 52U) - exponent_of_one;
  if (exponent < -most || exponent > most) return 0;
  return bit_cast<double>(static_cast<std::uint64_t>(exponent_of_one + bits - exponent) << 52U);
}

/// The sum of three numbers of up to 62 bits, each times one of up to 125 bits: its sign.
inline int sign_of_dot(const std::array<std::int64_t, 3>& a, const std::array<Int128, 3>& m) {
  Int128 high = 0;  // in units of 2^64
  Int128 low = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Int128 product = Int128(a[i]) * Int128(static_cast<std::uint64_t>(m[i]));
    high += Int128(a[i]) * (m[i] >> 64U) + (product >> 64U);
    low += Int128(static_cast<std::uint64_t>(product));
  }
  high += low >> 64U;
  if (high != 0) return high > 0 ? 1 : -1;
  return static_cast<std::uint64_t>(low) != 0 ? 1 : 0;
}

using WholeVec = std::array<std::int64_t, 3>;

/// A point in such units; false if it is between whole numbers, or beyond 2^61.
inline bool make_whole(const Vec<3, double>& point, double unit, WholeVec& whole) {
  constexpr double end = 0x1p61;
  bool is_whole = true;
  for (Dim i = 0; i < 3; ++i) {
    const double scaled = point[i] * unit;
    const auto number = static_cast<std::int64_t>(std::fabs(scaled) < end ? scaled : end);
    is_whole = is_whole && static_cast<double>(number) == scaled;
    whole[static_cast<std::size_t>(i)] = number;
  }
  return is_whole;
}

inline WholeVec difference(const WholeVec& a, const WholeVec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// Of numbers of up to 62 bits.
inline std::array<Int128, 3> whole_cross(const WholeVec& a, const WholeVec& b) {
  std::array<Int128, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    result[i] = Int128(a[j]) * b[k] - Int128(a[k]) * b[j];
  }
  return result;
}

/// The sign of det(a - o, b - o, c - o) where all coordinates are multiples of 2^-60 of the largest or so, as those of
/// floats mostly are, and of doubles of like sizes; else none. For coordinates that are zero or of magnitude 1e-90 to
/// 1e90.
inline std::optional<int> sign_of_whole_determinant(const std::array<Vec<3, double>, 3>& points,
                                                    const Vec<3, double>& origin) {
  double largest = max_abs(origin);
  for (const Vec<3, double>& point : points) largest = std::max(largest, max_abs(point));
  const double unit = unit_of_whole(largest);
  if (unit == 0) return std::nullopt;
  WholeVec from{};
  std::array<WholeVec, 3> at{};
  bool are_whole = make_whole(origin, unit, from);
  for (std::size_t i = 0; i < 3; ++i) are_whole = make_whole(points[i], unit, at[i]) && are_whole;
  if (!are_whole) return std::nullopt;
  return sign_of_dot(difference(at[0], from), whole_cross(difference(at[1], from), difference(at[2], from)));
}

/// The plane through three points in whole numbers, calculated once for many points beside it.
class WholePlane {
 public:
  /// Of coordinates that are whole numbers below 2^61 once multiplied by `unit`, a power of two; of others, and by
  /// zero, nothing is told.
  WholePlane(const std::array<Vec<3, double>, 3>& points, double unit) : unit_(unit), is_whole_(unit != 0) {
    std::array<WholeVec, 3> at{};
    for (std::size_t i = 0; i < 3; ++i) is_whole_ = make_whole(points[i], unit, at[i]) && is_whole_;
    from_ = at[0];
    if (is_whole_) normal_ = whole_cross(difference(at[1], at[0]), difference(at[2], at[0]));
  }

  /// As `orientation` of the three points and this one: exactly, or none.
  std::optional<int> side_of(const Vec<3, double>& point) const {
    WholeVec at{};
    if (!is_whole_ || !make_whole(point, unit_, at)) return std::nullopt;
    return sign_of_dot(difference(at, from_), normal_);
  }

 private:
  double unit_;
  bool is_whole_;
  WholeVec from_{};
  std::array<Int128, 3> normal_{};
};

#else

inline std::optional<int> sign_of_whole_determinant(const std::array<Vec<3, double>, 3>& /*points*/,
                                                    const Vec<3, double>& /*origin*/) {
  return std::nullopt;
}

class WholePlane {
 public:
  WholePlane(const std::array<Vec<3, double>, 3>& /*points*/, double /*unit*/) {}

  std::optional<int> side_of(const Vec<3, double>& /*point*/) const { return std::nullopt; }
};

inline double unit_of_whole(double /*largest*/) { return 0; }

#endif

}  // namespace graze::detail
