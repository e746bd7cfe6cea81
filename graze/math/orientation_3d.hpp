// SPDX-License-Identifier: MIT
/// @file
/// The exact side of a plane through three points on which a fourth point lies.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include <graze/math/exact/exact_determinant.hpp>
#include <graze/math/exact/twofold.hpp>
#include <graze/math/orientation.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>

namespace graze {

namespace detail {

/// Adds x y z exactly to `terms`: the rounded product of the first two and its error, each multiplied by the third.
template <std::size_t Count>
void add_triple_product(double x, double y, double z, std::array<double, Count>& terms, std::size_t& count) {
  const Rounded product = two_product(x, y);
  for (const double factor : {product.error, product.value}) {
    const Rounded part = two_product(factor, z);
    terms[count++] = part.error;
    terms[count++] = part.value;
  }
}

/// Adds dot(a, cross(b, c)), exactly.
template <std::size_t Count>
void add_determinant(const Vec<3, double>& a, const Vec<3, double>& b, const Vec<3, double>& c,
                     std::array<double, Count>& terms, std::size_t& count) {
  for (Dim i = 0; i < 3; ++i) {
    const Dim j = (i + 1) % 3;
    const Dim k = (i + 2) % 3;
    add_triple_product(b[j], c[k], a[i], terms, count);
    add_triple_product(-b[k], c[j], a[i], terms, count);
  }
}

/// The exact sign of det(a - o, b - o, c - o), for points where rounding in double hides it. `magnitude`, not zero, is
/// the sum of the absolute values of its six products.
inline int sign_of_determinant(const std::array<Vec<3, double>, 3>& points, const Vec<3, double>& origin,
                               double magnitude) {
  if (const std::optional<int> sign = sign_of_exact_determinant(points, origin)) return *sign;
  bool are_exact = true;
  std::array<TwofoldVec<3>, 3> rows;
  for (std::size_t row = 0; row < 3; ++row) {
    rows[row] = twofold_difference(points[row], origin);
    for (const Rounded& coordinate : rows[row]) are_exact = are_exact && coordinate.error == 0;
  }
  constexpr double least = 0x1p-600;  // above it, lost errors of products are far below the bound
  const double twofold = twofold_determinant(rows);
  if (magnitude > least && std::fabs(twofold) > tolerance::twofold_rounding * magnitude) return twofold > 0 ? 1 : -1;
  std::size_t count = 0;
  if (are_exact) {
    std::array<double, 24> terms{};
    add_determinant(points[0] - origin, points[1] - origin, points[2] - origin, terms, count);
    return sign_of_sum(terms);
  }
  // det(a - o, b - o, c - o) = det(a, b, c) - det(o, b, c) - det(a, o, c) - det(a, b, o)
  std::array<double, 96> terms{};
  add_determinant(points[0], points[1], points[2], terms, count);
  add_determinant(-origin, points[1], points[2], terms, count);
  add_determinant(points[0], -origin, points[2], terms, count);
  add_determinant(points[0], points[1], -origin, terms, count);
  return sign_of_sum(terms);
}

}  // namespace detail

/// The side of the plane through a, b, c on which d lies: 1 if a, b, c run counter-clockwise as seen from d, -1 on the
/// other side, 0 if the four points are coplanar. This is the negated exact sign of dot(a - d, cross(b - d, c - d)). It
/// is evaluated in double, which decides unless the result is within its error bound (Shewchuk, "Adaptive Precision
/// Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997, section 4.3); then in integers if the
/// coordinates have similar sizes, otherwise in twice the precision of double. If that does not decide either, the sum
/// is exact: one determinant if the differences are exact, as for neighbours on a grid, otherwise the four determinants
/// of the expanded one. Coordinates must be zero or have a magnitude from 1e-90 to 1e90; outside, products leave the
/// range of double.
template <class T>
int orientation(const Vec<3, T>& a, const Vec<3, T>& b, const Vec<3, T>& c, const Vec<3, T>& d) {
  const Vec<3, double> wide_d = wide<3, T>(d);
  const std::array<Vec<3, double>, 3> points{wide<3, T>(a), wide<3, T>(b), wide<3, T>(c)};
  const std::array<Vec<3, double>, 3> off{points[0] - wide_d, points[1] - wide_d, points[2] - wide_d};
  double determinant = 0;
  double magnitude = 0;
  for (Dim i = 0; i < 3; ++i) {
    const Dim j = (i + 1) % 3;
    const Dim k = (i + 2) % 3;
    const double left = off[1][j] * off[2][k];
    const double right = off[1][k] * off[2][j];
    determinant += off[0][i] * (left - right);
    magnitude += std::fabs(off[0][i]) * (std::fabs(left) + std::fabs(right));
  }
  // The paper's first error bound is (7 + 56 u) u with u half an epsilon; here the order of the products differs.
  constexpr double bound = 8 * std::numeric_limits<double>::epsilon();
  if (std::fabs(determinant) > bound * magnitude) return determinant > 0 ? -1 : 1;
  if (magnitude == 0) return 0;  // as on a plane of the grid: one of the factors of each product is zero, exactly
  return -detail::sign_of_determinant(points, wide_d, magnitude);
}

}  // namespace graze
