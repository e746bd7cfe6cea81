// SPDX-License-Identifier: MIT
// Exact numbers for the oracle. Every finite double is an integer times a power of two, so nothing is lost.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>

#include <graze/math/vec.hpp>

namespace graze::test {

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;

template <Dim N>
using RationalVec = std::array<Rational, static_cast<std::size_t>(N)>;
template <Dim N>
using IntegerVec = std::array<Integer, static_cast<std::size_t>(N)>;

/// The value of a finite number.
inline Rational exact(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  const Integer mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  exponent -= 53;
  if (exponent >= 0) return Rational(mantissa << static_cast<unsigned>(exponent));
  return Rational(mantissa, Integer(1) << static_cast<unsigned>(-exponent));
}

template <Dim N, class T>
RationalVec<N> exact(const Vec<N, T>& v) {
  RationalVec<N> result;
  for (Dim i = 0; i < N; ++i) result[static_cast<std::size_t>(i)] = exact(static_cast<double>(v[i]));
  return result;
}

/// Fifty decimal digits and a huge exponent range: for magnitudes, not for verdicts.
using Wide = boost::multiprecision::cpp_bin_float_50;

inline Wide wide_of(const Rational& x) {
  return Wide(boost::multiprecision::numerator(x)) / Wide(boost::multiprecision::denominator(x));
}

inline double to_double(const Rational& x) { return static_cast<double>(wide_of(x)); }

template <class Number, std::size_t N>
std::array<Number, N> operator+(const std::array<Number, N>& a, const std::array<Number, N>& b) {
  std::array<Number, N> sum;
  for (std::size_t i = 0; i < N; ++i) sum[i] = a[i] + b[i];
  return sum;
}

template <class Number, std::size_t N>
std::array<Number, N> operator-(const std::array<Number, N>& a, const std::array<Number, N>& b) {
  std::array<Number, N> difference;
  for (std::size_t i = 0; i < N; ++i) difference[i] = a[i] - b[i];
  return difference;
}

template <class Number, std::size_t N>
std::array<Number, N> operator*(const std::array<Number, N>& a, const Number& factor) {
  std::array<Number, N> product;
  for (std::size_t i = 0; i < N; ++i) product[i] = a[i] * factor;
  return product;
}

template <class Number, std::size_t N>
Number dot(const std::array<Number, N>& a, const std::array<Number, N>& b) {
  Number sum = a[0] * b[0];
  for (std::size_t i = 1; i < N; ++i) sum += a[i] * b[i];
  return sum;
}

template <class Number>
std::array<Number, 3> cross(const std::array<Number, 3>& a, const std::array<Number, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Number, std::size_t N>
bool is_zero(const std::array<Number, N>& v) {
  for (const Number& x : v) {
    if (x != 0) return false;
  }
  return true;
}

}  // namespace graze::test
