// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/shape/index_lists.hpp>

#include "catalogue.hpp"

namespace graze::detail::index_lists_test {
namespace {

using Numbers = std::vector<std::uint32_t>;

Numbers of(const IndexLists& lists, std::uint32_t head) {
  Numbers numbers;
  lists.for_each(head, [&](std::uint32_t number) { numbers.push_back(number); });
  return numbers;
}

TEST(IndexLists, KeepTheNewestNumberFirst) {
  IndexLists lists;
  std::uint32_t head = IndexLists::none;
  EXPECT_TRUE(of(lists, head).empty());
  for (const std::uint32_t number : {7U, 7U, 3U}) lists.add(head, number);
  EXPECT_EQ(of(lists, head), (Numbers{3, 7, 7}));
  EXPECT_EQ(lists.size(), 3U);
  lists.clear();
  EXPECT_EQ(lists.size(), 0U);
}

TEST(IndexLists, LetNumbersGoToOtherListsAsTheyAreTakenOut) {
  IndexLists lists;
  std::uint32_t old = IndexLists::none;
  std::uint32_t even = IndexLists::none;
  for (std::uint32_t number = 0; number < 6; ++number) lists.add(old, number);
  lists.drain(old, [&](std::uint32_t number) {
    if (number % 2 == 0) lists.add(even, number);
  });
  EXPECT_EQ(old, IndexLists::none);
  EXPECT_EQ(of(lists, even), (Numbers{0, 2, 4}));
  EXPECT_EQ(lists.size(), 3U);
}

TEST(IndexLists, AreWhatAsManyVectorsAre) {
  test::check_property([] {
    IndexLists lists;
    std::array<std::uint32_t, 3> heads = {IndexLists::none, IndexLists::none, IndexLists::none};
    std::array<Numbers, 3> expected;
    std::size_t size = 0;
    for (std::uint32_t step = 0; step < 60; ++step) {
      const std::size_t i = *test::choice(3);
      if (*test::choice(8) == 0) {
        Numbers taken;
        lists.drain(heads[i], [&](std::uint32_t number) { taken.push_back(number); });
        RC_ASSERT(taken == std::exchange(expected[i], {}));
        size -= taken.size();
      } else {
        lists.add(heads[i], step);
        expected[i].insert(expected[i].begin(), step);
        ++size;
      }
      RC_ASSERT(lists.size() == size);
      for (std::size_t k = 0; k < 3; ++k) RC_ASSERT(of(lists, heads[k]) == expected[k]);
    }
  });
}

}  // namespace
}  // namespace graze::detail::index_lists_test
