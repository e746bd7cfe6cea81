// SPDX-License-Identifier: MIT
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/log/state.hpp>

namespace graze::io::log_state_test {
namespace {

using Entry = LogEntry<2>;
using Ball = Sphere<2, double>;

constexpr ObjectId a{0, 1, logged_scene};
constexpr ObjectId b{1, 1, logged_scene};

Entry add(const ObjectId& id, const Ball& sphere) {
  return {{.kind = CallKind::add, .shapes = {sphere}, .options = {.name = "n"}}, logged(id)};
}

TEST(LogState, IsWhatTheLastCallsMakeOfEachObject) {
  const std::vector<Entry> entries{add(a, Ball{{0, 0}, 1}),
                                   add(b, Ball{{1, 0}, 1}),
                                   {{.kind = CallKind::move, .ids = {a}, .shapes = {Ball{{2, 0}, 1}}}, LoggedAnswer{}},
                                   {{.kind = CallKind::remove, .ids = {b}}, LoggedAnswer{}}};
  const auto state = state_after<2>(entries);
  EXPECT_EQ(state, state_after<2>(std::vector<Entry>{add(a, Ball{{2, 0}, 1})}));
  EXPECT_NE(state, state_after<2>(std::vector<Entry>{add(a, Ball{{0, 0}, 1})}));
}

TEST(LogState, IsNotChangedByWhatWasRefused) {
  const std::vector<Entry> entries{
      add(a, Ball{}),
      {{.kind = CallKind::move, .ids = {a}, .shapes = {Ball{{2, 0}, 1}}}, LoggedAnswer{.refusal = "no"}}};
  EXPECT_EQ(state_after<2>(entries), state_after<2>(std::vector<Entry>{add(a, Ball{})}));
}

TEST(LogState, HasTheExceptedPairs) {
  const auto change = [](CallKind kind, const ObjectId& one, const ObjectId& other) {
    return Entry{{.kind = kind, .ids = {one, other}}, LoggedAnswer{}};
  };
  std::vector<Entry> entries{add(a, Ball{}), add(b, Ball{}), change(CallKind::except, b, a)};
  EXPECT_EQ(excepted_after<2>(entries), (std::set<ObjectPair>{{a, b}}));
  std::vector<Entry> accepted = entries;
  accepted.push_back(change(CallKind::accept, a, b));
  EXPECT_TRUE(excepted_after<2>(accepted).empty());
  accepted.back().answer->refusal = "no";
  EXPECT_EQ(excepted_after<2>(accepted), excepted_after<2>(entries));
  entries.push_back({{.kind = CallKind::remove, .ids = {b}}, LoggedAnswer{}});
  EXPECT_TRUE(excepted_after<2>(entries).empty());
}

TEST(LogState, OfAListLeavesOutOtherObjects) {
  const auto is_a = [](const ObjectId& id) { return id == a; };
  const auto left = without_others(CallKind::overlapping, logged(std::vector<ObjectId>{a, b}), is_a);
  ASSERT_TRUE(left);
  EXPECT_TRUE(say_the_same(*left, logged(a)));
  EXPECT_TRUE(without_others(CallKind::pairs, logged(std::vector<ObjectPair>{{a, b}}), is_a)->rows.empty());
}

TEST(LogState, DoesNotGuessWhoComesNext) {
  const auto is_a = [](const ObjectId& id) { return id == a; };
  EXPECT_TRUE(without_others(CallKind::find, logged(a), is_a));
  EXPECT_FALSE(without_others(CallKind::find, logged(b), is_a));
  EXPECT_FALSE(without_others(CallKind::nearest, logged(std::vector<NearObject<double>>{{a, 1}, {b, 2}}), is_a));
  EXPECT_FALSE(without_others(CallKind::nearest_to, logged(std::vector<NearObject<double>>{{a, 1}, {b, 2}}), is_a));
  EXPECT_FALSE(without_others(CallKind::shape_cast, logged(b), is_a));
  EXPECT_FALSE(without_others(CallKind::time_of_impact, logged(b), is_a));
  EXPECT_TRUE(without_others(CallKind::shape_cast_all, logged(b), is_a)->rows.empty());
  EXPECT_FALSE(without_others(CallKind::pairs, {.digest = AnswerDigest{70, 1}}, is_a));
}

}  // namespace
}  // namespace graze::io::log_state_test
