// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/io/log/ddmin.hpp>

namespace graze::io::ddmin_test {
namespace {

using Numbers = std::vector<int>;

Numbers up_to(int count) {
  Numbers numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

/// A test that fails for lists that contain all of some numbers, and records every list.
auto needs(const std::set<int>& numbers) {
  return [numbers](const Numbers& some) {
    const bool fails = std::includes(some.begin(), some.end(), numbers.begin(), numbers.end());
    return fails ? std::optional(some) : std::nullopt;
  };
}

TEST(Ddmin, FindsWhatAFailureNeeds) {
  EXPECT_EQ(ddmin(up_to(100), needs({42})), (Numbers{42}));
  EXPECT_EQ(ddmin(up_to(100), needs({3, 42, 99})), (Numbers{3, 42, 99}));
  EXPECT_EQ(ddmin(up_to(3), needs({0, 1, 2})), (Numbers{0, 1, 2}));
  EXPECT_EQ(ddmin(up_to(0), needs({})), Numbers{});
}

TEST(Ddmin, GoesOnWithWhatTheTestSaysIsLeft) {
  const auto first_seven = [](Numbers some) {
    if (some.size() < 7) return std::optional<Numbers>();
    some.resize(7);
    return std::optional(some);
  };
  EXPECT_EQ(ddmin(up_to(100), first_seven).size(), 7U);
}

TEST(Ddmin, TriesFew) {
  int tries = 0;
  const auto test = needs({500, 501});
  ddmin(up_to(1000), [&](const Numbers& some) {
    ++tries;
    return test(some);
  });
  EXPECT_LT(tries, 100);
}

RC_GTEST_PROP(Ddmin, FindsAnyNumbers, (const std::set<std::uint8_t>& numbers)) {
  const std::set<int> needed(numbers.begin(), numbers.end());
  const Numbers found = ddmin(up_to(256), needs(needed));
  RC_ASSERT(found.size() == std::max<std::size_t>(needed.size(), 1));  // a single item is never removed
  RC_ASSERT(std::includes(found.begin(), found.end(), needed.begin(), needed.end()));
}

}  // namespace
}  // namespace graze::io::ddmin_test
