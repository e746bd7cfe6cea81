// SPDX-License-Identifier: MIT
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/index/key_table.hpp>

namespace graze::detail::key_table_test {
namespace {

Key take(KeyTable& table) {
  table.prepare();
  return table.take();
}

std::vector<Key> take_many(KeyTable& table, std::size_t count) {
  std::vector<std::uint32_t> slots(count);
  table.take_many(slots);
  return table.keys_of(slots);
}

TEST(KeyTable, ReleasesAllAsOneByOne) {
  KeyTable at_once;
  KeyTable one_by_one;
  for (KeyTable* keys : {&at_once, &one_by_one}) {
    take_many(*keys, 5);
    keys->release(2);
  }
  at_once.release_all();
  for (const std::uint32_t slot : {0U, 1U, 3U, 4U}) one_by_one.release(slot);
  EXPECT_EQ(at_once.size(), 0U);
  EXPECT_EQ(at_once.changes(), one_by_one.changes());
  const std::vector<Key> next = take_many(at_once, 6);
  const std::vector<Key> expected = take_many(one_by_one, 6);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(next[k].index, expected[k].index);
    EXPECT_EQ(next[k].generation, expected[k].generation);
  }
}

TEST(KeyTable, TakesTheSlotThatItPreparedAndUsesFreeOnesAgain) {
  KeyTable table;
  const Key prepared = table.prepare();
  EXPECT_EQ(prepared.index, 0U);
  EXPECT_EQ(table.prepare(), prepared);  // nothing is occupied yet
  const Key first = table.take();
  EXPECT_EQ(first, prepared);
  const Key second = take(table);
  EXPECT_EQ(first.index, 0U);
  EXPECT_EQ(second.index, 1U);
  table.release(0);
  EXPECT_EQ(table.prepare(), (Key{0, first.generation + 2, first.owner}));
  EXPECT_EQ(table.generations()[0], first.generation + 1);  // free
  EXPECT_EQ(take(table).generation, first.generation + 2);
  EXPECT_EQ(table.size(), 2U);
  EXPECT_EQ(table.slots(), 2U);
}

TEST(KeyTable, KnowsItsOwnKeysAlone) {
  KeyTable table;
  KeyTable other;
  const Key key = take(table);
  const Key foreign = take(other);
  EXPECT_TRUE(table.contains(key));
  EXPECT_EQ(table.slot_of(key), 0U);
  EXPECT_EQ(table.key_of(0), key);
  EXPECT_FALSE(table.contains(foreign));
  EXPECT_FALSE(table.contains(Key{}));
  EXPECT_FALSE(table.contains({7, key.generation, key.owner}));
  table.release(0);
  EXPECT_FALSE(table.contains(key));
  EXPECT_FALSE(table.contains({0, key.generation + 1, key.owner}));  // even: never issued
  EXPECT_FALSE(table.is_taken(0));
  EXPECT_THROW(table.slot_of(key), std::out_of_range);
}

TEST(KeyTable, ContainsAllKeysWhereItContainsEach) {
  KeyTable table;
  KeyTable other;
  using Keys = std::vector<Key>;
  const auto contains_all = [&table](const Keys& keys) { return table.contains_all(std::span<const Key>(keys)); };
  EXPECT_TRUE(contains_all({}));
  EXPECT_FALSE(contains_all({Key{}}));
  const Keys keys = take_many(table, 5);
  EXPECT_TRUE(contains_all({}));
  EXPECT_TRUE(contains_all(keys));
  EXPECT_TRUE(contains_all({keys[4], keys[4]}));
  table.release(2);
  EXPECT_FALSE(contains_all(keys));
  EXPECT_FALSE(contains_all({keys[0], {2, keys[2].generation + 1, keys[2].owner}}));  // even, as the table has it
  EXPECT_FALSE(contains_all({keys[0], {5, keys[0].generation, keys[0].owner}}));
  EXPECT_FALSE(contains_all({take(other), keys[0]}));
  EXPECT_TRUE(contains_all({keys[0], keys[1], keys[3], keys[4]}));
}

TEST(KeyTable, IsFullAtItsLimitAndRecovers) {
  KeyTable table(2);
  take(table);
  take(table);
  try {
    table.prepare();
    FAIL() << "no error";
  } catch (const std::length_error& error) {
    EXPECT_EQ(std::string(error.what()), "SpatialIndex: full; it holds at most 2 boxes");
    EXPECT_TRUE(table.is_full());
  }
  EXPECT_EQ(table.size(), 2U);
  table.release(1);
  EXPECT_EQ(take(table).index, 1U);
}

TEST(KeyTable, TakesManyAsOneByOne) {
  const auto used = [](KeyTable& table) {
    for (int k = 0; k < 6; ++k) take(table);
    for (const std::uint32_t slot : {4U, 1U, 3U}) table.release(slot);
  };
  for (const std::size_t count : {0U, 2U, 3U, 5U, 100U}) {
    KeyTable many;
    KeyTable one_by_one;
    used(many);
    used(one_by_one);
    const std::vector<Key> keys = take_many(many, count);
    ASSERT_EQ(keys.size(), count);
    for (const Key& key : keys) {
      const Key expected = take(one_by_one);
      EXPECT_EQ(key, (Key{expected.index, expected.generation, many.owner()}));
      EXPECT_TRUE(many.contains(key));
    }
    EXPECT_EQ(many.size(), one_by_one.size());
    EXPECT_EQ(many.slots(), one_by_one.slots());
    EXPECT_EQ(many.changes(), one_by_one.changes());
    for (const Key& key : keys) many.release(key.index);
    EXPECT_EQ(many.size(), 3U);
  }
}

TEST(KeyTable, TakesNoneWhereThereAreNotAsMany) {
  KeyTable table(5);
  take_many(table, 3);
  table.release(2);
  EXPECT_THROW(take_many(table, 4), std::length_error);
  EXPECT_EQ(table.size(), 2U);
  EXPECT_EQ(take_many(table, 3).size(), 3U);
  EXPECT_TRUE(table.is_full());
  EXPECT_TRUE(take_many(table, 0).empty());
}

TEST(KeyTable, CountsChanges) {
  KeyTable table;
  EXPECT_EQ(table.changes(), 0U);
  table.prepare();
  EXPECT_EQ(table.changes(), 0U);
  table.take();
  table.count_change();
  table.release(0);
  EXPECT_EQ(table.changes(), 3U);
}

TEST(KeyTable, GoesOnAsAnotherDidIfThatIsPlanned) {
  KeyTable table;
  for (int k = 0; k < 5; ++k) take(table);
  table.release(1);
  table.release(3);
  EXPECT_EQ(take(table).index, 3U);
  table.release(0);
  const std::vector<Key> free = table.free_keys();
  std::vector<Key> taken;
  for (std::uint32_t slot = 0; slot < table.slots(); ++slot) {
    if (table.is_taken(slot)) taken.push_back(table.key_of(slot));
  }
  KeyTable copy;
  copy.plan(taken, free);
  EXPECT_EQ(copy.size(), 0U);
  for (const Key& key : taken) {
    EXPECT_FALSE(copy.contains({key.index, key.generation, copy.owner()}));
    EXPECT_EQ(copy.prepare(), (Key{key.index, key.generation, copy.owner()}));
    EXPECT_EQ(copy.take(), (Key{key.index, key.generation, copy.owner()}));
  }
  EXPECT_EQ(copy.size(), table.size());
  for (int k = 0; k < 4; ++k) {
    const Key key = take(table);
    const Key same = take(copy);
    EXPECT_EQ(same.index, key.index);
    EXPECT_EQ(same.generation, key.generation);
  }
}

TEST(KeyTable, ReleasesWhatWasPlannedAsEverythingElse) {
  KeyTable table;
  const std::vector<Key> next = {{2, 7, 0}, {0, 1, 0}};
  const std::vector<Key> free = {{1, KeyTable::used_up, 0}};
  table.plan(next, free);
  take(table);
  take(table);
  for (const std::uint32_t slot : {2U, 0U}) table.release(slot);
  const std::uint32_t owner = table.owner();
  EXPECT_EQ(table.free_keys(), (std::vector<Key>{{1, KeyTable::used_up, owner}, {2, 8, owner}, {0, 2, owner}}));
  EXPECT_EQ(take(table), (Key{0, 3, table.owner()}));
  EXPECT_EQ(take(table), (Key{2, 9, table.owner()}));
  EXPECT_EQ(take(table).index, 3U);  // and never 1
}

TEST(KeyTable, HasPlannedKeysThatNobodyTookAmongTheFreeOnes) {
  const std::vector<Key> next = {{3, 1, 0}, {0, 7, 0}, {2, 1, 0}};
  const std::vector<Key> free = {{1, 2, 0}, {4, 0, 0}};
  for (int taken = 0; taken <= 5; ++taken) {
    for (const bool is_one_released : {false, true}) {
      KeyTable table;
      table.plan(next, free);
      for (int k = 0; k < taken; ++k) take(table);
      if (is_one_released && taken > 0) table.release(3);
      std::vector<Key> keys;
      for (std::uint32_t slot = 0; slot < table.slots(); ++slot) {
        if (table.is_taken(slot)) keys.push_back(table.key_of(slot));
      }
      KeyTable copy;
      copy.plan(keys, table.free_keys());
      for (std::size_t k = 0; k < keys.size(); ++k) take(copy);
      for (int k = 0; k < 7; ++k) {
        const Key expected = take(table);
        EXPECT_EQ(take(copy), (Key{expected.index, expected.generation, copy.owner()})) << taken;
      }
    }
  }
}

TEST(KeyTable, TakesAPlaceAgainUntilItsGenerationsAreUsedUp) {
  constexpr std::uint32_t last = KeyTable::used_up - 1;
  KeyTable table;
  table.plan({}, std::vector<Key>{{0, last - 3, 0}});
  EXPECT_EQ(take(table), (Key{0, last - 2, table.owner()}));
  table.release(0);
  EXPECT_EQ(take(table), (Key{0, last, table.owner()}));
  table.release(0);
  EXPECT_EQ(table.free_keys(), (std::vector<Key>{{0, KeyTable::used_up, table.owner()}}));
  EXPECT_EQ(take(table), (Key{1, 1, table.owner()}));
  KeyTable copy;
  copy.plan(std::vector<Key>{{1, 1, 0}}, table.free_keys());
  EXPECT_EQ(take(copy).index, 1U);
  EXPECT_EQ(take(copy).index, 2U);  // and never 0
}

TEST(KeyTable, RefusesAPlanThatIsNone) {
  const auto plan = [](std::vector<Key> next, std::vector<Key> free) { KeyTable().plan(next, free); };
  EXPECT_NO_THROW(plan({{0, 1, 0}}, {{1, 2, 0}}));
  EXPECT_THROW(plan({{0, 1, 0}, {0, 3, 0}}, {}), std::invalid_argument);  // twice
  EXPECT_THROW(plan({{0, 1, 0}}, {{0, 2, 0}}), std::invalid_argument);    // taken and free
  EXPECT_THROW(plan({{1, 1, 0}}, {}), std::invalid_argument);             // generation 0 is never issued
  EXPECT_THROW(plan({{0, 2, 0}}, {}), std::invalid_argument);
  EXPECT_THROW(plan({}, {{0, 1, 0}}), std::invalid_argument);
  EXPECT_THROW(plan({{0, KeyTable::used_up + 1, 0}}, {}), std::invalid_argument);  // never issued
  KeyTable used;
  take(used);
  used.release(0);
  EXPECT_THROW(used.plan({}, {}), std::logic_error);
}

}  // namespace
}  // namespace graze::detail::key_table_test
