// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/pair_sort.hpp>

#include "simd_targets.hpp"

namespace graze::detail::pair_sort_test {
namespace {

/// Shuffles the pairs, cuts them into pieces, sorts, and compares with std::sort.
void expect_sorted(std::vector<Pair> pairs, std::size_t limit_a, std::size_t limit_b) {
  std::vector<Pair> expected = pairs;
  std::sort(expected.begin(), expected.end());
  std::shuffle(pairs.begin(), pairs.end(), std::mt19937(7));
  for (const std::size_t piece_count : {1U, 2U, 7U}) {
    std::vector<std::span<const Pair>> pieces;
    for (std::size_t k = 0; k < piece_count; ++k) {
      const std::size_t first = k * pairs.size() / piece_count;
      pieces.push_back(std::span<const Pair>(pairs).subspan(first, (k + 1) * pairs.size() / piece_count - first));
    }
    for (const std::int64_t target : test::simd_targets()) {
      const test::ForcedTarget forced(target);
      std::vector<Pair> sorted(pairs.size());
      PairSort().sort(pieces, limit_a, limit_b, *limited_executor(2), sorted.data());
      EXPECT_EQ(sorted, expected) << piece_count << " pieces, " << hwy::TargetName(target);
    }
  }
}

TEST(PairSort, OfNothing) { expect_sorted({}, 0, 0); }

TEST(PairSort, OfOnePair) { expect_sorted({{4294967294U, 4294967295U}}, 4294967295U, 4294967296U); }

TEST(PairSort, OfFewPartnersEach) {
  std::mt19937 random(1);
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < 100'000; ++a) {
    const auto count = static_cast<std::uint32_t>(random() % 4);
    for (std::uint32_t k = 0; k < count; ++k) {
      pairs.push_back({a, a + 1 + k * 1000 + static_cast<std::uint32_t>(random() % 1000)});
    }
  }
  expect_sorted(pairs, 100'000, 104'000);
}

TEST(PairSort, OfFewPartnersEachAndManyForAFew) {
  std::mt19937 random(2);
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < 20'000; ++a) {
    const std::uint32_t count = a % 500 == 3 ? 9 + a % 32 : static_cast<std::uint32_t>(random() % 9);
    for (std::uint32_t k = 0; k < count; ++k) {
      pairs.push_back({a, a + 1 + k * 1000 + static_cast<std::uint32_t>(random() % 1000)});
    }
  }
  expect_sorted(pairs, 20'000, 70'000);
}

TEST(PairSort, OfAllKindsOfNumbersOfPartners) {
  std::vector<Pair> pairs;
  std::uint32_t a = 0;
  for (const std::uint32_t partners : {0U, 1U, 16U, 17U, 24U, 25U, 96U, 97U, 1025U, 70'000U}) {
    for (std::uint32_t b = 0; b < partners; ++b) pairs.push_back({a, b * 3});
    a += 300;
  }
  expect_sorted(pairs, a, 210'000);
}

TEST(PairSort, OfEveryoneWithEveryone) {
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < 400; ++a) {
    for (std::uint32_t b = a + 1; b < 400; ++b) pairs.push_back({a, b});
  }
  expect_sorted(pairs, 400, 400);
}

TEST(PairSort, OfTheLargestIndices) {
  constexpr std::uint32_t last = 0xFFFFFFFFU;
  std::vector<Pair> pairs;
  for (std::uint32_t k = 1; k < 200; ++k) {
    pairs.push_back({last - k, last});
    pairs.push_back({last - 200, last - k});
  }
  expect_sorted(pairs, std::size_t{last} + 1, std::size_t{last} + 1);
}

}  // namespace
}  // namespace graze::detail::pair_sort_test
