// SPDX-License-Identifier: MIT
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/input_error.hpp>
#include <graze/io/log/scene_after.hpp>
#include <graze/io/recorded_scene.hpp>

namespace graze::io::scene_after_test {
namespace {

QueryLog<2> log_of(const std::string& text) { return std::get<QueryLog<2>>(parse_query_log(text, "log")); }

const std::string head = "{\"schema\": \"graze.log/1\", \"dimension\": 2, \"numbers\": \"double\"}\n";
const std::string sphere =
    R"({"call": "add", "name": "ball", "shape": {"type": "sphere", "center": [0, 0], "radius": 1}})"
    "\n{\"answer\": [[0, 1]]}\n";

/// A program's own scene, recorded, with objects that are added, moved and removed.
TEST(SceneAfter, IsTheSceneThatWasRecorded) {
  std::ostringstream text;
  RecordedScene<2, float> recorded(text);
  const Layer walls = recorded.layer("walls");
  const Layer things = recorded.layer("things");
  const ObjectId gone = recorded.add(Sphere<2>{{9, 9}, 1}, {.name = "gone"});
  const ObjectId wall = recorded.add(Aabb<2>{{0, 0}, {0.1F, 4}}, {.name = "wall", .layer = walls});
  recorded.remove(gone);
  const ObjectId ball_id = recorded.add(Sphere<2>{{3, 1}, 0.5F}, {.name = "ball", .layer = things, .user = 7});
  recorded.move(ball_id, Sphere<2>{{2, 1}, 0.3F});
  recorded.except(ball_id, wall);
  EXPECT_THROW(recorded.move(gone, Sphere<2>{}), std::out_of_range);
  EXPECT_THROW(recorded.add(Sphere<2>{{0, 0}, -1}), std::invalid_argument);

  const Scene<2, double> scene = scene_after(log_of(text.str()), "log");
  ASSERT_EQ(scene.size(), 2U);
  EXPECT_EQ(scene.layer_names(), (std::vector<std::string>{"walls", "things"}));
  const ObjectId found = *scene.find("ball");
  EXPECT_EQ(found.index, ball_id.index);
  EXPECT_EQ(found.generation, ball_id.generation);
  const Object<2, double>& object = scene.object(found);
  EXPECT_EQ(object.layer, things);
  EXPECT_EQ(object.user, 7U);
  const auto& moved = std::get<Sphere<2, double>>(object.shape);
  EXPECT_EQ(moved.center, (Vec<2, double>(2, 1)));
  EXPECT_EQ(moved.radius, static_cast<double>(0.3F));
  EXPECT_EQ(scene.find("wall")->index, wall.index);
  EXPECT_FALSE(scene.find("gone"));
  EXPECT_TRUE(scene.excepted(found, *scene.find("wall")));
}

TEST(SceneAfter, KnowsPlannedIds) {
  const auto scene = scene_after(
      log_of(head + R"({"call": "plan_ids", "ids": [[1, 3], [0, 1]], "vacant_ids": []})" + "\n{\"answer\": []}\n" +
             R"({"call": "add", "name": "a", "shape": {"type": "point", "position": [0, 0]}})" +
             "\n{\"answer\": [[1, 3]]}\n"),
      "log");
  EXPECT_EQ(scene.find("a")->index, 1U);
  EXPECT_EQ(scene.find("a")->generation, 3U);
}

TEST(SceneAfter, ACallThatTheProgramDidNotSurviveChangesNothing) {
  const auto scene = scene_after(log_of(head + sphere + "{\"call\": \"remove\", \"id\": [0, 1]}\n"), "log");
  EXPECT_EQ(scene.size(), 1U);
  EXPECT_EQ(scene_after(log_of(head), "log").size(), 0U);
}

TEST(SceneAfter, ALogThatIsWrongIsRefusedWithItsLine) {
  try {
    scene_after(log_of(head + sphere + sphere), "yard.log");
    ADD_FAILURE() << "a name was taken twice";
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("yard.log: line 4: the log says that its scene accepted this \"add\""), std::string::npos)
        << what;
    EXPECT_NE(what.find("ball"), std::string::npos) << what;
  }
}

}  // namespace
}  // namespace graze::io::scene_after_test
