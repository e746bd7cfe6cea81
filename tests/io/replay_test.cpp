// SPDX-License-Identifier: MIT
#include <sstream>
#include <string>
#include <variant>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/io/log/query_log.hpp>
#include <graze/io/recorded_scene.hpp>
#include <graze/io/replay.hpp>

#include "logged_world.hpp"

namespace graze::io::replay_test {
namespace {

template <Dim N, class T>
void check_random_life() {
  const std::string text = random_log<N, T>(12);
  RC_LOG() << text;
  const auto log = std::get<QueryLog<N>>(parse_query_log(text, "log"));
  RC_ASSERT(log.numbers == number_type_of<T>);
  const ReplayReport report = replay(log, library_targets<N>(log.numbers));
  for (const ReplayDifference& each : report.first) {
    RC_LOG() << "\n"
             << call_line(log.entries[each.entry].call) << "\ngiven    " << answer_line(each.given) << "\nexpected "
             << answer_line(each.expected);
  }
  RC_ASSERT(report.differing == 0U);
  RC_ASSERT(report.calls == log.entries.size());
  std::ostringstream again;
  write_query_log(again, log);
  RC_ASSERT(again.str() == text);
}

/// A log with a wrong second answer, and a call without one.
const std::string wrong_log = R"({"schema": "graze.log/1", "dimension": 2, "numbers": "double"}
{"call": "add", "shape": {"type": "point", "position": [1, 2]}}
{"answer": [[0, 1]]}
{"call": "overlapping", "shape": {"type": "point", "position": [1, 2]}}
{"answer": []}
{"call": "overlapping", "shape": {"type": "point", "position": [1, 2]}}
{"answer": [[0, 1]]}
{"call": "pairs"}
)";

TEST(Replay, TellsWhichAnswersOfTheLogAreWrong) {
  const auto log = std::get<QueryLog<2>>(parse_query_log(wrong_log, "log"));
  std::size_t calls = 0;
  const ReplayReport report =
      replay(log, library_targets<2>(log.numbers), [&calls](std::size_t done) { calls = done; });
  EXPECT_EQ(calls, 4U);
  EXPECT_EQ(report.calls, 4U);
  EXPECT_EQ(report.differing, 1U);
  ASSERT_EQ(report.first.size(), 1U);
  const ReplayDifference& difference = report.first.front();
  EXPECT_EQ(difference.entry, 1U);
  EXPECT_FALSE(difference.is_from_judge);
  EXPECT_TRUE(difference.is_from_record);
  EXPECT_EQ(answer_line(difference.given), R"({"answer": [[0, 1]]})");
}

TEST(Replay, TellsWhenACallWithAFaultWasAnswered) {
  const std::string head = R"({"schema": "graze.log/1", "dimension": 2, "numbers": "double"})";
  const std::string call = R"({"call": "overlapping", "fault": "a sphere has a negative radius"})";
  const auto differing = [&](const std::string& answer) {
    const auto log = std::get<QueryLog<2>>(parse_query_log(head + "\n" + call + "\n" + answer + "\n", "log"));
    return replay(log, library_targets<2>(log.numbers)).differing;
  };
  EXPECT_EQ(differing(R"({"refused": "whatever"})"), 0U);
  EXPECT_EQ(differing(R"({"answer": []})"), 1U);
}

RC_GTEST_PROP(Replay, AgreesWithEveryLifeThatWasRecorded2f, ()) { check_random_life<2, float>(); }
RC_GTEST_PROP(Replay, AgreesWithEveryLifeThatWasRecorded3d, ()) { check_random_life<3, double>(); }

}  // namespace
}  // namespace graze::io::replay_test
