// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/scene/events.hpp>

namespace graze::events_test {
namespace {

using Pairs = std::vector<ObjectPair>;

ObjectPair pair(std::uint32_t a, std::uint32_t b, std::uint32_t generation = 1) {
  return {{a, generation, 7}, {b, 1, 7}};
}

TEST(SceneEvents, TellWhatIsNewWhatStaysAndWhatIsOver) {
  const SceneEvents events =
      events_between({pair(0, 1), pair(1, 2), pair(5, 6)}, {pair(0, 3), pair(1, 2), pair(5, 6), pair(8, 9)});
  EXPECT_EQ(events.began, (Pairs{pair(0, 3), pair(8, 9)}));
  EXPECT_EQ(events.stayed, (Pairs{pair(1, 2), pair(5, 6)}));
  EXPECT_EQ(events.ended, (Pairs{pair(0, 1)}));
}

TEST(SceneEvents, AnotherObjectInTheSamePlaceIsAnotherPair) {
  const SceneEvents events = events_between({pair(0, 1, 1)}, {pair(0, 1, 3)});
  EXPECT_EQ(events.began, (Pairs{pair(0, 1, 3)}));
  EXPECT_EQ(events.ended, (Pairs{pair(0, 1, 1)}));
  EXPECT_TRUE(events.stayed.empty());
}

TEST(SceneEvents, OfNothingAreNone) {
  const SceneEvents events = events_between({}, {});
  EXPECT_TRUE(events.began.empty() && events.stayed.empty() && events.ended.empty());
}

RC_GTEST_PROP(SceneEvents, AreTheDifferencesOfTwoSets,
              (const std::set<std::pair<std::uint8_t, std::uint8_t>>& old_numbers,
               const std::set<std::pair<std::uint8_t, std::uint8_t>>& new_numbers)) {
  const auto pairs_of = [](const auto& numbers) {
    Pairs pairs;
    for (const auto& [a, b] : numbers) pairs.push_back(pair(a % 8U, b % 8U));
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  };
  const Pairs before = pairs_of(old_numbers);
  const Pairs after = pairs_of(new_numbers);
  Pairs began;
  Pairs stayed;
  Pairs ended;
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::back_inserter(began));
  std::set_intersection(after.begin(), after.end(), before.begin(), before.end(), std::back_inserter(stayed));
  std::set_difference(before.begin(), before.end(), after.begin(), after.end(), std::back_inserter(ended));
  const SceneEvents events = events_between(before, after);
  RC_ASSERT(events.began == began);
  RC_ASSERT(events.stayed == stayed);
  RC_ASSERT(events.ended == ended);
}

}  // namespace
}  // namespace graze::events_test
