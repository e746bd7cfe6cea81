// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/bvh/split.hpp>
#include <graze/shape/shape.hpp>

#include "broad/box_worlds.hpp"

namespace graze::detail::bvh_split_test {
namespace {

using Entries = BvhEntries<3, float>;

/// The entries of the first side, sorted.
std::vector<std::uint32_t> first_side(Entries entries) {
  const std::uint32_t first = split_entries(entries);
  std::vector<std::uint32_t> side;
  for (std::uint32_t k = 0; k < first; ++k) side.push_back(entries.all[k].entry);
  std::sort(side.begin(), side.end());
  return side;
}

TEST(BvhSplit, CutsWhereThereIsAGap) {
  for (Dim axis = 0; axis < 3; ++axis) {
    Entries entries;
    for (std::uint32_t k = 0; k < 17; ++k) {
      Vec<3> low(static_cast<float>(k));
      low[axis] = static_cast<float>(k * 5 % 17 < 7 ? k : 1000 + k);
      entries.add({{low, low + 1.0F}, k});
    }
    std::vector<std::uint32_t> low;
    for (std::uint32_t k = 0; k < 17; ++k) {
      if (k * 5 % 17 < 7) low.push_back(k);
    }
    EXPECT_EQ(first_side(entries), low) << axis;
  }
}

TEST(BvhSplit, LeavesEnoughAndNotTooManyOnEitherSide) {
  constexpr float most = std::numeric_limits<float>::max();
  for (std::uint32_t count = block_size + 1; count <= 2 * block_size; ++count) {
    std::vector<Entries> cases(3);
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto place = static_cast<float>(k * k);
      cases[0].add({Aabb<3>{}, k});                                      // all equal
      cases[1].add({{Vec<3>(k == 0 ? -most : 1.0F), Vec<3>(most)}, k});  // the largest numbers
      cases[2].add({{Vec<3>(place), Vec<3>(place)}, count - k});         // increasing distances
    }
    for (Entries& entries : cases) {
      const std::uint32_t first = split_entries(entries);
      const std::uint32_t least = std::max(bvh_least, count - block_size);
      EXPECT_GE(first, least);
      EXPECT_LE(first, count - least);
    }
  }
}

TEST(BvhSplit, DependsOnTheSetOfEntriesAlone) {
  for (const auto& world : test::box_worlds<3, float>(20, 7)) {
    Entries entries;
    Entries reversed;
    std::vector<std::uint32_t> all;
    for (std::uint32_t k = 0; k < 20; ++k) {
      if (!is_valid(world.boxes[k])) continue;
      entries.add({world.boxes[k], k});
      all.push_back(k);
    }
    if (all.size() <= block_size) continue;
    for (std::size_t k = all.size(); k-- > 0;) reversed.add({world.boxes[all[k]], all[k]});
    EXPECT_EQ(first_side(entries), first_side(reversed)) << world.name;
    split_entries(entries);
    std::vector<std::uint32_t> kept;
    for (std::uint32_t k = 0; k < entries.count; ++k) kept.push_back(entries.all[k].entry);
    std::sort(kept.begin(), kept.end());
    EXPECT_EQ(kept, all) << world.name;
  }
}

TEST(BvhSplit, TakesTheEntriesOfANode) {
  BvhNode<3, float> node;
  clear_lanes(node, 0);
  put_box(node.boxes, 0, Aabb<3>{{1, 2, 3}, {4, 5, 6}});
  node.entries[0] = 7;
  put_box(node.boxes, 1, Aabb<3>{{0, 0, 0}, {1, 1, 1}});
  node.entries[1] = 9;
  Entries entries;
  entries.add(node, 2);
  ASSERT_EQ(entries.count, 2U);
  EXPECT_EQ(entries.all[0].box, (Aabb<3>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(entries.all[0].entry, 7U);
  EXPECT_EQ(entries.all[1].entry, 9U);
}

}  // namespace
}  // namespace graze::detail::bvh_split_test
