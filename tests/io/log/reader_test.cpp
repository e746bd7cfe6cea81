// SPDX-License-Identifier: MIT
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include <graze/io/log/query_log.hpp>

#include "io/scene_text.hpp"

namespace graze::io::query_log_reader_test {
namespace {

const std::string head = "{\"schema\": \"graze.log/1\", \"dimension\": 2, \"numbers\": \"float\"}\n";
const std::string add_point = R"({"call": "add", "shape": {"type": "point", "position": [1, 2]}})"
                              "\n";

std::string refusal_of(const std::string& text) {
  return error_of([&text] { parse_query_log(text, "log"); });
}

/// The error of a log with the header and these lines.
std::string refusal_behind_head(const std::string& lines) { return refusal_of(head + lines); }

TEST(QueryLogReader, ReadsCallsWithTheirAnswersAndLines) {
  const auto log = std::get<QueryLog<2>>(
      parse_query_log(head + "\n" + add_point + "{\"answer\": [[0, 1]]}\n{\"call\": \"update\"}\n", "log"));
  EXPECT_EQ(log.numbers, NumberType::single_precision);
  ASSERT_EQ(log.entries.size(), 2U);
  EXPECT_EQ(log.entries[0].call.kind, CallKind::add);
  EXPECT_EQ(log.entries[0].line, 3U);
  EXPECT_TRUE(say_the_same(*log.entries[0].answer, logged(ObjectId{0, 1, logged_scene})));
  EXPECT_EQ(log.entries[1].line, 5U);
  EXPECT_FALSE(log.entries[1].answer);  // the program ended here
}

TEST(QueryLogReader, ReadsBothDimensionsAndNumberTypes) {
  const auto log = parse_query_log(R"({"schema": "graze.log/1", "dimension": 3, "numbers": "double"})", "log");
  EXPECT_EQ(std::get<QueryLog<3>>(log).numbers, NumberType::double_precision);
}

TEST(QueryLogReader, RefusesWhatIsNoLog) {
  EXPECT_EQ(refusal_of(""), "log: this is empty; a log has at least a header");
  EXPECT_EQ(refusal_of("[]"), "log: line 1, column 1: a log begins with a JSON object");
  EXPECT_EQ(refusal_of("{}"),
            "log: line 1, column 1: there is no \"schema\"; a graze log begins with {\"schema\": "
            "\"graze.log/1\", \"dimension\": 2, \"numbers\": \"double\"}");
  EXPECT_EQ(refusal_of(R"({"schema": "graze.scene/1"})"),
            "log: line 1, column 12: \"schema\" is \"graze.scene/1\", which is not a query log; this version reads "
            "\"graze.log/1\"");
  EXPECT_EQ(refusal_of("{\n  \"schema\": \"graze.scene/1\",\n  \"dimension\": 2}"),
            "log: this is a scene, not a query log; graze simulate --log records one");
  EXPECT_EQ(refusal_of(std::string("\xFF\xFE{\0", 4)), "log: this is UTF-16; save it as UTF-8");
  EXPECT_EQ(
      refusal_of(R"({"schema": "graze.log/2"})"),
      "log: line 1, column 12: \"schema\" is \"graze.log/2\", another version; this version reads \"graze.log/1\"");
  EXPECT_EQ(refusal_of(R"({"schema": "graze.log/1", "dimension": 4, "numbers": "float"})"),
            "log: line 1, column 40: \"dimension\" is 4; it must be 2 or 3");
  EXPECT_EQ(refusal_of(R"({"schema": "graze.log/1", "dimension": 2, "numbers": "half"})"),
            "log: line 1, column 54: \"numbers\" is \"half\"; it must be \"float\" or \"double\"");
}

TEST(QueryLogReader, NamesTheLineThatIsCutOff) {
  EXPECT_EQ(refusal_behind_head(add_point + "{\"answer\": [["),
            "log: line 3, column 14: the JSON text ends here, before it is complete; is the file cut off?");
  EXPECT_EQ(refusal_behind_head("\n\nnonsense\n").substr(0, 20), "log: line 4, column ");
  EXPECT_EQ(refusal_behind_head("{\"call\": \"update\"}\n{\"answer\": [\"\xff\"]}\n").substr(0, 23),
            "log: line 3, column 14:");
}

TEST(QueryLogReader, WantsAnAnswerBehindEachCallButTheLast) {
  EXPECT_EQ(refusal_behind_head("{\"call\": \"update\"}\n{\"call\": \"pairs\"}\n"),
            "log: line 3: the call in line 2 has no answer; only the last call may lack one");
  EXPECT_EQ(refusal_behind_head("{\"answer\": []}\n"),
            "log: line 2: this answer has no call; each answer must follow its call");
  EXPECT_EQ(refusal_behind_head(add_point + "{\"answer\": []}\n"),
            "log: line 3: the answer to \"add\" must be one id: {\"answer\": [[0, 1]]}");
}

TEST(QueryLogReader, RefusesIdsThatNeverExisted) {
  const std::string message =
      "log: line 4: no earlier line returned the id [7, 1], so this call cannot have "
      "been answered";
  const std::string remove = R"({"call": "remove", "id": [7, 1]})"
                             "\n";
  const std::string before = add_point + "{\"answer\": [[0, 1]]}\n";
  EXPECT_EQ(refusal_behind_head(before + remove + "{\"answer\": []}\n"), message);
  EXPECT_EQ(refusal_behind_head(before + remove), message);
  const AnyQueryLog refused = parse_query_log(head + before + remove + "{\"refused\": \"no\"}\n", "log");
  EXPECT_EQ(std::get<QueryLog<2>>(refused).entries.size(), 2U);
}

TEST(QueryLogReader, RefusesNumbersThatFloatCannotHold) {
  EXPECT_EQ(refusal_behind_head(R"({"call": "add", "shape": {"type": "point", "position": [1e39, 2]}})"),
            "log: line 2: a shape has a number that float cannot hold, at most 3.4e38");
}

}  // namespace
}  // namespace graze::io::query_log_reader_test
