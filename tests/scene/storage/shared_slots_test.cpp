// SPDX-License-Identifier: MIT
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/scene/storage/shared_slots.hpp>

#include "catalogue.hpp"

namespace graze::detail::shared_slots_test {
namespace {

using Slots = SharedSlots<std::string>;

TEST(SharedSlots, NewOnesAreEmpty) {
  Slots slots;
  EXPECT_EQ(slots.size(), 0U);
  slots.grow(200);
  EXPECT_EQ(slots.size(), 200U);
  for (std::size_t i = 0; i < 200; ++i) EXPECT_FALSE(slots[i].has_value());
  slots.grow(100);
  EXPECT_EQ(slots.size(), 200U);
}

TEST(SharedSlots, ACopyThatWasSharedStaysAsItIs) {
  Slots slots;
  slots.grow(3);
  slots.change(1) = "old";
  const Slots shared = slots.share();
  slots.change(1) = "new";
  slots.grow(500);
  slots.change(400) = "more";
  EXPECT_EQ(shared[1], "old");
  EXPECT_EQ(shared.size(), 3U);
  EXPECT_EQ(slots[1], "new");
  EXPECT_EQ(slots[400], "more");
}

TEST(SharedSlots, OnlyWhatIsWrittenToIsCopied) {
  SharedSlots<std::shared_ptr<int>> slots;
  slots.grow(1000);
  const auto far = std::make_shared<int>(1);
  const auto near = std::make_shared<int>(2);
  slots.change(999) = far;
  slots.change(0) = near;
  const auto shared = slots.share();
  slots.change(1) = nullptr;
  EXPECT_EQ(near.use_count(), 3);  // here, in the shared chunk, in the copied chunk
  EXPECT_EQ(far.use_count(), 2);   // here, and in a chunk that both share
}

TEST(SharedSlots, AreAllOwnUntilSharedAndAgainWhenEachChunkWasCopied) {
  Slots slots;
  slots.grow(100);  // two chunks
  EXPECT_TRUE(slots.is_all_own());
  const Slots shared = slots.share();
  EXPECT_FALSE(slots.is_all_own());
  EXPECT_FALSE(shared.is_all_own());
  slots.change(5);
  slots.change(6);
  EXPECT_FALSE(slots.is_all_own());
  slots.change(99);
  EXPECT_TRUE(slots.is_all_own());
  EXPECT_TRUE(Slots(shared).is_all_own());
}

TEST(SharedSlots, AnOrdinaryCopyGoesItsOwnWay) {
  Slots slots;
  slots.grow(1);
  slots.change(0) = "one";
  Slots copy = slots;
  copy.change(0) = "two";
  slots = slots.share();
  EXPECT_EQ(slots[0], "one");
  EXPECT_EQ(copy[0], "two");
}

/// More than fit in one allocation.
TEST(SharedSlots, ManyAreEachForThemselves) {
  constexpr std::size_t many = 200'000;
  SharedSlots<std::size_t> slots;
  for (const std::size_t size : {std::size_t{1}, std::size_t{64}, std::size_t{65}, many / 2, many}) slots.grow(size);
  for (std::size_t i = 0; i < many; ++i) EXPECT_FALSE(slots[i].has_value());
  for (std::size_t i = 0; i < many; ++i) slots.change(i) = i;
  const SharedSlots<std::size_t> copy = slots;
  const SharedSlots<std::size_t> shared = slots.share();
  for (std::size_t i = 0; i < many; i += 2) slots.change(i) = i + 1;
  for (std::size_t i = 0; i < many; ++i) {
    ASSERT_EQ(slots[i], i | 1U);
    ASSERT_EQ(shared[i], i);
    ASSERT_EQ(copy[i], i);
  }
}

TEST(SharedSlots, WhatNobodyHasIsGone) {
  SharedSlots<std::shared_ptr<int>> slots;
  slots.grow(1000);
  const auto item = std::make_shared<int>(1);
  for (std::size_t i = 0; i < 1000; ++i) slots.change(i) = item;
  {
    const auto shared = slots.share();
    for (std::size_t i = 0; i < 1000; ++i) slots.change(i).reset();
    EXPECT_EQ(item.use_count(), 1001);
  }
  EXPECT_EQ(item.use_count(), 1);
}

// The oracle keeps a copy of every shared state as a plain vector.
RC_GTEST_PROP(SharedSlots, SharedStatesNeverChange, ()) {
  Slots slots;
  slots.grow(150);
  std::vector<std::optional<std::string>> plain(150);
  std::vector<std::pair<Slots, std::vector<std::optional<std::string>>>> kept;
  const auto steps = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::arbitrary<std::uint32_t>());
  for (const std::uint32_t step : steps) {
    const std::size_t slot = step % 150;
    if (step % 7 == 0) {
      kept.emplace_back(slots.share(), plain);
    } else {
      const auto value = step % 7 == 1 ? std::nullopt : std::optional<std::string>(std::to_string(step));
      slots.change(slot) = value;
      plain[slot] = value;
    }
  }
  kept.emplace_back(slots.share(), plain);
  for (const auto& [shared, expected] : kept) {
    for (std::size_t i = 0; i < expected.size(); ++i) RC_ASSERT(shared[i] == expected[i]);
  }
}

}  // namespace
}  // namespace graze::detail::shared_slots_test
