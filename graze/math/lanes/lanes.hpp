// SPDX-License-Identifier: MIT
// Vectors of four floats, and three numbers in double two at a time, for the filters that settle most questions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <type_traits>

#include <graze/math/platform/bit_cast.hpp>
#include <graze/math/platform/has_lanes.hpp>
#include <graze/math/vec.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// Four numbers that are calculated with at once.
using Lanes = float __attribute__((vector_size(16)));
using LaneBits = int __attribute__((vector_size(16)));

/// Four numbers in a row, wherever they are.
[[gnu::always_inline]] inline Lanes four_at(const float* numbers) {
  Lanes lanes;
  std::memcpy(&lanes, numbers, sizeof lanes);
  return lanes;
}

/// Four in a row of the floats that a shape is made of, from one of them on.
template <class S>
[[gnu::always_inline]] inline Lanes four_of(const S& shape, std::size_t first) {
  static_assert(std::is_trivially_copyable_v<S> && sizeof(S) % sizeof(float) == 0);
  Lanes lanes;
  std::memcpy(&lanes, reinterpret_cast<const char*>(&shape) + first * sizeof(float), sizeof(lanes));
  return lanes;
}

template <int first, int second, int third>
[[gnu::always_inline]] inline Lanes arranged(Lanes v) {
  return __builtin_shufflevector(v, v, first, second, third, 3);
}
/// (y, z, x) of (x, y, z): a cross product is made of it and the next.
[[gnu::always_inline]] inline Lanes turned(Lanes v) { return arranged<1, 2, 0>(v); }
[[gnu::always_inline]] inline Lanes turned_back(Lanes v) { return arranged<2, 0, 1>(v); }

[[gnu::always_inline]] inline Lanes magnitude(Lanes v) {
  constexpr int all_but_sign = std::numeric_limits<int>::max();
  return bit_cast<Lanes>(bit_cast<LaneBits>(v) & all_but_sign);
}
/// Of a number and one that is NaN, the second that was given.
[[gnu::always_inline]] inline Lanes larger(Lanes a, Lanes b) { return a > b ? a : b; }
[[gnu::always_inline]] inline Lanes smaller(Lanes a, Lanes b) { return a < b ? a : b; }
[[gnu::always_inline]] inline float sum_of_three(Lanes v) { return v[0] + v[1] + v[2]; }
[[gnu::always_inline]] inline float largest_of_three(Lanes v) { return std::max(v[0], std::max(v[1], v[2])); }
[[gnu::always_inline]] inline float smallest_of_three(Lanes v) { return std::min(v[0], std::min(v[1], v[2])); }

/// The largest of the first three numbers of `a` as lane 0, of `b` as lane 1. A NaN counts as nothing, and so may what
/// stands before it.
[[gnu::always_inline]] inline Lanes largest_of_both(Lanes a, Lanes b) {
  const Lanes low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
  const Lanes high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  return larger(larger(low, __builtin_shufflevector(low, low, 2, 3, 2, 3)), high);
}

/// Three columns of three numbers, or their rows.
struct LaneMatrix {
  Lanes column[3];
};

/// The rows of a matrix whose columns are given.
[[gnu::always_inline]] inline LaneMatrix transposed(const LaneMatrix& m) {
  const Lanes low = __builtin_shufflevector(m.column[0], m.column[1], 0, 4, 1, 5);   // x0 x1 y0 y1
  const Lanes high = __builtin_shufflevector(m.column[0], m.column[1], 2, 6, 3, 7);  // z0 z1 . .
  return {__builtin_shufflevector(low, m.column[2], 0, 1, 4, 7), __builtin_shufflevector(low, m.column[2], 2, 3, 5, 7),
          __builtin_shufflevector(high, m.column[2], 0, 1, 6, 7)};
}

[[gnu::always_inline]] inline LaneMatrix magnitude(const LaneMatrix& m) {
  return {magnitude(m.column[0]), magnitude(m.column[1]), magnitude(m.column[2])};
}

/// The sum of the columns, each times its number of `factors`.
[[gnu::always_inline]] inline Lanes combined(const LaneMatrix& m, Lanes factors) {
  return m.column[0] * factors[0] + m.column[1] * factors[1] + m.column[2] * factors[2];
}

/// Two numbers in double that are calculated with at once.
using LanePair = double __attribute__((vector_size(16)));
using LanePairBits = long long __attribute__((vector_size(16)));

[[gnu::always_inline]] inline LanePair magnitude(LanePair v) {
  constexpr long long all_but_sign = std::numeric_limits<long long>::max();
  return bit_cast<LanePair>(bit_cast<LanePairBits>(v) & all_but_sign);
}

/// Bit i is set where lane i has its sign set, zero, infinity and NaN among them.
[[gnu::always_inline]] inline unsigned sign_bits(LanePair v) {
#ifdef __SSE2__
  return static_cast<unsigned>(__builtin_ia32_movmskpd(v));
#else
  const LanePairBits bits = bit_cast<LanePairBits>(v) < 0;
  return static_cast<unsigned>((bits[0] & 1) | (bits[1] & 2));
#endif
}

[[gnu::always_inline]] inline unsigned sign_bits(LanePairBits v) { return sign_bits(bit_cast<LanePair>(v)); }

/// The same anywhere in memory.
using LoosePair [[gnu::aligned(8)]] = LanePair;

/// A vector in double, as Vec<3, double> to the bit: two coordinates at once, for compilers rarely see that they might.
/// Without padding, since what is copied with it is read otherwise than it was written, for which the processor waits.
struct PairedVec {
  LoosePair xy;
  double z;

  [[gnu::always_inline]] PairedVec(LanePair first, double last) : xy(first), z(last) {}
  [[gnu::always_inline]] explicit PairedVec(const Vec<3, float>& v)
      : xy{static_cast<double>(v.x), static_cast<double>(v.y)}, z(v.z) {}
  [[gnu::always_inline]] explicit PairedVec(const Vec<3, double>& v) : xy{v.x, v.y}, z(v.z) {}
  [[gnu::always_inline]] explicit PairedVec(Lanes v) : z(v[2]) {
    using Four = double __attribute__((vector_size(32)));  // in two registers
    const Four four = __builtin_convertvector(v, Four);
    xy = __builtin_shufflevector(four, four, 0, 1);
  }

  [[gnu::always_inline]] friend PairedVec operator+(const PairedVec& a, const PairedVec& b) {
    return {a.xy + b.xy, a.z + b.z};
  }
  [[gnu::always_inline]] friend PairedVec operator-(const PairedVec& a, const PairedVec& b) {
    return {a.xy - b.xy, a.z - b.z};
  }
  [[gnu::always_inline]] friend PairedVec operator-(const PairedVec& a) { return {-a.xy, -a.z}; }
  [[gnu::always_inline]] friend PairedVec operator*(const PairedVec& a, double factor) {
    return {a.xy * factor, a.z * factor};
  }
  [[gnu::always_inline]] friend PairedVec operator/(const PairedVec& a, double divisor) {
    return {a.xy / divisor, a.z / divisor};
  }
  [[gnu::always_inline]] friend PairedVec operator/(const PairedVec& a, const PairedVec& b) {
    return {a.xy / b.xy, a.z / b.z};
  }
};

static_assert(sizeof(PairedVec) == 3 * sizeof(double));

/// What has long been in memory, read by two numbers at once; what was just written by one could not be forwarded.
[[gnu::always_inline]] inline PairedVec read_paired(const Vec<3, double>& v) {
  LanePair xy;
  std::memcpy(&xy, &v, sizeof(xy));
  return {xy, v.z};
}

[[gnu::always_inline]] inline double dot(const PairedVec& a, const PairedVec& b) {
  const LanePair product = a.xy * b.xy;
  return product[0] + product[1] + a.z * b.z;
}

[[gnu::always_inline]] inline PairedVec cross(const PairedVec& a, const PairedVec& b) {
  const auto yz = [](const PairedVec& v) { return LanePair{v.xy[1], v.z}; };
  const auto zx = [](const PairedVec& v) { return LanePair{v.z, v.xy[0]}; };
  return {yz(a) * zx(b) - yz(b) * zx(a), a.xy[0] * b.xy[1] - b.xy[0] * a.xy[1]};
}

[[gnu::always_inline]] inline Vec<3, double> plain(const PairedVec& v) { return {v.xy[0], v.xy[1], v.z}; }

/// Never minus zero.
template <class T>
[[gnu::always_inline]] inline Vec<3, T> rounded_vec(const PairedVec& v) {
  const LanePair xy = v.xy;
  if constexpr (sizeof(T) == sizeof(double)) {
    const LanePair positive = xy + 0.0;
    return {positive[0], positive[1], v.z + 0.0};
  } else {
    using Four = double __attribute__((vector_size(32)));  // in two registers
    const Four four = {xy[0], xy[1], v.z, v.z};
    const Lanes positive = __builtin_convertvector(four, Lanes) + 0.0F;
    return {positive[0], positive[1], positive[2]};
  }
}

/// `second` where all bits are set, `first` where none is. Without a branch, which would be guessed wrong every other
/// time.
[[gnu::always_inline]] inline LanePair one_of(LanePair first, LanePair second, LanePairBits takes_second) {
  return bit_cast<LanePair>((bit_cast<LanePairBits>(first) & ~takes_second) |
                            (bit_cast<LanePairBits>(second) & takes_second));
}
[[gnu::always_inline]] inline PairedVec one_of(const PairedVec& first, const PairedVec& second,
                                               LanePairBits takes_second) {
  return {one_of(LanePair(first.xy), LanePair(second.xy), takes_second),
          one_of(LanePair{first.z, first.z}, LanePair{second.z, second.z}, takes_second)[0]};
}

[[gnu::always_inline]] inline PairedVec magnitude(const PairedVec& v) {
  return {magnitude(LanePair(v.xy)), __builtin_fabs(v.z)};
}
[[gnu::always_inline]] inline double sum_of_coordinates(const PairedVec& v) { return v.xy[0] + v.xy[1] + v.z; }

/// A vector in float, and a zero.
[[gnu::always_inline]] inline Lanes narrow(const PairedVec& v) {
  using Four = double __attribute__((vector_size(32)));
  const Four four = {v.xy[0], v.xy[1], v.z, 0};
  return __builtin_convertvector(four, Lanes);
}

/// A number and a vector in float.
[[gnu::always_inline]] inline Lanes narrow(double first, const PairedVec& rest) {
  using Four = double __attribute__((vector_size(32)));
  const Four four = {first, rest.xy[0], rest.xy[1], rest.z};
  return __builtin_convertvector(four, Lanes);
}

}  // namespace graze::detail

#endif
