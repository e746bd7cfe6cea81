// SPDX-License-Identifier: MIT
// The kernels of every instruction set of this machine, and those for none at all, against plain loops, bit for bit.
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/block_kernels.hpp>
#include <graze/broad/meet_kernels.hpp>

#include "box_worlds.hpp"
#include "simd_targets.hpp"

namespace graze::detail::meet_kernels_test {
namespace {

template <Dim N, class T>
struct In {
  static constexpr Dim dimension = N;
  using scalar = T;
};

template <class Space>
class MeetKernelsTest : public testing::Test {
 protected:
  /// Calls test(kernels) for each instruction set.
  template <class Test>
  void for_every_target(const Test& test) {
    for (const std::int64_t target : test::simd_targets()) {
      const test::ForcedTarget forced(target);
      const auto& kernels = meet_kernels<Space::dimension, typename Space::scalar>();
      SCOPED_TRACE(hwy::TargetName(target));
      test(kernels);
    }
  }
};

using Spaces = testing::Types<In<2, float>, In<3, float>, In<2, double>, In<3, double>>;
TYPED_TEST_SUITE(MeetKernelsTest, Spaces);

TYPED_TEST(MeetKernelsTest, MeetingsAreThoseOfPlainLoops) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  constexpr std::uint32_t count = 5 * block_size - 3;
  for (const auto& world : test::box_worlds<N, T>(count, 7)) {
    if (world.name.find("empty") != std::string::npos) continue;  // such boxes never come so far
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
        EXPECT_EQ(std::count_if(found.begin(), found.end(), itself), 1) << "block " << i << " must meet itself";
      }
      std::vector<Pair> pairs(found.size() * 256);
      pairs.resize(kernels.meet(blocks.data(), ids.data(), blocks.data(), ids.data(), above.data(), true, found.data(),
                                found.size(), pairs.data()));
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
  std::vector<BlockPair> meetings;  // more than are looked at in one go
  for (std::uint32_t i = 0; i < block_count; ++i) {
    for (std::uint32_t j = i; j < block_count; ++j) meetings.push_back({i, j});
  }
  ASSERT_GT(meetings.size(), 2 * block_pairs_at_once);
  for (const auto& world : test::box_worlds<N, T>(count, 11)) {
    if (world.name.find("empty") != std::string::npos) continue;  // such boxes never come so far
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

}  // namespace
}  // namespace graze::detail::meet_kernels_test
