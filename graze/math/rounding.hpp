// SPDX-License-Identifier: MIT
// Sums and products rounded in a chosen direction, for results that promise to contain something.
// Exact results stay exact; anything else moves to the neighbouring double on the safe side.
// Error-free transformations: Knuth, TAOCP 2 (1969), 4.2.2, and Dekker, Numer. Math. 18 (1971).
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <graze/math/platform/bit_cast.hpp>
#include <graze/math/vec.hpp>

namespace graze {

/// A rounded result together with the exact rounding error: `value + error` is the true result.
struct Rounded {
  double value;
  double error;
};

/// a + b with its error. Exact unless the sum overflows.
inline Rounded two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  const double a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

namespace detail {

/// Two numbers of at most 26 bits whose sum is x (Veltkamp 1968). Exact below 2^996.
inline Rounded halves(double x) {
  const double spread = 0x1.0000002p27 * x;  // by 2^27 + 1
  const double upper = spread - (spread - x);
  return {upper, x - upper};
}

/// What std::fma(a, b, -product) gives for the rounded product of a and b, to the bit, by products of halves (Dekker
/// 1971) where none of them over- or underflows.
inline double product_error_by_halves(double a, double b, double product) {
  const double size = std::fabs(product);
  const bool is_moderate = size > 0x1p-900 && size < 0x1p900 && std::fabs(a) < 0x1p900 && std::fabs(b) < 0x1p900;
  if (!is_moderate) return size == 0 && (a == 0 || b == 0) ? 0 : std::fma(a, b, -product);
  const Rounded of_a = halves(a);
  const Rounded of_b = halves(b);
  const double without_last = (of_a.value * of_b.value - product) + of_a.value * of_b.error + of_a.error * of_b.value;
  return without_last + of_a.error * of_b.error;
}

}  // namespace detail

/// a * b with its error. Exact unless the product over- or underflows.
inline Rounded two_product(double a, double b) {
  const double product = a * b;
#if defined(__wasm__)  // has no instruction for it, and the C library's function takes as long as dozens of others
  return {product, detail::product_error_by_halves(a, b, product)};
#else
  return {product, std::fma(a, b, -product)};
#endif
}

/// a * b - c * d within two epsilon of itself, however much of the products cancels; exactly negated when the products
/// change places. Exact zero is found exactly. Products must neither over- nor underflow.
inline double difference_of_products(double a, double b, double c, double d) {
  const Rounded first = two_product(a, b);
  const Rounded second = two_product(c, d);
  const Rounded difference = two_sum(first.value, -second.value);
  return difference.value + (difference.error + (first.error - second.error));
}

/// The cross product with every coordinate known to two epsilon of itself, so that the direction holds even for vectors
/// that are almost parallel, where `cross` gives mostly rounding. In 2D a number.
inline double accurate_cross(const Vec<2, double>& a, const Vec<2, double>& b) {
  return difference_of_products(a.x, b.y, a.y, b.x);
}

inline Vec<3, double> accurate_cross(const Vec<3, double>& a, const Vec<3, double>& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

/// The power of two that brings `size` near 1, so that products of several numbers of that size stay in the range of
/// double; 1 if they do anyway, or if it is zero or not finite. To multiply by it rounds nothing.
inline double scale_to_moderate(double size) {
  const bool is_moderate = size > 0x1p-200 && size < 0x1p200;
  if (is_moderate || !(size > 0) || std::isinf(size)) return 1;
  int exponent = 0;
  (void)std::frexp(size, &exponent);
  return std::ldexp(1.0, -exponent < 1000 ? -exponent : 1000);
}

/// The same direction, of a length whose powers stay in the range of double.
template <Dim N>
Vec<N, double> of_moderate_size(const Vec<N, double>& direction) {
  return direction * scale_to_moderate(max_abs(direction));
}

/// The neighbouring number above, that of minus infinity the lowest finite one; plus infinity and NaN stay. What
/// std::nextafter gives, whose calls take most of the time of bounds.
template <Scalar T>
T next_up(T x) {
  using Bits = std::conditional_t<sizeof(T) == sizeof(std::uint32_t), std::uint32_t, std::uint64_t>;
  if (!(x < std::numeric_limits<T>::infinity())) return x;
  if (x == T(0)) return std::numeric_limits<T>::denorm_min();
  const auto bits = bit_cast<Bits>(x);  // ordered by magnitude
  return bit_cast<T>(x > T(0) ? bits + 1 : bits - 1);
}

/// The neighbouring number below, likewise.
template <Scalar T>
T next_down(T x) {
  return -next_up(-x);
}

/// The magnitude of a finite number; 0 of infinity and NaN. By its bits, for compilers make a branch of comparisons.
template <Scalar T>
T finite_magnitude(T x) {
  using Bits = std::conditional_t<sizeof(T) == sizeof(std::uint32_t), std::uint32_t, std::uint64_t>;
  const Bits bits = bit_cast<Bits>(x) & (~Bits{0} >> 1U);
  const Bits infinity = bit_cast<Bits>(std::numeric_limits<T>::infinity());
  return bit_cast<T>(bits < infinity ? bits : Bits{0});
}

/// The least double that is not below a + b.
inline double add_up(double a, double b) {
  const Rounded sum = two_sum(a, b);
  const bool overflow = std::isinf(sum.value) && std::isfinite(a) && std::isfinite(b);
  return sum.error > 0 || overflow ? next_up(sum.value) : sum.value;
}

/// The greatest double that is not above a + b.
inline double add_down(double a, double b) { return -add_up(-a, -b); }

/// The rounding error of a smaller product can have bits below the last of all doubles, 2^-1074: `two_product` may lose
/// it. A product spans at most 106 bits.
inline constexpr double least_product_with_error = 0x1p-969;

/// A double that is not below a * b: the least one, except that a product below `least_product_with_error` may come out
/// one step higher.
inline double multiply_up(double a, double b) {
  const Rounded product = two_product(a, b);
  const bool error_lost = std::fabs(product.value) < least_product_with_error && a != 0 && b != 0;
  return product.error > 0 || error_lost ? next_up(product.value) : product.value;
}

/// The least T that is not below x. Without a branch, for that would guess wrong every other time: below x are minus
/// infinity and other numbers, but never minus zero, so that one step up is one of its bits.
template <Scalar T>
T round_up(double x) {
  const T rounded = static_cast<T>(x);
  if constexpr (std::is_same_v<T, float>) {
    const auto bits = bit_cast<std::uint32_t>(rounded);
    const std::uint32_t step = (bits >> 31U) != 0 ? ~std::uint32_t{0} : 1U;
    return bit_cast<float>(bits + (static_cast<double>(rounded) < x ? step : 0U));
  } else {
    return rounded;
  }
}

/// The greatest T that is not above x.
template <Scalar T>
T round_down(double x) {
  return -round_up<T>(-x);
}

}  // namespace graze
