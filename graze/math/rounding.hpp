// SPDX-License-Identifier: MIT
/// @file
/// Sums and products rounded in a chosen direction, for results that must contain the true value. Exact results stay
/// exact; others move to the neighbouring double on the safe side. Error-free transformations: Knuth, TAOCP 2 (1969),
/// 4.2.2, and Dekker, Numer. Math. 18 (1971).
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <graze/math/platform/bit_cast.hpp>
#include <graze/math/vec.hpp>

namespace graze {

/// A rounded result and its exact rounding error: `value + error` is the true result.
struct Rounded {
  double value;  ///< The nearest double.
  double error;  ///< The true result minus `value`.
};

/// a + b and its rounding error (Knuth). Exact unless the sum overflows.
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

/// The error of the rounded product of a and b, from products of halves (Dekker 1971). Exact if none of them overflows
/// or underflows.
inline double error_by_halves(double a, double b, double product) {
  const Rounded of_a = halves(a);
  const Rounded of_b = halves(b);
  const double without_last = (of_a.value * of_b.value - product) + of_a.value * of_b.error + of_a.error * of_b.value;
  return without_last + of_a.error * of_b.error;
}

/// The same, of any numbers: their significands are multiplied, and the error is scaled. What is left of a product
/// below 2^-1022 is at most half the least double, and rounds to zero.
inline double error_of_extreme_product(double a, double b, double product) {
  if (std::isinf(product) && std::isfinite(a) && std::isfinite(b)) return -product;  // it overflowed
  if (!std::isfinite(product)) return std::numeric_limits<double>::quiet_NaN();
  int exponent_of_a = 0;
  int exponent_of_b = 0;
  const double significand_of_a = std::frexp(a, &exponent_of_a);
  const double significand_of_b = std::frexp(b, &exponent_of_b);
  const int exponent = exponent_of_a + exponent_of_b;
  const double rounded = significand_of_a * significand_of_b;
  const double dropped = rounded - std::ldexp(product, -exponent);  // zero unless the product is below 2^-1022
  return std::ldexp(dropped + error_by_halves(significand_of_a, significand_of_b, rounded), exponent);
}

/// The same bits as std::fma(a, b, -product) for the rounded product of a and b.
inline double product_error(double a, double b, double product) {
  const double size = std::fabs(product);
  const bool is_moderate = size > 0x1p-900 && size < 0x1p900 && std::fabs(a) < 0x1p900 && std::fabs(b) < 0x1p900;
  return is_moderate ? error_by_halves(a, b, product) : error_of_extreme_product(a, b, product);
}

}  // namespace detail

/// a * b and its rounding error. Exact unless the product overflows or underflows.
inline Rounded two_product(double a, double b) {
  const double product = a * b;
#if defined(__wasm__) || (defined(__MINGW32__) && !defined(__FMA__))  // std::fma is slow here, or rounds twice
  return {product, detail::product_error(a, b, product)};
#else
  return {product, std::fma(a, b, -product)};
#endif
}

/// a * b - c * d with a relative error of at most two epsilon, however much cancels. Swapping the products negates the
/// result exactly, and a zero result is exact. The products must not overflow or underflow.
inline double difference_of_products(double a, double b, double c, double d) {
  const Rounded first = two_product(a, b);
  const Rounded second = two_product(c, d);
  const Rounded difference = two_sum(first.value, -second.value);
  return difference.value + (difference.error + (first.error - second.error));
}

/// The power of two that brings `size` near 1, so that products of several numbers of that size stay in the range of
/// double; 1 if they do anyway, or if `size` is zero or not finite. Multiplying by it is exact.
inline double scale_to_moderate(double size) {
  const bool is_moderate = size > 0x1p-200 && size < 0x1p200;
  if (is_moderate || !(size > 0) || std::isinf(size)) return 1;
  int exponent = 0;
  (void)std::frexp(size, &exponent);
  return std::ldexp(1.0, -exponent < 1000 ? -exponent : 1000);
}

/// The vector scaled by a power of two so that powers of its length stay in the range of double.
template <Dim N>
Vec<N, double> of_moderate_size(const Vec<N, double>& direction) {
  return direction * scale_to_moderate(max_abs(direction));
}

namespace detail {

/// For products of at least this magnitude, `two_product` loses no error bits. A product spans at most 106 bits, and
/// those below 2^-1074, the least double, are lost.
inline constexpr double least_product_with_error = 0x1p-969;

}  // namespace detail

/// The 2D cross product, a number, with a relative error of at most two epsilon. Its sign is right even for nearly
/// parallel vectors, where `cross_2d` returns mostly rounding error.
inline double accurate_cross(const Vec<2, double>& a, const Vec<2, double>& b) {
  return difference_of_products(a.x, b.y, a.y, b.x);
}

/// The 3D cross product, each coordinate with a relative error of at most two epsilon. So its direction is right even
/// for nearly parallel vectors, where `cross` returns mostly rounding error; `cross` is cheaper.
inline Vec<3, double> accurate_cross(const Vec<3, double>& a, const Vec<3, double>& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

/// The next larger number, as std::nextafter returns it but faster. Minus infinity gives the lowest finite number; plus
/// infinity and NaN are returned unchanged.
template <Scalar T>
T next_up(T x) {
  using Bits = std::conditional_t<sizeof(T) == sizeof(std::uint32_t), std::uint32_t, std::uint64_t>;
  if (!(x < std::numeric_limits<T>::infinity())) return x;
  if (x == T(0)) return std::numeric_limits<T>::denorm_min();
  const auto bits = bit_cast<Bits>(x);  // ordered by magnitude
  return bit_cast<T>(x > T(0) ? bits + 1 : bits - 1);
}

/// The next smaller number: `next_up` with the signs reversed.
template <Scalar T>
T next_down(T x) {
  return -next_up(-x);
}

/// The absolute value of a finite number; 0 for infinity and NaN. Works on the bits, because compilers turn comparisons
/// into a branch.
template <Scalar T>
T finite_magnitude(T x) {
  using Bits = std::conditional_t<sizeof(T) == sizeof(std::uint32_t), std::uint32_t, std::uint64_t>;
  const Bits bits = bit_cast<Bits>(x) & (~Bits{0} >> 1U);
  const Bits infinity = bit_cast<Bits>(std::numeric_limits<T>::infinity());
  return bit_cast<T>(bits < infinity ? bits : Bits{0});
}

/// The least double that is at least a + b.
inline double add_up(double a, double b) {
  const Rounded sum = two_sum(a, b);
  const bool overflow = std::isinf(sum.value) && std::isfinite(a) && std::isfinite(b);
  return sum.error > 0 || overflow ? next_up(sum.value) : sum.value;
}

/// The greatest double that is at most a + b.
inline double add_down(double a, double b) { return -add_up(-a, -b); }

/// A double that is at least a * b: the least one, but one step higher for some products below 2^-969.
inline double multiply_up(double a, double b) {
  const Rounded product = two_product(a, b);
  const bool error_lost = std::fabs(product.value) < detail::least_product_with_error && a != 0 && b != 0;
  return product.error > 0 || error_lost ? next_up(product.value) : product.value;
}

/// The least T that is at least x. Branchless, because the branch would be mispredicted half of the time: minus
/// infinity and other numbers are below x, but never minus zero, so one step up is one step of the bits.
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

/// The greatest T that is at most x.
template <Scalar T>
T round_down(double x) {
  return -round_up<T>(-x);
}

}  // namespace graze
