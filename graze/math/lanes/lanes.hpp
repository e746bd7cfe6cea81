// SPDX-License-Identifier: MIT
// Vectors of four floats, and 3D vectors in double with two coordinates per register, for the filters that settle most
// queries.
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

/// Four floats in one vector register.
using Lanes = float __attribute__((vector_size(16)));
using LaneBits = int __attribute__((vector_size(16)));

/// Loads four consecutive floats, with any alignment.
[[gnu::always_inline]] inline Lanes four_at(const float* numbers) {
  Lanes lanes;
  std::memcpy(&lanes, numbers, sizeof lanes);
  return lanes;
}

/// Loads four consecutive floats of a shape, starting at number `first`.
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
/// Rotates (x, y, z) to (y, z, x). A cross product combines this and `turned_back`.
[[gnu::always_inline]] inline Lanes turned(Lanes v) { return arranged<1, 2, 0>(v); }
[[gnu::always_inline]] inline Lanes turned_back(Lanes v) { return arranged<2, 0, 1>(v); }

[[gnu::always_inline]] inline Lanes magnitude(Lanes v) {
  constexpr int all_but_sign = std::numeric_limits<int>::max();
  return bit_cast<Lanes>(bit_cast<LaneBits>(v) & all_but_sign);
}
/// Returns `b` if either is NaN.
[[gnu::always_inline]] inline Lanes larger(Lanes a, Lanes b) { return a > b ? a : b; }
[[gnu::always_inline]] inline Lanes smaller(Lanes a, Lanes b) { return a < b ? a : b; }
[[gnu::always_inline]] inline float sum_of_three(Lanes v) { return v[0] + v[1] + v[2]; }
[[gnu::always_inline]] inline float largest_of_three(Lanes v) { return std::max(v[0], std::max(v[1], v[2])); }
[[gnu::always_inline]] inline float smallest_of_three(Lanes v) { return std::min(v[0], std::min(v[1], v[2])); }

/// The largest of the first three numbers of `a` in lane 0, of `b` in lane 1. NaNs are ignored, and numbers before a
/// NaN may be.
[[gnu::always_inline]] inline Lanes largest_of_both(Lanes a, Lanes b) {
  const Lanes low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
  const Lanes high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  return larger(larger(low, __builtin_shufflevector(low, low, 2, 3, 2, 3)), high);
}

/// The first three lanes of three columns (or rows) form a 3x3 matrix.
struct LaneMatrix {
  Lanes column[3];
};

[[gnu::always_inline]] inline LaneMatrix transposed(const LaneMatrix& m) {
  const Lanes low = __builtin_shufflevector(m.column[0], m.column[1], 0, 4, 1, 5);   // x0 x1 y0 y1
  const Lanes high = __builtin_shufflevector(m.column[0], m.column[1], 2, 6, 3, 7);  // z0 z1 . .
  return {__builtin_shufflevector(low, m.column[2], 0, 1, 4, 7), __builtin_shufflevector(low, m.column[2], 2, 3, 5, 7),
          __builtin_shufflevector(high, m.column[2], 0, 1, 6, 7)};
}

[[gnu::always_inline]] inline LaneMatrix magnitude(const LaneMatrix& m) {
  return {magnitude(m.column[0]), magnitude(m.column[1]), magnitude(m.column[2])};
}

/// The linear combination of the columns: the product of the matrix and the vector `factors`.
[[gnu::always_inline]] inline Lanes combined(const LaneMatrix& m, Lanes factors) {
  return m.column[0] * factors[0] + m.column[1] * factors[1] + m.column[2] * factors[2];
}

/// Two doubles in one vector register.
using LanePair = double __attribute__((vector_size(16)));
using LanePairBits = long long __attribute__((vector_size(16)));

[[gnu::always_inline]] inline LanePair magnitude(LanePair v) {
  constexpr long long all_but_sign = std::numeric_limits<long long>::max();
  return bit_cast<LanePair>(bit_cast<LanePairBits>(v) & all_but_sign);
}

/// Bit i is the sign bit of lane i, also for zero, infinity and NaN.
[[gnu::always_inline]] inline unsigned sign_bits(LanePair v) {
#ifdef __SSE2__
  return static_cast<unsigned>(__builtin_ia32_movmskpd(v));
#else
  const LanePairBits bits = bit_cast<LanePairBits>(v) < 0;
  return static_cast<unsigned>((bits[0] & 1) | (bits[1] & 2));
#endif
}

[[gnu::always_inline]] inline unsigned sign_bits(LanePairBits v) { return sign_bits(bit_cast<LanePair>(v)); }

/// A LanePair that need not be aligned to 16 bytes.
using LoosePair [[gnu::aligned(8)]] = LanePair;

/// A 3D vector in double with two coordinates per register, bit-identical to Vec<3, double>; compilers rarely vectorise
/// this themselves. It has no padding: a copy that reads with another width than the write stalls on store forwarding.
struct PairedVec {
  LoosePair xy;
  double z;

  [[gnu::always_inline]] PairedVec(LanePair first, double last) : xy(first), z(last) {}
  [[gnu::always_inline]] explicit PairedVec(const Vec<3, float>& v)
      : xy{static_cast<double>(v.x), static_cast<double>(v.y)}, z(v.z) {}
  [[gnu::always_inline]] explicit PairedVec(const Vec<3, double>& v) : xy{v.x, v.y}, z(v.z) {}
  [[gnu::always_inline]] explicit PairedVec(Lanes v) : z(v[2]) {
    using Four = double __attribute__((vector_size(32)));  // two registers
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

/// Loads x and y together. Only for values written long ago: a load of two doubles that were just written separately
/// would stall on store forwarding.
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

/// Rounds to T; adding zero turns -0 into +0.
template <class T>
[[gnu::always_inline]] inline Vec<3, T> rounded_vec(const PairedVec& v) {
  const LanePair xy = v.xy;
  if constexpr (sizeof(T) == sizeof(double)) {
    const LanePair positive = xy + 0.0;
    return {positive[0], positive[1], v.z + 0.0};
  } else {
    using Four = double __attribute__((vector_size(32)));  // two registers
    const Four four = {xy[0], xy[1], v.z, v.z};
    const Lanes positive = __builtin_convertvector(four, Lanes) + 0.0F;
    return {positive[0], positive[1], positive[2]};
  }
}

/// `second` where all bits of the mask are set, `first` where none is. Branch-free, because a branch would be
/// mispredicted half of the time.
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

/// A vector in float, with zero in lane 3.
[[gnu::always_inline]] inline Lanes narrow(const PairedVec& v) {
  using Four = double __attribute__((vector_size(32)));
  const Four four = {v.xy[0], v.xy[1], v.z, 0};
  return __builtin_convertvector(four, Lanes);
}

/// A number in lane 0 and a vector in lanes 1 to 3, in float.
[[gnu::always_inline]] inline Lanes narrow(double first, const PairedVec& rest) {
  using Four = double __attribute__((vector_size(32)));
  const Four four = {first, rest.xy[0], rest.xy[1], rest.z};
  return __builtin_convertvector(four, Lanes);
}

}  // namespace graze::detail

#endif
