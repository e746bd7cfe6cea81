// SPDX-License-Identifier: MIT
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/io/text/printable.hpp>

namespace graze::io::printable_test {
namespace {

TEST(Printable, leaves_ordinary_text_as_it_is) {
  EXPECT_EQ(printable(""), "");
  EXPECT_EQ(printable("ball 1, \"left\" \\ ~"), "ball 1, \"left\" \\ ~");
  EXPECT_EQ(printable("Prüfstück 球 🎱"), "Prüfstück 球 🎱");
}

TEST(Printable, writes_control_characters_as_escapes) {
  EXPECT_EQ(printable("\x1b[31mred\x1b[0m"), "\\x1b[31mred\\x1b[0m");
  EXPECT_EQ(printable("a\tb\nc\rd\x7f"), "a\\x09b\\x0ac\\x0dd\\x7f");
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "\\x9b31m");  // U+009B begins an escape sequence too
}

TEST(Printable, writes_characters_that_turn_or_hide_text_as_escapes) {
  EXPECT_EQ(printable("a\u202eb"), "a\\u{202e}b");
  EXPECT_EQ(printable("a\u200bb\ufeff"), "a\\u{200b}b\\u{feff}");
  EXPECT_EQ(printable("\U000e0041"), "\\u{e0041}");
}

TEST(Printable, replaces_bytes_that_are_not_utf8) {
  const std::string mark = "\xef\xbf\xbd";
  EXPECT_EQ(printable("a\xff"), "a" + mark);
  EXPECT_EQ(printable("\xc0\x80"), mark + mark);             // overlong zero
  EXPECT_EQ(printable("\xed\xa0\x80"), mark + mark + mark);  // a surrogate
  EXPECT_EQ(printable("\xe7\x90"), mark + mark);             // cut off
}

TEST(DisplayColumns, counts_what_a_terminal_shows) {
  EXPECT_EQ(display_columns(""), 0U);
  EXPECT_EQ(display_columns("ball"), 4U);
  EXPECT_EQ(display_columns("Stück"), 5U);
  EXPECT_EQ(display_columns("Stu\u0308ck"), 5U);  // u and a combining diaeresis
  EXPECT_EQ(display_columns("球"), 2U);
  EXPECT_EQ(display_columns("🎱"), 2U);
}

RC_GTEST_PROP(Printable, gives_text_that_is_printable_already, (const std::string& bytes)) {
  const std::string once = printable(bytes);
  RC_ASSERT(printable(once) == once);
  for (const char character : once) RC_ASSERT(static_cast<unsigned char>(character) >= 0x20);
}

}  // namespace
}  // namespace graze::io::printable_test
