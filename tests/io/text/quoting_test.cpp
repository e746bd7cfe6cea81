// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <graze/io/text/quoting.hpp>

namespace graze::io::quoting_test {
namespace {

TEST(JsonString, EscapesWhatJsonWants) {
  EXPECT_EQ(json_string("crate"), R"("crate")");
  EXPECT_EQ(json_string("a \"b\"\n\\"), R"("a \"b\"\n\\")");
  EXPECT_EQ(json_string("\x01"), R"("\u0001")");
  EXPECT_EQ(json_string("\xff"), "\"\xef\xbf\xbd\"");  // not UTF-8
}

TEST(CsvField, IsQuotedWhereItHoldsASeparator) {
  EXPECT_EQ(csv_field("crate"), "crate");
  EXPECT_EQ(csv_field(""), "");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("a \"b\""), "\"a \"\"b\"\"\"");
  EXPECT_EQ(csv_field("a\nb"), "\"a\nb\"");
  EXPECT_EQ(csv_field("a\rb"), "\"a\rb\"");
}

}  // namespace
}  // namespace graze::io::quoting_test
