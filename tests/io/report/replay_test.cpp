// SPDX-License-Identifier: MIT
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <graze/io/report/replay.hpp>

namespace graze::io::replay_report_test {
namespace {

QueryLog<2> log_of_one_call() {
  LogEntry<2> entry;
  entry.call.kind = CallKind::find;
  entry.call.name = "a";
  entry.line = 2;
  return {NumberType::single_precision, {entry}};
}

ReplayReport one_difference() {
  ReplayReport report{1, 1, {}};
  report.first.push_back({0, logged(ObjectId{0, 1, logged_scene}), LoggedAnswer{}, LoggedAnswer{}, true, true});
  return report;
}

std::string written(ReplayFormat format, const ReplayReport& report) {
  std::ostringstream out;
  write_replay(out, format, {"x.log", 0.25}, log_of_one_call(), report);
  return out.str();
}

TEST(ReplayReport, ShowsTheFirstDifferenceInFull) {
  EXPECT_EQ(written(ReplayFormat::table, one_difference()), R"(LINE  CALL  DIFFERS FROM
2     find  the log and brute force

line 2: {"call": "find", "name": "a"}
  given        {"answer": [[0, 1]]}
  brute force  {"answer": []}
  the log      {"answer": []}

1 of 1 answer differs; 2D float, 0.250 seconds
)");
}

TEST(ReplayReport, OfAgreementIsASentence) {
  EXPECT_EQ(written(ReplayFormat::table, {5, 0, {}}), "none of 5 answers differ; 2D float, 0.250 seconds\n");
}

TEST(ReplayReport, IsAJsonDocument) {
  const auto document = nlohmann::json::parse(written(ReplayFormat::json, one_difference()));
  EXPECT_EQ(document["schema"], "graze.replay/1");
  EXPECT_EQ(document["log"], "x.log");
  EXPECT_EQ(document["numbers"], "float");
  EXPECT_EQ(document["summary"]["calls"], 1);
  EXPECT_EQ(document["summary"]["differing"], 1);
  const auto difference = document["differences"][0];
  EXPECT_EQ(difference["line"], 2);
  EXPECT_EQ(difference["call"]["name"], "a");
  EXPECT_EQ(difference["given"]["answer"][0][1], 1);
  EXPECT_EQ(difference["brute_force"]["answer"].size(), 0U);
  EXPECT_EQ(difference["differs_from_log"], true);
  EXPECT_EQ(nlohmann::json::parse(written(ReplayFormat::json, {5, 0, {}}))["differences"].size(), 0U);
}

}  // namespace
}  // namespace graze::io::replay_report_test
