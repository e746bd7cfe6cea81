// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/text/decimal.hpp>

namespace graze::io::decimal_test {
namespace {

TEST(Decimal, NumbersAreRoundedToTheNearestDouble) {
  const std::vector<std::pair<std::string, double>> table = {{"0", 0},      {"+2", 2},    {"-1.5", -1.5},
                                                             {".5", 0.5},   {"2.", 2},    {"1e3", 1e3},
                                                             {"1E+3", 1e3}, {"0.1", 0.1}, {"5e-324", 0x1p-1074}};
  for (const auto& [text, expected] : table) {
    const Decimal number = decimal_of(text);
    EXPECT_EQ(number.fault, "") << text;
    EXPECT_EQ(number.value, expected) << text;
  }
  EXPECT_TRUE(std::signbit(decimal_of("-0").value));
}

TEST(Decimal, WhatIsNoNumberIsSaidWithTheWayOut) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"", "is \"\", which is not a number"},
      {" 1", "is \" 1\", which is not a number"},
      {"1mm", "is \"1mm\", which is not a number"},
      {"3.1+e2", "is \"3.1+e2\", which is not a number"},
      {"+-1", "is \"+-1\", which is not a number"},
      {"0x10", "is \"0x10\", which is not a number"},
      {"1,5", "is \"1,5\", which is not a number; write decimals with a point"},
      {"nan", "is \"nan\"; it must be a finite number"},
      {"-inf", "is \"-inf\"; it must be a finite number"},
      {"1e999", "is \"1e999\"; the largest number is about 1.8e308"}};
  for (const auto& [text, expected] : table) EXPECT_EQ(decimal_of(text).fault, expected) << text;
}

}  // namespace
}  // namespace graze::io::decimal_test
