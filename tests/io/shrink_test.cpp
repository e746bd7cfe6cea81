// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/log/query_log.hpp>
#include <graze/io/recorded_scene.hpp>
#include <graze/io/replay.hpp>
#include <graze/io/shrink.hpp>

namespace graze::io::shrink_test {
namespace {

using Ball = Sphere<2, double>;
using World = RecordedScene<2, double>;
using Log = QueryLog<2>;

Log log_of(const std::string& text) { return std::get<Log>(parse_query_log(text, "log")); }

std::string text_of(const Log& log) {
  std::ostringstream out;
  write_query_log(out, log);
  return out.str();
}

/// A scene in which answers to rays lack the last object once three objects were removed.
class Forgetful final : public CallTarget<2> {
 public:
  LoggedAnswer perform(const LoggedCall<2>& call) override {
    LoggedAnswer answer = scene_->perform(call);
    if (call.kind == CallKind::remove && !answer.refusal) ++removed_;
    if (call.kind == CallKind::ray_cast_all && removed_ >= 3 && !answer.rows.empty()) answer.rows.pop_back();
    return answer;
  }

 private:
  std::unique_ptr<CallTarget<2>> scene_ = scene_targets<2>(NumberType::double_precision)();
  int removed_ = 0;
};

ReplayTargets<2> forgetful_targets() {
  return {[] { return std::make_unique<Forgetful>(); }, plain_scene_targets<2>(NumberType::double_precision)};
}

/// Forty objects on a line, of which many move and some are removed, and rays along the line.
std::string long_life() {
  std::ostringstream text;
  World scene(text);
  std::vector<ObjectId> ids;
  const Layer walls = scene.layer("walls");
  for (int i = 0; i < 40; ++i) {
    ids.push_back(scene.add(Ball{{3.125 * i, 0.3}, 1.37}, {.name = "ball " + std::to_string(i), .layer = walls}));
  }
  const Ray<2, double> ray{{-10.1, 0.2}, {1, 0}};
  for (std::size_t round = 0; round < 10; ++round) {
    std::vector<ObjectMove<2, double>> moves;
    for (std::size_t i = 10; i < ids.size(); ++i) moves.push_back({ids[i], Ball{{3.0 * static_cast<double>(i), 0}, 1}});
    scene.move(moves);
    scene.update();
    scene.remove(ids.back());
    ids.pop_back();
    scene.overlapping(Ball{{9, 9}, 9});
    scene.ray_cast_all(ray);
  }
  return text.str();
}

TEST(Shrink, FindsTheFewCallsThatAFaultNeeds) {
  const Log log = log_of(long_life());
  ASSERT_EQ(replay(log, library_targets<2>(log.numbers)).differing, 0U);
  ASSERT_EQ(replay(log, forgetful_targets()).differing, 8U);  // from the third round on
  const auto small = shrunk(log, forgetful_targets());
  ASSERT_TRUE(small);
  // Three objects must go and one must stay: four calls of add, three of remove, and the ray.
  EXPECT_EQ(small->entries.size(), 8U) << text_of(*small);
  EXPECT_EQ(small->entries.back().call.kind, CallKind::ray_cast_all);
  const ReplayReport report = replay(*small, forgetful_targets());
  ASSERT_EQ(report.differing, 1U);
  EXPECT_EQ(report.first.front().entry, small->entries.size() - 1);
  EXPECT_TRUE(report.first.front().is_from_judge);
  EXPECT_FALSE(report.first.front().is_from_record);  // it is the subject's answer
}

TEST(Shrink, MakesNumbersRounderAndForgetsNames) {
  const auto small = shrunk(log_of(long_life()), forgetful_targets());
  ASSERT_TRUE(small);
  for (const LogEntry<2>& entry : small->entries) {
    EXPECT_EQ(entry.call.options.name, "");
    EXPECT_EQ(entry.call.options.layer, 0);
    for (const AnyShape<2, double>& shape : entry.call.shapes) {
      const auto* const sphere = std::get_if<Ball>(&shape);
      EXPECT_EQ(sphere == nullptr ? 1 : sphere->radius, 1) << text_of(*small);
    }
  }
}

TEST(Shrink, LeavesAloneWhatDoesNotFail) {
  const Log log = log_of(long_life());
  EXPECT_FALSE(shrunk(log, library_targets<2>(log.numbers)));
}

/// The log with a part of it replaced.
Log altered(std::string text, const std::string& old_piece, const std::string& new_piece) {
  const std::size_t place = text.find(old_piece);
  EXPECT_NE(place, std::string::npos) << text;
  return log_of(text.replace(place, old_piece.size(), new_piece));
}

/// The result of shrinking a log that contradicts the library's own scene.
std::string shrunk_text(const Log& log) {
  const ReplayTargets<2> targets = library_targets<2>(log.numbers);
  EXPECT_EQ(replay(log, targets).differing, 1U);
  const auto small = shrunk(log, targets);
  if (!small) return "it does not fail";
  const ReplayReport report = replay(*small, targets);
  if (report.differing != 1 || !report.first.front().is_from_record) return "it fails otherwise";
  return text_of(*small);
}

TEST(Shrink, KeepsOfALogThatSaysSomethingElseWhatTheAnswerIsAbout) {
  std::ostringstream text;
  World scene(text);
  const ObjectId a = scene.add(Ball{{0, 0}, 1});
  scene.add(Ball{{5, 0}, 1});
  const ObjectId c = scene.add(Ball{{9, 0}, 1});
  scene.move(c, Ball{{8, 0}, 1});
  scene.move(c, Ball{{1, 0}, 1});
  scene.update();
  scene.remove(a);
  scene.overlapping(Ball{{3, 0}, 1});  // touches both that are left
  EXPECT_EQ(shrunk_text(altered(text.str(), R"({"answer": [[1, 1], [2, 1]]})", R"({"answer": [[1, 1]]})")),
            R"({"schema": "graze.log/1", "dimension": 2, "numbers": "double"}
{"call": "add", "shape": {"type": "sphere", "center": [9, 0], "radius": 1}}
{"answer": [[0, 1]]}
{"call": "move", "id": [0, 1], "shape": {"type": "sphere", "center": [1, 0], "radius": 1}}
{"answer": []}
{"call": "overlapping", "shape": {"type": "sphere", "center": [3, 0], "radius": 1}}
{"answer": []}
)");
}

TEST(Shrink, KeepsTheUpdatesThatEventsAreBetween) {
  std::ostringstream text;
  World scene(text);
  scene.add(Ball{{7, 0}, 1});
  scene.add(Ball{{0, 0}, 1});
  const ObjectId b = scene.add(Ball{{1, 0}, 1});
  scene.update();
  scene.pairs();
  scene.move(b, Ball{{4, 0}, 1});
  scene.update();
  EXPECT_EQ(shrunk_text(altered(text.str(), R"({"answer": [["ended", [1, 1], [2, 1]]]})",
                                R"({"answer": [["stayed", [1, 1], [2, 1]]]})")),
            R"({"schema": "graze.log/1", "dimension": 2, "numbers": "double"}
{"call": "add", "shape": {"type": "sphere", "center": [0, 0], "radius": 1}}
{"answer": [[0, 1]]}
{"call": "add", "shape": {"type": "sphere", "center": [1, 0], "radius": 1}}
{"answer": [[1, 1]]}
{"call": "update"}
{"answer": [["began", [0, 1], [1, 1]]]}
{"call": "move", "id": [1, 1], "shape": {"type": "sphere", "center": [4, 0], "radius": 1}}
{"answer": []}
{"call": "update"}
{"answer": [["stayed", [0, 1], [1, 1]]]}
)");
}

TEST(Shrink, KeepsAllChangesBeforeOneThatWentOtherwise) {
  std::ostringstream text;
  World scene(text);
  const ObjectId a = scene.add(Ball{{0, 0}, 1});
  scene.overlapping(Ball{});
  scene.remove(a);
  scene.add(Ball{{1, 0}, 1});
  scene.overlapping(Ball{});
  EXPECT_EQ(shrunk_text(altered(text.str(), R"({"answer": [[0, 3]]}
{"call": "overlapping", "shape": {"type": "sphere", "center": [0, 0], "radius": 1}}
{"answer": [[0, 3]]})",
                                R"({"answer": [[7, 1]]})")),
            R"({"schema": "graze.log/1", "dimension": 2, "numbers": "double"}
{"call": "add", "shape": {"type": "sphere", "center": [0, 0], "radius": 1}}
{"answer": [[0, 1]]}
{"call": "remove", "id": [0, 1]}
{"answer": []}
{"call": "add", "shape": {"type": "sphere", "center": [1, 0], "radius": 1}}
{"answer": [[7, 1]]}
)");
}

TEST(Shrink, OfADigestKeepsEveryObject) {
  std::ostringstream text;
  World scene(text);
  for (int i = 0; i < 70; ++i) scene.add(Ball{{2 * i, 0}, 1});  // a chain
  scene.update();
  scene.pairs();
  scene.overlapping(Ball{{70, 0}, 100});
  const auto log = log_of(text.str());
  Log other = log;
  other.entries.back().answer->digest->digest ^= 1U;
  const auto small = shrunk(other, library_targets<2>(log.numbers));
  ASSERT_TRUE(small);
  EXPECT_EQ(small->entries.size(), 71U);
  EXPECT_EQ(small->entries.back().answer->digest, other.entries.back().answer->digest);
}

}  // namespace
}  // namespace graze::io::shrink_test
