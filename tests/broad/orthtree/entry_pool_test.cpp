// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/orthtree/entry_pool.hpp>

namespace graze::detail::entry_pool_test {
namespace {

using Pool = EntryPool<2, float>;

std::vector<std::uint32_t> slots_of(const Pool& pool, const EntryList& list) {
  std::vector<std::uint32_t> slots;
  pool.for_each(list, [&slots](const Entry<2, float>& entry) { slots.push_back(entry.slot); });
  std::sort(slots.begin(), slots.end());
  return slots;
}

TEST(EntryPool, KeepsListsApart) {
  Pool pool;
  std::array<EntryList, 2> lists;
  for (std::uint32_t slot = 0; slot < 20; ++slot) {
    const std::uint32_t position = pool.add(lists[slot % 2], 70 + slot % 2, {{}, slot});
    EXPECT_EQ(pool.slot(position), slot);
    EXPECT_EQ(pool.owner(position), 70 + slot % 2);
  }
  EXPECT_EQ(lists[1].count, 10U);
  EXPECT_EQ(slots_of(pool, lists[1]), (std::vector<std::uint32_t>{1, 3, 5, 7, 9, 11, 13, 15, 17, 19}));
  pool.set_owner(lists[1], 5);
  pool.release(lists[0]);
  EXPECT_TRUE(slots_of(pool, lists[0]).empty());
  EXPECT_EQ(slots_of(pool, lists[1]).size(), 10U);
  EXPECT_EQ(pool.owner(pool.add(lists[1], 5, {{}, 21})), 5U);
}

TEST(EntryPool, UsesReleasedBlocksAgain) {
  Pool pool;
  EntryList list;
  for (std::uint32_t slot = 0; slot < 64; ++slot) pool.add(list, 0, {{}, slot});
  const std::size_t bytes = pool.bytes();
  for (int round = 0; round < 9; ++round) {
    pool.release(list);
    for (std::uint32_t slot = 0; slot < 64; ++slot) pool.add(list, 0, {{}, slot});
  }
  EXPECT_EQ(pool.bytes(), bytes);
}

TEST(EntryPool, StopsWhenTheVisitorSaysSo) {
  Pool pool;
  EntryList list;
  for (std::uint32_t slot = 0; slot < 30; ++slot) pool.add(list, 0, {{{float(slot), 0}, {float(slot), 0}}, slot});
  int visits = 0;
  const auto right = [](const Aabb<2, float>& box) { return box.min.x >= 10; };
  EXPECT_FALSE(pool.visit_where(list, right, [&visits](std::uint32_t slot) {
    EXPECT_GE(slot, 10U);
    return ++visits < 4;
  }));
  EXPECT_EQ(visits, 4);
  EXPECT_TRUE(pool.visit_where(list, right, [&visits](std::uint32_t) { return ++visits < 100; }));
  EXPECT_EQ(visits, 24);
  EXPECT_FALSE(pool.visit(list, [&visits](const Entry<2, float>&) { return ++visits < 25; }));
  EXPECT_EQ(visits, 25);
}

TEST(EntryPool, WritesWhatPassesBlockByBlock) {
  Pool pool;
  EntryList list;
  EXPECT_TRUE(pool.first_block(list).is_none());
  for (std::uint32_t slot = 0; slot < 20; ++slot) pool.add(list, 0, {{{float(slot), 0}, {float(slot), 0}}, slot});
  const auto odd = [](const Aabb<2, float>& box) { return std::fmod(box.min.x, 2.0F) == 1; };
  std::vector<std::uint32_t> filled;
  std::vector<std::uint32_t> slots;
  for (EntryBlock block = pool.first_block(list); !block.is_none(); block = pool.next_block(block)) {
    std::array<std::uint32_t, Pool::block_size> passed{};
    slots.insert(slots.end(), passed.begin(),
                 passed.begin() + static_cast<std::ptrdiff_t>(pool.write_where(block, odd, passed.data())));
    filled.push_back(block.filled);
  }
  EXPECT_EQ(filled, (std::vector<std::uint32_t>{4, 8, 8}));
  EXPECT_EQ(slots, (std::vector<std::uint32_t>{17, 19, 9, 11, 13, 15, 1, 3, 5, 7}));
}

/// For readers of all positions of a block.
TEST(EntryPool, HasBoxesThatMeetNothingWhereThereIsNoEntry) {
  Pool pool;
  EntryList list;
  const auto present = [&pool](std::uint32_t block) {
    std::size_t count = 0;
    for (const Aabb<2, float>& box : pool.pages()[block].boxes) {
      if (boxes_overlap(box, Aabb<2, float>::everything())) ++count;
    }
    return count;
  };
  for (std::uint32_t slot = 0; slot < 12; ++slot) pool.add(list, 0, {{{1, 1}, {2, 2}}, slot});
  EXPECT_EQ(present(list.head), 4U);
  EXPECT_EQ(present(pool.pages()[list.head].next), 8U);
  pool.remove(list, list.head * Pool::block_size + 1);
  EXPECT_EQ(present(list.head), 3U);
  const std::uint32_t head = list.head;
  pool.release(list);
  pool.add(list, 0, {{{1, 1}, {2, 2}}, 0});
  EXPECT_NE(list.head, head);  // but the one that was full
  EXPECT_EQ(present(list.head), 1U);
}

RC_GTEST_PROP(EntryPool, RemovalPutsTheLastInTheHoleAndSaysWhich, (const std::vector<std::uint8_t>& picks)) {
  Pool pool;
  EntryList list;
  std::vector<std::uint32_t> position_of;
  std::vector<std::uint32_t> held;
  for (const std::uint8_t pick : picks) {
    if (pick % 3 != 0 || held.empty()) {
      const auto slot = static_cast<std::uint32_t>(position_of.size());
      position_of.push_back(pool.add(list, 1, {{}, slot}));
      held.push_back(slot);
      continue;
    }
    const std::size_t place = pick / 3 % held.size();
    const std::uint32_t position = position_of[held[place]];
    position_of[pool.remove(list, position)] = position;
    held.erase(held.begin() + static_cast<std::ptrdiff_t>(place));
    for (const std::uint32_t slot : held) RC_ASSERT(pool.slot(position_of[slot]) == slot);
    RC_ASSERT(slots_of(pool, list) == held);
  }
}

}  // namespace
}  // namespace graze::detail::entry_pool_test
