// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <graze/broad/pairs/pair_list.hpp>

#include "broad/thread_executor.hpp"

namespace graze::detail::pair_list_test {
namespace {

constexpr std::size_t enough_to_populate = 700'000;  // pairs

std::vector<Pair> counted_pairs(std::size_t count) {
  std::vector<Pair> pairs(count);
  for (std::size_t k = 0; k < count; ++k) pairs[k] = {static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(~k)};
  return pairs;
}

/// Appends pairs, `step` at a time, and passes the expected total at each step.
template <class Expect>
std::vector<Pair> appended(std::span<const Pair> pairs, std::size_t step, const Expect& expected) {
  PairList list(serial_executor());
  for (std::size_t k = 0; k < pairs.size(); k += step) {
    const std::span<const Pair> some = pairs.subspan(k, std::min(step, pairs.size() - k));
    const Pair* const first = list.append(some, expected(k + some.size()));
    EXPECT_TRUE(std::equal(pairs.begin(), pairs.begin() + 1, first)) << "the first of all";
  }
  return list.take();
}

TEST(PairList, AppendsWhateverIsExpected) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Pair> pairs = counted_pairs(*rc::gen::inRange<std::size_t>(0, 5000));
    const std::size_t step = *rc::gen::inRange<std::size_t>(1, 700);
    const auto expected = *rc::gen::element<std::size_t>(0, 1, 3000, std::size_t{1} << 50U);
    const std::vector<Pair> list = appended(pairs, step, [=](std::size_t /*done*/) { return expected; });
    RC_ASSERT(list == pairs);
    RC_ASSERT(list.capacity() / 2 <= list.size());
  }));
}

TEST(PairList, AppendsManyByRightAndByWrongExpectations) {
  const std::vector<Pair> pairs = counted_pairs(enough_to_populate);
  EXPECT_EQ(appended(pairs, 10'007, [](std::size_t /*done*/) { return enough_to_populate; }), pairs);
  EXPECT_EQ(appended(pairs, 10'007, [](std::size_t done) { return done; }), pairs);
  EXPECT_EQ(appended(pairs, 300'000, [](std::size_t done) { return 9 * done; }), pairs);
}

TEST(PairList, HasRoomForAllAtOnceWhoeverPopulatesIt) {
  const test::ThreadExecutor two(2);
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{70'000}, enough_to_populate}) {
    const std::vector<Pair> pairs = counted_pairs(count);
    for (const Executor* executor : {&serial_executor(), static_cast<const Executor*>(&two)}) {
      PairList list(*executor);
      std::copy(pairs.begin(), pairs.end(), list.all(count));
      EXPECT_EQ(list.take(), pairs);
      EXPECT_TRUE(list.take().empty()) << "the list was moved out";
    }
  }
}

TEST(PairList, IsReachedInTurnsWhoeverPopulatesIt) {
  const test::ThreadExecutor two(2);
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{70'000}, enough_to_populate}) {
    const std::vector<Pair> pairs = counted_pairs(count);
    for (const Executor* executor : {&serial_executor(), static_cast<const Executor*>(&two)}) {
      PairList list(*executor);
      Pair* const out = list.all_in_turns(count);
      constexpr std::size_t step = 9'001;
      for (std::size_t k = 0; k < count; k += step) {
        const std::size_t end = std::min(count, k + step);
        list.reach(end);
        if (k > 0) list.reach(k);  // already reached
        std::copy(pairs.data() + k, pairs.data() + end, out + k);
      }
      EXPECT_EQ(list.take(), pairs);
    }
  }
}

/// Like sorting pairs: data stored in the list is overwritten from the beginning, but not before its turn.
TEST(PairList, KeepsWhatWaitsInItUntilItIsReachedWhoeverPopulatesIt) {
  const test::ThreadExecutor two(2);
  for (const std::size_t count : {std::size_t{10}, std::size_t{70'000}, enough_to_populate}) {
    for (const Executor* executor : {&serial_executor(), static_cast<const Executor*>(&two)}) {
      PairList list(*executor);
      const std::span<Pair> ahead = list.ahead(count);
      if (ahead.empty()) GTEST_SKIP() << "writes to spare capacity are reported here";
      ASSERT_GE(ahead.size(), count);
      const std::vector<Pair> waiting = counted_pairs(count);
      std::copy(waiting.begin(), waiting.end(), ahead.begin());
      ASSERT_EQ(list.all_in_turns(count), ahead.data());
      if (executor->concurrency() > 1) list.reach_by_all(count / 4);
      list.reach(count / 2);
      EXPECT_TRUE(std::equal(waiting.begin() + static_cast<std::ptrdiff_t>(count / 2), waiting.end(),
                             ahead.begin() + static_cast<std::ptrdiff_t>(count / 2)));
      list.reach_by_all(count);
      EXPECT_EQ(list.take().size(), count);
    }
  }
}

TEST(KeptPairSink, SaysHowMuchOfItWasWrittenTo) {
  KeptPairSink room;
  const std::span<Pair> ahead = room.ahead(1'000);
  EXPECT_GE(ahead.size(), 1'050U);
  EXPECT_EQ(room.bytes(), 1'000 * sizeof(Pair));
  EXPECT_EQ(room.all(1'040), ahead.data());
  EXPECT_EQ(room.bytes(), 1'040 * sizeof(Pair));
  room.all(100'000);
  EXPECT_EQ(room.bytes(), 100'000 * sizeof(Pair));
}

}  // namespace
}  // namespace graze::detail::pair_list_test
