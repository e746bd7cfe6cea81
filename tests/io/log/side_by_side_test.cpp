// SPDX-License-Identifier: MIT
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/log/side_by_side.hpp>

namespace graze::io::side_by_side_test {
namespace {

using Entry = LogEntry<2>;
using Ball = Sphere<2, double>;

constexpr ObjectId a{0, 1, logged_scene};
constexpr ObjectId b{1, 1, logged_scene};

Entry add(const ObjectId& id) { return {{.kind = CallKind::add, .shapes = {Ball{}}}, logged(id)}; }

TEST(SideBySide, FindsObjectsUnderTheIdsThatTheyHaveHere) {
  const std::set<ObjectId> names{a, b};
  SideBySide<2> run(library_targets<2>(NumberType::double_precision), names);
  EXPECT_FALSE(run.perform({{.kind = CallKind::remove, .ids = {b}}, LoggedAnswer{}}));  // it does not exist here yet
  ASSERT_TRUE(run.perform(add(b)));
  EXPECT_TRUE(run.was_added(b));
  EXPECT_FALSE(run.was_added(a));
  const auto step = run.perform({{.kind = CallKind::overlapping, .shapes = {Ball{}}}, logged(b)});
  ASSERT_TRUE(step);
  EXPECT_TRUE(say_the_same(step->given, logged(a)));  // which has the first id here
  EXPECT_TRUE(say_the_same(step->expected, step->given));
  EXPECT_TRUE(say_the_same(run.translated(logged(std::vector<ObjectId>{a, b})), logged(a)));
}

TEST(SideBySide, LeavesObjectsOutOfMovesOfMany) {
  const std::set<ObjectId> names{a, b};
  SideBySide<2> run(library_targets<2>(NumberType::double_precision), names);
  run.perform(add(b));
  const auto step = run.perform(
      {{.kind = CallKind::move_many, .ids = {a, b}, .shapes = {Ball{{1, 0}, 1}, Ball{{2, 0}, 1}}}, LoggedAnswer{}});
  ASSERT_TRUE(step);
  EXPECT_EQ(step->call.ids, (std::vector<ObjectId>{a}));
  ASSERT_EQ(step->call.shapes.size(), 1U);
  EXPECT_EQ(std::get<Ball>(step->call.shapes.front()).center.x, 2);
}

TEST(SideBySide, LeavesOutExceptionsOfObjectsThatAreNotHere) {
  const std::set<ObjectId> names{a, b};
  SideBySide<2> run(library_targets<2>(NumberType::double_precision), names);
  const Entry except{{.kind = CallKind::except, .ids = {a, b}}, LoggedAnswer{}};
  const Entry nearest{{.kind = CallKind::nearest_to, .shapes = {Ball{}}, .except = {a, b}, .count = 9}, LoggedAnswer{}};
  run.perform(add(b));
  EXPECT_FALSE(run.perform(except));
  EXPECT_EQ(run.perform(nearest)->call.except, (std::vector<ObjectId>{a}));  // b, which has the first id here
  run.perform(add(a));
  EXPECT_EQ(run.perform({{.kind = CallKind::pairs}, LoggedAnswer{}})->given.rows.size(), 1U);
  ASSERT_TRUE(run.perform(except));
  EXPECT_TRUE(run.perform({{.kind = CallKind::pairs}, LoggedAnswer{}})->given.rows.empty());
  EXPECT_TRUE(run.perform(nearest)->given.rows.empty());
}

TEST(SideBySide, TakesIdsThatAreNoNamesAsTheyAre) {
  const std::set<ObjectId> names;
  SideBySide<2> run(library_targets<2>(NumberType::double_precision), names);
  const auto step = run.perform({{.kind = CallKind::remove, .ids = {b}}, LoggedAnswer{}});
  ASSERT_TRUE(step);
  EXPECT_TRUE(step->given.refusal);
}

TEST(SideBySide, RefusesFaultsWithoutPerformingThem) {
  const std::set<ObjectId> names;
  SideBySide<2> run(library_targets<2>(NumberType::double_precision), names);
  const auto step = run.perform({{.kind = CallKind::add, .fault = "a sphere"}, LoggedAnswer{}});
  ASSERT_TRUE(step);
  EXPECT_TRUE(step->given.refusal);
  EXPECT_TRUE(step->expected.refusal);
}

TEST(SideBySide, KnowsTheIdsThatALogGaveOut) {
  const std::vector<Entry> entries{add(a), add(b), {{.kind = CallKind::add}, LoggedAnswer{.refusal = "no"}}};
  EXPECT_EQ(added_ids(entries), (std::set<ObjectId>{a, b}));
}

}  // namespace
}  // namespace graze::io::side_by_side_test
