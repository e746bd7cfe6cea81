// SPDX-License-Identifier: MIT
#include <sstream>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include <graze/io/log/query_log.hpp>

#include "io/scene_text.hpp"

namespace graze::io::query_log_test {
namespace {

TEST(QueryLog, IsWrittenAsItIsRead) {
  const std::string text = R"({"schema": "graze.log/1", "dimension": 3, "numbers": "float"}
{"call": "add", "shape": {"type": "point", "position": [0.10000000149011612, 2, -0.0]}}
{"answer": [[0, 1]]}
{"call": "remove", "id": [1, 1]}
{"refused": "no such object"}
{"call": "update"}
)";
  std::ostringstream out;
  write_query_log(out, std::get<QueryLog<3>>(parse_query_log(text, "log")));
  EXPECT_EQ(out.str(), text);
}

TEST(QueryLog, HasAHeadThatNamesItsNumbers) {
  EXPECT_EQ(log_head(2, number_type_of<float>), R"({"schema": "graze.log/1", "dimension": 2, "numbers": "float"})");
  EXPECT_EQ(name_of(number_type_of<double>), "double");
}

TEST(QueryLog, IsWhatThePageShows) {
  const std::string page = text_of(project_file("docs/query_log.md"));
  const std::string log = code_block(page, "json");
  ASSERT_FALSE(log.empty());
  std::ostringstream out;
  write_query_log(out, std::get<QueryLog<2>>(parse_query_log(log, "docs/query_log.md")));
  EXPECT_EQ(out.str(), log);
}

}  // namespace
}  // namespace graze::io::query_log_test
