// SPDX-License-Identifier: MIT
// Numbers with error bounds: two doubles and a bound on the rounding error. If nothing was rounded, as with small
// integers, the bound is zero and the number exact. A certain sign is a proof either way.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace graze::test {

/// A number within `error` of high + low, where |low| is at most half an ulp of `high`. Nothing traps: beyond the range
/// of double the error becomes infinite or NaN, and every sign uncertain.
struct Enclosed {
  double high = 0;
  double low = 0;
  double error = 0;
};

/// Bounds are multiplied by this after every few operations on positive numbers: more than their rounding errors.
inline constexpr double outward = 1 + 64 * std::numeric_limits<double>::epsilon();

/// Products smaller than this may underflow; this much is added to their error.
inline constexpr double least_product = 0x1p-900;

struct SumOfTwo {
  double sum;
  double rest;  ///< a + b - sum, exactly.
};

/// Knuth, The Art of Computer Programming 2, 4.2.2, theorem B.
inline SumOfTwo exact_sum(double a, double b) {
  const double sum = a + b;
  const double part_of_b = sum - a;
  return {sum, (a - (sum - part_of_b)) + (b - part_of_b)};
}

/// Dekker 1971, "A floating-point technique for extending the available precision", section 5: products of halves with
/// 26 bits are exact.
inline SumOfTwo exact_product(double a, double b) {
  constexpr double splitter = 0x1p27 + 1;
  const double scaled_a = splitter * a;
  const double scaled_b = splitter * b;
  const double upper_a = scaled_a - (scaled_a - a);
  const double upper_b = scaled_b - (scaled_b - b);
  const double lower_a = a - upper_a;
  const double lower_b = b - upper_b;
  const double product = a * b;
  return {product, ((upper_a * upper_b - product) + upper_a * lower_b + lower_a * upper_b) + lower_a * lower_b};
}

inline Enclosed enclosed(double x) { return {x, 0, 0}; }

/// The stored number itself, as an exact one: for values that need no proof, such as a search direction.
inline Enclosed taken_as_exact(const Enclosed& x) { return {x.high, x.low, 0}; }

inline Enclosed operator-(const Enclosed& x) { return {-x.high, -x.low, x.error}; }

inline Enclosed operator+(const Enclosed& a, const Enclosed& b) {
  const SumOfTwo highs = exact_sum(a.high, b.high);
  if (a.low == 0 && b.low == 0) return {highs.sum, highs.rest, (a.error + b.error) * outward};
  const SumOfTwo lows = exact_sum(a.low, b.low);
  const SumOfTwo middle = exact_sum(highs.rest, lows.sum);
  const SumOfTwo first = exact_sum(highs.sum, middle.sum);
  const SumOfTwo second = exact_sum(first.rest, lows.rest);
  const SumOfTwo last = exact_sum(first.sum, second.sum);
  const double lost = std::fabs(middle.rest) + std::fabs(second.rest);
  return {last.sum, last.rest, (a.error + b.error + lost) * outward};
}

inline Enclosed operator-(const Enclosed& a, const Enclosed& b) { return a + -b; }
inline Enclosed& operator+=(Enclosed& a, const Enclosed& b) { return a = a + b; }

/// An upper bound on the magnitude.
inline double magnitude(const Enclosed& x) { return (std::fabs(x.high) + std::fabs(x.low) + x.error) * outward; }

inline Enclosed operator*(const Enclosed& a, const Enclosed& b) {
  const auto product = [](double x, double y) {
    const SumOfTwo exact = exact_product(x, y);
    const bool is_safe = x == 0 || y == 0 || std::fabs(exact.sum) >= least_product;
    return Enclosed{exact.sum, exact.rest, is_safe ? 0 : least_product};
  };
  Enclosed result = product(a.high, b.high);
  if (b.low != 0) result = result + product(a.high, b.low);
  if (a.low != 0) result = result + product(a.low, b.high);
  if (a.low != 0 && b.low != 0) result = result + product(a.low, b.low);
  if (a.error != 0 || b.error != 0) {
    // These products may underflow, too.
    result.error = (result.error + magnitude(a) * b.error + magnitude(b) * a.error) * outward + least_product;
  }
  return result;
}

// ---- Certain comparisons: false if the error bound leaves the result open

inline bool is_surely_positive(const Enclosed& x) { return x.high + x.low > x.error * outward; }
inline bool is_surely_negative(const Enclosed& x) { return is_surely_positive(-x); }
inline bool is_surely_zero(const Enclosed& x) { return x.high == 0 && x.low == 0 && x.error == 0; }
inline bool is_surely_not_negative(const Enclosed& x) { return x.error == 0 ? x.high >= 0 : is_surely_positive(x); }

/// The bounding doubles below and above; 0 for an exact 0.
inline double lower_bound(const Enclosed& x) {
  if (x.error == 0 && x.low == 0) return x.high;
  const double sum = x.high + (x.low - x.error * outward);
  return std::nextafter(sum, -std::numeric_limits<double>::infinity());
}

inline double upper_bound(const Enclosed& x) { return -lower_bound(-x); }

// ---- Approximate

inline bool is_below_zero(const Enclosed& x) { return x.high < 0; }

template <class Real>
Real rounded_to(const Enclosed& x) {
  return static_cast<Real>(x.high) + static_cast<Real>(x.low);
}

// ---- Vectors, with the arithmetic of numbers.hpp

template <std::size_t N>
using EnclosedVec = std::array<Enclosed, N>;

template <std::size_t N>
EnclosedVec<N> taken_as_exact(const EnclosedVec<N>& v) {
  EnclosedVec<N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = taken_as_exact(v[i]);
  return result;
}

}  // namespace graze::test
