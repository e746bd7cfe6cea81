// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/io/csv/records.hpp>

#include "io/scene_text.hpp"

namespace graze::io::csv_records_test {
namespace {

using Table = std::vector<std::vector<std::string>>;

Table read(const std::string& text) {
  CsvRecords records(text, "a.csv");
  Table table;
  while (records.next()) {
    table.emplace_back();
    for (const CsvField& field : records.fields()) table.back().emplace_back(field.text);
  }
  return table;
}

TEST(CsvRecords, LinesEndWithLfOrCrlfOrTheText) {
  const Table expected = {{"a", "b"}, {"c", "d"}};
  EXPECT_EQ(read("a,b\nc,d\n"), expected);
  EXPECT_EQ(read("a,b\r\nc,d\r\n"), expected);
  EXPECT_EQ(read("a,b\nc,d"), expected);
  EXPECT_EQ(read("a,b\r\nc,d\r"), expected);
}

TEST(CsvRecords, TheSeparatorIsTheFirstOfTheFirstLine) {
  EXPECT_EQ(csv_separator("a,b;c\n"), ',');
  EXPECT_EQ(csv_separator("a;b,c\n"), ';');
  EXPECT_EQ(csv_separator("\n a\tb;c\n"), '\t');
  EXPECT_EQ(csv_separator("\"a,b\";c\n"), ';');
  EXPECT_EQ(csv_separator("a\nb;c\n"), ',');
  EXPECT_EQ(csv_separator("a\rb;c\r"), ',');
  EXPECT_EQ(csv_separator(""), ',');
}

TEST(CsvRecords, OtherSeparatorsLeaveCommasInFields) {
  CsvRecords records("a,b;\"c;d\"\n", "a.csv", ';');
  ASSERT_TRUE(records.next());
  ASSERT_EQ(records.fields().size(), 2U);
  EXPECT_EQ(records.fields()[0].text, "a,b");
  EXPECT_EQ(records.fields()[1].text, "c;d");
  CsvRecords wrong("\"a\"b;c\n", "a.csv", ';');
  EXPECT_EQ(error_of([&wrong] { wrong.next(); }),
            "a.csv: line 1, column 4: text after a closing quote; only a semicolon or the end of the line may follow");
}

TEST(CsvRecords, BlankLinesArePassedOver) {
  EXPECT_EQ(read("\n\r\na,b\n\n  \t\r\nc,d\n\n \n"), (Table{{"a", "b"}, {"c", "d"}}));
  EXPECT_EQ(read(""), Table{});
  EXPECT_EQ(read(" \n\n"), Table{});
}

TEST(CsvRecords, EmptyFieldsAreFields) {
  EXPECT_EQ(read("a,,b\n,,\n"), (Table{{"a", "", "b"}, {"", "", ""}}));
  EXPECT_EQ(read("a,\"\"\n"), (Table{{"a", ""}}));
  EXPECT_EQ(read("a,"), (Table{{"a", ""}}));
}

TEST(CsvRecords, QuotedFieldsHoldCommasQuotesAndLineBreaks) {
  EXPECT_EQ(read("\"a,b\",\"say \"\"hi\"\"\",\"x\r\ny\"\r\n1,2,3\n"),
            (Table{{"a,b", "say \"hi\"", "x\r\ny"}, {"1", "2", "3"}}));
  EXPECT_EQ(read("\"\"\"\"\"\",\"\"\"a\""), (Table{{"\"\"", "\"a"}}));
}

TEST(CsvRecords, FieldsKnowWhereTheyBegin) {
  const std::string text = "a,\"b\"\nc,d";
  CsvRecords records(text, "a.csv");
  ASSERT_TRUE(records.next());
  EXPECT_EQ(records.fields()[1].offset, 2U);
  ASSERT_TRUE(records.next());
  EXPECT_EQ(records.fields()[0].offset, 6U);
  EXPECT_EQ(records.fields()[1].offset, 8U);
  EXPECT_FALSE(records.next());
}

TEST(CsvRecords, QuotesThatDoNotMatchAreNamed) {
  EXPECT_EQ(error_of([] { read("a,b\nc,\"d\ne,f"); }), "a.csv: line 2, column 3: this quote is never closed");
  EXPECT_EQ(error_of([] { read("a,\"b\"c\n"); }),
            "a.csv: line 1, column 6: text after a closing quote; only a comma or the end of the line may follow");
  EXPECT_EQ(error_of([] { read("a,5\"\n"); }),
            "a.csv: line 1, column 4: a quote inside a field; put the whole field in quotes and write each quote in it "
            "twice");
}

RC_GTEST_PROP(CsvRecords, WhateverIsQuotedComesBack, (const std::vector<std::string>& fields)) {
  RC_PRE(!fields.empty());
  std::string text;
  for (const std::string& field : fields) {
    text += text.empty() ? "\"" : ",\"";
    for (const char character : field) text += character == '"' ? std::string("\"\"") : std::string(1, character);
    text += '"';
  }
  RC_ASSERT(read(text) == Table{fields});
  RC_ASSERT(read(text + "\r\n" + text + "\n") == (Table{fields, fields}));
}

}  // namespace
}  // namespace graze::io::csv_records_test
