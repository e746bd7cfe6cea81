// SPDX-License-Identifier: MIT
// Vectors in double, 2D and 3D, with two coordinates per register: shared by the 2D and 3D filters.
#pragma once

#include <cmath>
#include <type_traits>

#include <graze/math/lanes/lanes.hpp>
#include <graze/math/vec.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// The 2D counterpart of PairedVec.
struct Pair2d {
  LanePair xy;

  [[gnu::always_inline]] explicit Pair2d(LanePair both) : xy(both) {}
  [[gnu::always_inline]] explicit Pair2d(const Vec<2, float>& v)
      : xy{static_cast<double>(v.x), static_cast<double>(v.y)} {}
  [[gnu::always_inline]] explicit Pair2d(const Vec<2, double>& v) : xy{v.x, v.y} {}

  [[gnu::always_inline]] friend Pair2d operator+(Pair2d a, Pair2d b) { return Pair2d(a.xy + b.xy); }
  [[gnu::always_inline]] friend Pair2d operator-(Pair2d a, Pair2d b) { return Pair2d(a.xy - b.xy); }
  [[gnu::always_inline]] friend Pair2d operator*(Pair2d a, double factor) { return Pair2d(a.xy * factor); }
};

template <Dim N>
using Paired = std::conditional_t<N == 2, Pair2d, PairedVec>;

[[gnu::always_inline]] inline Pair2d products(Pair2d a, Pair2d b) { return Pair2d(a.xy * b.xy); }
[[gnu::always_inline]] inline PairedVec products(const PairedVec& a, const PairedVec& b) {
  return {a.xy * b.xy, a.z * b.z};
}

[[gnu::always_inline]] inline Pair2d magnitude(Pair2d v) { return Pair2d(magnitude(v.xy)); }
[[gnu::always_inline]] inline double sum_of_coordinates(Pair2d v) { return v.xy[0] + v.xy[1]; }
[[gnu::always_inline]] inline double dot(Pair2d a, Pair2d b) { return sum_of_coordinates(products(a, b)); }

/// Normalises a vector whose length is `length` up to rounding. The last steps of Newton's iteration are faster than a
/// square root.
template <class V>
[[gnu::always_inline]] inline V unit_of(const V& v, double length) {
  const double inverse = 1 / length;
  const double excess = 1 - dot(v, v) * (inverse * inverse);
  constexpr double small = 0x1p-18;  // the next term is below an eighth of epsilon
  if (!(std::fabs(excess) < small)) return v * (1 / std::sqrt(dot(v, v)));
  return v * (inverse * (1 + excess * (0.5 + 0.375 * excess)));
}

/// Rounds to T; adding zero turns -0 into +0, also after underflow.
template <class T>
[[gnu::always_inline]] inline Vec<2, T> rounded_vec(Pair2d v) {
  return {static_cast<T>(v.xy[0]) + T(0), static_cast<T>(v.xy[1]) + T(0)};
}

/// For two vectors: the sum of the coordinates and the sum of their magnitudes.
struct TwoSums {
  LanePair value;
  LanePair magnitude;
};

[[gnu::always_inline]] inline TwoSums two_sums(Pair2d a, Pair2d b) {
  const LanePair x = __builtin_shufflevector(a.xy, b.xy, 0, 2);
  const LanePair y = __builtin_shufflevector(a.xy, b.xy, 1, 3);
  return {x + y, magnitude(x) + magnitude(y)};
}
[[gnu::always_inline]] inline TwoSums two_sums(const PairedVec& a, const PairedVec& b) {
  const TwoSums xy = two_sums(Pair2d(a.xy), Pair2d(b.xy));
  const LanePair z{a.z, b.z};
  return {xy.value + z, xy.magnitude + magnitude(z)};
}

}  // namespace graze::detail

#endif
