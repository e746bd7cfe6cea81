// SPDX-License-Identifier: MIT
// Every instruction set gives the mask of scalar code.
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/lanes/sixteen.hpp>

namespace graze::detail::sixteen_test {
namespace {

TEST(LaneMasks, HoldTheFirstLanes) {
  EXPECT_EQ(first_lanes(0), 0U);
  EXPECT_EQ(first_lanes(3), 0b111U);
  EXPECT_EQ(first_lanes(row_length), 0xFFFFU);
}

TEST(LaneMasks, AreVisitedAscendingUntilToldToStop) {
  std::vector<std::uint32_t> visited;
  EXPECT_TRUE(for_each_lane(0b1000'0000'0010'0110U, [&](std::uint32_t lane) {
    visited.push_back(lane);
    return true;
  }));
  EXPECT_EQ(visited, (std::vector<std::uint32_t>{1, 2, 5, 15}));
  visited.clear();
  EXPECT_FALSE(for_each_lane(0b110U, [&](std::uint32_t lane) {
    visited.push_back(lane);
    return false;
  }));
  EXPECT_EQ(visited, std::vector<std::uint32_t>{1});
}

#ifdef GRAZE_HAS_LANES

template <class T>
class SixteenLanes : public ::testing::Test {
 public:
  using Number = T;

  /// Small whole numbers, so that many are equal, and now and then NaN or an infinity.
  static Row<T> draw(std::mt19937& random) {
    constexpr T infinity = std::numeric_limits<T>::infinity();
    const std::array<T, 3> special = {std::numeric_limits<T>::quiet_NaN(), infinity, -infinity};
    Row<T> row;
    for (T& number : row) {
      number = random() % 10 == 0 ? special[random() % 3] : static_cast<T>(static_cast<int>(random() % 9) - 4);
    }
    return row;
  }
};
using NumberTypes = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SixteenLanes, NumberTypes);

TYPED_TEST(SixteenLanes, HaveTheSameMaskWithEveryInstructionSet) {
  using T = typename TestFixture::Number;
  std::mt19937 random(1);
  for (int round = 0; round < 1000; ++round) {
    const Row<T> a = TestFixture::draw(random);
    const Row<T> b = TestFixture::draw(random);
    LaneMask expected = 0;
    for (std::size_t lane = 0; lane < row_length; ++lane) {
      expected |= (a[lane] < b[lane] ? LaneMask{1} : LaneMask{0}) << lane;
    }
    const auto kernel = [&](auto& group) __attribute__((always_inline)) {
      using Group = std::remove_reference_t<decltype(group)>;
      using Numbers = typename Group::Numbers;
      Numbers numbers_a;
      Numbers numbers_b;
      group.read(a, numbers_a);
      group.read(b, numbers_b);
      group.flags = numbers_a < numbers_b;
    };
    ASSERT_EQ(lanes_set_by<T>(kernel), expected);
    ASSERT_EQ(run_plain<T>(kernel), expected);
#ifdef GRAZE_HAS_WIDER_LANES
    if (__builtin_cpu_supports("avx2")) {
      ASSERT_EQ(run_avx2<T>(kernel), expected);
    }
    if (__builtin_cpu_supports("avx512dq")) {
      ASSERT_EQ(run_avx512<T>(kernel), expected);
    }
#endif
  }
}

TYPED_TEST(SixteenLanes, KeepTheFirstWhereTheSecondIsNone) {
  using T = typename TestFixture::Number;
  std::mt19937 random(2);
  for (int round = 0; round < 1000; ++round) {
    const Row<T> a = TestFixture::draw(random);
    const Row<T> b = TestFixture::draw(random);
    Row<T> larger;
    Row<T> smaller;
    Row<T> magnitudes;
    lanes_set_by<T>([&](auto& group) __attribute__((always_inline)) {
      using Group = std::remove_reference_t<decltype(group)>;
      using Numbers = typename Group::Numbers;
      Numbers numbers;
      Numbers others;
      group.read(b, others);
      group.read(a, numbers);
      make_larger(numbers, others);
      group.write(numbers, larger);
      group.read(a, numbers);
      make_smaller(numbers, others);
      group.write(numbers, smaller);
      make_positive<Group>(others);
      group.write(others, magnitudes);
    });
    for (std::size_t lane = 0; lane < row_length; ++lane) {
      const auto expect_same = [](T found, T expected) {
        EXPECT_TRUE(found == expected || (std::isnan(found) && std::isnan(expected))) << found << " " << expected;
      };
      expect_same(larger[lane], b[lane] > a[lane] ? b[lane] : a[lane]);
      expect_same(smaller[lane], b[lane] < a[lane] ? b[lane] : a[lane]);
      expect_same(magnitudes[lane], std::fabs(b[lane]));
      EXPECT_FALSE(std::signbit(magnitudes[lane]));
    }
  }
}

#endif

}  // namespace
}  // namespace graze::detail::sixteen_test
