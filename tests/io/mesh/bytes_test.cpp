// SPDX-License-Identifier: MIT
#include <cstdint>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/io/mesh/bytes.hpp>

namespace graze::io::mesh_bytes_test {
namespace {

TEST(MeshBytes, EitherOrderIsRead) {
  EXPECT_EQ(number_at<std::uint16_t>("\x01\x02"), 0x0201);
  EXPECT_EQ(number_at<std::uint16_t>("\x01\x02", ByteOrder::big), 0x0102);
  EXPECT_EQ(number_at<std::int8_t>("\xff"), -1);
  EXPECT_EQ(number_at<std::int32_t>("\xfe\xff\xff\xff"), -2);
  EXPECT_EQ(number_at<float>("\x00\x00\x80\x3f"), 1.0F);
  EXPECT_EQ(number_at<float>("\x3f\x80\x00\x00", ByteOrder::big), 1.0F);
  EXPECT_EQ(number_at<double>("\xc0\x00\x00\x00\x00\x00\x00\x00", ByteOrder::big), -2.0);
}

template <class Number>
void check_round_trip(Number number) {
  std::string bytes;
  append_number(bytes, number);
  RC_ASSERT(bytes.size() == sizeof(Number));
  RC_ASSERT(number_at<Number>(bytes.data()) == number);
  const std::string reversed(bytes.rbegin(), bytes.rend());
  RC_ASSERT(number_at<Number>(reversed.data(), ByteOrder::big) == number);
}

RC_GTEST_PROP(MeshBytes, WhatIsWrittenIsRead, (std::uint32_t whole, std::uint16_t half, double number)) {
  check_round_trip(whole);
  check_round_trip(half);
  check_round_trip(number);
  check_round_trip(static_cast<float>(whole));
}

}  // namespace
}  // namespace graze::io::mesh_bytes_test
