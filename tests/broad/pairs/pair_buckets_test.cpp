// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/pairs/pair_buckets.hpp>

namespace graze::detail::pair_buckets_test {
namespace {

std::vector<Pair> sorted(std::vector<Pair> pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

template <class Code>
std::vector<Pair> bucket_of(const PairBuckets& buckets, std::size_t bucket, PairCode form) {
  std::vector<Pair> result;
  buckets.for_each_part<Code>(bucket, [&result, bucket, form](std::span<const Code> part) {
    EXPECT_FALSE(part.empty());
    for (const Code code : part) {
      const auto first = static_cast<std::uint32_t>(bucket << form.row_bits);
      result.push_back({first + form.row_of(code), form.second_of(code)});
    }
  });
  EXPECT_EQ(result.size(), buckets.count(bucket));
  return sorted(result);
}

/// Pairs whose first indices are concentrated in low buckets.
std::vector<Pair> random_pairs(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<Pair> pairs;
  for (std::uint32_t k = 0; k < count; ++k) {
    pairs.push_back({static_cast<std::uint32_t>(random() % 640) >> random() % 4, k});
  }
  return pairs;
}

template <class Code>
void expect_held(PairBuckets& kept, std::size_t count, PairCode form) {
  constexpr std::size_t buckets = 10;
  const std::vector<Pair> pairs = random_pairs(count, static_cast<std::uint32_t>(count));
  kept.clear(buckets, form);
  for (std::size_t first = 0, size = 1; first < count; first += size, size = size * 3 % 1'000 + 1) {
    kept.add(std::span<const Pair>(pairs).subspan(first, std::min(size, count - first)));
  }
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    std::vector<Pair> expected;
    std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(expected),
                 [bucket, form](const Pair& pair) { return form.bucket_of(pair) == bucket; });
    EXPECT_EQ(bucket_of<Code>(kept, bucket, form), sorted(expected)) << count << " pairs, bucket " << bucket;
  }
}

TEST(PairBuckets, HoldEachPairOnceInItsBucketHoweverItCame) {
  PairBuckets kept;  // its memory is reused for more pairs, then for fewer, in codes of both widths
  for (const std::size_t count : {0U, 1U, 3U, 4U, 100U, 2'000U, 50'000U, 500U}) {
    expect_held<std::int32_t>(kept, count, {.row_bits = 6, .second_bits = 16});
    expect_held<std::int64_t>(kept, count, {.row_bits = 6, .second_bits = 32});
  }
}

TEST(PairBuckets, SayWhatTheyHold) {
  PairBuckets buckets;
  for (const std::uint32_t second_bits : {16U, 32U}) {
    const std::size_t code_bytes = second_bits == 16 ? sizeof(std::int32_t) : sizeof(std::int64_t);
    buckets = PairBuckets();
    buckets.clear(4, {.row_bits = 1, .second_bits = second_bits});
    const std::size_t before = buckets.bytes();
    buckets.add(std::vector<Pair>(10'000, Pair{5, 6}));
    EXPECT_EQ(buckets.count(2), 10'000U);
    EXPECT_EQ(buckets.count(3), 0U);
    EXPECT_GE(buckets.bytes(), before + 9'000 * code_bytes);
    EXPECT_LE(buckets.bytes(), before + 30'000 * code_bytes);
  }
}

}  // namespace
}  // namespace graze::detail::pair_buckets_test
