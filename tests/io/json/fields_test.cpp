// SPDX-License-Identifier: MIT
#include <array>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include <graze/io/json/fields.hpp>

#include "io/scene_text.hpp"

namespace graze::io::json_fields_test {
namespace {

/// Calls `ask` with the fields of an object, which is object 3 "sphere" in messages.
template <class Ask>
auto with_fields(const std::string& text, const Ask& ask) {
  const JsonDocument document(text, "a.json");
  const JsonPlace place{document, nullptr, "object", 3, "ball"};
  return ask(JsonFields(document.root(), place, "a sphere"));
}

template <class Ask>
std::string message_for(const std::string& text, const Ask& ask) {
  return error_of([&] { with_fields(text, ask); });
}

TEST(JsonFields, NumbersAndVectorsAreRead) {
  EXPECT_EQ(with_fields(R"({"radius": 2.5})", [](const JsonFields& fields) { return fields.number("radius"); }), 2.5);
  const auto center =
      with_fields(R"({"center": [1, -2.5, 1e3]})", [](const JsonFields& fields) { return fields.vector<3>("center"); });
  EXPECT_EQ(center, (Vec<3, double>(1, -2.5, 1000)));
}

TEST(JsonFields, AMissingFieldIsNamed) {
  EXPECT_EQ(message_for("{}", [](const JsonFields& fields) { fields.number("radius"); }),
            R"(a.json: line 1, column 1: object 3 "ball": a sphere needs the field "radius")");
}

TEST(JsonFields, AnUnknownFieldIsNamedWithTheNearestKnown) {
  const auto allow = [](const JsonFields& fields) {
    fields.allow_only(std::array<std::string_view, 2>{"center", "radius"});
  };
  EXPECT_NO_THROW(with_fields(R"({"center": 1, "radius": 2})", allow));
  EXPECT_EQ(message_for("{\"center\": 1,\n \"raduis\": 2}", allow),
            R"(a.json: line 2, column 2: object 3 "ball": unknown field "raduis"; did you mean "radius"?)");
}

TEST(JsonFields, AValueOfTheWrongKindIsNamed) {
  const auto number = [](const JsonFields& fields) { fields.number("radius"); };
  const std::string begin = R"(a.json: line 1, column 12: object 3 "ball": "radius" must be a number, not )";
  EXPECT_EQ(message_for(R"({"radius": null})", number), begin + "null");
  EXPECT_EQ(message_for(R"({"radius": "2"})", number), begin + "a string");
  EXPECT_EQ(message_for(R"({"radius": [2]})", number), begin + "an array");
  EXPECT_EQ(message_for(R"({"radius": {}})", number), begin + "an object");
  EXPECT_EQ(message_for(R"({"radius": true})", number), begin + "true or false");
}

TEST(JsonFields, AVectorNeedsAsManyNumbersAsThereAreDimensions) {
  const auto vector = [](const JsonFields& fields) { fields.vector<3>("center"); };
  const std::string begin = R"(a.json: line 1, column 12: object 3 "ball": "center" )";
  EXPECT_EQ(message_for(R"({"center": [1, 2]})", vector), begin + "has 2 numbers; this scene has dimension 3");
  EXPECT_EQ(message_for(R"({"center": [1]})", vector), begin + "has 1 number; this scene has dimension 3");
  EXPECT_EQ(message_for(R"({"center": []})", vector), begin + "has 0 numbers; this scene has dimension 3");
  EXPECT_EQ(message_for(R"({"center": 1})", vector), begin + "must be an array of 3 numbers, not a number");
  EXPECT_EQ(message_for(R"({"center": [1, null, 2]})", vector),
            R"(a.json: line 1, column 16: object 3 "ball": "center" must hold numbers; coordinate 1 is null)");
}

TEST(JsonFields, WholeNumbersAreToBeWhole) {
  const auto whole = [](const JsonFields& fields) {
    return read_whole(fields.require("user"), {"user"}, fields.place());
  };
  EXPECT_EQ(with_fields(R"({"user": 18446744073709551615})", whole), 18446744073709551615U);
  EXPECT_EQ(message_for(R"({"user": -1})", whole), R"(a.json: line 1, column 10: object 3 "ball": "user" is -1; )"
                                                   "it must be a whole number from 0 to 18446744073709551615");
  EXPECT_NE(message_for(R"({"user": 1.5})", whole).find("\"user\" is 1.5; it must be"), std::string::npos);
  EXPECT_NE(message_for(R"({"user": "7"})", whole).find("must be a whole number, not a string"), std::string::npos);
}

TEST(JsonFields, PlacesInsideEachOtherAreAllNamed) {
  const JsonDocument document("[]", "a.json");
  const JsonPlace object{document, nullptr, "object", 3, "chair"};
  const JsonPlace part{document, &object, "part", 2};
  const JsonPlace inner{document, &part, "part", 0};
  EXPECT_STREQ(inner.error(1, "is wrong").what(),
               R"(a.json: line 1, column 2: object 3 "chair", part 2, part 0: is wrong)");
  EXPECT_STREQ(JsonPlace{document}.error(0, "is wrong").what(), "a.json: line 1, column 1: is wrong");
}

TEST(JsonFields, AnElementIsNamedByItsIndex) {
  const JsonDocument document("[[1]]", "a.json");
  const JsonPlace place{document};
  EXPECT_EQ(error_of([&] {
              read_vector<2>(*document.root().items().begin(), {"points", 4}, place);
            }),
            R"(a.json: line 1, column 2: "points"[4] has 1 number; this scene has dimension 2)");
}

}  // namespace
}  // namespace graze::io::json_fields_test
