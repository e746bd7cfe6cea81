// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/pair_buckets.hpp>

namespace graze::detail::pair_buckets_test {
namespace {

std::vector<Pair> sorted(std::vector<Pair> pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<Pair> bucket_of(const PairBuckets& buckets, std::size_t bucket) {
  std::vector<Pair> result;
  buckets.for_each_part(bucket, [&result](std::span<const Pair> part) {
    EXPECT_FALSE(part.empty());
    result.insert(result.end(), part.begin(), part.end());
  });
  EXPECT_EQ(result.size(), buckets.count(bucket));
  return sorted(result);
}

/// Pairs whose first indices crowd in low buckets.
std::vector<Pair> random_pairs(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<Pair> pairs;
  for (std::uint32_t k = 0; k < count; ++k) {
    pairs.push_back({static_cast<std::uint32_t>(random() % 640) >> random() % 4, k});
  }
  return pairs;
}

TEST(PairBuckets, HoldEachPairOnceInItsBucketHoweverItCame) {
  constexpr std::size_t buckets = 10;
  constexpr std::uint32_t shift = 6;
  PairBuckets kept;  // its memory serves for more pairs, then for fewer
  for (const std::size_t count : {0U, 1U, 3U, 4U, 100U, 2'000U, 50'000U, 500U}) {
    const std::vector<Pair> pairs = random_pairs(count, static_cast<std::uint32_t>(count));
    kept.clear(buckets, shift);
    for (std::size_t first = 0, size = 1; first < count; first += size, size = size * 3 % 1'000 + 1) {
      kept.add(std::span<const Pair>(pairs).subspan(first, std::min(size, count - first)));
    }
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
      std::vector<Pair> expected;
      std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(expected),
                   [bucket](const Pair& pair) { return pair.a >> shift == bucket; });
      EXPECT_EQ(bucket_of(kept, bucket), sorted(expected)) << count << " pairs, bucket " << bucket;
    }
  }
}

TEST(PairBuckets, SayWhatTheyHold) {
  PairBuckets buckets;
  buckets.clear(4, 1);
  const std::size_t before = buckets.bytes();
  buckets.add(std::vector<Pair>(10'000, Pair{5, 6}));
  EXPECT_EQ(buckets.count(2), 10'000U);
  EXPECT_EQ(buckets.count(3), 0U);
  EXPECT_GE(buckets.bytes(), before + 9'000 * sizeof(Pair));
  EXPECT_LE(buckets.bytes(), before + 30'000 * sizeof(Pair));
}

}  // namespace
}  // namespace graze::detail::pair_buckets_test
