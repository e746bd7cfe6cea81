// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

#include <graze/math/orientation_3d.hpp>

#include "exact/numbers.hpp"

namespace graze::orientation_3d_test {
namespace {

template <class T>
int exact_orientation(const Vec<3, T>& a, const Vec<3, T>& b, const Vec<3, T>& c, const Vec<3, T>& d) {
  const auto off = [&d](const Vec<3, T>& point) {
    test::RationalVec<3> result = test::exact(point);
    const test::RationalVec<3> from = test::exact(d);
    for (std::size_t i = 0; i < 3; ++i) result[i] -= from[i];
    return result;
  };
  const test::RationalVec<3> p = off(a);
  const test::RationalVec<3> q = off(b);
  const test::RationalVec<3> r = off(c);
  test::Rational determinant = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    determinant += p[i] * (q[j] * r[k] - q[k] * r[j]);
  }
  return -determinant.sign();
}

template <class T>
void expect_exact(const Vec<3, T>& a, const Vec<3, T>& b, const Vec<3, T>& c, const Vec<3, T>& d) {
  const int sign = orientation(a, b, c, d);
  EXPECT_EQ(sign, exact_orientation(a, b, c, d));
  EXPECT_EQ(orientation(b, c, a, d), sign);
  EXPECT_EQ(orientation(b, a, c, d), -sign);
  EXPECT_EQ(orientation(b, a, d, c), sign) << "an even exchange";
}

TEST(OrientationInSpace, IsPositiveOnTheSideFromWhichThePointsRunCounterClockwise) {
  const Vec<3, double> a{0, 0, 0};
  const Vec<3, double> b{1, 0, 0};
  const Vec<3, double> c{0, 1, 0};
  EXPECT_EQ(orientation(a, b, c, Vec<3, double>{5, 7, 1}), 1);
  EXPECT_EQ(orientation(a, b, c, Vec<3, double>{5, 7, -1}), -1);
  EXPECT_EQ(orientation(a, b, c, Vec<3, double>{5, 7, 0}), 0);
  EXPECT_EQ(orientation(a, b, c, Vec<3, double>{5, 7, 1e-80}), 1);
}

template <class T>
class Orientation3d : public testing::Test {
 protected:
  T number(double low, double high) { return static_cast<T>(std::uniform_real_distribution<>(low, high)(random_)); }
  Vec<3, T> point(double reach) { return {number(-reach, reach), number(-reach, reach), number(-reach, reach)}; }
  std::mt19937_64& random() { return random_; }

 private:
  std::mt19937_64 random_{5};
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Orientation3d, Scalars);

TYPED_TEST(Orientation3d, IsExactForRandomPoints) {
  for (int i = 0; i < 300; ++i) expect_exact(this->point(1), this->point(1), this->point(1), this->point(1));
}

// Every other case is exactly on the plane.
TYPED_TEST(Orientation3d, IsExactOnAGrid) {
  using T = TypeParam;
  std::uniform_int_distribution<int> whole(-2, 2);
  const auto point = [&] {
    const auto coordinate = [&] { return static_cast<T>(whole(this->random())); };
    const T x = coordinate();
    const T y = coordinate();
    return Vec<3, T>(x, y, coordinate());
  };
  for (int i = 0; i < 600; ++i) expect_exact(point(), point(), point(), point());
}

// The rounded point of a plane is slightly off it, on either side.
TYPED_TEST(Orientation3d, IsExactAHairFromThePlane) {
  using T = TypeParam;
  for (const double far : {0.0, 1.0, 1e6}) {
    for (int i = 0; i < 300; ++i) {
      const Vec<3, T> shift(static_cast<T>(far));
      const Vec<3, T> a = this->point(1) + shift;
      const Vec<3, T> b = this->point(1) + shift;
      const Vec<3, T> c = this->point(1) + shift;
      const T s = this->number(-2, 2);
      const T t = this->number(-2, 2);
      expect_exact(a, b, c, a + (b - a) * s + (c - a) * t);
    }
  }
}

TYPED_TEST(Orientation3d, IsExactWhereDifferencesAreRounded) {
  using T = TypeParam;
  for (int i = 0; i < 300; ++i) {
    const T large = static_cast<T>(std::ldexp(1.0, 20 + i % 30));
    const Vec<3, T> a = this->point(1) * large;
    const Vec<3, T> b = this->point(1) / large;
    const Vec<3, T> c = this->point(1);
    expect_exact(a, b, c, a + b);
    expect_exact(a, b, c, (a + b) + c);
    expect_exact(a, b, c, b + c);
  }
}

}  // namespace
}  // namespace graze::orientation_3d_test
