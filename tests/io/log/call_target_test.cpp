// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/log/call_target.hpp>

namespace graze::io::call_target_test {
namespace {

using Call = LoggedCall<2>;
using Ball = Sphere<2, double>;

constexpr ObjectId first{0, 1, logged_scene};
constexpr ObjectId second{1, 1, logged_scene};

/// A target's answers about a small sphere and a large one, in the form of a log.
std::vector<std::string> answers_of(const TargetMaker<2>& maker, double radius) {
  const auto target = maker();
  const AnyShape<2, double> sphere = Ball{{1, 0}, 1};
  const AnyShape<2, double> ray = Ray<2, double>{{-4, 0}, {1, 0}};
  const AnyShape<2, double> mover = Vec<2, double>(-4, 0);
  const std::vector<Call> calls{
      {.kind = CallKind::layer, .name = "walls"},
      {.kind = CallKind::add, .shapes = {Ball{}}, .options = {.name = "a"}},
      {.kind = CallKind::add, .shapes = {Ball{}}, .options = {.name = "a"}},
      {.kind = CallKind::add, .shapes = {sphere}},
      {.kind = CallKind::move, .ids = {first}, .shapes = {Ball{{0, 0}, radius}}},
      {.kind = CallKind::update},
      {.kind = CallKind::find, .name = "a"},
      {.kind = CallKind::candidates, .margin = 1},
      {.kind = CallKind::pairs},
      {.kind = CallKind::overlapping, .shapes = {sphere}},
      {.kind = CallKind::cull, .shapes = {sphere}},
      {.kind = CallKind::cull_frustum, .corners = {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}},
      {.kind = CallKind::nearest, .shapes = {Vec<2, double>(3, 0)}, .count = 1},
      {.kind = CallKind::ray_cast, .shapes = {ray}},
      {.kind = CallKind::ray_cast_all, .shapes = {ray}, .t_max = 4},
      {.kind = CallKind::shape_cast, .shapes = {mover}, .motion = {{8, 0}}},
      {.kind = CallKind::shape_cast_all, .shapes = {mover}, .except = {first}, .motion = {{8, 0}}},
      {.kind = CallKind::time_of_impact, .shapes = {mover}, .except = {first}, .motion = {{8, 0}, 0, {0, 1}}},
      {.kind = CallKind::contacts_with, .shapes = {Vec<2, double>(0, 0)}, .except = {first}},
      {.kind = CallKind::nearest_to, .shapes = {mover}, .except = {second}, .count = 2},
      {.kind = CallKind::closest_pairs, .within = 1},
      {.kind = CallKind::except, .ids = {second, first}},
      {.kind = CallKind::pairs},
      {.kind = CallKind::accept, .ids = {first, second}},
      {.kind = CallKind::except, .ids = {first, first}},
      {.kind = CallKind::move_many, .ids = {first}, .shapes = {Ball{{9, 0}, 1}}},
      {.kind = CallKind::contacts},
      {.kind = CallKind::remove, .ids = {first}},
      {.kind = CallKind::remove, .ids = {first}},
      {.kind = CallKind::remove, .ids = {{1, 1, other_scene}}},
  };
  std::vector<std::string> answers;
  for (const Call& call : calls) {
    const LoggedAnswer answer = target->perform(call);
    answers.push_back(answer.refusal ? "refused" : answer_line(answer));
  }
  return answers;
}

const std::vector<std::string> expected = {
    R"({"answer": [0]})",
    R"({"answer": [[0, 1]]})",
    "refused",
    R"({"answer": [[1, 1]]})",
    R"({"answer": []})",
    R"({"answer": [["began", [0, 1], [1, 1]]]})",
    R"({"answer": [[0, 1]]})",
    R"({"answer": [[[0, 1], [1, 1]]]})",
    R"({"answer": [[[0, 1], [1, 1]]]})",
    R"({"answer": [[0, 1], [1, 1]]})",
    R"({"answer": [[0, 1], [1, 1]]})",
    R"({"answer": [[0, 1], [1, 1]]})",
    R"({"answer": [[[1, 1], 1]]})",
    R"({"answer": [[[0, 1], 3.75, -0.25, 0, -1, 0]]})",
    R"({"answer": [[[0, 1], 3.75, -0.25, 0, -1, 0], [[1, 1], 4, 0, 0, -1, 0]]})",
    R"({"answer": [[[0, 1], 0.46875, -0.25, 0, 1, 0]]})",
    R"({"answer": [[[1, 1], 0.5, 0, 0, 1, 0]]})",
    R"({"answer": [[[1, 1], 0.5, 0, 0, 1, 0]]})",
    R"({"answer": [[[1, 1], 1, 0, 0, 0, 0, 0, 0]]})",
    R"({"answer": [[[0, 1], 3.75]]})",
    R"({"answer": [[[0, 1], [1, 1], 0]]})",
    R"({"answer": []})",
    R"({"answer": []})",
    R"({"answer": []})",
    "refused",
    R"({"answer": []})",
    R"({"answer": []})",
    R"({"answer": []})",
    "refused",
    "refused",
};

TEST(CallTarget, PerformsEveryKindOfCallOnAScene) {
  EXPECT_EQ(answers_of(scene_targets<2>(NumberType::double_precision), 0.25), expected);
}

TEST(CallTarget, PerformsEveryKindOfCallOnAPlainScene) {
  EXPECT_EQ(answers_of(plain_scene_targets<2>(NumberType::double_precision), 0.25), expected);
}

TEST(CallTarget, KeepsNumbersInFloatWhereTheLogSaysSo) {
  const auto answers = answers_of(scene_targets<2>(NumberType::single_precision), 0.1);
  EXPECT_EQ(answers, answers_of(plain_scene_targets<2>(NumberType::single_precision), 0.1));
  EXPECT_NE(answers, answers_of(scene_targets<2>(NumberType::double_precision), 0.1));  // a different number
}

}  // namespace
}  // namespace graze::io::call_target_test
