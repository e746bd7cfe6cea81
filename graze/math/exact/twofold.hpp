// SPDX-License-Identifier: MIT
// Vectors in twice the precision of double, for products and determinants of differences that nearly cancel.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>

namespace graze::detail {

/// Each coordinate is the sum of two doubles; the second is less than an epsilon of the first.
template <Dim N>
using TwofoldVec = std::array<Rounded, static_cast<std::size_t>(N)>;

/// a - b, exactly.
template <Dim N>
TwofoldVec<N> twofold_difference(const Vec<N, double>& a, const Vec<N, double>& b) {
  TwofoldVec<N> difference{};
  for (std::size_t i = 0; i < difference.size(); ++i) {
    const Dim axis = static_cast<Dim>(i);
    difference[i] = two_sum(a[axis], -b[axis]);
  }
  return difference;
}

/// a - b within two epsilon squared of the larger one.
template <std::size_t N>
std::array<Rounded, N> twofold_difference(const std::array<Rounded, N>& a, const std::array<Rounded, N>& b) {
  std::array<Rounded, N> difference{};
  for (std::size_t i = 0; i < N; ++i) {
    const Rounded once = two_sum(a[i].value, -b[i].value);
    difference[i] = two_sum(once.value, once.error + (a[i].error - b[i].error));
  }
  return difference;
}

/// Rounded to double.
template <std::size_t N>
Vec<static_cast<Dim>(N), double> rounded(const std::array<Rounded, N>& v) {
  Vec<static_cast<Dim>(N), double> result;
  for (std::size_t i = 0; i < N; ++i) result[static_cast<Dim>(i)] = v[i].value;
  return result;
}

/// a x b, scaled by a power of two to a length of about 1, with errors around epsilon squared divided by the sine of
/// the angle. Zero if the product is zero.
inline TwofoldVec<3> twofold_normal(const TwofoldVec<3>& a, const TwofoldVec<3>& b) {
  TwofoldVec<3> normal{};
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const Rounded left = two_product(a[j].value, b[k].value);
    const Rounded right = two_product(a[k].value, b[j].value);
    const double left_rest = left.error + (a[j].value * b[k].error + a[j].error * b[k].value);
    const double right_rest = right.error + (a[k].value * b[j].error + a[k].error * b[j].value);
    const Rounded difference = two_sum(left.value, -right.value);
    normal[i] = two_sum(difference.value, difference.error + (left_rest - right_rest));
    size = std::max(size, std::fabs(normal[i].value));
  }
  int exponent = 0;
  (void)std::frexp(size, &exponent);
  for (Rounded& x : normal) x = {std::ldexp(x.value, -exponent), std::ldexp(x.error, -exponent)};
  return normal;
}

/// det(a, b, c). The error is at most `twofold_rounding` times the sum of the absolute values of its six products.
inline double twofold_determinant(const std::array<TwofoldVec<3>, 3>& rows) {
  const auto times = [](const Rounded& a, const Rounded& b) {
    const Rounded product = two_product(a.value, b.value);
    return Rounded{product.value, product.error + (a.value * b.error + a.error * b.value)};
  };
  Rounded total{0, 0};
  const auto add = [&total](const Rounded& term) {
    const Rounded sum = two_sum(total.value, term.value);
    total = {sum.value, total.error + (sum.error + term.error)};
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const Rounded& a = rows[0][i];
    add(times(times(rows[1][j], rows[2][k]), a));
    add(times(times(rows[1][k], rows[2][j]), {-a.value, -a.error}));
  }
  return total.value + total.error;
}

}  // namespace graze::detail
