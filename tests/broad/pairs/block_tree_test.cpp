// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/pairs/block_tree.hpp>

#include "broad/box_worlds.hpp"

namespace graze::detail::block_tree_test {
namespace {

/// The box in a lane, or an empty box if there is none.
template <Dim N, class T>
Aabb<N, T> lane_of(const Block<N, T>* blocks, std::size_t position) {
  const Block<N, T>& block = blocks[position / block_size];
  Aabb<N, T> box;
  for (Dim i = 0; i < N; ++i) {
    box.min[i] = block.min[i][position % block_size];
    box.max[i] = block.max[i][position % block_size];
  }
  return std::isnan(box.min[0]) ? Aabb<N, T>::nothing() : box;
}

template <Dim N, class T>
void expect_sound(const BlockTree<N, T>& tree, const std::vector<Aabb<N, T>>& boxes) {
  std::vector<int> seen(boxes.size());
  ASSERT_GE(tree.height(), 2U);
  EXPECT_EQ(tree.level_size(tree.height() - 1), 1U);
  for (std::size_t k = 0; k < tree.level_size(0) * block_size; ++k) {
    const Aabb<N, T> box = lane_of(tree.level(0), k);
    if (is_nothing(box)) continue;
    EXPECT_EQ(box, boxes[tree.ids()[k]]);
    ++seen[tree.ids()[k]];
  }
  for (std::size_t k = 0; k < boxes.size(); ++k) EXPECT_EQ(seen[k], is_nothing(boxes[k]) ? 0 : 1) << "box " << k;
  for (std::size_t level = 1; level < tree.height(); ++level) {
    for (std::size_t k = 0; k < tree.level_size(level) * block_size; ++k) {
      Aabb<N, T> bounds = Aabb<N, T>::nothing();
      for (std::size_t j = 0; k < tree.level_size(level - 1) && j < block_size; ++j) {
        bounds.grow(lane_of(tree.level(level - 1), k * block_size + j));
      }
      EXPECT_EQ(lane_of(tree.level(level), k), bounds) << "lane " << k << " of level " << level;
    }
  }
}

TEST(BlockTree, HoldsEveryBoxOnceAndEveryLevelBoundsTheOneBelow) {
  for (const std::size_t count : {1U, 16U, 17U, 256U, 257U, 6000U}) {
    BlockTree<3, float> solid;
    for (const auto& world : test::box_worlds<3, float>(count, 21)) {
      if (count == 1 && world.name.find("empty") != std::string::npos) continue;
      SCOPED_TRACE(world.name + ", " + std::to_string(count));
      solid.build(world.boxes, 0, default_executor());  // repeatedly in the same memory
      expect_sound(solid, world.boxes);
    }
    BlockTree<2, double> flat;
    for (const auto& world : test::box_worlds<2, double>(count, 22)) {
      if (count == 1 && world.name.find("empty") != std::string::npos) continue;
      SCOPED_TRACE(world.name + ", " + std::to_string(count));
      flat.build(world.boxes, 0, serial_executor());
      expect_sound(flat, world.boxes);
    }
  }
}

TEST(BlockTree, OfNothingHasNoLevels) {
  BlockTree<2, float> tree;
  tree.build({}, 0, serial_executor());
  EXPECT_EQ(tree.height(), 0U);
  const std::vector<Rect<float>> nothings(100, Rect<float>::nothing());
  tree.build(nothings, 0, serial_executor());
  EXPECT_EQ(tree.height(), 0U);
}

TEST(BlockTree, GrowsBoxesByTheMargin) {
  const std::vector<Rect<float>> boxes{{{0, 1}, {2, 3}}};
  BlockTree<2, float> tree;
  tree.build(boxes, 0.5F, serial_executor());
  EXPECT_EQ(lane_of(tree.level(0), 0), (Rect<float>{{-0.5F, 0.5F}, {2.5F, 3.5F}}));
}

TEST(BlockTree, CanBeRaised) {
  const std::vector<Rect<float>> boxes{{{0, 1}, {2, 3}}};
  BlockTree<2, float> tree;
  tree.build(boxes, 0, serial_executor());
  EXPECT_EQ(tree.height(), 2U);
  tree.raise(5);
  EXPECT_EQ(tree.height(), 5U);
  expect_sound(tree, boxes);
  tree.raise(3);  // already higher
  EXPECT_EQ(tree.height(), 5U);
}

/// Moves every box a little, in its own direction.
template <Dim N, class T>
void stir(std::vector<Aabb<N, T>>& boxes, double step, test::Numbers& numbers) {
  for (Aabb<N, T>& box : boxes) {
    const Vec<N, T> by = numbers.point<N, T>(-step, step);
    box = {box.min + by, box.max + by};
  }
}

TEST(BlockTree, TakesBoxesThatHaveMovedInTheOrderOfTheLast) {
  test::Numbers numbers(6);
  for (const std::size_t count : {1U, 16U, 17U, 300U, 6000U}) {
    std::vector<Aabb<3, float>> boxes = test::box_worlds<3, float>(count, 23).front().boxes;
    BlockTree<3, float> tree;
    EXPECT_FALSE(tree.refit(boxes, 0, serial_executor())) << "there is no order yet";
    tree.build(boxes, 0, serial_executor());
    tree.raise(5);
    const std::vector<std::uint32_t> order(tree.ids(), tree.ids() + tree.level_size(0) * block_size);
    for (int frame = 0; frame < 3; ++frame) {
      stir(boxes, 0.01, numbers);
      ASSERT_TRUE(tree.refit(boxes, 0, default_executor())) << count;
      expect_sound(tree, boxes);
      EXPECT_TRUE(std::equal(order.begin(), order.end(), tree.ids()));
    }
  }
}

TEST(BlockTree, RefitsToBoxesGrownByAMargin) {
  std::vector<Rect<float>> boxes{{{0, 1}, {2, 3}}};
  BlockTree<2, float> tree;
  tree.build(boxes, 0, serial_executor());
  boxes[0] = {{0, 1}, {2, 2.5F}};
  ASSERT_TRUE(tree.refit(boxes, 0.5F, serial_executor()));
  EXPECT_EQ(lane_of(tree.level(1), 0), (Rect<float>{{-0.5F, 0.5F}, {2.5F, 3}}));
}

TEST(BlockTree, DoesNotRefitWhatIsBetterSortedAnew) {
  const std::vector<Aabb<3, float>> boxes = test::box_worlds<3, float>(20'000, 24).front().boxes;
  BlockTree<3, float> tree;
  tree.build(boxes, 0, serial_executor());
  EXPECT_FALSE(tree.refit(std::span(boxes).first(19'999), 0, serial_executor()));
  std::vector<Aabb<3, float>> others = boxes;
  std::reverse(others.begin(), others.end());
  EXPECT_FALSE(tree.refit(others, 0, serial_executor()));
  others = boxes;
  for (std::size_t k = 0; k < others.size(); k += 100)
    others[k] = boxes[others.size() - 1 - k];  // one of a hundred jumps
  EXPECT_FALSE(tree.refit(others, 0, serial_executor()));
  others = boxes;
  others[777].min.y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(tree.refit(others, 0, serial_executor()));
  EXPECT_TRUE(tree.refit(boxes, 0, serial_executor()));
  expect_sound(tree, boxes);
  others[777] = Aabb<3, float>::nothing();
  EXPECT_FALSE(tree.refit(others, 0, serial_executor()));
  tree.build(others, 0, serial_executor());
  EXPECT_FALSE(tree.refit(others, 0, serial_executor())) << "empty boxes may become non-empty";
}

TEST(BlockTree, SlowDriftIsSortedAnewInTheEnd) {
  test::Numbers numbers(7);
  std::vector<Aabb<3, float>> boxes = test::box_worlds<3, float>(5000, 25).front().boxes;
  BlockTree<3, float> tree;
  tree.build(boxes, 0, serial_executor());
  int frames = 0;
  for (; frames < 1000; ++frames) {
    stir(boxes, 0.2, numbers);
    if (!tree.refit(boxes, 0, serial_executor())) break;
  }
  EXPECT_GT(frames, 2);
  EXPECT_LT(frames, 100);
}

TEST(BlockTree, NeighboursShareBlocks) {
  test::Numbers numbers(5);
  std::vector<Aabb<3, float>> boxes;
  for (int k = 0; k < 30'000; ++k) {
    boxes.push_back(Aabb<3, float>::from_center(numbers.point<3, float>(0, 60), Vec<3>(0.0F)));
  }
  BlockTree<3, float> tree;
  tree.build(boxes, 0, serial_executor());
  double volume = 0;
  for (std::size_t k = 0; k < tree.level_size(0); ++k) {
    const Aabb<3, float> bounds = lane_of(tree.level(1), k);
    const Vec<3> side = bounds.max - bounds.min;
    volume += static_cast<double>(side.x) * static_cast<double>(side.y) * static_cast<double>(side.z);
  }
  // Blocks of points that fill the cube would have its volume in total; twice as much is the cost of the curve.
  EXPECT_LT(volume, 2.0 * 60 * 60 * 60);
}

}  // namespace
}  // namespace graze::detail::block_tree_test
