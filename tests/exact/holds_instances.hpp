// SPDX-License-Identifier: MIT
// The definitions behind holds.hpp, for the files that instantiate them.
#pragma once

#include <graze/math/vec.hpp>

#include "exact/holds.hpp"
#include "exact/numbers.hpp"

namespace graze::test {

template <Dim N, class T>
bool contains_exactly(const Sphere<N, T>& sphere, const Vec<N, T>& point) {
  const RationalVec<N> to_point = exact(point) - exact(sphere.center);
  const Rational radius = exact(static_cast<double>(sphere.radius));
  return radius >= 0 && dot(to_point, to_point) <= radius * radius;
}

inline Rational determinant(const RationalVec<2>& a, const RationalVec<2>& b) { return a[0] * b[1] - a[1] * b[0]; }
inline Rational determinant(const RationalVec<3>& a, const RationalVec<3>& b, const RationalVec<3>& c) {
  return dot(a, cross(b, c));
}

/// The determinant of the axes of a box with column `column` replaced by `v`.
template <Dim N, class T>
Rational replaced_determinant(const Obb<N, T>& box, Dim column, const RationalVec<N>& v) {
  const auto axis = [&](Dim i) { return i == column ? v : exact<N, T>(box.axes[i]); };
  if constexpr (N == 2) {
    return determinant(axis(0), axis(1));
  } else {
    return determinant(axis(0), axis(1), axis(2));
  }
}

/// The point is center + axes * u with u by Cramer's rule.
template <Dim N, class T>
bool contains_exactly(const Obb<N, T>& box, const Vec<N, T>& point) {
  const Rational exact_determinant = replaced_determinant<N, T>(box, 0, exact<N, T>(box.axes[0]));
  const RationalVec<N> to_point = exact(point) - exact(box.center);
  for (Dim i = 0; i < N; ++i) {
    const Rational reach = abs(replaced_determinant<N, T>(box, i, to_point));
    if (reach > exact(static_cast<double>(box.half_extents[i])) * abs(exact_determinant)) return false;
  }
  return true;
}

}  // namespace graze::test
