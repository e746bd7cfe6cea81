// SPDX-License-Identifier: MIT
// On which side of a plane through three points a fourth one lies, exactly.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/math/orientation.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>

namespace graze {

namespace detail {

/// Adds x y z, exactly, to `terms`: the rounded product of the first two and its error, each times the third.
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

}  // namespace detail

/// 1 when d lies on that side of the plane through a, b, c from which these run counter-clockwise, -1 on the other
/// side, 0 when the four lie on one plane. The exact sign of dot(a - d, cross(b - d, c - d)), negated: a double
/// evaluation decides unless it is within its error bound (Shewchuk, "Adaptive Precision Floating-Point Arithmetic and
/// Fast Robust Geometric Predicates", 1997, section 4.3); where the differences are exact, as those of neighbours on a
/// grid, one determinant is summed exactly; else the four of the expanded one. For coordinates that are zero or of
/// magnitude 1e-90 to 1e90: outside, products leave the range of double.
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
  // The first error bound of that paper is (7 + 56 u) u with u half an epsilon; ours has the products in another order.
  constexpr double bound = 8 * std::numeric_limits<double>::epsilon();
  if (std::fabs(determinant) > bound * magnitude) return determinant > 0 ? -1 : 1;

  bool are_exact = true;
  for (const Vec<3, double>& point : points) {
    for (Dim i = 0; i < 3; ++i) are_exact = are_exact && two_sum(point[i], -wide_d[i]).error == 0;
  }
  std::size_t count = 0;
  if (are_exact) {
    std::array<double, 24> terms{};
    detail::add_determinant(off[0], off[1], off[2], terms, count);
    return -sign_of_sum(terms);
  }
  // det(a - d, b - d, c - d) = det(a, b, c) - det(d, b, c) - det(a, d, c) - det(a, b, d)
  std::array<double, 96> terms{};
  detail::add_determinant(points[0], points[1], points[2], terms, count);
  detail::add_determinant(-wide_d, points[1], points[2], terms, count);
  detail::add_determinant(points[0], -wide_d, points[2], terms, count);
  detail::add_determinant(points[0], points[1], -wide_d, terms, count);
  return -sign_of_sum(terms);
}

}  // namespace graze
