// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <graze/broad/pairs/pair_sort.hpp>

#include "broad/simd_targets.hpp"

namespace graze::detail::pair_sort_test {
namespace {

/// Output memory that must not be accessed before its start or after its end.
class ExactRoom final : public PairSink {
 public:
  Pair* all(std::size_t count) override {
    pairs.resize(count);
    return pairs.data();
  }
  bool appends() const override { return false; }
  const Pair* append(std::span<const Pair> /*pairs*/, std::size_t /*expected*/) override { return nullptr; }

  std::vector<Pair> pairs;
};

/// Sorts pieces, each as from a separate thread, into exactly sized memory.
std::vector<Pair> sorted_by(PairSort& sort, std::span<const Pair> pairs, std::size_t pieces, const PairLimits& limits) {
  sort.begin(limits);
  {
    std::vector<std::unique_ptr<PairSort::Sink>> sinks;
    for (std::size_t k = 0; k < pieces; ++k) {
      const std::size_t first = k * pairs.size() / pieces;
      sinks.push_back(std::make_unique<PairSort::Sink>(sort));
      sinks.back()->add(pairs.subspan(first, (k + 1) * pairs.size() / pieces - first));
    }
  }
  EXPECT_EQ(sort.count(), pairs.size());
  ExactRoom room;
  const Pair* const first = sort.sort(*limited_executor(2), room);
  EXPECT_EQ(first, room.pairs.data());
  return room.pairs;
}

/// Shuffles the pairs, cuts them into pieces, sorts, and compares with std::sort; then a third of them in the same
/// memory.
void expect_sorted(std::vector<Pair> pairs, std::size_t limit_a, std::size_t limit_b) {
  std::shuffle(pairs.begin(), pairs.end(), std::mt19937(7));
  const std::span<const Pair> third(pairs.data(), pairs.size() / 3);
  for (const std::size_t pieces : {1U, 2U, 7U}) {
    for (const std::int64_t target : test::simd_targets()) {
      const test::ForcedTarget forced(target);
      PairSort sort;
      for (const auto part : {std::span<const Pair>(pairs), third}) {
        std::vector<Pair> expected(part.begin(), part.end());
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(sorted_by(sort, part, pieces, {limit_a, limit_b}), expected)
            << pieces << " pieces, " << hwy::TargetName(target);
      }
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

TEST(PairSort, OfRowsOfEveryLengthThatIsSortedAsAWhole) {
  std::mt19937 random(3);
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < 5'000; ++a) {
    for (std::uint32_t k = 0; k < a % 37; ++k) {
      pairs.push_back({a, (k << 27U) + static_cast<std::uint32_t>(random() >> 5U)});
    }
  }
  expect_sorted(pairs, 5'000, std::size_t{1} << 32U);
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

/// Output memory that is partly known in advance, with guarded neighbours.
class RoomAhead final : public PairSink {
 public:
  static constexpr Pair mark = {7, 3};

  explicit RoomAhead(std::size_t known) : known_(known), memory_(known + 2 * margin, mark) {}

  std::span<Pair> ahead(std::size_t /*expected*/) override { return {memory_.data() + margin, known_}; }
  Pair* all(std::size_t count) override {
    if (count > known_) {
      memory_.assign(count + 2 * margin, mark);
      known_ = count;
    }
    return memory_.data() + margin;
  }
  bool appends() const override { return false; }
  const Pair* append(std::span<const Pair> /*pairs*/, std::size_t /*expected*/) override { return nullptr; }

  bool is_untouched_around() const {
    return std::all_of(memory_.begin(), memory_.begin() + margin, [](const Pair& pair) { return pair == mark; }) &&
           std::all_of(memory_.end() - margin, memory_.end(), [](const Pair& pair) { return pair == mark; });
  }

 private:
  static constexpr std::ptrdiff_t margin = 64;

  std::size_t known_;
  std::vector<Pair> memory_;
};

/// Some partners for each of many boxes, in an order like a spatial one.
std::vector<Pair> crowded_pairs(std::uint32_t rows, std::uint32_t partners, std::uint32_t seed) {
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < rows; ++a) {
    for (std::uint32_t k = 0; k < partners; ++k) pairs.push_back({a, a + 1 + k});
  }
  std::shuffle(pairs.begin(), pairs.end(), std::mt19937(seed));
  return pairs;
}

void add_in_pieces(PairSort& sort, std::span<const Pair> pairs, std::size_t sinks) {
  std::vector<std::unique_ptr<PairSort::Sink>> all;
  for (std::size_t k = 0; k < sinks; ++k) all.push_back(std::make_unique<PairSort::Sink>(sort));
  constexpr std::size_t step = 500;
  for (std::size_t k = 0; k < pairs.size(); k += step) {
    all[k / step % sinks]->add(pairs.subspan(k, std::min(step, pairs.size() - k)));
  }
}

/// Whatever was forecast, and whatever memory is available.
TEST(PairSort, OfPairsThatWaitInTheRoomForAllAndInMemoryThatIsLent) {
  EXPECT_TRUE(rc::check([] {
    const auto rows = *rc::gen::inRange<std::uint32_t>(1'000, 40'000);
    const auto partners = *rc::gen::inRange<std::uint32_t>(1, 14);
    const auto limit = std::size_t{rows} + 20;
    const bool wide = *rc::gen::arbitrary<bool>();
    const PairLimits limits{limit, wide ? std::size_t{1} << 32U : limit};
    const std::vector<Pair> pairs = crowded_pairs(rows, partners, 3);
    const auto percent = *rc::gen::weightedElement<std::size_t>({{5, 100}, {1, 103}, {1, 97}, {1, 50}, {1, 300}});
    const auto known = pairs.size() * *rc::gen::element<std::size_t>(90, 100, 106, 150) / 100;
    PairForecast forecast{.count = pairs.size() * percent / 100};
    PairSort sort;
    std::vector<std::byte> idle(*rc::gen::element<std::size_t>(0, 70'000, 1'000'000));
    sort.begin(limits);
    if (*rc::gen::arbitrary<bool>()) {
      for (std::size_t k = 0; k < forecast.firsts.size(); ++k) {
        forecast.firsts[k] = static_cast<std::uint32_t>(sort.shares()[k] * rows);
      }
    } else {
      forecast.firsts[0] = *rc::gen::inRange<std::uint32_t>(0, rows * 2);
      forecast.firsts[1] = *rc::gen::inRange<std::uint32_t>(0, rows * 2);
    }
    sort.lend(idle);
    RoomAhead room(known);
    sort.wait_in(room, forecast);
    add_in_pieces(sort, pairs, *rc::gen::inRange<std::size_t>(1, 4));
    RC_ASSERT(sort.count() == pairs.size());
    const Pair* const first = sort.sort(*limited_executor(2), room);
    std::vector<Pair> expected = pairs;
    std::sort(expected.begin(), expected.end());
    RC_ASSERT(std::equal(expected.begin(), expected.end(), first));
    RC_ASSERT(room.is_untouched_around());
  }));
}

TEST(PairSort, TakesLittleForPairsThatWaitInTheRoomForAll) {
  constexpr std::uint32_t rows = 200'000;
  const std::vector<Pair> pairs = crowded_pairs(rows, 12, 4);
  std::vector<double> bytes;
  PairForecast forecast;
  for (int with_forecast = 0; with_forecast < 2; ++with_forecast) {
    PairSort sort;
    sort.begin({rows + 20, rows + 20});
    RoomAhead room(pairs.size() * 17 / 16);
    sort.wait_in(room, forecast);
    add_in_pieces(sort, pairs, 1);
    EXPECT_EQ(sort.count(), pairs.size());
    sort.sort(serial_executor(), room);
    bytes.push_back(static_cast<double>(sort.bytes()) / static_cast<double>(pairs.size()));
    EXPECT_EQ(sort.last().count, 0U) << "there was no previous sort";
    sort.begin({rows + 20, rows + 20});
    forecast = sort.last();
    EXPECT_EQ(forecast.count, pairs.size());
  }
  EXPECT_GT(bytes[0], 4);
  EXPECT_LT(bytes[1], 2) << "a pair, of which a seventh is stored elsewhere, and incomplete chunks";
}

TEST(PairSort, SaysWhatItNeedsInPassingToo) {
  std::vector<Pair> pairs;
  // a single bucket, whose pairs are sorted in temporary memory
  for (std::uint32_t b = 0; b < 300'000; ++b) pairs.push_back({7, b});
  PairSort sort;
  sorted_by(sort, pairs, 1, {1'000, 300'000});
  const std::size_t with_many = sort.bytes();
  EXPECT_GE(with_many, pairs.size() * (sizeof(std::int32_t) + 2 * sizeof(std::uint32_t)));
  sorted_by(sort, {}, 1, {1'000, 300'000});
  EXPECT_LE(sort.bytes(), with_many - pairs.size() * 2 * sizeof(std::uint32_t));
}

TEST(PairSort, TakesNotMuchMoreThanThePairsNeedAlsoFromManyThreads) {
  constexpr std::uint32_t rows = 1'000'000;
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < rows; ++a) pairs.push_back({a * 7919U % rows, a});
  for (const std::size_t threads : {1U, 16U}) {
    PairSort sort;
    sort.begin({rows, rows}, threads);
    {
      std::vector<std::unique_ptr<PairSort::Sink>> sinks;
      for (std::size_t k = 0; k < threads; ++k) sinks.push_back(std::make_unique<PairSort::Sink>(sort));
      for (std::size_t k = 0; k < rows; k += 500) {
        sinks[k / 500 % threads]->add(std::span<const Pair>(pairs).subspan(k, 500));
      }
    }
    EXPECT_EQ(sort.count(), pairs.size());
    EXPECT_LE(sort.bytes(), pairs.size() * (threads == 1 ? 7U : 14U)) << threads << " threads";
  }
}

/// On either side of the limit where a pair of a bucket fits 31 bits.
TEST(PairSort, OfAsManyIndicesAsCodesHaveRoomForAndMore) {
  for (const std::uint32_t limit : {(1U << 20U) - 1, 1U << 20U, (1U << 20U) + 1, (1U << 21U) + 1}) {
    std::mt19937 random(limit);
    std::vector<Pair> pairs;
    for (std::uint32_t k = 0; k < 60'000; ++k) {
      const std::uint32_t a = k < 1'000 ? k : k < 2'000 ? limit - 1 - k : static_cast<std::uint32_t>(random()) % limit;
      pairs.push_back({a, k % 2 == 0 ? limit - 1 - k : k});
    }
    expect_sorted(pairs, limit, limit);
  }
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
