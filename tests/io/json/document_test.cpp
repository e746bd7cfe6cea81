// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/json/document.hpp>

#include "io/scene_text.hpp"

namespace graze::io::json_document_test {
namespace {

std::string parse_error(const std::string& text) {
  return error_of([&text] { const JsonDocument document(text, "a.json"); });
}

TEST(JsonDocument, ValuesOfEveryKindAreFoundWithTheirPlaces) {
  const std::string text = R"({"none": null, "yes": true, "n": 7, "x": -2.5e1, "s": "a\"\u00e4", "list": [1, [], {}]})";
  const JsonDocument document(text, "a.json");
  const JsonValue root = document.root();
  EXPECT_EQ(root.kind(), JsonKind::object);
  EXPECT_EQ(root.size(), 6U);
  EXPECT_EQ(root.find("none")->kind(), JsonKind::null);
  EXPECT_EQ(root.find("yes")->kind(), JsonKind::boolean);
  EXPECT_EQ(root.find("n")->kind(), JsonKind::whole);
  EXPECT_EQ(root.find("n")->whole(), 7U);
  EXPECT_EQ(root.find("n")->number(), 7.0);
  EXPECT_EQ(root.find("x")->kind(), JsonKind::number);
  EXPECT_EQ(root.find("x")->number(), -25.0);
  EXPECT_EQ(root.find("s")->text(), "a\"\xC3\xA4");
  EXPECT_FALSE(root.find("absent").has_value());
  const JsonValue list = *root.find("list");
  ASSERT_EQ(list.size(), 3U);
  std::vector<JsonKind> kinds;
  for (const JsonValue item : list.items()) kinds.push_back(item.kind());
  EXPECT_EQ(kinds, (std::vector{JsonKind::whole, JsonKind::array, JsonKind::object}));
  for (const JsonField field : root.fields()) {
    EXPECT_EQ(field.offset, text.find('"' + std::string(field.name) + '"'));
  }
  EXPECT_EQ(root.find("x")->offset(), text.find("-2.5e1"));
  EXPECT_EQ(list.offset(), text.find("[1"));
}

TEST(JsonDocument, StringsInArraysAreElements) {
  const JsonDocument document(R"(["a", "b", ["c"], {"k": "d"}])", "a.json");
  EXPECT_EQ(document.root().size(), 4U);
  EXPECT_EQ((*document.root().items().begin()).text(), "a");
}

TEST(JsonDocument, WholeNumbersKeepAllTheirBits) {
  const JsonDocument document("[18446744073709551615, 18446744073709551616, -1, 0, -0, -0.0]", "a.json");
  std::vector<JsonValue> values;
  for (const JsonValue value : document.root().items()) values.push_back(value);
  EXPECT_EQ(values[0].kind(), JsonKind::whole);
  EXPECT_EQ(values[0].whole(), 18446744073709551615U);
  EXPECT_EQ(values[1].kind(), JsonKind::number);
  EXPECT_EQ(values[2].number(), -1.0);
  EXPECT_FALSE(std::signbit(values[3].number()));
  EXPECT_TRUE(std::signbit(values[4].number()));
  EXPECT_TRUE(std::signbit(values[5].number()));
}

TEST(JsonDocument, AByteOrderMarkIsAllowed) {
  const JsonDocument document("\xEF\xBB\xBF[1]", "a.json");
  EXPECT_EQ(document.root().size(), 1U);
}

TEST(JsonDocument, CutOffTextIsNamedAsSuchWhereverItIsCut) {
  const std::string whole = R"({"a": [1.5, "x\u00e4", true, null, {}], "b": -2e3})";
  for (std::size_t length = 1; length < whole.size(); ++length) {
    const std::string message = parse_error(whole.substr(0, length));
    EXPECT_NE(message.find("is the file cut off?"), std::string::npos) << message;
    EXPECT_EQ(message.find("a.json: line 1, column " + std::to_string(length + 1)), 0U) << message;
  }
}

TEST(JsonDocument, SyntaxErrorsHaveLineAndColumn) {
  EXPECT_EQ(parse_error("{\n  \"a\": 1,\n}"),
            "a.json: line 3, column 1: this is not JSON: unexpected '}'; expected string literal");
  EXPECT_EQ(parse_error("{\"a\" 1}").find("a.json: line 1, column 6: this is not JSON: unexpected number literal"), 0U);
  EXPECT_EQ(parse_error("[1] x").find("a.json: line 1, column 5: this is not JSON: "), 0U);
  EXPECT_EQ(parse_error("[tru]").find("a.json: line 1, column 5: this is not JSON: invalid literal"), 0U);
  EXPECT_EQ(parse_error("[\"a\nb\"]").find("a.json: line 1, column 4: this is not JSON: invalid string: control"), 0U);
  // The token that was read last is omitted completely, even if it looks like the following words.
  EXPECT_EQ(
      parse_error("[\"'; expected \xE2\x80\xAE\n"),
      "a.json: line 1, column 16: this is not JSON: invalid string: control character U+000A (LF) must be escaped "
      "to \\u000A or \\n");
}

TEST(JsonDocument, NanAndInfinityAreExplained) {
  for (const std::string_view word : {"NaN", "nan", "Infinity", "-Infinity", "inf", "+inf"}) {
    EXPECT_EQ(parse_error("[1,\n " + std::string(word) + "]"),
              "a.json: line 2, column 2: neither JSON nor a scene can hold NaN or infinity; "
              "give a finite number");
  }
}

TEST(JsonDocument, NumbersTooLargeForADoubleAreErrorsAndTooSmallOnesAreZero) {
  EXPECT_EQ(parse_error("[1,\n 1e999]"),
            "a.json: line 2, column 2: \"1e999\" is too large; the largest number is about 1.8e308");
  EXPECT_EQ(parse_error("[-1e999]").find("a.json: line 1, column 2: \"-1e999\""), 0U);
  EXPECT_EQ(parse_error('[' + std::string(400, '9') + ']').find("a.json: line 1, column 2: \"999"), 0U);
  const JsonDocument document("[1e-999, 5e-324]", "a.json");
  const auto first = document.root().items().begin();
  EXPECT_EQ((*first).number(), 0.0);
}

TEST(JsonDocument, AKeyThatAppearsTwiceIsAnError) {
  EXPECT_EQ(parse_error("{\"a\": 1,\n \"b\": {\"a\": 2},\n \"a\": 3}"),
            "a.json: line 3, column 2: field \"a\" appears twice in one object, first in line 1, column 2");
  EXPECT_EQ(parse_error(R"({"\u0061": 1, "a": 3})").find("a.json: line 1, column 15: field \"a\" appears twice"), 0U);
}

TEST(JsonDocument, NestingIsLimitedWithoutRecursion) {
  const std::size_t limit = JsonDocument::max_depth;
  EXPECT_NO_THROW(JsonDocument(std::string(limit, '[') + std::string(limit, ']'), "a.json"));
  const std::string message = parse_error(std::string(1000000, '['));
  EXPECT_EQ(message, "a.json: line 1, column 129: nested deeper than 128 levels, the most that is allowed");
}

TEST(JsonDocument, MayBeALaterLineOfItsSource) {
  const auto error_in_line_7 = [](const std::string& text) {
    return error_of([&text] { JsonDocument(text, "a.json", 7); });
  };
  EXPECT_EQ(error_in_line_7("[1,").substr(0, 23), "a.json: line 7, column ");
  EXPECT_EQ(error_in_line_7("[\"\xFF\"]").substr(0, 24), "a.json: line 7, column 3");
  EXPECT_EQ(error_in_line_7("{\"a\": 1, \"a\": 2}"),
            "a.json: line 7, column 10: field \"a\" appears twice in one object, first in line 7, column 2");
}

TEST(JsonDocument, TextThatIsNotUtf8IsAnError) {
  EXPECT_EQ(parse_error("[\"\xFF\"]").find("a.json: line 1, column 3: byte 0xFF is not UTF-8 text"), 0U);
  EXPECT_EQ(parse_error(std::string("[1]\0", 4)).find("a.json: line 1, column 4: byte 0x00"), 0U);
}

TEST(JsonDocument, PacksArraysOfWholeNumbersInOneField) {
  const std::string text = R"({"data": [1, 4294967295], "a": [1], "b": {"data": [ ]}, "data2": [3], "data": 5})";
  const std::string other = R"({"data": [1, 2, -3, [4]], "x": {"data": [7, 8]}})";
  EXPECT_THROW(JsonDocument(text, "t", 1, "data"), InputError) << "a field twice";
  const JsonDocument packed(text.substr(0, text.rfind(',')) + "}", "t", 1, "data");
  const JsonValue data = *packed.root().find("data");
  EXPECT_EQ(data.kind(), JsonKind::array);
  EXPECT_EQ(data.size(), 2U);
  ASSERT_EQ(data.packed().size(), 2U);
  EXPECT_EQ(data.packed()[1], 4294967295U);
  EXPECT_EQ(data.items().begin(), data.items().end());
  EXPECT_TRUE(packed.root().find("a")->packed().empty());
  EXPECT_EQ((*packed.root().find("a")->items().begin()).whole(), 1U);
  EXPECT_EQ(packed.root().find("b")->find("data")->size(), 0U);

  const JsonDocument mixed(other, "t", 1, "data");
  const JsonValue array = *mixed.root().find("data");
  EXPECT_TRUE(array.packed().empty());
  EXPECT_EQ(array.size(), 4U);
  std::vector<JsonKind> kinds;
  for (const JsonValue element : array.items()) kinds.push_back(element.kind());
  EXPECT_EQ(kinds, (std::vector<JsonKind>{JsonKind::whole, JsonKind::whole, JsonKind::number, JsonKind::array}));
  EXPECT_EQ(mixed.root().find("x")->find("data")->packed()[0], 7U);
  EXPECT_TRUE(JsonDocument(other, "t").root().find("x")->find("data")->packed().empty()) << "only where asked for";
}

}  // namespace
}  // namespace graze::io::json_document_test
