// SPDX-License-Identifier: MIT
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/pairs/block_spread.hpp>

namespace graze::detail::block_spread_test {
namespace {

/// Bounds of blocks, one per lane.
std::vector<Block<2, float>> lanes_with(const std::vector<Vec<2>>& extents) {
  std::vector<Block<2, float>> above(extents.size() / block_size + 1);
  for (std::size_t k = 0; k < extents.size(); ++k) {
    for (Dim i = 0; i < 2; ++i) {
      above[k / block_size].min[i][k % block_size] = 10;
      above[k / block_size].max[i][k % block_size] = 10 + extents[k][i];
    }
  }
  return above;
}

TEST(BlockSpread, OfAUsualBlockIsTwoToThePowerOfItsDimension) {
  const auto above = lanes_with(std::vector<Vec<2>>(100, Vec<2>(2, 4)));
  BlockSpread<2, float> spread;
  spread.take_as_usual(above.data(), 100);
  EXPECT_EQ(spread.of(above.data(), 99), 4 * 64U);
  EXPECT_EQ(spread.of(above.data(), 20, 30), 10 * 4 * 64U);
  EXPECT_EQ(spread.of(above.data(), 20, 20), 0U);
}

TEST(BlockSpread, GrowsAsBlocksReachFurtherButNotBeyondTheirNumber) {
  std::vector<Vec<2>> extents(1000, Vec<2>(2, 4));
  extents[0] = {4, 4};     // (2 + 1) * (1 + 1)
  extents[1] = {18, 36};   // (9 + 1) * (9 + 1)
  extents[2] = {2e5F, 4};  // more than there are
  extents[3] = {0, 0};     // a point overlaps only its own position
  extents[4] = {std::numeric_limits<float>::infinity(), 0};
  const auto above = lanes_with(extents);
  BlockSpread<2, float> spread;
  spread.take_as_usual(above.data(), extents.size());
  EXPECT_EQ(spread.of(above.data(), 0), 6 * 64U);
  EXPECT_EQ(spread.of(above.data(), 1), 100 * 64U);
  EXPECT_EQ(spread.of(above.data(), 2), 1000 * 64U);
  EXPECT_EQ(spread.of(above.data(), 3), 64U);
  EXPECT_EQ(spread.of(above.data(), 4), 1000 * 64U);
}

TEST(BlockSpread, LeavesOutAxesWithoutExtent) {
  const auto above = lanes_with(std::vector<Vec<2>>(50, Vec<2>(0, 4)));
  BlockSpread<2, float> spread;
  spread.take_as_usual(above.data(), 50);
  EXPECT_EQ(spread.of(above.data(), 7), 2 * 64U);
}

TEST(BlockSpread, OfBlocksThatAreAtInfinityIsTheirNumber) {
  std::vector<Vec<2>> extents(30, Vec<2>(1, 1));
  auto above = lanes_with(extents);
  above[0].min[0][3] = above[0].max[0][3] = std::numeric_limits<float>::infinity();  // their difference is NaN
  BlockSpread<2, float> spread;
  spread.take_as_usual(above.data(), extents.size());
  EXPECT_EQ(spread.of(above.data(), 3), 30 * 64U);
}

}  // namespace
}  // namespace graze::detail::block_spread_test
