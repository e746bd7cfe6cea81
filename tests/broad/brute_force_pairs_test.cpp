// SPDX-License-Identifier: MIT
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/brute_force_pairs.hpp>

namespace graze::brute_force_pairs_test {
namespace {

using Box = Aabb<2, float>;

TEST(BruteForcePairs, CountsTouchingAndLeavesOutBoxesThatContainNothing) {
  const std::vector<Box> boxes = {
      {{0, 0}, {1, 1}}, {{1, 1}, {2, 2}}, Box::nothing(), {{3, 0}, {4, 1}}, Box::everything()};
  const std::vector<Pair> expected = {{0, 1}, {0, 4}, {1, 4}, {3, 4}};
  EXPECT_EQ(brute_force_pairs(std::span<const Box>(boxes)), expected);
}

TEST(BruteForcePairs, BetweenTwoSetsKeepsEachSetsOwnIndices) {
  const std::vector<Box> first = {{{0, 0}, {1, 1}}, Box::nothing(), {{5, 5}, {6, 6}}};
  const std::vector<Box> second = {{{6, 6}, {7, 7}}, {{0.5F, 0.5F}, {0.6F, 0.6F}}, Box::nothing()};
  const std::vector<Pair> expected = {{0, 1}, {2, 0}};
  EXPECT_EQ(brute_force_pairs(std::span<const Box>(first), std::span<const Box>(second)), expected);
}

}  // namespace
}  // namespace graze::brute_force_pairs_test
