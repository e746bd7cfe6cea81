// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/box_tree.hpp>

#include "box_worlds.hpp"

namespace graze::detail {
namespace {

std::vector<std::uint32_t> every_third(std::size_t count) {
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 0; i < count; i += 3) indices.push_back(i);
  return indices;
}

TEST(BoxTree, MeetsEachOverlappingPairOfItsOwnBoxesOnce) {
  const auto boxes = test::box_worlds<2, float>(200, 7).front().boxes;
  std::vector<Pair> found;
  BoxTree<2, float>(boxes, every_third(boxes.size())).visit_pairs([&](std::uint32_t i, std::uint32_t j) {
    found.push_back({std::min(i, j), std::max(i, j)});
  });
  std::sort(found.begin(), found.end());
  std::vector<Pair> expected;
  for (std::uint32_t i = 0; i < boxes.size(); i += 3) {
    for (std::uint32_t j = i + 3; j < boxes.size(); j += 3) {
      if (boxes_overlap(boxes[i], boxes[j])) expected.push_back({i, j});
    }
  }
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(found, expected);
}

TEST(BoxTree, WithoutBoxesMeetsNothing) {
  const std::vector<Aabb<3, double>> boxes(10);
  const BoxTree<3, double> empty(boxes, {});
  const BoxTree<3, double> full(boxes, {0, 1, 2});
  const auto never = [](std::uint32_t, std::uint32_t) { FAIL(); };
  empty.visit_pairs(never);
  empty.visit_pairs(full, never);
  full.visit_pairs(empty, never);
}

TEST(BoxTree, VisitsInTheSameOrderEveryTime) {
  const auto boxes = test::box_worlds<3, float>(500, 8)[1].boxes;
  std::vector<std::uint32_t> indices(boxes.size());
  for (std::uint32_t i = 0; i < indices.size(); ++i) indices[i] = i;
  std::vector<Pair> runs[2];
  for (auto& run : runs) {
    BoxTree<3, float>(boxes, indices).visit_pairs([&](std::uint32_t i, std::uint32_t j) { run.push_back({i, j}); });
  }
  EXPECT_FALSE(runs[0].empty());
  EXPECT_EQ(runs[0], runs[1]);
}

}  // namespace
}  // namespace graze::detail
