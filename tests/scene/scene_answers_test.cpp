// SPDX-License-Identifier: MIT
// How long answers of a scene are valid: they are values, so a loop may change the scene while iterating over them;
// references are valid until the changes that scene.hpp names.
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/scene/scene.hpp>

namespace graze::scene_answers_test {
namespace {

using World = Scene<2, double>;
using View = SceneView<2, double>;
using Ball = Sphere<2, double>;
using V2 = Vec<2, double>;
using Ids = std::vector<ObjectId>;
using Pairs = std::vector<ObjectPair>;

/// Balls in a row, each touching the next.
Ids fill(World& scene, int count = 200) {
  Ids ids;
  for (int k = 0; k < count; ++k) ids.push_back(scene.add(Ball{{2.0 * k, 0}, 1}, {.name = std::to_string(k)}));
  return ids;
}

/// The ids in answers of each kind.
ObjectId id_in(const ObjectId& id) { return id; }
ObjectId id_in(const ObjectPair& pair) { return pair.a; }
ObjectId id_in(const NearObject<double>& near) { return near.id; }
ObjectId id_in(const NearPair<double>& near) { return near.pair.a; }
ObjectId id_in(const ObjectHit<2, double>& hit) { return hit.id; }
ObjectId id_in(const ObjectImpact<2, double>& impact) { return impact.id; }
ObjectId id_in(const ObjectTouch<2, double>& touch) { return touch.id; }
ObjectId id_in(const ObjectContact<2, double>& contact) { return contact.pair.a; }

/// Moves and removes the objects in an answer and adds others while iterating over it; the answer must not change.
void expect_to_stay_while_the_scene_changes(const auto& question) {
  World scene;
  fill(scene);
  const auto expected = question(scene);
  ASSERT_GE(expected.size(), 5U);
  std::size_t next = 0;
  for (const auto& each : question(scene)) {
    ASSERT_LT(next, expected.size());
    ASSERT_EQ(each, expected[next++]);
    const ObjectId id = id_in(each);
    ASSERT_TRUE(scene.contains(id));
    if (next % 3 == 0) scene.remove(id);
    const double far = 900 + static_cast<double>(20 * next);
    if (next % 3 == 1) scene.move(id, Ball{{0, far}, 1});
    for (int k = 1; k <= 5; ++k) scene.add(Ball{{0, far + 3 * k}, 1});
    if (next % 4 == 0) scene.update();
  }
  EXPECT_EQ(next, expected.size());
  EXPECT_EQ(scene.size(), 200 + 5 * next - next / 3);
}

TEST(SceneAnswers, StayWhileTheLoopThroughThemMovesAddsAndRemoves) {
  expect_to_stay_while_the_scene_changes([](const World& scene) { return scene.ids(); });
  expect_to_stay_while_the_scene_changes([](const World& scene) { return scene.pairs(); });
  expect_to_stay_while_the_scene_changes([](const World& scene) { return scene.candidates(); });
  expect_to_stay_while_the_scene_changes([](const World& scene) { return scene.contacts(); });
  expect_to_stay_while_the_scene_changes([](const World& scene) { return scene.contacts_with(Ball{{50, 0}, 25}); });
  expect_to_stay_while_the_scene_changes([](const World& scene) { return scene.overlapping(Ball{{50, 0}, 25}); });
  expect_to_stay_while_the_scene_changes([](const World& scene) { return scene.cull(Ball{{50, 0}, 25}); });
  expect_to_stay_while_the_scene_changes([](const World& scene) { return scene.nearest({50, 0}, 20); });
  expect_to_stay_while_the_scene_changes([](const World& scene) { return scene.nearest(Ball{{50, 0}, 1}, 20); });
  expect_to_stay_while_the_scene_changes([](const World& scene) { return scene.closest_pairs(1); });
  expect_to_stay_while_the_scene_changes([](const World& scene) { return scene.ray_cast_all({{-9, 0.5}, {1, 0}}); });
  expect_to_stay_while_the_scene_changes([](const World& scene) {
    return scene.shape_cast_all(Ball{{-9, 0.5}, 1}, {99, 0});
  });
}

/// A loop that removes both objects of every pair meets removed ids: `contains` says so, and nothing else is removed.
TEST(SceneAnswers, NameObjectsThatTheLoopHasRemovedByIdsThatAreStale) {
  World scene;
  const Ids ids = fill(scene, 10);
  std::size_t stale = 0;
  for (const ObjectPair& pair : scene.pairs()) {
    for (const ObjectId id : {pair.a, pair.b}) {
      if (!scene.contains(id)) {
        ++stale;
        EXPECT_THROW(scene.remove(id), std::out_of_range);
        EXPECT_THROW(scene.move(id, Ball{}), std::out_of_range);
        EXPECT_THROW(scene.object(id), std::out_of_range);
        continue;
      }
      scene.remove(id);
      const ObjectId other = scene.add(Ball{{0, 900}, 0});  // in its slot
      EXPECT_EQ(other.index, id.index);
      scene.move(other, Ball{{0, 901}, 0});
    }
  }
  EXPECT_EQ(stale, 8U);  // of 9 pairs in a row, all but the first share an object with the previous one
  EXPECT_EQ(scene.size(), 10U);
  for (const ObjectId id : ids) EXPECT_FALSE(scene.contains(id));
}

TEST(SceneAnswers, EventsMayBeGoneThroughWhileTheLoopMovesAddsAndRemoves) {
  World scene;
  fill(scene);
  const auto go_through = [&scene](const Pairs& events) {
    const Pairs expected = events;
    std::size_t next = 0;
    for (const ObjectPair& pair : events) {
      ASSERT_EQ(pair, expected[next++]);
      if (!scene.contains(pair.a)) continue;
      if (next % 2 == 0) scene.remove(pair.a);
      if (next % 2 == 1) scene.move(pair.a, Ball{{0, 2.0 * static_cast<double>(next)}, 1});
      scene.add(Ball{{static_cast<double>(next), 900}, 1});
      if (next % 10 == 0) scene.snapshot();
      if (next % 10 == 5) scene.pairs();
    }
    EXPECT_EQ(next, expected.size());
    EXPECT_GT(next, 5U);
    EXPECT_EQ(events, expected);
  };
  go_through(scene.update().began);
  go_through(scene.update().ended);
  scene.update();
  go_through(scene.events().stayed);
}

/// Whether the update repairs pairs or finds all again, and whether a snapshot shares the events.
TEST(SceneAnswers, OfAnUpdateStayUntilTheNextOne) {
  World scene;
  const Ids ids = fill(scene);
  for (int round = 0; round < 6; ++round) {
    const SceneEvents& events = scene.update();
    EXPECT_EQ(&events, &scene.events());
    const SceneEvents copy = events;
    const auto snapshot = round % 2 == 0 ? scene.snapshot() : nullptr;
    for (std::size_t k = 0; k < ids.size(); k += round < 3 ? 1 : 50) {  // nearly all, or a few
      scene.move(ids[k], Ball{{2.0 * static_cast<double>(k), round % 2 == 0 ? 5.0 * static_cast<double>(k) : 0}, 1});
    }
    scene.remove(scene.add(Ball{}));
    EXPECT_EQ(&events, &scene.events());
    EXPECT_EQ(events.began, copy.began);
    EXPECT_EQ(events.stayed, copy.stayed);
    EXPECT_EQ(events.ended, copy.ended);
  }
}

/// Updates, queries and snapshots do not move objects in memory, so a reference is valid until the next change.
TEST(SceneAnswers, AnObjectStaysWhereItIsUntilTheNextChange) {
  World scene;
  const Ids ids = fill(scene);
  const Object<2, double>& object = scene.object(ids[7]);
  scene.update();
  const auto snapshot = scene.snapshot();
  scene.overlapping(Ball{});
  scene.pairs();
  EXPECT_EQ(&object, &scene.object(ids[7]));
  EXPECT_EQ(object.name, "7");
  scene.move(ids[7], Ball{std::get<Ball>(object.shape).center + V2(0, 3), 1});
  EXPECT_EQ(std::get<Ball>(scene.object(ids[7]).shape).center, V2(14, 3));
}

/// A snapshot and the addresses of its objects do not change, whatever the scene does, including its destruction.
TEST(SceneAnswers, AnObjectOfASnapshotStaysAsLongAsTheSnapshot) {
  std::shared_ptr<const View> snapshot;
  Ids ids;
  std::vector<const Object<2, double>*> objects;
  {
    World scene;
    ids = fill(scene);
    snapshot = scene.snapshot();
    for (const ObjectId id : ids) objects.push_back(&snapshot->object(id));
    EXPECT_EQ(&scene.object(ids[0]), objects[0]);  // nothing was copied yet
    for (const ObjectId id : ids) {
      if (id.index % 2 == 0) scene.move(id, Ball{{0, 900}, 9});
      if (id.index % 2 == 1) scene.remove(id);
      scene.add(Ball{});
    }
    EXPECT_NE(&scene.object(ids[0]), objects[0]);
    scene.update();
  }
  for (std::size_t k = 0; k < ids.size(); ++k) {
    EXPECT_EQ(&snapshot->object(ids[k]), objects[k]);
    EXPECT_EQ(objects[k]->name, std::to_string(k));
    EXPECT_EQ(std::get<Ball>(objects[k]->shape).center, V2(2.0 * static_cast<double>(k), 0));
  }
}

}  // namespace
}  // namespace graze::scene_answers_test
