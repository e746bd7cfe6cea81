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

#include "box_arrays.hpp"
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
    const test::OwnedBoxArrays<N, T> arrays(world.boxes);
    std::vector<std::uint16_t> order(count);
    std::iota(order.begin(), order.end(), std::uint16_t{0});
    std::vector<Block<N, T>> blocks(5);
    std::vector<Block<N, T>> above(1);
    std::vector<std::uint32_t> ids(5 * block_size);
    const auto& best = block_kernels<N, T>();
    best.fill(*arrays, order.data(), count, blocks.data(), ids.data());
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
      found.resize(kernels.descend(above.data(), above.data(), true, &root, 1, found.data()));
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

}  // namespace
}  // namespace graze::detail::meet_kernels_test
