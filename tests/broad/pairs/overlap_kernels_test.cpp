// SPDX-License-Identifier: MIT
// Compares the kernels of every instruction set of this machine, and the scalar ones, with plain loops, bit for bit.
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/brute_force_pairs.hpp>
#include <graze/broad/pairs/block_kernels.hpp>
#include <graze/broad/pairs/overlap_kernels.hpp>

#include "broad/box_worlds.hpp"
#include "broad/simd_targets.hpp"
#include "spaces.hpp"

namespace graze::detail::meet_kernels_test {
namespace {

template <class Space>
class MeetKernelsTest : public testing::Test {
 protected:
  /// Calls test(kernels) for each instruction set.
  template <class Test>
  void for_every_target(const Test& test) {
    for (const std::int64_t target : test::simd_targets()) {
      const test::ForcedTarget forced(target);
      const auto& kernels = overlap_kernels<Space::dimension, typename Space::scalar>();
      SCOPED_TRACE(hwy::TargetName(target));
      test(kernels);
    }
  }
};

TYPED_TEST_SUITE(MeetKernelsTest, test::Spaces);

TYPED_TEST(MeetKernelsTest, MeetingsAreThoseOfPlainLoops) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  constexpr std::uint32_t count = 5 * block_size - 3;
  for (const auto& world : test::box_worlds<N, T>(count, 7)) {
    if (world.name.find("empty") != std::string::npos) continue;  // empty boxes never get this far
    SCOPED_TRACE(world.name);
    std::vector<std::uint16_t> order(count);
    std::iota(order.begin(), order.end(), std::uint16_t{0});
    std::vector<Block<N, T>> blocks(5);
    std::vector<Block<N, T>> above(1);
    std::vector<std::uint32_t> ids(5 * block_size);
    std::iota(ids.begin(), ids.end(), 1000U);
    const auto& best = block_kernels<N, T>();
    best.fill(world.boxes.data(), order.data(), count, T(0), blocks.data());
    best.close(blocks.data(), blocks.size(), above.data());
    std::vector<Pair> expected;
    std::vector<BlockPair> meetings;
    for (std::uint32_t i = 0; i < count; ++i) {
      for (std::uint32_t j = i + 1; j < count; ++j) {
        if (boxes_overlap(world.boxes[i], world.boxes[j])) expected.push_back({1000 + i, 1000 + j});
      }
    }
    std::vector<Pair> in_order;
    this->for_every_target([&](const auto& kernels) {
      const BlockPair root{0, 0};
      std::vector<BlockPair> found(256);
      found.resize(kernels.descend(above.data(), above.data(), nullptr, true, &root, 1, found.data()));
      ASSERT_LE(found.size(), block_pairs_at_once);
      for (std::uint32_t i = 0; i < 5; ++i) {
        const auto itself = [i](const BlockPair& pair) { return pair.a == i && pair.b == i; };
        EXPECT_EQ(std::count_if(found.begin(), found.end(), itself), 1)
            << "block " << i << " must be compared with itself";
      }
      std::vector<Pair> pairs(found.size() * 256);
      const BlockLevel<N, T> level{blocks.data(), ids.data(), above.data()};
      pairs.resize(kernels.meet(level, level, true, found.data(), found.size(), pairs.data()));
      if (in_order.empty()) in_order = pairs;
      EXPECT_EQ(pairs, in_order) << "the order depends on the instruction set";
      std::sort(pairs.begin(), pairs.end());
      EXPECT_EQ(pairs, expected);
    });
  }
}

TYPED_TEST(MeetKernelsTest, BlocksBelowPairsOfBlocksAreThoseOfPlainLoopsWhetherBoundsAreKnownOrNot) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  constexpr std::uint32_t block_count = 12;
  constexpr std::uint32_t count = block_count * block_size - 5;
  std::vector<BlockPair> meetings;  // more than are compared in one batch
  for (std::uint32_t i = 0; i < block_count; ++i) {
    for (std::uint32_t j = i; j < block_count; ++j) meetings.push_back({i, j});
  }
  ASSERT_GT(meetings.size(), 2 * block_pairs_at_once);
  for (const auto& world : test::box_worlds<N, T>(count, 11)) {
    if (world.name.find("empty") != std::string::npos) continue;  // empty boxes never get this far
    std::vector<std::uint16_t> order(count);
    std::iota(order.begin(), order.end(), std::uint16_t{0});
    std::vector<Block<N, T>> blocks(block_count);
    std::vector<Block<N, T>> above(1);
    const auto& best = block_kernels<N, T>();
    best.fill(world.boxes.data(), order.data(), count, T(0), blocks.data());
    best.close(blocks.data(), blocks.size(), above.data());
    for (const bool itself : {true, false}) {
      SCOPED_TRACE(world.name + (itself ? ", with itself" : ", with another"));
      std::vector<Pair> expected;
      for (const auto& [a, b] : meetings) {
        for (std::uint32_t i = a * block_size; i < std::min(count, (a + 1) * block_size); ++i) {
          for (std::uint32_t j = itself && a == b ? i : b * block_size; j < std::min(count, (b + 1) * block_size);
               ++j) {
            if (boxes_overlap(world.boxes[i], world.boxes[j])) expected.push_back({i, j});
          }
        }
      }
      this->for_every_target([&](const auto& kernels) {
        for (const Block<N, T>* bounds : {above.data(), static_cast<Block<N, T>*>(nullptr)}) {
          std::vector<BlockPair> found(meetings.size() * 256);
          found.resize(kernels.descend(blocks.data(), blocks.data(), bounds, itself, meetings.data(), meetings.size(),
                                       found.data()));
          std::vector<Pair> pairs;
          for (const auto& [a, b] : found) pairs.push_back({a, b});
          EXPECT_EQ(pairs, expected) << (bounds != nullptr ? "by bounds" : "without bounds");
        }
      });
    }
  }
}

/// Boxes in blocks in their original order, with ids from `first_id` on.
template <Dim N, class T>
struct Filled {
  Filled(const std::vector<Aabb<N, T>>& boxes, std::uint32_t first_id)
      : blocks((boxes.size() + block_size - 1) / block_size), above(1), ids(blocks.size() * block_size) {
    std::vector<std::uint16_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::uint16_t{0});
    std::iota(ids.begin(), ids.end(), first_id);
    block_kernels<N, T>().fill(boxes.data(), order.data(), order.size(), T(0), blocks.data());
    block_kernels<N, T>().close(blocks.data(), blocks.size(), above.data());
  }
  BlockLevel<N, T> level() const { return {blocks.data(), ids.data(), above.data()}; }

  std::vector<Block<N, T>> blocks;
  std::vector<Block<N, T>> above;
  std::vector<std::uint32_t> ids;
};

TYPED_TEST(MeetKernelsTest, LargeBoxesMeetSmallOnesFromEitherSide) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::Numbers numbers(5);
  std::vector<Aabb<N, T>> large;  // nearly all touch the bounds of any block of small ones, but few touch its boxes
  std::vector<Aabb<N, T>> small;
  for (std::uint32_t k = 0; k < 3 * block_size - 2; ++k) {
    large.push_back(Aabb<N, T>::from_center(numbers.point<N, T>(-40, 40), Vec<N, T>(T(30))));
    const auto place = static_cast<T>(k / block_size);
    small.push_back(Aabb<N, T>::from_center(Vec<N, T>(place) + numbers.point<N, T>(-8, 8), Vec<N, T>(T(0.5))));
  }
  const Filled<N, T> large_blocks(large, 1000);
  const Filled<N, T> small_blocks(small, 2000);
  std::vector<BlockPair> meetings;
  std::vector<Pair> large_first;
  for (std::uint32_t i = 0; i < 3; ++i) {
    for (std::uint32_t j = 0; j < 3; ++j) meetings.push_back({i, j});
  }
  for (std::uint32_t i = 0; i < large.size(); ++i) {
    for (std::uint32_t j = 0; j < small.size(); ++j) {
      if (boxes_overlap(large[i], small[j])) large_first.push_back({1000 + i, 2000 + j});
    }
  }
  std::vector<Pair> small_first;
  for (const auto& [i, j] : large_first) small_first.push_back({j, i});
  std::sort(small_first.begin(), small_first.end());
  ASSERT_GT(large_first.size(), 100U);
  ASSERT_LT(large_first.size(), large.size() * small.size() * 4 / 5);
  const auto met = [&](const auto& kernels, const Filled<N, T>& a, const Filled<N, T>& b, bool itself) {
    std::vector<Pair> pairs(meetings.size() * 256);
    pairs.resize(kernels.meet(a.level(), b.level(), itself, meetings.data(), meetings.size(), pairs.data()));
    return pairs;
  };
  std::vector<Pair> in_order;
  this->for_every_target([&](const auto& kernels) {
    std::vector<Pair> pairs = met(kernels, large_blocks, small_blocks, false);
    if (in_order.empty()) in_order = pairs;
    EXPECT_EQ(pairs, in_order) << "the order depends on the instruction set";
    std::sort(pairs.begin(), pairs.end());
    EXPECT_EQ(pairs, large_first);
    pairs = met(kernels, small_blocks, large_blocks, false);
    std::sort(pairs.begin(), pairs.end());
    EXPECT_EQ(pairs, small_first);
  });
}

TYPED_TEST(MeetKernelsTest, LargeBoxesMeetSmallOnesOfTheSameTree) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::Numbers numbers(6);
  std::vector<Aabb<N, T>> boxes;
  for (std::uint32_t k = 0; k < 4 * block_size; ++k) {
    const bool is_large = k / block_size % 2 == 0;
    boxes.push_back(is_large ? Aabb<N, T>::from_center(numbers.point<N, T>(-40, 40), Vec<N, T>(T(30)))
                             : Aabb<N, T>::from_center(numbers.point<N, T>(-8, 8), Vec<N, T>(T(0.5))));
  }
  const Filled<N, T> filled(boxes, 0);
  std::vector<BlockPair> meetings;
  for (std::uint32_t i = 0; i < 4; ++i) {
    for (std::uint32_t j = i; j < 4; ++j) meetings.push_back({i, j});
  }
  const std::vector<Pair> expected = brute_force_pairs(std::span<const Aabb<N, T>>(boxes));
  this->for_every_target([&](const auto& kernels) {
    std::vector<Pair> pairs(meetings.size() * 256);
    pairs.resize(kernels.meet(filled.level(), filled.level(), true, meetings.data(), meetings.size(), pairs.data()));
    std::sort(pairs.begin(), pairs.end());
    EXPECT_EQ(pairs, expected);
  });
}

}  // namespace
}  // namespace graze::detail::meet_kernels_test
