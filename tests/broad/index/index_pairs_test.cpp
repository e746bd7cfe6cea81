// SPDX-License-Identifier: MIT
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/index/index_pairs.hpp>

namespace graze::detail::index_pairs_test {
namespace {

TEST(IndexPairs, SkipsSlotsThatAreFreeAndNamesTheOthersByTheirKeys) {
  KeyTable keys;
  std::vector<Key> given;
  for (int k = 0; k < 5; ++k) {
    keys.prepare();
    given.push_back(keys.take());
  }
  keys.release(1);
  const auto box_of = [](std::uint32_t slot) {  // each touches the next
    const auto x = static_cast<float>(slot);
    return Aabb<2>{{x, 0}, {x + 1, 1}};
  };
  std::vector<std::pair<Key, Key>> pairs;
  auto note = [&pairs](Key a, Key b) { pairs.emplace_back(a, b); };
  visit_index_pairs(keys, box_of, note);
  EXPECT_EQ(pairs, (std::vector{std::pair{given[2], given[3]}, std::pair{given[3], given[4]}}));
  int visits = 0;
  auto stop = [&visits](Key, Key) { return ++visits < 1; };
  visit_index_pairs(keys, box_of, stop);
  EXPECT_EQ(visits, 1);
}

}  // namespace
}  // namespace graze::detail::index_pairs_test
