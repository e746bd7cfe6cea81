// SPDX-License-Identifier: MIT
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/log/query_log.hpp>
#include <graze/io/output_error.hpp>
#include <graze/io/recorded_scene.hpp>
#include <graze/io/replay.hpp>
#include <graze/math/pose.hpp>
#include <graze/shape/polytope.hpp>

namespace graze::io::recorded_scene_test {
namespace {

using Ball = Sphere<2, double>;
using World = RecordedScene<2, double>;

const std::string head = "{\"schema\": \"graze.log/1\", \"dimension\": 2, \"numbers\": \"double\"}\n";

std::size_t differences_in(const std::string& text) {
  const auto log = std::get<QueryLog<2>>(parse_query_log(text, "log"));
  return replay(log, library_targets<2>(log.numbers)).differing;
}

TEST(RecordedScene, WritesEachCallAndItsAnswer) {
  std::ostringstream log;
  World scene(log);
  const ObjectId sphere = scene.add(Ball{{0, 0}, 1}, {.name = "ball"});
  const ObjectId wall = scene.add(Aabb<2, double>{{1, -1}, {2, 1}});
  EXPECT_EQ(scene.update().began, (std::vector<ObjectPair>{{sphere, wall}}));
  EXPECT_EQ(scene.find("ball"), sphere);
  EXPECT_EQ(scene.ray_cast({{-2, 0}, {1, 0}})->hit.t, 1);
  scene.remove(sphere);
  EXPECT_EQ(log.str(),
            head + R"({"call": "add", "name": "ball", "shape": {"type": "sphere", "center": [0, 0], "radius": 1}}
{"answer": [[0, 1]]}
{"call": "add", "shape": {"type": "aabb", "min": [1, -1], "max": [2, 1]}}
{"answer": [[1, 1]]}
{"call": "update"}
{"answer": [["began", [0, 1], [1, 1]]]}
{"call": "find", "name": "ball"}
{"answer": [[0, 1]]}
{"call": "ray_cast", "shape": {"type": "ray", "origin": [-2, 0], "direction": [1, 0]}}
{"answer": [[[0, 1], 1, -1, 0, -1, 0]]}
{"call": "remove", "id": [0, 1]}
{"answer": []}
)");
  EXPECT_EQ(scene.scene().size(), 1U);
}

// The corners of a rotated crate are in another order than those of its hull would be; its contacts come in that order.
TEST(RecordedScene, OfHullsThatWereMovedCanBeReplayed) {
  std::vector<Vec<3, double>> corners;
  for (int i = 0; i < 8; ++i) corners.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  const auto crate = convex_hull<3, double>(corners);
  std::ostringstream text;
  RecordedScene<3, double> scene(text);
  const auto turned = [](double degrees) { return rotation_matrix(Vec<3, double>(0, 0, 1), degrees); };
  scene.add(transformed(crate, Pose<3, double>{turned(100), {0.5, -0.5, 0}}));
  scene.add(transformed(crate, Pose<3, double>{turned(200), {0.75, 0.5, 0.875}}));
  scene.update();
  ASSERT_EQ(scene.contacts().size(), 1U);
  const auto log = std::get<QueryLog<3>>(parse_query_log(text.str(), "log"));
  EXPECT_EQ(replay(log, library_targets<3>(log.numbers)).differing, 0U);
}

TEST(RecordedScene, MovesManyToShapesOfOneTypeAsByAList) {
  std::ostringstream log;
  World scene(log);
  const std::vector<ObjectId> spheres = {scene.add(Ball{{0, 0}, 1}), scene.add(Ball{{5, 0}, 1})};
  const std::size_t before = log.str().size();
  scene.move(spheres, std::vector<Ball>{{{1, 0}, 1}, {{2, 0}, 1}});
  EXPECT_EQ(
      log.str().substr(before),
      R"({"call": "move_many", "ids": [[0, 1], [1, 1]], "shapes": [{"type": "sphere", "center": [1, 0], "radius": 1}, )"
      R"({"type": "sphere", "center": [2, 0], "radius": 1}]})"
      "\n{\"answer\": []}\n");
  EXPECT_THROW(scene.move(spheres, std::vector<Ball>{{{1, 0}, 1}}), std::invalid_argument);
  EXPECT_EQ(scene.update().began.size(), 1U);
  EXPECT_EQ(differences_in(log.str()), 0U);
}

TEST(RecordedScene, WritesWhyACallWasRefused) {
  std::ostringstream log;
  World scene(log);
  Scene<2, double> other;
  EXPECT_THROW(scene.remove(ObjectId{}), std::out_of_range);
  EXPECT_THROW(scene.remove(other.add(Ball{})), std::out_of_range);
  EXPECT_THROW(scene.add(Ball{{0, 0}, -1}), std::invalid_argument);
  EXPECT_THROW(scene.ray_cast({{0, 0}, {1, 0}}, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(scene.ray_cast({{0, 0}, {1, 0}}, -1), std::invalid_argument);
  EXPECT_THROW(scene.candidates(std::numeric_limits<double>::infinity()), std::invalid_argument);
  EXPECT_EQ(log.str(), head + R"({"call": "remove", "id": null}
{"refused": "Scene: the id (index 0, generation 0) is default-constructed; only add returns ids"}
{"call": "remove", "id": {"other_scene": [0, 1]}}
{"refused": "Scene: the id (index 0, generation 1) belongs to another scene"}
{"call": "add", "fault": "a sphere has a negative radius"}
{"refused": "Scene: the object, a sphere, has a negative radius"}
{"call": "ray_cast", "fault": "a t_max that is nan"}
{"refused": "Scene: t_max is negative or not a number"}
{"call": "ray_cast", "shape": {"type": "ray", "origin": [0, 0], "direction": [1, 0]}, "t_max": -1}
{"refused": "Scene: t_max is negative or not a number"}
{"call": "candidates", "fault": "a margin that is inf"}
{"refused": "Scene: the margin of candidates is negative or not finite"}
)");
  EXPECT_EQ(differences_in(log.str()), 0U);
}

TEST(RecordedScene, WritesQueriesWithShapesAndWhatTheyLeaveOut) {
  std::ostringstream log;
  World scene(log);
  const ObjectId near = scene.add(Ball{{4, 0}, 1});
  const ObjectId far = scene.add(Ball{{9, 0}, 1}, {.layer = 1});
  const std::size_t before = log.str().size();
  EXPECT_EQ(scene.shape_cast(Ball{{0, 0}, 1}, {4, 0})->impact.t, 0.5);
  EXPECT_EQ(scene.nearest(Ball{{0, 0}, 1}, 1, {.predicate = [&](ObjectId id) { return id == far; }}).at(0).distance, 7);
  EXPECT_EQ(scene.contacts_with(Ball{{2.5, 0}, 1}, {.layers = only_layer(0)}).size(), 1U);
  EXPECT_EQ(scene.closest_pairs(3).size(), 1U);
  EXPECT_EQ(log.str().substr(before),
            R"({"call": "shape_cast", "shape": {"type": "sphere", "center": [0, 0], "radius": 1}, "motion": [4, 0]}
{"answer": [[[0, 1], 0.5, 3, 0, 1, 0]]}
{"call": "nearest_to", "shape": {"type": "sphere", "center": [0, 0], "radius": 1}, "count": 1, "except": [[0, 1]]}
{"answer": [[[1, 1], 7]]}
{"call": "contacts_with", "shape": {"type": "sphere", "center": [2.5, 0], "radius": 1}, "layers": 1}
{"answer": [[[0, 1], 1, 0, 3.5, 0, 3, 0, 0.5]]}
{"call": "closest_pairs", "within": 3}
{"answer": [[[0, 1], [1, 1], 3]]}
)");
  EXPECT_EQ(scene.shape_cast_all(Ball{{0, 0}, 1}, {9, 0}, {.except = {&near, 1}}).size(), 1U);
  EXPECT_EQ(scene.time_of_impact(Ball{{0, 0}, 1}, {{4, 0}, 3, {0, 1}})->id, near);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(scene.shape_cast(Ball{{0, 0}, 1}, {nan, 0}), std::invalid_argument);
  EXPECT_THROW(scene.closest_pairs(nan), std::invalid_argument);
  EXPECT_THROW(scene.contacts_with(Ball{{0, 0}, -1}), std::invalid_argument);
  const auto asks_again = [&](ObjectId id) { return !scene.contacts_with(scene.object(id).shape).empty(); };
  EXPECT_EQ(scene.nearest(Ball{{0, 0}, 1}, 9, {.predicate = asks_again}).size(), 2U);
  EXPECT_EQ(differences_in(log.str()), 0U);
}

TEST(RecordedScene, WritesExceptedPairs) {
  Scene<2, double> past;
  const ObjectId a = past.add(Ball{{0, 0}, 1});
  const ObjectId b = past.add(Ball{{1, 0}, 1});
  const ObjectId c = past.add(Ball{{0, 1}, 1});
  past.except(a, b);
  past.update();
  std::ostringstream log;
  World scene(log, past);
  EXPECT_NE(log.str().find(R"({"call": "except", "ids": [[0, 1], [1, 1]]})"), std::string::npos);
  const std::size_t before = log.str().size();
  scene.except(c, a);
  scene.accept(a, b);
  EXPECT_TRUE(scene.excepted(a, c));
  EXPECT_THROW(scene.except(a, a), std::invalid_argument);
  EXPECT_EQ(scene.excepted_pairs(), (std::vector<ObjectPair>{{a, c}}));
  const std::string added = log.str().substr(before);
  EXPECT_EQ(added.substr(0, added.find("refused")), R"({"call": "except", "ids": [[2, 1], [0, 1]]}
{"answer": []}
{"call": "accept", "ids": [[0, 1], [1, 1]]}
{"answer": []}
{"call": "except", "ids": [[0, 1], [0, 1]]}
{")");
  EXPECT_EQ(scene.update().began, (std::vector<ObjectPair>{{a, b}}));
  EXPECT_EQ(differences_in(log.str()), 0U);
}

TEST(RecordedScene, DoesNothingThatItCannotWrite) {
  std::ostringstream log;
  World scene(log);
  EXPECT_THROW(scene.add(Ball{}, {.name = "\xff"}), OutputError);
  EXPECT_EQ(scene.size(), 0U);
  EXPECT_EQ(log.str(), head);
}

TEST(RecordedScene, BeginsWithWhatTheSceneHolds) {
  Scene<2, double> before;
  before.layer("walls");
  const ObjectId gone = before.add(Ball{});
  const ObjectId a = before.add(Ball{{0, 0}, 1}, {.name = "a"});
  before.add(Ball{{1, 0}, 1}, {.mobility = Mobility::fixed});
  before.remove(gone);
  before.update();
  std::ostringstream log;
  World scene(log, before);
  EXPECT_EQ(scene.add(Ball{{9, 9}, 1}).index, 0U);  // where one was removed
  scene.move(a, Ball{{5, 5}, 1});
  EXPECT_EQ(scene.update().ended.size(), 1U);
  EXPECT_EQ(log.str().substr(0, log.str().find("\n{\"answer\": []}")),
            head + R"({"call": "plan_ids", "ids": [[1, 1], [2, 1]], "vacant_ids": [[0, 2]]})");
  EXPECT_EQ(differences_in(log.str()), 0U);
}

TEST(RecordedScene, RefusesASceneWhoseNextEventsALogCouldNotTell) {
  Scene<2, double> before;
  const ObjectId a = before.add(Ball{});
  before.add(Ball{});
  before.update();
  before.move(a, Ball{{9, 9}, 1});
  std::ostringstream log;
  EXPECT_THROW(World(log, before), std::logic_error);
  EXPECT_EQ(log.str(), "");
  EXPECT_EQ(before.update().ended.size(), 1U);
}

TEST(RecordedScene, OfAnotherSceneRecordsUntilItIsGone) {
  Scene<2, double> scene;
  const ObjectId id = scene.add(Ball{{0, 0}, 1});
  std::ostringstream log;
  {
    World recorded(log, scene);
    recorded.move(id, Ball{{1, 0}, 1});
    EXPECT_EQ(&recorded.scene(), &scene);
  }
  const std::string text = log.str();
  EXPECT_EQ(scene.update().began.size(), 0U);
  EXPECT_EQ(std::get<Ball>(scene.object(id).shape).center, (Vec<2, double>(1, 0)));
  EXPECT_EQ(log.str(), text);
  EXPECT_EQ(differences_in(text), 0U);
}

TEST(RecordedScene, WritesWhatEveryQueryLeavesOut) {
  std::ostringstream log;
  World scene(log);
  const ObjectId left = scene.add(Ball{{4, 0}, 1});
  const ObjectId right = scene.add(Ball{{9, 0}, 1});
  const AnyShape<2, double> all = Aabb<2, double>{{-20, -20}, {20, 20}};
  const Ray<2, double> ray{{0, 0}, {1, 0}};
  constexpr double inf = std::numeric_limits<double>::infinity();
  const SceneQuery query{.except = {&left, 1}, .predicate = [&](ObjectId id) { return id == right; }};
  const std::size_t before = log.str().size();
  EXPECT_EQ(scene.overlapping(all, query), std::vector{right});
  EXPECT_EQ(scene.cull(all, query), std::vector{right});
  EXPECT_EQ(scene.nearest({0, 0}, 2, query).size(), 1U);
  EXPECT_EQ(scene.ray_cast(ray, inf, query)->id, right);
  EXPECT_EQ(scene.ray_cast_all(ray, inf, query).size(), 1U);
  const std::string text = log.str().substr(before);
  std::size_t lists = 0;
  for (std::size_t at = 0; (at = text.find(R"("except": [[0, 1]]})", at)) != std::string::npos; ++at) ++lists;
  EXPECT_EQ(lists, 5U);
  EXPECT_EQ(differences_in(log.str()), 0U);
}

TEST(RecordedScene, WritesWhatManyThreadsAskOneAfterTheOther) {
  std::ostringstream log;
  World scene(log);
  for (int i = 0; i < 20; ++i) scene.add(Ball{{static_cast<double>(i), 0}, 1});
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 3; ++thread) {
    threads.emplace_back([&scene] {
      for (int i = 0; i < 10; ++i) EXPECT_EQ(scene.overlapping(Ball{{3.5, 0}, 1}).size(), 4U);
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(std::get<QueryLog<2>>(parse_query_log(log.str(), "log")).entries.size(), 50U);
  EXPECT_EQ(differences_in(log.str()), 0U);
}

}  // namespace
}  // namespace graze::io::recorded_scene_test
