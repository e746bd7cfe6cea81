// SPDX-License-Identifier: MIT
// Vectors in twice the precision of double, against rational numbers.
#include <cmath>
#include <cstddef>
#include <random>

#include <gtest/gtest.h>

#include <graze/math/exact/twofold.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>

#include "exact.hpp"
#include "exact/numbers.hpp"

namespace graze::test::twofold_test {
namespace {

using detail::rounded;
using detail::twofold_determinant;
using detail::twofold_difference;
using detail::twofold_normal;
using detail::TwofoldVec;
using V2 = Vec<2, double>;
using V3 = Vec<3, double>;

RationalVec<3> exact_of(const TwofoldVec<3>& v) {
  RationalVec<3> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = exact(v[i].value) + exact(v[i].error);
  return result;
}

struct Numbers {
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
  V3 vector() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }
  TwofoldVec<3> twofold() { return twofold_difference(vector(), vector() * between(0, 1e-9)); }

  std::mt19937_64 engine{5};
};

TEST(Twofold, ADifferenceKeepsWhatRoundingDrops) {
  const TwofoldVec<2> a = twofold_difference(V2(1, 1), V2(0x1p-60, -0x1p-60));
  EXPECT_EQ(rounded(a), V2(1, 1));
  EXPECT_EQ(a[0].error, -0x1p-60);
  EXPECT_EQ(a[1].error, 0x1p-60);
}

TEST(Twofold, WhatADifferenceHasKeptIsThereWhenTheRestCancels) {
  const TwofoldVec<2> a = twofold_difference(V2(1, 1), V2(0x1p-60, -0x1p-60));
  const TwofoldVec<2> b = twofold_difference(V2(1, 3), V2(0, 0x1p-59));
  const TwofoldVec<2> rest = twofold_difference(a, b);
  EXPECT_EQ(rounded(rest), V2(-0x1p-60, -2));
  EXPECT_EQ(rest[0].error, 0);
  EXPECT_EQ(rest[1].error, 0x1p-60 + 0x1p-59);
}

TEST(Twofold, ADifferenceOfDifferencesIsWithinTwoEpsilonSquared) {
  Numbers numbers;
  for (int i = 0; i < 2000; ++i) {
    const TwofoldVec<3> a = numbers.twofold();
    const TwofoldVec<3> b = numbers.twofold();
    const RationalVec<3> off = exact_of(twofold_difference(a, b)) - (exact_of(a) - exact_of(b));
    for (const Rational& coordinate : off) {
      ASSERT_LE(std::fabs(to_double(coordinate)), 2 * tolerance::epsilon * tolerance::epsilon) << "pair " << i;
    }
  }
}

// The sine goes down to 1e-12, where products of doubles have lost all but a few bits.
TEST(Twofold, TheNormalOfNearlyParallelVectorsIsRight) {
  Numbers numbers;
  for (int i = 0; i < 2000; ++i) {
    const double sine = std::pow(10.0, -(i % 13));
    const TwofoldVec<3> u = numbers.twofold();
    const TwofoldVec<3> v = twofold_difference(rounded(u), numbers.vector() * sine);
    const V3 normal = rounded(twofold_normal(u, v));
    const RationalVec<3> exact_normal = cross(exact_of(u), exact_of(v));
    const double length = std::ldexp(1.0, std::ilogb(max_abs(normal)));
    ASSERT_EQ(length, 0.5) << "pair " << i;
    const double scale =
        std::ldexp(1.0, static_cast<int>(std::lround(std::log2(normal.x / to_double(exact_normal[0])))));
    for (Dim axis = 0; axis < 3; ++axis) {
      ASSERT_NEAR(normal[axis], scale * to_double(exact_normal[static_cast<std::size_t>(axis)]), 2 * tolerance::epsilon)
          << "pair " << i;
    }
  }
}

TEST(Twofold, TheNormalOfParallelVectorsIsZero) {
  const TwofoldVec<3> u = twofold_difference(V3(1, 2, 3), V3(0.0));
  EXPECT_EQ(rounded(twofold_normal(u, u)), V3(0.0));
}

TEST(Twofold, ADeterminantIsWithinItsBound) {
  Numbers numbers;
  for (int i = 0; i < 2000; ++i) {
    const TwofoldVec<3> a = numbers.twofold();
    const TwofoldVec<3> b = numbers.twofold();
    const TwofoldVec<3> c = twofold_difference(a, b);  // flat up to rounding
    const Rational off = exact(twofold_determinant({a, b, c})) - dot(exact_of(a), cross(exact_of(b), exact_of(c)));
    constexpr double most_products = 6 * 2;
    ASSERT_LE(std::fabs(to_double(off)), tolerance::twofold_rounding * most_products) << "triple " << i;
  }
}

}  // namespace
}  // namespace graze::test::twofold_test
