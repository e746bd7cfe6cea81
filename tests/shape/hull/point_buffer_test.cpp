// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <utility>

#include <gtest/gtest.h>

#include <graze/shape/hull/point_buffer.hpp>

namespace graze::detail::hull_point_room_test {
namespace {

HullPoint point_of(std::uint32_t i) { return {Vec<3, double>(i, 2.0 * i, -1.0 * i), i}; }

void expect_points(HullPointBuffer& room, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    EXPECT_EQ(room[i].place, point_of(i).place);
    EXPECT_EQ(room.at(i)->index, i);
    EXPECT_EQ(room[i].link, HullPoint::none);
  }
}

TEST(HullPointBuffer, KeepsWhatItIsToldToWhenItGrows) {
  HullPointBuffer room;
  std::uint32_t count = 0;
  for (const std::size_t size : {1U, 2U, 3U, 100U, 50U, 1000U}) {
    room.make_room(size, count);
    expect_points(room, count);
    for (; count < size; ++count) room[count] = point_of(count);
  }
  expect_points(room, count);
}

TEST(HullPointBuffer, IsHandedOn) {
  HullPointBuffer room;
  room.make_room(4, 0);
  for (std::uint32_t i = 0; i < 4; ++i) room[i] = point_of(i);
  HullPointBuffer other = std::move(room);
  expect_points(other, 4);
  HullPointBuffer third;
  third.make_room(9, 0);
  third = std::move(other);
  expect_points(third, 4);
}

}  // namespace
}  // namespace graze::detail::hull_point_room_test
