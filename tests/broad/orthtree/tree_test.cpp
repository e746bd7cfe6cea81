// SPDX-License-Identifier: MIT
// Invariants of a CellTree after any sequence of calls; orthtree_test.cpp and spatial_index_laws.hpp have the rest.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/orthtree/tree.hpp>

#include "broad/cell_checks.hpp"

namespace graze::detail::cell_tree_test {
namespace {

using Tree = CellTree<2, float>;
using Box = Aabb<2, float>;
using test::expect_sound;

RC_GTEST_PROP(CellTree, IsSoundAfterAnySequenceOfCalls, ()) {
  Tree tree({*rc::gen::inRange<std::size_t>(1, 5), *rc::gen::inRange(0, 12)});
  std::map<std::uint32_t, Box> boxes;
  std::uint32_t slots = 0;
  const auto small = rc::gen::inRange(0, 40);
  const auto steps = *rc::gen::scale(
      3.0, rc::gen::container<std::vector<std::vector<int>>>(rc::gen::container<std::vector<int>>(6, small)));
  for (const std::vector<int>& step : steps) {
    const float scale = step[1] == 0 ? 1e6F : step[1] == 1 ? 1e-3F : 1.0F;
    const Vec<2> low = Vec<2>(step[2], step[3]) * scale;
    const Vec<2> size = Vec<2>(step[4] % 7, step[5] % 7) * scale;
    const auto picked =
        boxes.empty() ? boxes.end() : std::next(boxes.begin(), step[1] % static_cast<int>(boxes.size()));
    if (step[0] % 8 < 4 || boxes.empty()) {
      boxes[slots] = {low, low + size};
      tree.insert(slots++, {low, low + size});
    } else if (step[0] % 8 < 6) {
      picked->second = {low, low + size};
      tree.update(picked->first, picked->second);
    } else {
      tree.erase(picked->first);
      boxes.erase(picked);
    }
    if (step[0] == 0) expect_sound(tree, boxes);
  }
  expect_sound(tree, boxes);
}

TEST(CellTree, RefusesOptionsBeyondTheirLimits) {
  EXPECT_THROW(Tree({0, 5}), std::invalid_argument);
  EXPECT_THROW(Tree({1, -1}), std::invalid_argument);
  EXPECT_THROW(Tree({1, 33}), std::invalid_argument);
  EXPECT_NO_THROW(Tree({1, 32}));
}

TEST(CellTree, ForgetsEverythingWhenItIsEmpty) {
  Tree tree({2, 8});
  for (std::uint32_t slot = 0; slot < 100; ++slot) {
    const std::uint32_t row = slot / 10;
    const Vec<2> place(static_cast<float>(slot % 10), static_cast<float>(row));
    tree.insert(slot, {place, place});
  }
  ASSERT_TRUE(tree.has_root());
  for (std::uint32_t slot = 0; slot < 100; ++slot) tree.erase(slot * 37 % 100);
  EXPECT_FALSE(tree.has_root());
}

/// Insertions, moves and removals forever do not increase the memory.
TEST(CellTree, DoesNotGrowWithTheNumberOfCalls) {
  Tree tree({4, 10});
  const auto box = [](std::uint32_t slot, std::uint32_t round) {
    const Vec<2> place(static_cast<float>((slot * 7 + round * 13) % 97), static_cast<float>((slot * 31 + round) % 89));
    return Box{place, place + 1.0F};
  };
  for (std::uint32_t slot = 0; slot < 300; ++slot) tree.insert(slot, box(slot, 0));
  std::size_t bytes = 0;
  for (std::uint32_t round = 1; round < 60; ++round) {
    for (std::uint32_t slot = 0; slot < 300; ++slot) {
      if ((slot + round) % 3 == 0) {
        tree.erase(slot);
        tree.insert(slot, box(slot, round));
      } else {
        tree.update(slot, box(slot, round));
      }
    }
    if (round == 20) bytes = tree.bytes();
  }
  EXPECT_LE(tree.bytes(), 2 * bytes);
}

}  // namespace
}  // namespace graze::detail::cell_tree_test
