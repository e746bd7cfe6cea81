// SPDX-License-Identifier: MIT
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/ray_cast.hpp>
#include <graze/scene/plain_scene.hpp>

namespace graze::plain_scene_test {
namespace {

using World = PlainScene<2, double>;
using Ball = Sphere<2, double>;
using V2 = Vec<2, double>;
using Ids = std::vector<ObjectId>;
using Pairs = std::vector<ObjectPair>;

TEST(PlainScene, GivesIdsAsAScenesDo) {
  World scene;
  const ObjectId a = scene.add(Ball{}, {.name = "a"});
  const ObjectId b = scene.add(Ball{});
  EXPECT_EQ(scene.find("a"), a);
  scene.remove(a);
  EXPECT_EQ(scene.find("a"), std::nullopt);
  const ObjectId c = scene.add(Ball{}, {.name = "a"});
  EXPECT_EQ(c, (ObjectId{0, 3, b.owner}));
  World other;
  other.plan_ids(Ids{{1, 5, 0}}, Ids{{0, 2, 0}});
  EXPECT_EQ(other.add(Ball{}).generation, 5U);
  EXPECT_EQ(other.add(Ball{}).generation, 3U);
}

TEST(PlainScene, TellsWhatTouchesAndWhatBeganAndEnded) {
  World scene;
  const ObjectId a = scene.add(Ball{{0, 0}, 1});
  const ObjectId b = scene.add(Ball{{1.5, 1.5}, 1});  // only the boxes overlap
  const ObjectId c = scene.add(Ball{{2, 0}, 1}, {.mobility = Mobility::fixed});
  scene.add(Ball{{2, 0}, 1}, {.mask = 0});
  EXPECT_EQ(scene.candidates(), (Pairs{{a, b}, {a, c}, {b, c}}));
  EXPECT_EQ(scene.candidates(7).size(), 3U);
  EXPECT_EQ(scene.pairs(), (Pairs{{a, c}, {b, c}}));
  EXPECT_EQ(scene.update().began, (Pairs{{a, c}, {b, c}}));
  const std::vector<ObjectMove<2, double>> moves{{b, Ball{{9, 9}, 1}}, {b, Ball{{-2, 0}, 1}}};
  scene.move(moves);
  const SceneEvents events = scene.update();
  EXPECT_EQ(events.began, (Pairs{{a, b}}));
  EXPECT_EQ(events.stayed, (Pairs{{a, c}}));
  EXPECT_EQ(events.ended, (Pairs{{b, c}}));
  const auto contacts = scene.contacts();
  ASSERT_EQ(contacts.size(), 2U);
  EXPECT_EQ(contacts[1].pair, (ObjectPair{a, c}));
  EXPECT_EQ(contacts[1].manifold.normal, V2(1, 0));
}

TEST(PlainScene, AsksEveryObject) {
  World scene;
  const ObjectId far = scene.add(Ball{{8, 0}, 1});
  const ObjectId near = scene.add(Ball{{4, 0}, 1}, {.layer = scene.layer("walls")});
  const ObjectId wall = scene.add(Plane<2, double>{{1, 0}, -3}, {.layer = scene.layer("ghosts")});
  EXPECT_EQ(scene.overlapping(V2(4, 1)), (Ids{near}));
  EXPECT_EQ(scene.overlapping(Ball{{6, 0}, 1}), (Ids{far, near}));
  EXPECT_EQ(scene.cull(Ball{{6, 1.5}, 1.25}), (Ids{far, near}));  // in the corners of their boxes
  EXPECT_EQ(scene.overlapping(Ball{{6, 1.5}, 1.25}), (Ids{}));
  EXPECT_EQ(scene.cull(Frustum<2, double>{}), (Ids{}));
  const auto nearest = scene.nearest({0, 0}, 2);
  ASSERT_EQ(nearest.size(), 2U);
  EXPECT_EQ(nearest[0], (NearObject<double>{near, 3}));
  EXPECT_EQ(nearest[1], (NearObject<double>{wall, 3}));
  const Ray<2, double> ray{{0, 0}, {2, 0}};
  ASSERT_EQ(scene.ray_cast_all(ray).size(), 2U);
  EXPECT_EQ(scene.ray_cast(ray)->id, near);
  EXPECT_EQ(scene.ray_cast(ray)->hit.t, 1.5);
  EXPECT_EQ(scene.ray_cast(ray, 9, only_layer(1)), std::nullopt);
  EXPECT_EQ(scene.ray_cast(ray, 1), std::nullopt);
}

TEST(PlainScene, MovesAShapePastEveryObject) {
  World scene;
  const ObjectId far = scene.add(Ball{{8, 0}, 1});
  const ObjectId near = scene.add(Ball{{4, 0}, 1}, {.layer = 1});
  scene.add(Ball{{4, 9}, 1});
  const Ball bullet{{0, 0}, 1};
  const auto impacts = scene.shape_cast_all(bullet, {8, 0});
  ASSERT_EQ(impacts.size(), 2U);
  EXPECT_EQ(impacts[0].id, near);
  EXPECT_EQ(impacts[0].impact.t, 0.25);
  EXPECT_EQ(impacts[1].id, far);
  EXPECT_EQ(scene.shape_cast(bullet, {8, 0}), impacts[0]);
  EXPECT_EQ(scene.shape_cast(bullet, {8, 0}, {.layers = only_layer(0)}), impacts[1]);
  EXPECT_EQ(scene.shape_cast(bullet, {8, 0}, {.except = {&near, 1}}), impacts[1]);
  EXPECT_EQ(scene.shape_cast(bullet, {8, 0}, {.predicate = [far](ObjectId id) { return id == far; }}), impacts[1]);
  EXPECT_EQ(scene.shape_cast(bullet, {1, 0}), std::nullopt);
  const auto spinning = scene.time_of_impact(Capsule<2, double>{{0, 0}, {0, 4}, 1}, {{0, 0}, -2, {0, 0}});
  ASSERT_TRUE(spinning);
  EXPECT_EQ(spinning->id, near);
}

TEST(PlainScene, RefusesNonsense) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  World scene;
  const ObjectId a = scene.add(Ball{}, {.name = "a"});
  EXPECT_THROW(scene.add(Ball{{0, 0}, -1}), std::invalid_argument);
  EXPECT_THROW(scene.add(Ball{}, {.name = "a"}), std::invalid_argument);
  EXPECT_THROW(scene.add(Ball{}, {.layer = 64}), std::invalid_argument);
  EXPECT_THROW(scene.move(ObjectId{}, Ball{}), std::out_of_range);
  EXPECT_THROW(scene.move(a, Ball{{nan, 0}, 1}), std::invalid_argument);
  EXPECT_THROW(scene.plan_ids({}, {}), std::logic_error);
  EXPECT_THROW(scene.candidates(-1), std::invalid_argument);
  EXPECT_THROW(scene.overlapping(V2(nan, 0)), std::invalid_argument);
  EXPECT_THROW(scene.nearest(V2(nan, 0), 1), std::invalid_argument);
  EXPECT_THROW(scene.ray_cast({{0, 0}, {0, 0}}), std::invalid_argument);
  EXPECT_THROW(scene.ray_cast({{0, 0}, {1, 0}}, nan), std::invalid_argument);
  scene.remove(a);
  EXPECT_THROW(scene.remove(a), std::out_of_range);
}

}  // namespace
}  // namespace graze::plain_scene_test
