// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/brute_force.hpp>
#include <graze/broad/pairs.hpp>

#include "box_worlds.hpp"

namespace graze {
namespace {

template <class Space>
class PairsTest : public testing::Test {};

template <Dim N, class T>
struct In {
  static constexpr Dim dimension = N;
  using scalar = T;
};
using Spaces = testing::Types<In<2, float>, In<3, float>, In<2, double>, In<3, double>>;
TYPED_TEST_SUITE(PairsTest, Spaces);

constexpr PairOptions by_tree{PairMethod::tree};
constexpr PairOptions by_brute_force{PairMethod::brute_force};

TYPED_TEST(PairsTest, FindThePairsOfAHandMadeRow) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  using Box = Aabb<N, T>;
  const auto along = [](T low, T high) {
    Box box{Vec<N, T>(T(0)), Vec<N, T>(T(1))};
    box.min[0] = low;
    box.max[0] = high;
    return box;
  };
  // 0 and 1 overlap, 1 and 2 touch, 3 is alone, 4 contains 3.
  const std::vector<Box> boxes = {along(0, 2), along(1, 3), along(3, 4), along(6, 7), along(5, 8)};
  const std::vector<Pair> expected = {{0, 1}, {1, 2}, {3, 4}};
  for (const PairOptions& options : {PairOptions{}, by_tree, by_brute_force}) {
    EXPECT_EQ(overlapping_pairs(boxes, options), expected);
  }
}

TYPED_TEST(PairsTest, TreeEqualsBruteForceInEveryWorld) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (const std::size_t count : {0U, 1U, 2U, 9U, 64U, 65U, 700U}) {
    for (const auto& world : test::box_worlds<N, T>(count, 20261121 + count)) {
      SCOPED_TRACE(world.name + ", " + std::to_string(count) + " boxes");
      const std::vector<Pair> expected = overlapping_pairs(world.boxes, by_brute_force);
      EXPECT_EQ(overlapping_pairs(world.boxes, by_tree), expected);
      EXPECT_EQ(overlapping_pairs(world.boxes), expected);
      EXPECT_TRUE(std::is_sorted(expected.begin(), expected.end()));
    }
  }
}

TYPED_TEST(PairsTest, BetweenTwoSetsTreeEqualsBruteForceInEveryWorld) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const auto worlds_a = test::box_worlds<N, T>(500, 1);
  const auto worlds_b = test::box_worlds<N, T>(90, 2);
  for (std::size_t i = 0; i < worlds_a.size(); ++i) {
    SCOPED_TRACE(worlds_a[i].name);
    const std::vector<Pair> expected = overlapping_pairs(worlds_a[i].boxes, worlds_b[i].boxes, by_brute_force);
    EXPECT_EQ(overlapping_pairs(worlds_a[i].boxes, worlds_b[i].boxes, by_tree), expected);
    EXPECT_EQ(overlapping_pairs(worlds_a[i].boxes, worlds_b[i].boxes), expected);
  }
}

TYPED_TEST(PairsTest, TwoSetsAreThePairsOfTheirUnionAcross) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const auto boxes = test::box_worlds<N, T>(300, 5).front().boxes;
  const std::vector<Aabb<N, T>> first(boxes.begin(), boxes.begin() + 120);
  const std::vector<Aabb<N, T>> second(boxes.begin() + 120, boxes.end());
  std::vector<Pair> expected;
  for (const Pair& pair : overlapping_pairs(boxes)) {
    if (pair.a < 120 && pair.b >= 120) expected.push_back({pair.a, pair.b - 120});
  }
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(overlapping_pairs(first, second), expected);
}

TYPED_TEST(PairsTest, ShufflingTheBoxesRenamesThePairs) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const auto boxes = test::box_worlds<N, T>(400, 9)[1].boxes;
  std::vector<std::uint32_t> order(boxes.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  std::vector<Aabb<N, T>> shuffled;
  for (const std::uint32_t i : order) shuffled.push_back(boxes[i]);
  std::vector<Pair> renamed;
  for (const Pair& pair : overlapping_pairs(shuffled)) {
    renamed.push_back({std::min(order[pair.a], order[pair.b]), std::max(order[pair.a], order[pair.b])});
  }
  std::sort(renamed.begin(), renamed.end());
  EXPECT_EQ(renamed, overlapping_pairs(boxes));
}

TYPED_TEST(PairsTest, AllBoxesAtOnePointGiveAllPairs) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const std::vector<Aabb<N, T>> boxes(300);
  EXPECT_EQ(overlapping_pairs(boxes, by_tree).size(), 300U * 299U / 2U);
}

TYPED_TEST(PairsTest, NaNIsRefusedWithTheIndexOfItsBox) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (Dim axis = 0; axis < N; ++axis) {
    for (const bool at_max : {false, true}) {
      std::vector<Aabb<N, T>> boxes(5);
      (at_max ? boxes[3].max : boxes[3].min)[axis] = std::numeric_limits<T>::quiet_NaN();
      try {
        overlapping_pairs(boxes);
        FAIL() << "NaN was accepted";
      } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("box 3 has a coordinate that is NaN"), std::string::npos)
            << error.what();
      }
      EXPECT_THROW(overlapping_pairs(std::vector<Aabb<N, T>>(2), boxes), std::invalid_argument);
    }
  }
}

}  // namespace
}  // namespace graze
