// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/math/orientation.hpp>

#include "../catalogue.hpp"

namespace graze::orientation_test {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using test::between;
using test::drawn;
using test::whole;

template <class T>
int exact_orientation(const Vec<2, T>& a, const Vec<2, T>& b, const Vec<2, T>& c) {
  const auto x = [](const Vec<2, T>& v) { return Rational(v.x); };
  const auto y = [](const Vec<2, T>& v) { return Rational(v.y); };
  const Rational determinant = (x(a) - x(c)) * (y(b) - y(c)) - (y(a) - y(c)) * (x(b) - x(c));
  return determinant.sign();
}

/// The six orders of three points: even permutations have one orientation, odd ones the other.
template <class T>
void assert_all_orders(const Vec<2, T>& a, const Vec<2, T>& b, const Vec<2, T>& c) {
  const int expected = exact_orientation(a, b, c);
  RC_ASSERT(orientation(a, b, c) == expected);
  RC_ASSERT(orientation(b, c, a) == expected);
  RC_ASSERT(orientation(c, a, b) == expected);
  RC_ASSERT(orientation(b, a, c) == -expected);
  RC_ASSERT(orientation(a, c, b) == -expected);
  RC_ASSERT(orientation(c, b, a) == -expected);
}

/// A few ulp of noise on both coordinates; zero stays.
template <class T>
rc::Gen<Vec<2, T>> shaken(const Vec<2, T>& point) {
  const auto ulps = drawn<int>([](rc::Random& random) { return whole(random, -2, 2); });
  const auto shift = [](T x, int steps) {
    for (int i = 0; x != T(0) && i < std::abs(steps); ++i) x = std::nextafter(x, steps < 0 ? T(-1e30) : T(1e30));
    return x;
  };
  return rc::gen::apply([=](int i, int j) { return Vec<2, T>(shift(point.x, i), shift(point.y, j)); }, ulps, ulps);
}

TEST(Orientation, SaysWhichWayAPathTurns) {
  const Vec<2, float> a(0, 0);
  const Vec<2, float> b(4, 0);
  EXPECT_EQ(orientation(a, b, Vec<2, float>(5, 1)), 1);
  EXPECT_EQ(orientation(a, b, Vec<2, float>(-5, 1)), 1);
  EXPECT_EQ(orientation(a, b, Vec<2, float>(5, -1)), -1);
  EXPECT_EQ(orientation(a, b, Vec<2, float>(9, 0)), 0);
  EXPECT_EQ(orientation(a, b, Vec<2, float>(2, 0)), 0);
  EXPECT_EQ(orientation(a, b, b), 0);
  EXPECT_EQ(orientation(a, a, a), 0);
}

TEST(Orientation, DecidesByTheLastBit) {
  const Vec<2, double> a(0.5, 0.5);
  const Vec<2, double> b(12, 12);
  const double up = std::nextafter(24.0, 25.0);
  EXPECT_EQ(orientation(a, b, Vec<2, double>(24, 24)), 0);
  EXPECT_EQ(orientation(a, b, Vec<2, double>(24, up)), 1);
  EXPECT_EQ(orientation(a, b, Vec<2, double>(up, 24)), -1);
  EXPECT_EQ(orientation(a, b, Vec<2, double>(up, up)), 0);
}

TEST(Orientation, IsRightOnAGridOfNeighbouringDoubles) {
  // Kettner, Mehlhorn et al., "Classroom examples of robustness problems" (2004): plain doubles give a chaotic picture.
  const double step = 0x1p-53;
  const Vec<2, double> q(12, 12);
  const Vec<2, double> r(24, 24);
  for (int i = 0; i < 32; ++i) {
    for (int j = 0; j < 32; ++j) {
      const Vec<2, double> p(0.5 + i * step, 0.5 + j * step);
      EXPECT_EQ(orientation(p, q, r), exact_orientation(p, q, r)) << test::to_source(p);
    }
  }
}

TEST(Orientation, SurvivesDifferencesThatRound) {
  // The tiny coordinate vanishes beside the large ones in every difference, yet decides. Above the line means to the
  // right of the path from (1e50, 1e50) to (-1e50, -1e50).
  EXPECT_EQ(orientation(Vec<2, double>(0, 1e-100), Vec<2, double>(1e50, 1e50), Vec<2, double>(-1e50, -1e50)), -1);
  EXPECT_EQ(orientation(Vec<2, double>(0, -1e-100), Vec<2, double>(1e50, 1e50), Vec<2, double>(-1e50, -1e50)), 1);
  EXPECT_EQ(orientation(Vec<2, double>(0, 0), Vec<2, double>(1e50, 1e50), Vec<2, double>(-1e50, -1e50)), 0);
}

TEST(Orientation, SignOfSumSeesWhatCancellationLeaves) {
  EXPECT_EQ(sign_of_sum(std::array<double, 3>{1e300, 1e-300, -1e300}), 1);
  EXPECT_EQ(sign_of_sum(std::array<double, 3>{1e300, -1e-300, -1e300}), -1);
  EXPECT_EQ(sign_of_sum(std::array<double, 4>{1e300, 1, -1e300, -1}), 0);
  EXPECT_EQ(sign_of_sum(std::array<double, 2>{0, -0.0}), 0);
  EXPECT_EQ(sign_of_sum(std::array<double, 0>{}), 0);
}

RC_GTEST_PROP(Orientation, SignOfSumIsExact, ()) {
  const auto term = drawn<double>([](rc::Random& random) {
    return std::ldexp(std::floor(between(random, -8, 8)), static_cast<int>(whole(random, -200, 200)));
  });
  auto terms = *rc::gen::container<std::array<double, 12>>(term);
  // Half of the terms nearly cancel the other half.
  for (std::size_t i = 0; i < 6; ++i) terms[i + 6] = -terms[(i * 5) % 6] * (i == 3 ? 1 + 0x1p-52 : 1);
  Rational sum = 0;
  for (const double x : terms) sum += Rational(x);
  RC_ASSERT(sign_of_sum(terms) == sum.sign());
}

template <class T>
class OrientationIn : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(OrientationIn, Scalars);

TYPED_TEST(OrientationIn, IsExactForAnyThreePoints) {
  using Point = Vec<2, TypeParam>;
  test::check_property([] {
    const auto from = test::draw_source<2, TypeParam>();
    const Point a = *from.point;
    const Point b = *from.point;
    const Point c = *from.point;
    assert_all_orders(a, b, c);
  });
}

TYPED_TEST(OrientationIn, IsExactForPointsAFewUlpFromALine) {
  using T = TypeParam;
  test::check_property([] {
    const auto [start, end] = *test::any_pair<Vec<2, T>, Vec<2, T>>();
    const auto place = [start = start, end = end](T t) { return start + (end - start) * t; };
    const auto t = drawn<T>([](rc::Random& random) { return between(random, -2, 3); });
    const Vec<2, T> a = *shaken<T>(place(*t));
    const Vec<2, T> b = *shaken<T>(place(*t));
    const Vec<2, T> c = *shaken<T>(place(*t));
    assert_all_orders(a, b, c);
  });
}

TYPED_TEST(OrientationIn, DoesNotDependOnTheUnitOfLength) {
  using T = TypeParam;
  const Vec<2, T> a(T(0.1), T(0.3));
  const Vec<2, T> b(T(0.7), T(0.9));
  for (const T off : {T(0), std::numeric_limits<T>::epsilon()}) {
    const Vec<2, T> c(T(0.4), T(0.6) + off);
    const int expected = orientation(a, b, c);
    constexpr int most = std::numeric_limits<T>::max_exponent - 1;
    constexpr int least = std::numeric_limits<T>::min_exponent + 2;
    for (int exponent = least + std::numeric_limits<T>::digits; exponent <= most; ++exponent) {
      const T unit = std::ldexp(T(1), exponent);
      ASSERT_EQ(orientation(a * unit, b * unit, c * unit), expected) << "2^" << exponent;
      ASSERT_EQ(orientation(b * unit, a * unit, c * unit), -expected) << "2^" << exponent;
    }
  }
}

TEST(Orientation, OfPointsAcrossTheWholeRangeOfDoubleDoesNotOverflow) {
  constexpr double most = std::numeric_limits<double>::max();
  using Point = Vec<2, double>;
  EXPECT_EQ(orientation(Point(-most, -most), Point(most, -most), Point(0, most)), 1);
  EXPECT_EQ(orientation(Point(-most, most), Point(most, most), Point(0, -most)), -1);
  EXPECT_EQ(orientation(Point(-most, -most), Point(most, most), Point(0, 0)), 0);
  EXPECT_EQ(orientation(Point(-most, -most), Point(most, most), Point(1e200, 1e200)), 0);
  EXPECT_EQ(orientation(Point(-most, -most), Point(most, most), Point(1e200, 2e200)), 1);
}

}  // namespace
}  // namespace graze::orientation_test
