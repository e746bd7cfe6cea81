// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <graze/scene/update/compaction_kernels.hpp>

#include "broad/simd_targets.hpp"

namespace graze::detail::choice_kernels_test {
namespace {

constexpr Pair untouched{7, 7};
constexpr std::uint32_t nowhere = 0xFFFFFFFFU;

TEST(CompactionKernels, KeepTheMarkedPairsAndTheirPlacesInOrder) {
  std::mt19937 random(3);
  for (std::size_t count = 0; count < 70; ++count) {
    for (const unsigned marked_of_8 : {0U, 1U, 4U, 7U, 8U}) {
      std::vector<Pair> pairs(count);
      std::vector<char> marks(count);
      std::vector<Pair> expected;
      std::vector<std::uint32_t> expected_places;
      for (std::size_t k = 0; k < count; ++k) {
        pairs[k] = {static_cast<std::uint32_t>(random()), static_cast<std::uint32_t>(random())};
        marks[k] = random() % 8 < marked_of_8 ? 1 : 0;
        if (marks[k] == 0) continue;
        expected.push_back(pairs[k]);
        expected_places.push_back(static_cast<std::uint32_t>(k));
      }
      for (const std::int64_t target : test::simd_targets()) {
        const test::ForcedTarget forced(target);
        std::vector<Pair> chosen(count + room_behind_chosen + 1, untouched);
        std::vector<std::uint32_t> places(count + room_behind_chosen + 1, nowhere);
        const std::size_t number =
            compaction_kernels().choose(pairs.data(), marks.data(), count, chosen.data(), places.data());
        ASSERT_EQ(number, expected.size()) << hwy::TargetName(target);
        EXPECT_TRUE(std::equal(expected.begin(), expected.end(), chosen.begin())) << hwy::TargetName(target);
        EXPECT_TRUE(std::equal(expected_places.begin(), expected_places.end(), places.begin()))
            << hwy::TargetName(target);
        EXPECT_EQ(chosen[number + room_behind_chosen], untouched) << hwy::TargetName(target);
        EXPECT_EQ(places[number + room_behind_chosen], nowhere) << hwy::TargetName(target);
      }
    }
  }
}

/// Signalling NaNs in moved data: pairs whose bits are such a NaN.
TEST(CompactionKernels, MovePairsAsTheyAre) {
  const std::vector<Pair> pairs(16, Pair{1, 0x7FF00000U});
  const std::vector<char> marks(16, 1);
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    std::vector<Pair> chosen(16 + room_behind_chosen);
    std::vector<std::uint32_t> places(16 + room_behind_chosen);
    ASSERT_EQ(compaction_kernels().choose(pairs.data(), marks.data(), 16, chosen.data(), places.data()), 16U);
    chosen.resize(16);
    EXPECT_EQ(chosen, pairs) << hwy::TargetName(target);
  }
}

}  // namespace
}  // namespace graze::detail::choice_kernels_test
