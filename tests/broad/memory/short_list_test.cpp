// SPDX-License-Identifier: MIT
#include <functional>

#include <gtest/gtest.h>

#include <graze/broad/memory/short_list.hpp>

namespace graze::detail::short_list_test {
namespace {

TEST(ShortList, GivesBackWhatWasPushedLastBeyondItsRoomToo) {
  ShortList<int, 4> list;
  EXPECT_TRUE(list.empty());
  for (int k = 0; k < 100; ++k) list.push(k);
  EXPECT_EQ(list.size(), 100U);
  for (int k = 100; k-- > 0;) EXPECT_EQ(list.pop(), k);
  EXPECT_TRUE(list.empty());
  list.push(7);  // after it has moved to the heap
  EXPECT_EQ(list.pop(), 7);
}

TEST(ShortList, PushesUnderACondition) {
  ShortList<int, 4> list;
  for (int k = 0; k < 20; ++k) list.push_if(k % 3 == 0, k);
  EXPECT_EQ(list.size(), 7U);
  for (int k = 18; k >= 0; k -= 3) EXPECT_EQ(list.pop(), k);
}

TEST(ShortHeap, GivesTheFirstInItsOrder) {
  ShortHeap<int, 4, std::less<>> heap;
  for (int k = 0; k < 50; ++k) heap.push(k * 37 % 50);
  for (int k = 0; k < 50; ++k) EXPECT_EQ(heap.pop(), k);
  EXPECT_TRUE(heap.empty());
}

TEST(ShortList, HasRoomForSeveralAtOnceAlsoBeyondItsOwn) {
  ShortList<int, 4> list;
  for (int first = 0; first < 40; first += 3) {
    int* const room = list.room_for(5);
    for (int k = 0; k < 5; ++k) room[k] = first + k;
    list.append(3);
  }
  ASSERT_EQ(list.size(), 42U);
  for (int expected = 41; expected >= 0; --expected) EXPECT_EQ(list.pop(), expected);
}

}  // namespace
}  // namespace graze::detail::short_list_test
