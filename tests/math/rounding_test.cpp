// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/math/rounding.hpp>

#include "../catalogue/numbers.hpp"

namespace graze::rounding_test {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using test::between;
using test::drawn;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double huge = std::numeric_limits<double>::max();
constexpr double tiny = std::numeric_limits<double>::denorm_min();
constexpr double ulp = std::numeric_limits<double>::epsilon();

/// Any finite double with an exponent in a range: all bits of the significand random, or only a few of them.
rc::Gen<double> any_double(int min_exponent, int max_exponent) {
  return drawn<double>([=](rc::Random& random) {
    std::uint64_t bits = random.next() >> 12U;
    if (test::whole(random, 0, 1) == 0) bits &= ~std::uint64_t{0} << static_cast<unsigned>(test::whole(random, 0, 52));
    const double significand = 1 + static_cast<double>(bits) * 0x1p-52;
    const double sign = test::whole(random, 0, 1) == 0 ? 1 : -1;
    return sign * std::ldexp(significand, static_cast<int>(test::whole(random, min_exponent, max_exponent)));
  });
}

/// Two numbers of similar size, or not.
std::array<double, 2> two_numbers(int range) {
  const double a = *any_double(-range, range);
  const int exponent = std::ilogb(a);
  const double near = *any_double(std::max(exponent - 60, -range), std::min(exponent + 60, range));
  const double anything = *any_double(-range, range);
  return {a, *rc::gen::element(near, anything)};
}

template <class T>
bool is_least_not_below(T result, const Rational& exact) {
  return Rational(result) >= exact && Rational(std::nextafter(result, -std::numeric_limits<T>::infinity())) < exact;
}

template <class T>
bool is_greatest_not_above(T result, const Rational& exact) {
  return is_least_not_below<T>(-result, -exact);
}

TEST(Rounding, TwoSumKeepsWhatRoundingDrops) {
  const Rounded sum = two_sum(1, ulp / 4);
  EXPECT_EQ(sum.value, 1);
  EXPECT_EQ(sum.error, ulp / 4);
}

RC_GTEST_PROP(Rounding, TwoSumIsExact, ()) {
  const auto [a, b] = two_numbers(300);
  const Rounded sum = two_sum(a, b);
  RC_ASSERT(Rational(sum.value) + Rational(sum.error) == Rational(a) + Rational(b));
}

TEST(Rounding, TwoProductKeepsWhatRoundingDrops) {
  const Rounded square = two_product(1 + ulp, 1 + ulp);  // 1 + 2 ulp + ulp^2
  EXPECT_EQ(square.value, 1 + 2 * ulp);
  EXPECT_EQ(square.error, ulp * ulp);
}

RC_GTEST_PROP(Rounding, TwoProductIsExact, ()) {
  const auto [a, b] = two_numbers(300);
  const Rounded product = two_product(a, b);
  RC_ASSERT(Rational(product.value) + Rational(product.error) == Rational(a) * Rational(b));
}

Rational power_of_two(int exponent) {
  const Rational result(boost::multiprecision::cpp_int(1) << std::abs(exponent));
  return exponent < 0 ? 1 / result : result;
}

/// The double nearest to a number below 2^1024; of two, the even one.
double nearest_double(const Rational& exact) {
  if (exact == 0) return 0;
  const boost::multiprecision::cpp_int above = abs(numerator(exact));
  const boost::multiprecision::cpp_int below = denominator(exact);
  const auto bits = static_cast<int>(msb(above)) - static_cast<int>(msb(below));  // of the size, or one more
  int last = std::max(bits - 53, -1074);
  if (Rational(above, below) >= Rational(std::ldexp(1.0, 53)) * power_of_two(last)) ++last;
  const Rational steps = Rational(above, below) / power_of_two(last);
  boost::multiprecision::cpp_int whole = numerator(steps) / denominator(steps);
  const Rational rest = steps - whole;
  const Rational half(1, 2);
  if (rest > half || (rest == half && whole % 2 == 1)) ++whole;
  return std::copysign(std::ldexp(whole.convert_to<double>(), last), exact < 0 ? -1.0 : 1.0);
}

/// The error as std::fma(a, b, -product) returns it, where that is exact.
double exact_error(double a, double b, double product) {
  if (std::isinf(product) && std::isfinite(a) && std::isfinite(b)) return -product;
  if (!std::isfinite(product)) return std::numeric_limits<double>::quiet_NaN();
  return nearest_double(Rational(a) * Rational(b) - Rational(product));
}

void expect_exact_error(double a, double b) {
  const double product = a * b;
  const double wanted = exact_error(a, b, product);
  for (const double error : {detail::product_error(a, b, product), two_product(a, b).error}) {
    const bool is_same = std::bit_cast<std::uint64_t>(error) == std::bit_cast<std::uint64_t>(wanted);
    EXPECT_TRUE(is_same || (std::isnan(error) && std::isnan(wanted))) << a << " * " << b << ": " << error;
  }
}

RC_GTEST_PROP(Rounding, TheErrorOfAProductIsExactToTheBit, ()) {
  const auto [a, b] = two_numbers(600);
  expect_exact_error(a, b);
  expect_exact_error(*any_double(-1074, 1023), b);
  const double c = *any_double(-600, -400);
  expect_exact_error(c, std::ldexp(*any_double(-1, 1), -1050 - std::ilogb(c)));  // the product is near the least double
}

TEST(Rounding, TheErrorOfAProductIsExactForNastyNumbers) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double a : {0.0, 1.0, 1 + ulp, 1 / 3.0, tiny, 3 * tiny, 0x1p-1022, 0x1p-450, 0x1.8p-900, 0x1.fp899,
                         0x1p900, huge, infinity, nan}) {
    for (const double b :
         {0.0, -1.0, 1 - ulp, 2 / 3.0, tiny, 0x1p-1022, 0x1.fp-451, 0x1p-899, 0x1p450, 0x1p901, huge, infinity, nan}) {
      for (const double sign : {1.0, -1.0}) {
        expect_exact_error(sign * a, b);
        expect_exact_error(a, sign * b);
      }
    }
  }
}

TEST(Rounding, NextUpAndNextDownAreNeighboursAndInfinitiesStay) {
  EXPECT_EQ(next_up(1.0), 1 + ulp);
  EXPECT_EQ(next_down(1.0), 1 - ulp / 2);
  EXPECT_EQ(next_up(0.0), tiny);
  EXPECT_EQ(next_down(0.0), -tiny);
  EXPECT_EQ(next_up(huge), infinity);
  EXPECT_EQ(next_up(infinity), infinity);
  EXPECT_EQ(next_down(-infinity), -infinity);
}

/// Any bit pattern, including infinities and NaN.
template <class T, class Bits>
void expect_neighbours_of(Bits bits) {
  const T x = std::bit_cast<T>(bits);
  const T above = std::nextafter(x, std::numeric_limits<T>::infinity());
  const T below = std::nextafter(x, -std::numeric_limits<T>::infinity());
  if (std::isnan(x)) {
    RC_ASSERT(std::isnan(next_up(x)) && std::isnan(next_down(x)));
  } else {
    RC_ASSERT(std::bit_cast<Bits>(next_up(x)) == std::bit_cast<Bits>(above));
    RC_ASSERT(std::bit_cast<Bits>(next_down(x)) == std::bit_cast<Bits>(below));
  }
}

RC_GTEST_PROP(Rounding, NeighboursOfFloatsAreThoseOfTheLibrary, (std::uint32_t bits)) {
  expect_neighbours_of<float>(bits);
}
RC_GTEST_PROP(Rounding, NeighboursOfDoublesAreThoseOfTheLibrary, ()) {
  expect_neighbours_of<double>(*drawn<std::uint64_t>([](rc::Random& random) { return random.next(); }));
}

TEST(Rounding, NeighboursOfTheOutermostNumbersAreThoseOfTheLibrary) {
  for (const float x : {0.0F, -0.0F, 1.0F, -1.0F, std::numeric_limits<float>::max(),
                        std::numeric_limits<float>::lowest(), std::numeric_limits<float>::denorm_min(),
                        -std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::min(),
                        std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()}) {
    EXPECT_EQ(next_up(x), std::nextafter(x, std::numeric_limits<float>::infinity())) << x;
    EXPECT_EQ(next_down(x), std::nextafter(x, -std::numeric_limits<float>::infinity())) << x;
  }
}

template <class T>
void expect_finite_magnitudes() {
  using Limits = std::numeric_limits<T>;
  for (const T x : {T(0), Limits::denorm_min(), Limits::min(), T(1.5), Limits::max()}) {
    EXPECT_EQ(finite_magnitude(x), x);
    EXPECT_EQ(finite_magnitude(-x), x);
    EXPECT_FALSE(std::signbit(finite_magnitude(-x)));
  }
  for (const T x : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()}) EXPECT_EQ(finite_magnitude(x), 0);
}

TEST(Rounding, WhatIsNotFiniteHasNoFiniteMagnitude) {
  expect_finite_magnitudes<float>();
  expect_finite_magnitudes<double>();
}

TEST(Rounding, AddUpLeavesExactSumsAndStepsOverOthers) {
  EXPECT_EQ(add_up(1, 2), 3);
  EXPECT_EQ(add_down(1, 2), 3);
  EXPECT_EQ(add_up(1, tiny), 1 + ulp);
  EXPECT_EQ(add_down(1, tiny), 1);
  EXPECT_EQ(add_up(1, -tiny), 1);
  EXPECT_EQ(add_down(1, -tiny), 1 - ulp / 2);
  EXPECT_EQ(add_up(0.1, 0.2), 0.30000000000000004);  // 0.1 + 0.2 is 0.3000000000000000166...
  EXPECT_EQ(add_down(0.1, 0.2), 0.3);
}

TEST(Rounding, SumsThatOverflowStayOnTheSafeSide) {
  EXPECT_EQ(add_up(huge, huge), infinity);
  EXPECT_EQ(add_down(huge, huge), huge);
  EXPECT_EQ(add_up(-huge, -huge), -huge);
  EXPECT_EQ(add_down(-huge, -huge), -infinity);
}

TEST(Rounding, InfiniteTermsGiveInfiniteSums) {
  for (const double other : {0.0, 1.0, -huge, huge}) {
    EXPECT_EQ(add_up(infinity, other), infinity);
    EXPECT_EQ(add_down(infinity, other), infinity);
    EXPECT_EQ(add_up(-infinity, other), -infinity);
    EXPECT_EQ(add_down(-infinity, other), -infinity);
  }
}

RC_GTEST_PROP(Rounding, AddUpIsTheLeastDoubleNotBelowTheSum, ()) {
  const auto [a, b] = two_numbers(1000);
  RC_ASSERT(is_least_not_below(add_up(a, b), Rational(a) + Rational(b)));
}

RC_GTEST_PROP(Rounding, AddDownIsTheGreatestDoubleNotAboveTheSum, ()) {
  const auto [a, b] = two_numbers(1000);
  RC_ASSERT(is_greatest_not_above(add_down(a, b), Rational(a) + Rational(b)));
}

TEST(Rounding, MultiplyUpLeavesExactProductsAndStepsOverOthers) {
  EXPECT_EQ(multiply_up(3, 0.5), 1.5);
  EXPECT_EQ(multiply_up(0, huge), 0);
  EXPECT_EQ(multiply_up(1 + ulp, 1 + ulp), 1 + 3 * ulp);
  EXPECT_EQ(multiply_up(1 + ulp, -1 - ulp), -1 - 2 * ulp);
  EXPECT_EQ(multiply_up(1e200, 1e200), infinity);
  EXPECT_EQ(multiply_up(1e200, -1e200), -huge);
  EXPECT_EQ(multiply_up(1e-200, 1e-200), tiny);
}

TEST(Rounding, MultiplyUpNoticesAnErrorTooSmallForADouble) {
  // (1 + ulp)^2 * 2^-1000 is 2^-1104 above the nearest double; 2^-1104 itself rounds to zero.
  const double product = multiply_up(1 + ulp, (1 + ulp) * 0x1p-1000);
  EXPECT_GE(Rational(product), Rational(1 + ulp) * Rational((1 + ulp) * 0x1p-1000));
}

RC_GTEST_PROP(Rounding, MultiplyUpIsTheLeastDoubleNotBelowTheProduct, ()) {
  const auto [a, b] = two_numbers(400);
  RC_ASSERT(is_least_not_below(multiply_up(a, b), Rational(a) * Rational(b)));
}

RC_GTEST_PROP(Rounding, MultiplyUpIsAtMostOneStepTooHighWhereProductsUnderflow, ()) {
  const double a = *any_double(-600, -400);
  const double b = *any_double(-600, -400);
  const Rational exact = Rational(a) * Rational(b);
  const double product = multiply_up(a, b);
  RC_ASSERT(Rational(product) >= exact);
  RC_ASSERT(Rational(next_down(next_down(product))) < exact);
}

TEST(Rounding, RoundUpToFloatGoesToTheNeighbourOnTheSafeSide) {
  const float above = std::nextafter(1.0F, 2.0F);
  EXPECT_EQ(round_up<float>(1), 1.0F);
  EXPECT_EQ(round_up<float>(1 + 1e-12), above);
  EXPECT_EQ(round_down<float>(1 + 1e-12), 1.0F);
  EXPECT_EQ(round_down<float>(-1 - 1e-12), -above);
  EXPECT_EQ(round_up<float>(-1 - 1e-12), -1.0F);
  EXPECT_EQ(round_up<double>(0.1), 0.1);
  EXPECT_EQ(round_down<double>(0.1), 0.1);
}

TEST(Rounding, NumbersBeyondFloatStayOnTheSafeSide) {
  constexpr float float_infinity = std::numeric_limits<float>::infinity();
  constexpr float float_huge = std::numeric_limits<float>::max();
  EXPECT_EQ(round_up<float>(1e300), float_infinity);
  EXPECT_EQ(round_down<float>(1e300), float_huge);
  EXPECT_EQ(round_up<float>(-1e300), -float_huge);
  EXPECT_EQ(round_down<float>(-1e300), -float_infinity);
  EXPECT_EQ(round_up<float>(1e-300), std::numeric_limits<float>::denorm_min());
  EXPECT_EQ(round_down<float>(1e-300), 0.0F);
  EXPECT_EQ(round_up<float>(infinity), float_infinity);
  EXPECT_EQ(round_down<float>(-infinity), -float_infinity);
}

RC_GTEST_PROP(Rounding, RoundUpIsTheLeastFloatNotBelow, ()) {
  const double x = *any_double(-140, 120);
  RC_ASSERT(is_least_not_below(round_up<float>(x), Rational(x)));
  RC_ASSERT(is_greatest_not_above(round_down<float>(x), Rational(x)));
}

}  // namespace
}  // namespace graze::rounding_test
