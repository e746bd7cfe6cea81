// SPDX-License-Identifier: MIT
// The vector types of filters give results that are bit-identical to scalar code.
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <graze/math/lanes/lanes.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail::lanes_test {
namespace {

TEST(Lanes, FindTheLargestOfThreeTwice) {
  const Lanes a{1, 5, -2, 100};
  const Lanes b{-7, -3, -4, 100};
  EXPECT_EQ(largest_of_both(a, b)[0], 5);
  EXPECT_EQ(largest_of_both(a, b)[1], -3);
  EXPECT_EQ(largest_of_both(turned(a), turned_back(b))[0], 5);
  EXPECT_EQ(largest_of_both(turned_back(a), turned(b))[1], -3);
}

TEST(Lanes, LetNoNumberThatIsNoneBeTheLargest) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const Lanes all{1, 2, 3, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    Lanes some = all;
    some[i] = nan;
    EXPECT_FALSE(largest_of_both(some, all)[0] > 3);
    EXPECT_EQ(largest_of_both(some, all)[1], 3);
  }
}

TEST(Lanes, CalculateInPairsWhatVectorsDo) {
  std::mt19937 engine(20261124);
  const auto number = [&] { return std::uniform_real_distribution<float>(-1, 1)(engine); };
  const auto expect_same = [](const PairedVec& paired, const Vec<3, double>& v) {
    EXPECT_EQ(paired.xy[0], v.x);
    EXPECT_EQ(paired.xy[1], v.y);
    EXPECT_EQ(paired.z, v.z);
  };
  for (int i = 0; i < 10000; ++i) {
    const Vec<3> a(number(), number(), number());
    const Vec<3> b(number(), number(), number());
    const Vec<3, double> wide_a = wide<3, float>(a);
    const Vec<3, double> wide_b = wide<3, float>(b);
    const PairedVec third = PairedVec(a) / 3.0;
    const Vec<3, double> wide_third = wide_a / 3.0;
    expect_same(PairedVec(Lanes{a.x, a.y, a.z, 0}), wide_a);
    expect_same(third + PairedVec(b), wide_third + wide_b);
    expect_same(third - PairedVec(b), wide_third - wide_b);
    expect_same(third * 0.7, wide_third * 0.7);
    expect_same(-third, -wide_third);
    expect_same(PairedVec(wide_third), wide_third);
    EXPECT_EQ(plain(third), wide_third);
    expect_same(magnitude(third), abs(wide_third));
    EXPECT_EQ(sum_of_coordinates(third), wide_third.x + wide_third.y + wide_third.z);
    EXPECT_EQ(rounded_vec<float>(third), (Vec<3, float>(wide_third)));
    EXPECT_EQ(rounded_vec<double>(third), wide_third);
    expect_same(one_of(third, PairedVec(b), LanePairBits{0, 0}), wide_third);
    expect_same(one_of(third, PairedVec(b), LanePairBits{-1, -1}), wide_b);
    expect_same(third / PairedVec(b), wide_third / wide_b);
    expect_same(cross(third, PairedVec(b)), cross(wide_third, wide_b));
    EXPECT_EQ(dot(third, PairedVec(b)), dot(wide_third, wide_b));
    const Lanes narrowed = narrow(0.1, third);
    EXPECT_EQ(narrowed[0], 0.1F);
    EXPECT_EQ(narrowed[1], static_cast<float>(wide_third.x));
    EXPECT_EQ(narrowed[2], static_cast<float>(wide_third.y));
    EXPECT_EQ(narrowed[3], static_cast<float>(wide_third.z));
  }
}

TEST(RoundedVec, IsNeverMinusZero) {
  const PairedVec zeros(LanePair{-0.0, -1e-300}, -0.0);
  for (const float coordinate :
       {rounded_vec<float>(zeros).x, rounded_vec<float>(zeros).y, rounded_vec<float>(zeros).z}) {
    EXPECT_FALSE(std::signbit(coordinate));
  }
  EXPECT_FALSE(std::signbit(rounded_vec<double>(zeros).x));
  EXPECT_FALSE(std::signbit(rounded_vec<double>(zeros).z));
}

}  // namespace
}  // namespace graze::detail::lanes_test

#endif
