// SPDX-License-Identifier: MIT
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/random/linear_congruential.hpp>
#include <graze/scene/storage/pair_exceptions.hpp>

namespace graze::pair_exceptions_test {
namespace {

using detail::PairExceptions;
using Pairs = std::vector<Pair>;

TEST(PairExceptions, HaveNoOrderWithinAPair) {
  PairExceptions exceptions;
  EXPECT_TRUE(exceptions.empty());
  EXPECT_FALSE(exceptions.contains(1, 2));
  exceptions.add(5, 2);
  exceptions.add(2, 5);
  exceptions.add(0, 5);
  EXPECT_FALSE(exceptions.empty());
  EXPECT_TRUE(exceptions.contains(2, 5) && exceptions.contains(5, 2) && exceptions.contains(5, 0));
  EXPECT_FALSE(exceptions.contains(0, 2));
  EXPECT_EQ(exceptions.all(), (Pairs{{0, 5}, {2, 5}}));
  EXPECT_TRUE(exceptions.has_any(5) && exceptions.has_any(0));
  EXPECT_FALSE(exceptions.has_any(1) || exceptions.has_any(6));
  exceptions.remove(5, 2);
  exceptions.remove(5, 2);
  EXPECT_EQ(exceptions.all(), (Pairs{{0, 5}}));
  EXPECT_FALSE(exceptions.has_any(2));
}

TEST(PairExceptions, OfASlotAreRemovedTogether) {
  PairExceptions exceptions;
  for (const std::uint32_t other : {1U, 3U, 9U}) exceptions.add(4, other);
  exceptions.add(3, 9);
  std::vector<std::uint32_t> visited;
  exceptions.remove_all_of(4, [&](std::uint32_t other) {
    EXPECT_FALSE(exceptions.contains(4, other));
    visited.push_back(other);
  });
  EXPECT_EQ(visited, (std::vector<std::uint32_t>{1, 3, 9}));
  EXPECT_EQ(exceptions.all(), (Pairs{{3, 9}}));
  exceptions.remove_all_of(4, [](std::uint32_t) { FAIL(); });
}

TEST(PairExceptions, AreASetAfterAnyCalls) {
  detail::LinearCongruential random;
  PairExceptions exceptions;
  std::set<Pair> expected;
  const auto any_slot = [&random] { return static_cast<std::uint32_t>(random.below(12)); };
  for (int step = 0; step < 5000; ++step) {
    const std::uint32_t a = any_slot();
    const std::uint32_t b = any_slot();
    if (a == b) {
      if (step % 4 == 0) exceptions.remove_all_of(a, [](std::uint32_t) {});
      if (step % 4 == 0) std::erase_if(expected, [a](const Pair& pair) { return pair.a == a || pair.b == a; });
      continue;
    }
    const Pair pair = a < b ? Pair{a, b} : Pair{b, a};
    ASSERT_EQ(exceptions.contains(a, b), expected.contains(pair));
    if (random.below(2) == 0) {
      exceptions.add(a, b);
      expected.insert(pair);
    } else {
      exceptions.remove(a, b);
      expected.erase(pair);
    }
    ASSERT_EQ(exceptions.all(), (Pairs{expected.begin(), expected.end()}));
  }
}

}  // namespace
}  // namespace graze::pair_exceptions_test
