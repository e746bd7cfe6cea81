// SPDX-License-Identifier: MIT
#include <string>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>

#include <graze/io/text/utf8.hpp>

#include "io/scene_text.hpp"

namespace graze::io::utf8_test {
namespace {

constexpr std::size_t none = std::string_view::npos;

TEST(Utf8, SequencesOfOneToFourBytesAreMeasured) {
  EXPECT_EQ(utf8_sequence_length("a", 0), 1U);
  EXPECT_EQ(utf8_sequence_length("\xC2\x80", 0), 2U);
  EXPECT_EQ(utf8_sequence_length("\xE0\xA0\x80", 0), 3U);
  EXPECT_EQ(utf8_sequence_length("\xF0\x90\x80\x80", 0), 4U);
  EXPECT_EQ(utf8_sequence_length("\xF4\x8F\xBF\xBF", 0), 4U);  // U+10FFFF, the last
  EXPECT_EQ(utf8_sequence_length("a", 1), 0U);
}

TEST(Utf8, WhatUnicodeForbidsIsNoSequence) {
  EXPECT_EQ(utf8_sequence_length("\x80", 0), 0U);              // a continuation alone
  EXPECT_EQ(utf8_sequence_length("\xC0\xAF", 0), 0U);          // overlong /
  EXPECT_EQ(utf8_sequence_length("\xC1\xBF", 0), 0U);          // overlong
  EXPECT_EQ(utf8_sequence_length("\xE0\x9F\xBF", 0), 0U);      // overlong
  EXPECT_EQ(utf8_sequence_length("\xF0\x8F\xBF\xBF", 0), 0U);  // overlong
  EXPECT_EQ(utf8_sequence_length("\xED\xA0\x80", 0), 0U);      // a surrogate
  EXPECT_EQ(utf8_sequence_length("\xF4\x90\x80\x80", 0), 0U);  // above U+10FFFF
  EXPECT_EQ(utf8_sequence_length("\xF5\x80\x80\x80", 0), 0U);
  EXPECT_EQ(utf8_sequence_length("\xE2\x82", 0), 0U);  // cut off
  EXPECT_EQ(utf8_sequence_length("\xE2\x82X", 0), 0U);
  EXPECT_EQ(utf8_sequence_length("\xFF", 0), 0U);
}

TEST(Utf8, TheFirstInvalidByteIsFoundAtEveryOffset) {
  for (std::size_t before = 0; before < 20; ++before) {
    const std::string text = std::string(before, 'x') + "\xFF" + std::string(20 - before, 'y');
    EXPECT_EQ(find_invalid_utf8(text), before);
  }
  EXPECT_EQ(find_invalid_utf8(""), none);
  EXPECT_EQ(find_invalid_utf8("plain text of more than eight bytes, gr\xC3\xB6\xC3\x9F"
                              "er"),
            none);
  EXPECT_EQ(find_invalid_utf8("12345678\xC3"), 8U);
}

TEST(Utf8, OnlyAWholeByteOrderMarkIsTakenAway) {
  EXPECT_EQ(without_byte_order_mark("\xEF\xBB\xBFx"), "x");
  EXPECT_EQ(without_byte_order_mark("\xEF\xBBx"), "\xEF\xBBx");
  EXPECT_EQ(without_byte_order_mark("x"), "x");
}

TEST(Utf8, OtherEncodingsAreToldByTheirMarksAndZeros) {
  const auto encoding = [](const std::string& text) { return other_encoding(text); };
  EXPECT_EQ(encoding(std::string("\xFF\xFE{\0", 4)), "UTF-16");
  EXPECT_EQ(encoding(std::string("\xFE\xFF\0{", 4)), "UTF-16");
  EXPECT_EQ(encoding(std::string("{\0\n\0", 4)), "UTF-16");
  EXPECT_EQ(encoding(std::string("\0{\0\n", 4)), "UTF-16");
  EXPECT_EQ(encoding(std::string("\xFF\xFE\0\0", 4)), "UTF-32");
  EXPECT_EQ(encoding(std::string("\0\0\xFE\xFF", 4)), "UTF-32");
  EXPECT_EQ(encoding(std::string("{\0\0\0", 4)), "UTF-32");
  EXPECT_EQ(encoding(std::string("a\0bc", 4)), "");
  EXPECT_EQ(encoding("\xEF\xBB\xBF{}"), "");
  EXPECT_EQ(encoding("{}"), "");
  EXPECT_EQ(encoding(""), "");
}

TEST(Utf8, BytesThatAreNoTextAreNamedWithTheirPlace) {
  EXPECT_NO_THROW(
      require_utf8("gr\xC3\xBC\xC3\x9F"
                   "e\n",
                   "a.csv"));
  EXPECT_EQ(error_of([] {
              require_utf8(
                  "ab\nc\xE9"
                  "d",
                  "a.csv");
            }),
            "a.csv: line 2, column 2: byte 0xE9 is not UTF-8 text; save the file as UTF-8");
  EXPECT_EQ(error_of([] { require_utf8(std::string_view("a\0b", 3), "a.csv"); }),
            "a.csv: line 1, column 2: byte 0x00 is not UTF-8 text; save the file as UTF-8");
}

}  // namespace
}  // namespace graze::io::utf8_test
