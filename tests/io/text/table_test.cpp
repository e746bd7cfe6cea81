// SPDX-License-Identifier: MIT
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/text/table.hpp>

namespace graze::io::text_table_test {
namespace {

std::string table(const TableRow& head, const std::vector<TableRow>& rows, Colours colours = Colours::off) {
  std::ostringstream out;
  write_table(out, head, rows, colours);
  return out.str();
}

TEST(TextTable, HasColumnsAsWideAsTheirWidestWord) {
  EXPECT_EQ(table({{"A"}, {"LONG"}, {"C"}}, {{{"wide"}, {"b"}, {"c"}}, {{"a"}, {"b"}, {"last"}}}),
            "A     LONG  C\n"
            "wide  b     c\n"
            "a     b     last\n");
}

TEST(TextTable, CountsWhatIsShownAndNotBytes) {
  EXPECT_EQ(table({{"NAME"}, {"X"}}, {{{"球球球"}, {"x"}}, {{"ü"}, {"y"}}}),
            "NAME    X\n"
            "球球球  x\n"
            "ü       y\n");
}

TEST(TextTable, WithoutRowsIsItsHead) { EXPECT_EQ(table({{"A"}, {"B"}}, {}), "A  B\n"); }

TEST(TextTable, ColoursWordsAndNotTheBlanksBehindThem) {
  const std::vector<TableRow> rows = {{{"red", "\x1b[31m"}, {"plain"}}};
  EXPECT_EQ(table({{"COLOUR"}, {"B"}}, rows, Colours::on), "\x1b[1mCOLOUR  B\x1b[0m\n\x1b[31mred\x1b[0m     plain\n");
  EXPECT_EQ(table({{"COLOUR"}, {"B"}}, rows), "COLOUR  B\nred     plain\n");
}

TEST(TextTable, IsWrittenAsItComesOnceItsColumnsAreKnown) {
  std::ostringstream out;
  TableWriter table(out, {{"A"}, {"B"}}, Colours::off);
  EXPECT_TRUE(table.is_empty());
  for (std::size_t i = 0; i + 1 < TableWriter::rows_for_widths; ++i) table.write({{"word"}, {"b"}});
  EXPECT_EQ(out.str(), "");
  EXPECT_FALSE(table.is_empty());
  table.write({{"word"}, {"b"}});
  EXPECT_EQ(out.str().substr(0, 16), "A     B\nword  b\n");
  out.str("");
  table.write({{"a wider word"}, {"b"}});
  EXPECT_EQ(out.str(), "a wider word  b\n");
  table.finish();
  EXPECT_EQ(out.str(), "a wider word  b\n");
  EXPECT_FALSE(table.is_empty());
}

TEST(TextTable, NumbersHaveSixDigits) {
  EXPECT_EQ(short_number(1.0 / 3), "0.333333");
  EXPECT_EQ(short_numbers(std::vector<double>{1, -2.5, 1e9}), "1, -2.5, 1e+09");
  EXPECT_EQ(short_numbers({}), "");
}

}  // namespace
}  // namespace graze::io::text_table_test
