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

/// The touching pairs in a scene of eight slots, from update to update, in which objects replace others.
struct World {
  detail::KeyTable ids;
  SceneEvents events;
  detail::EventsEdit edit;
  std::vector<Pair> touching;

  World() {
    for (std::uint32_t k = 0; k < 8; ++k) take();
  }

  void take() {
    ids.prepare();
    ids.take();
  }

  void replace(std::uint32_t place) {
    ids.release(place);
    take();
  }

  Pairs named(const std::vector<Pair>& pairs) const {
    Pairs result;
    for (const Pair& pair : pairs) {
      const Key a = ids.key_of(pair.a);
      const Key b = ids.key_of(pair.b);
      result.push_back({{a.index, a.generation, a.owner}, {b.index, b.generation, b.owner}});
    }
    return result;
  }

  static std::vector<Pair> places(const Pairs& pairs) {
    std::vector<Pair> result;
    for (const ObjectPair& each : pairs) result.push_back({each.a.index, each.b.index});
    return result;
  }
};

/// Which of the touching pairs began.
detail::YoungMarks young_of(const SceneEvents& events) {
  detail::YoungMarks young;
  for (const ObjectPair& each : detail::pairs_of(events)) {
    young.push_back(std::binary_search(events.began.begin(), events.began.end(), each) ? 1 : 0);
  }
  return young;
}

RC_GTEST_PROP(SceneEvents, AreTheSameFoundByWhatOfAListTouches, ()) {
  World world;
  std::vector<Pair> list;
  for (std::uint32_t a = 0; a < 8; ++a) {
    for (std::uint32_t b = a + 1; b < 8; ++b) list.push_back({a, b});
  }
  std::vector<char> touched(list.size(), 0);
  std::vector<std::uint32_t> places_before;
  detail::YoungMarks young;
  const int updates = *rc::gen::inRange(1, 8);
  for (int update = 0; update < updates; ++update) {
    std::vector<char> touches = touched;
    for (const std::size_t place :
         *rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(0, 28))) {
      touches[place] ^= 1;
    }
    std::vector<Pair> found;
    std::vector<std::uint32_t> places;
    for (std::uint32_t place = 0; place < list.size(); ++place) {
      if (touches[place] == 0) continue;
      found.push_back(list[place]);
      places.push_back(place);
    }
    const SceneEvents expected = events_between(detail::pairs_of(world.events), world.named(found));
    detail::NextEvents next;
    next.events.began.resize(3);  // of earlier events
    next.young.resize(40);
    detail::find_events(world.events, young, {found, places, places_before, touches.data(), touched.data()}, world.ids,
                        next);
    RC_ASSERT(next.events.began == expected.began);
    RC_ASSERT(next.events.stayed == expected.stayed);
    RC_ASSERT(next.events.ended == expected.ended);
    RC_ASSERT(next.young == young_of(expected));
    world.events = next.events;
    young = next.young;
    touched = touches;
    places_before = places;
  }
}

RC_GTEST_PROP(SceneEvents, AreTheSameFoundAnewAndByWhatHasChanged, ()) {
  World world;
  Pairs before;
  std::uint64_t last_changes = world.ids.changes();
  const int updates = *rc::gen::inRange(1, 8);
  for (int update = 0; update < updates; ++update) {
    const bool some_go = *rc::gen::arbitrary<bool>();
    for (const std::uint32_t place : *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange(0U, 8U))) {
      if (some_go && *rc::gen::inRange(0, 4) == 0) world.replace(place);
    }
    std::set<Pair> chosen;
    for (const std::uint32_t number : *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange(0U, 64U))) {
      if (number / 8 < number % 8) chosen.insert({number / 8, number % 8});
    }
    const std::vector<Pair> found(chosen.begin(), chosen.end());
    const Pairs after = world.named(found);
    const SceneEvents expected = events_between(before, after);
    if (*rc::gen::arbitrary<bool>()) {
      detail::NextEvents next;
      const bool are_the_same = world.ids.changes() == last_changes && *rc::gen::inRange(0, 4) != 0;
      detail::find_events(world.events, found, world.ids,
                          are_the_same ? detail::SlotReuse::the_same : detail::SlotReuse::maybe_others, next);
      world.events = next.events;
      RC_ASSERT(next.young == young_of(world.events));
    } else {
      world.edit.plan(world.events, World::places(expected.began), World::places(expected.ended), world.ids);
      world.edit.make_room(world.events);
      world.edit.apply(world.events);
    }
    RC_ASSERT(world.events.began == expected.began);
    RC_ASSERT(world.events.stayed == expected.stayed);
    RC_ASSERT(world.events.ended == expected.ended);
    RC_ASSERT(detail::pairs_of(world.events) == after);
    before = after;
    last_changes = world.ids.changes();
  }
}

}  // namespace
}  // namespace graze::events_test
