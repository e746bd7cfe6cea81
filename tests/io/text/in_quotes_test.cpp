// SPDX-License-Identifier: MIT
#include <string>

#include <gtest/gtest.h>

#include <graze/io/text/in_quotes.hpp>

namespace graze::io::in_quotes_test {
namespace {

TEST(InQuotes, ShortTextStandsAsItIs) {
  EXPECT_EQ(in_quotes("ball"), "\"ball\"");
  EXPECT_EQ(in_quotes(""), "\"\"");
  EXPECT_EQ(in_quotes("gr\xC3\xBC\xC3\x9F"
                      "e"),
            "\"gr\xC3\xBC\xC3\x9F"
            "e\"");
}

TEST(InQuotes, WhatWouldSteerATerminalIsSpelledOut) { EXPECT_EQ(in_quotes("a\x1B[31mb\n"), "\"a\\x1b[31mb\\x0a\""); }

TEST(InQuotes, LongTextIsCutBetweenCharacters) {
  EXPECT_EQ(in_quotes(std::string(80, 'x')), '"' + std::string(80, 'x') + '"');
  EXPECT_EQ(in_quotes(std::string(81, 'x')), '"' + std::string(80, 'x') + "...\"");
  EXPECT_EQ(in_quotes(std::string(79, 'x') + "\xC3\xA4z"), '"' + std::string(79, 'x') + "...\"");
}

}  // namespace
}  // namespace graze::io::in_quotes_test
