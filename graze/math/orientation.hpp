// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>

namespace graze {

/// The sign (-1, 0, 1) of the exact sum of the terms. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast
/// Robust Geometric Predicates" (1997), section 2.4: the terms are added one by one to a list of doubles with no
/// overlapping bits, so the last nonzero one carries the sign. Exact unless something overflows or underflows.
template <std::size_t Count>
int sign_of_sum(const std::array<double, Count>& terms) {
  std::array<double, Count> parts{};
  std::size_t used = 0;
  for (double carry : terms) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < used; ++i) {
      const Rounded sum = two_sum(carry, parts[i]);
      if (sum.error != 0) parts[kept++] = sum.error;
      carry = sum.value;
    }
    if (carry != 0) parts[kept++] = carry;
    used = kept;
  }
  if (used == 0) return 0;
  return parts[used - 1] > 0 ? 1 : -1;
}

/// The sign of a - b for two exact products. Rounding is monotonic, so the rounded values decide unless they are equal.
inline int sign_of_difference(const Rounded& a, const Rounded& b) {
  if (a.value != b.value) return a.value > b.value ? 1 : -1;
  if (a.error != b.error) return a.error > b.error ? 1 : -1;
  return 0;
}

namespace detail {

/// The power of two that scales numbers up to `largest` so that products of two of them, and the errors of these
/// products, are representable as doubles; 1 if they already are.
inline double scale_for_products(double largest) {
  if (largest > 0x1p-60 && largest < 0x1p500) return 1;
  if (!(largest > 0) || std::isinf(largest)) return 1;
  int exponent = 0;
  (void)std::frexp(largest, &exponent);
  return std::ldexp(1.0, std::min(460 - exponent, 1000));
}

/// The exact sign of (p - r) x (q - r), for points where rounding hides it.
inline int sign_of_turn(const Vec<2, double>& p, const Vec<2, double>& q, const Vec<2, double>& r) {
  const Rounded px = two_sum(p.x, -r.x);
  const Rounded py = two_sum(p.y, -r.y);
  const Rounded qx = two_sum(q.x, -r.x);
  const Rounded qy = two_sum(q.y, -r.y);
  if (px.error == 0 && py.error == 0 && qx.error == 0 && qy.error == 0) {
    return sign_of_difference(two_product(px.value, qy.value), two_product(py.value, qx.value));
  }
  std::array<double, 12> terms{};
  std::size_t count = 0;
  const auto add_product = [&](double x, double y) {
    const Rounded product = two_product(x, y);
    terms[count++] = product.error;
    terms[count++] = product.value;
  };
  add_product(p.x, q.y);
  add_product(-p.x, r.y);
  add_product(-r.x, q.y);
  add_product(-p.y, q.x);
  add_product(p.y, r.x);
  add_product(r.y, q.x);
  return sign_of_sum(terms);
}

}  // namespace detail

/// The turn of the path a, b, c: 1 counter-clockwise (y up), -1 clockwise, 0 if the points are collinear. This is the
/// exact sign of (a - c) x (b - c). It is evaluated in double, which decides unless the result is within its error
/// bound (Shewchuk 1997, section 4.2) or out of range. Otherwise, if the differences are exact, as for neighbours on a
/// grid, their two products are compared exactly; if not, the six products of the expanded determinant are summed
/// exactly. Coordinates may have any magnitude, but what is below 1e-120 of the largest may count as zero.
template <class T>
int orientation(const Vec<2, T>& a, const Vec<2, T>& b, const Vec<2, T>& c) {
  const Vec<2, double> p = wide<2, T>(a);
  const Vec<2, double> q = wide<2, T>(b);
  const Vec<2, double> r = wide<2, T>(c);
  const double left = (p.x - r.x) * (q.y - r.y);
  const double right = (p.y - r.y) * (q.x - r.x);
  const double determinant = left - right;
  constexpr double bound = 4 * std::numeric_limits<double>::epsilon();
  constexpr double underflow = 0x1p-1000;  // far above what products lose by underflow
  if (std::fabs(determinant) > bound * (std::fabs(left) + std::fabs(right)) + underflow)
    return determinant > 0 ? 1 : -1;
  const double scale = detail::scale_for_products(std::max({max_abs(p), max_abs(q), max_abs(r)}));
  return detail::sign_of_turn(p * scale, q * scale, r * scale);
}

}  // namespace graze
