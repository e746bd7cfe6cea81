// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <graze/io/text/position.hpp>

namespace graze::io::text_position_test {
namespace {

TEST(TextPosition, LinesAndColumnsCountFromOne) {
  const std::string_view text = "ab\ncd\r\n\ne";
  EXPECT_EQ(position_of(text, 0), (TextPosition{1, 1}));
  EXPECT_EQ(position_of(text, 1), (TextPosition{1, 2}));
  EXPECT_EQ(position_of(text, 2), (TextPosition{1, 3}));  // a line break belongs to the line that it ends
  EXPECT_EQ(position_of(text, 3), (TextPosition{2, 1}));
  EXPECT_EQ(position_of(text, 7), (TextPosition{3, 1}));
  EXPECT_EQ(position_of(text, 8), (TextPosition{4, 1}));
}

TEST(TextPosition, AnUmlautAndAnEmojiAreOneColumnEach) {
  const std::string_view text = "\xC3\xA4\xF0\x9F\x98\x80x";
  EXPECT_EQ(position_of(text, 6), (TextPosition{1, 3}));
}

TEST(TextPosition, AnOffsetBeyondTheEndIsTheEnd) {
  EXPECT_EQ(position_of("ab\nc", 99), (TextPosition{2, 2}));
  EXPECT_EQ(position_of("", 5), (TextPosition{1, 1}));
}

TEST(TextPosition, AnErrorNamesSourceAndPlace) {
  EXPECT_STREQ(error_at("a\nbc", "level.json", 3, "this is wrong").what(),
               "level.json: line 2, column 2: this is wrong");
  EXPECT_STREQ(error_at("a\nbc", "level.json", 3, "this is wrong", 5).what(),
               "level.json: line 6, column 2: this is wrong");
}

}  // namespace
}  // namespace graze::io::text_position_test
