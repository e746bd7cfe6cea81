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

/// The sign of det(a - o, b - o, c - o) where all coordinates are multiples of 2^-60 of the largest or so, as those of
/// floats mostly are, and of doubles of like sizes; else none. For coordinates that are zero or of magnitude 1e-90 to
/// 1e90.
inline std::optional<int> sign_of_whole_determinant(const std::array<Vec<3, double>, 3>& points,
                                                    const Vec<3, double>& origin) {
  using Whole = std::array<std::int64_t, 3>;
  double largest = max_abs(origin);
  for (const Vec<3, double>& point : points) largest = std::max(largest, max_abs(point));
  const double unit = unit_of_whole(largest);
  if (unit == 0) return std::nullopt;
  bool are_whole = true;
  const auto whole = [&](const Vec<3, double>& point) {
    Whole result{};
    for (Dim i = 0; i < 3; ++i) {
      const double scaled = point[i] * unit;
      const auto number = static_cast<std::int64_t>(scaled);
      are_whole = are_whole && static_cast<double>(number) == scaled;
      result[static_cast<std::size_t>(i)] = number;
    }
    return result;
  };
  const Whole from = whole(origin);
  std::array<Whole, 3> off = {whole(points[0]), whole(points[1]), whole(points[2])};
  if (!are_whole) return std::nullopt;
  for (Whole& row : off) {
    for (std::size_t i = 0; i < 3; ++i) row[i] -= from[i];
  }
  std::array<Int128, 3> minors{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    minors[i] = Int128(off[1][j]) * off[2][k] - Int128(off[1][k]) * off[2][j];
  }
  return sign_of_dot(off[0], minors);
}

#else

inline std::optional<int> sign_of_whole_determinant(const std::array<Vec<3, double>, 3>& /*points*/,
                                                    const Vec<3, double>& /*origin*/) {
  return std::nullopt;
}

#endif

}  // namespace graze::detail
