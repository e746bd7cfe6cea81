// SPDX-License-Identifier: MIT
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <graze/broad/key_table.hpp>

namespace graze::detail::key_table_test {
namespace {

Key take(KeyTable& table) {
  table.prepare();
  return table.take();
}

TEST(KeyTable, TakesTheSlotThatItPreparedAndUsesFreeOnesAgain) {
  KeyTable table;
  EXPECT_EQ(table.prepare(), 0U);
  EXPECT_EQ(table.prepare(), 0U);  // nothing is taken yet
  const Key first = table.take();
  const Key second = take(table);
  EXPECT_EQ(first.index, 0U);
  EXPECT_EQ(second.index, 1U);
  table.release(0);
  EXPECT_EQ(table.prepare(), 0U);
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
  EXPECT_FALSE(table.contains({0, key.generation + 1, key.owner}));  // even: nobody was given it
  EXPECT_FALSE(table.is_taken(0));
  EXPECT_THROW(table.slot_of(key), std::out_of_range);
}

TEST(KeyTable, IsFullAtItsLimitAndRecovers) {
  KeyTable table(2);
  take(table);
  take(table);
  try {
    table.prepare();
    FAIL() << "no error";
  } catch (const std::length_error& error) {
    EXPECT_EQ(std::string(error.what()), "SpatialIndex: it is full; it holds 2 boxes at most");
    EXPECT_TRUE(table.is_full());
  }
  EXPECT_EQ(table.size(), 2U);
  table.release(1);
  EXPECT_EQ(take(table).index, 1U);
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

}  // namespace
}  // namespace graze::detail::key_table_test
