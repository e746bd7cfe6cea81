// SPDX-License-Identifier: MIT
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <graze/io/input_error.hpp>
#include <graze/io/log/line_reader.hpp>

#include "io/json_schema.hpp"
#include "io/scene_text.hpp"

namespace graze::io::log_line_reader_test {
namespace {

/// Writes again what is read from a line.
std::string call_again(const std::string& line) { return call_line(read_call<2>(JsonDocument(line, "log"))); }
std::string answer_again(const std::string& line) { return answer_line(read_answer(JsonDocument(line, "log"))); }

std::string call_refusal(const std::string& line) {
  return error_of([&line] { read_call<2>(JsonDocument(line, "log", 9)); });
}
std::string answer_refusal(const std::string& line) {
  return error_of([&line] { read_answer(JsonDocument(line, "log", 9)); });
}

TEST(LogLineReader, ReadsEveryKindOfCall) {
  for (
      const char* line : {
          R"({"call": "plan_ids", "ids": [[1, 1]], "vacant_ids": [[0, 2]]})",
          R"({"call": "layer", "name": "walls"})",
          R"({"call": "add", "name": "b", "layer": 2, "mask": 18446744073709551614, "user": 7, "fixed": true, "shape": )"
          R"({"type": "point", "position": [0.1, -0.0]}})",
          R"({"call": "move", "id": {"other_scene": [3, 1]}, "shape": {"type": "point", "position": [0, 1]}})",
          R"({"call": "move_many", "ids": [[3, 1], null], "shapes": [{"type": "point", "position": [0, 1]}, )"
          R"({"type": "compound", "parts": []}]})",
          R"({"call": "remove", "id": null})",
          R"({"call": "except", "ids": [[3, 1], [0, 1]]})",
          R"({"call": "accept", "ids": [[3, 1], null]})",
          R"({"call": "update"})",
          R"({"call": "find", "name": ""})",
          R"({"call": "candidates", "margin": -1})",
          R"({"call": "pairs"})",
          R"({"call": "contacts"})",
          R"({"call": "overlapping", "shape": {"type": "point", "position": [0, 1]}, "layers": 3})",
          R"({"call": "cull", "shape": {"type": "point", "position": [0, 1]}})",
          R"({"call": "cull_frustum", "corners": [[0, 0], [1, 0], [0, 1], [1, 1]], "layers": 0})",
          R"({"call": "nearest", "shape": {"type": "point", "position": [0, 1]}, "count": 3})",
          R"({"call": "ray_cast", "shape": {"type": "ray", "origin": [0, 1], "direction": [1, 0]}, "t_max": -0.5})",
          R"({"call": "ray_cast_all", "shape": {"type": "ray", "origin": [0, 1], "direction": [1, 0]}})",
          R"({"call": "shape_cast", "shape": {"type": "point", "position": [0, 1]}, "motion": [3, -0.5], "layers": 3})",
          R"({"call": "shape_cast_all", "shape": {"type": "point", "position": [0, 1]}, "motion": [3, 0], )"
          R"("except": [[0, 1], null], "ignore_initial_touch": true})",
          R"({"call": "time_of_impact", "shape": {"type": "point", "position": [0, 1]}, "motion": [3, 0], )"
          R"("angular": -1.5, "center": [0, 1]})",
          R"({"call": "contacts_with", "shape": {"type": "point", "position": [0, 1]}, "layers": 0})",
          R"({"call": "nearest_to", "shape": {"type": "point", "position": [0, 1]}, "count": 3})",
          R"({"call": "closest_pairs", "within": 0.5})",
          R"({"call": "add", "fault": "a sphere has a negative radius"})",
      }) {
    EXPECT_EQ(call_again(line), line);
  }
}

TEST(LogLineReader, ReadsEveryKindOfAnswer) {
  for (const char* line : {
           R"({"answer": []})",
           R"({"answer": [3]})",
           R"({"answer": [[0, 1], null, {"other_scene": [7, 3]}]})",
           R"({"answer": [[[0, 1], [7, 3]]]})",
           R"({"answer": [[[0, 1], 0.5, -0.0, "inf", "-inf", "nan"]]})",
           R"({"answer": [["began", [0, 1], [7, 3]], ["stayed", [0, 1], [1, 1]], ["ended", [0, 1], [2, 1]]]})",
           R"({"refused": "no \"b\""})",
           R"({"count": 65, "digest": "00ff00ff00ff00ff"})",
       }) {
    EXPECT_EQ(answer_again(line), line);
  }
}

/// Whether the line is read.
bool is_answer(const std::string& line) {
  try {
    read_answer(JsonDocument(line, "log"));
  } catch (const InputError&) {
    return false;
  }
  return true;
}

// The schema does not constrain how a number is written: it accepts 1e1 as an integer.
TEST(LogLineReader, ReadsTheAnswersThatTheJsonSchemaAllows) {
  const JsonSchema schema(nlohmann::json::parse(text_of(project_file("data/log.schema.json"))));
  const std::vector<std::string> parts = {"3",          "-3",     "0.5",  "\"nan\"", "\"ended\"",
                                          "\"x\"",      "[0, 1]", "null", "[0.5]",   "{\"other_scene\": [7, 3]}",
                                          "4294967296", "true"};
  std::vector<std::string> rows = parts;
  rows.push_back("[]");
  for (const std::string& a : parts) {
    rows.push_back("[" + a + "]");
    for (const std::string& b : parts) {
      rows.push_back("[" + a + ", " + b + "]");
      for (const std::string& c : parts) rows.push_back("[" + a + ", " + b + ", " + c + "]");
    }
  }
  std::size_t read = 0;
  for (const std::string& row : rows) {
    const std::string line = R"({"answer": [)" + row + "]}";
    const bool is_read = is_answer(line);
    EXPECT_EQ(schema.definition_allows("answer", nlohmann::json::parse(line)), is_read) << line;
    read += is_read ? 1 : 0;
  }
  EXPECT_GT(read, rows.size() / 8);
  EXPECT_LT(read, rows.size() / 2);
}

TEST(LogLineReader, SaysWhatIsWrongWithACall) {
  EXPECT_EQ(call_refusal(R"({"call": "mov"})"),
            "log: line 9, column 10: \"call\" is \"mov\", which is not known; did you mean \"move\"?");
  EXPECT_EQ(call_refusal(R"({"call": "update", "id": [0, 1]})").substr(0, 44),
            "log: line 9, column 20: unknown field \"id\"; ");
  EXPECT_EQ(call_refusal(R"({"call": "remove"})"), "log: line 9, column 1: a call needs the field \"id\"");
  EXPECT_EQ(call_refusal(R"({"call": "remove", "id": [1]})"),
            "log: line 9, column 26: \"id\" has 1 numbers; an id has two");
  EXPECT_EQ(call_refusal(R"({"call": "remove", "id": [1, 4294967296]})"),
            "log: line 9, column 30: \"id\" has 4294967296; at most 4294967295");
  EXPECT_EQ(call_refusal(R"({"call": "move_many", "ids": [[0, 1]], "shapes": []})"),
            "log: line 9, column 50: \"shapes\" are 0, but \"ids\" are 1");
  EXPECT_EQ(call_refusal(R"({"call": "cull_frustum", "corners": [[0, 0]]})"),
            "log: line 9, column 37: \"corners\" are 1; a frustum has 4");
  EXPECT_EQ(
      call_refusal(R"({"call": "nearest", "shape": {"type": "sphere", "center": [0, 0], "radius": 1}, "count": 1})"),
      "log: line 9, column 30: \"shape\" must be a point");
  EXPECT_EQ(call_refusal(R"({"call": "ray_cast", "shape": {"type": "point", "position": [0, 0]}})"),
            "log: line 9, column 31: \"shape\" must be a ray");
  EXPECT_EQ(call_refusal(R"({"call": "cull", "shape": {"type": "sphere", "center": [0, 0], "radius": -1}})"),
            "log: line 9, column 74: \"radius\" is -1; it must not be negative");
  EXPECT_EQ(call_refusal("7"), "log: line 9, column 1: a line of a log is a JSON object, not a number");
}

TEST(LogLineReader, SaysWhatIsWrongWithAnAnswer) {
  EXPECT_EQ(answer_refusal("{}"), "log: line 9, column 1: an answer needs the field \"answer\"");
  EXPECT_EQ(answer_refusal(R"({"count": 65, "digest": "xyz"})"),
            "log: line 9, column 25: \"digest\" is \"xyz\"; it must have 16 hexadecimal digits");
  EXPECT_EQ(answer_refusal(R"({"answer": [["befell", [0, 1]]]})"),
            "log: line 9, column 14: \"befell\" is not valid in an answer");
  EXPECT_EQ(answer_refusal(R"({"answer": [[1e1, 1]]})"),
            "log: line 9, column 13: a list of numbers in an answer must begin with an id");
}

}  // namespace
}  // namespace graze::io::log_line_reader_test
