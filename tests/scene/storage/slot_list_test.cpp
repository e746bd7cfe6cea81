// SPDX-License-Identifier: MIT
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/scene/storage/slot_list.hpp>

namespace graze::detail {
namespace {

std::vector<std::uint32_t> slots_of(const SlotList& list) { return {list.all().begin(), list.all().end()}; }

TEST(SlotList, HoldsWhatWasAddedInThatOrder) {
  SlotList list;
  EXPECT_TRUE(list.empty());
  list.reserve(3);
  for (const std::uint32_t slot : {7U, 2U, 5U}) list.add(slot);
  EXPECT_EQ(slots_of(list), (std::vector<std::uint32_t>{7, 2, 5}));
  EXPECT_EQ(list[1], 2U);
  list.drop_last();
  EXPECT_EQ(list.size(), 2U);
  list.clear();
  EXPECT_TRUE(list.empty());
}

TEST(SlotList, KeepsItsRoomWhenItIsCleared) {
  SlotList list;
  list.reserve(2);
  const std::uint32_t* const place = list.all().data();
  list.add(1);
  list.clear();
  list.reserve(1);
  list.add(2);
  EXPECT_EQ(list.all().data(), place);
}

/// A copied vector has no spare capacity, so adding to it could fail.
TEST(SlotList, GivesItsRoomToCopies) {
  SlotList list;
  list.reserve(4);
  list.add(1);
  SlotList copy = list;
  const std::uint32_t* const place = copy.all().data();
  for (std::uint32_t slot = 2; slot <= 4; ++slot) copy.add(slot);
  EXPECT_EQ(copy.all().data(), place);
  EXPECT_EQ(slots_of(copy), (std::vector<std::uint32_t>{1, 2, 3, 4}));
  EXPECT_EQ(slots_of(list), (std::vector<std::uint32_t>{1}));
}

TEST(SlotList, LeavesNothingWhereItWasMovedFrom) {
  SlotList list;
  list.reserve(1);
  list.add(9);
  SlotList moved = std::move(list);
  EXPECT_EQ(slots_of(moved), (std::vector<std::uint32_t>{9}));
  EXPECT_TRUE(list.empty());  // NOLINT(bugprone-use-after-move): the test uses it on purpose
  list = std::move(moved);
  EXPECT_EQ(slots_of(list), (std::vector<std::uint32_t>{9}));
}

}  // namespace
}  // namespace graze::detail
