// SPDX-License-Identifier: MIT
// Allocations of a scene, and its behaviour when they fail. This program counts each thread's calls of operator new,
// and can make them fail.
#include <cstddef>
#include <cstdint>
#include <new>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/executor.hpp>
#include <graze/query/bounds.hpp>
#include <graze/scene/scene.hpp>

#include "heap_watch.hpp"
#include "scene/scene_sight.hpp"

namespace graze::scene_memory_test {
namespace {

using World = Scene<2, double>;
using Ball = Sphere<2, double>;
using Box = Aabb<2, double>;
using Any = AnyShape<2, double>;
using V2 = Vec<2, double>;
using Ids = std::vector<ObjectId>;

/// During its lifetime, this number of this thread's allocations succeed, and then all fail.
class ShortMemory {
 public:
  explicit ShortMemory(std::size_t grants) { test::heap_watch.grants_left = grants; }
  ~ShortMemory() { test::heap_watch.grants_left = test::HeapWatch::no_end; }
  ShortMemory(const ShortMemory&) = delete;
  ShortMemory& operator=(const ShortMemory&) = delete;
};

/// Runs an operation on a scene with memory that runs out one allocation later each time, until it succeeds: on failure
/// nothing may have changed, on success everything must be as with unlimited memory. Returns the number of failures.
std::size_t expect_all_or_nothing(World& scene, const auto& act) {
  const auto before = test::ray_verdict_of(scene);
  World calm = scene;
  act(calm);
  for (std::size_t grants = 0;; ++grants) {
    try {
      const ShortMemory memory(grants);
      act(scene);
    } catch (const std::bad_alloc&) {
      EXPECT_TRUE(test::ray_verdict_of(scene) == before) << grants << " grants";
      continue;
    }
    EXPECT_TRUE(test::ray_verdict_of(scene) == test::ray_verdict_of(calm)) << grants << " grants";
    return grants;
  }
}

/// Touching balls in a row, or boxes, some with names too long for the small-string optimisation.
Ids fill(World& scene, int count) {
  const std::string start = "an object with quite a long name, number ";
  Ids ids;
  for (int k = 0; k < count; ++k) {
    const V2 center(2.0 * k, 0);
    const Any shape = k % 4 == 0 ? Any(Box{center - 1.0, center + 1.0}) : Any(Ball{center, 1});
    ids.push_back(scene.add(shape, {.name = k % 3 == 0 ? start + std::to_string(k) : ""}));
  }
  return ids;
}

Any pair_of_balls(double x) {
  const std::vector<Any> parts{Ball{{x, 0}, 1}, Ball{{x + 1, 2}, 1}};
  return compound_of<2, double>(parts);
}

/// Runs every operation that changes a scene once. Returns how often memory ran out.
std::size_t change_in_every_way(World& scene, const Ids& ids) {
  std::size_t failed = 0;
  const auto change = [&](const auto& act) { failed += expect_all_or_nothing(scene, act); };
  const std::string name = "another object with quite a long name";
  change([&](World& world) { world.add(pair_of_balls(3), {.name = name}); });
  change([&](World& world) { world.layer("a layer with quite a long name"); });
  change([&](World& world) { world.move(ids[1], Ball{{9, 1}, 1}); });
  change([&](World& world) { world.move(ids[2], pair_of_balls(5)); });
  change([&](World& world) { world.update(serial_executor()); });
  const std::vector<ObjectMove<2, double>> moves{
      {ids[3], Ball{{1, 0}, 1}}, {ids[4], pair_of_balls(7)}, {ids[70], Box{}}, {ids[5], pair_of_balls(9)}};
  change([&](World& world) { world.move(moves); });
  const Ids many(ids.begin(), ids.begin() + 60);
  const std::vector<Box> boxes(60, Box{{20, 0}, {21, 1}});
  change([&](World& world) { world.move(many, boxes); });
  change([&](World& world) { world.update(serial_executor()); });
  change([&](World& world) { world.except(ids[6], ids[7]); });
  change([&](World& world) { world.except(ids[9], ids[8]); });
  change([&](World& world) { world.update(serial_executor()); });
  change([&](World& world) { world.accept(ids[8], ids[9]); });
  change([&](World& world) { world.remove(ids[6]); });
  change([&](World& world) { world.remove(*world.find(name)); });
  change([&](World& world) { world.add(Ball{{1, 0}, 1}); });  // in a reused slot
  change([&](World& world) { world.update(serial_executor()); });
  return failed;
}

TEST(SceneMemory, ThatRunsOutLeavesTheSceneAsItWas) {
  World scene;
  EXPECT_GT(expect_all_or_nothing(scene, [](World& world) { world.add(Ball{}, {.name = "first"}); }), 5U);
  const Ids ids = fill(scene, 100);
  EXPECT_GT(change_in_every_way(scene, ids), 30U);
}

/// The same while a snapshot exists, so that chunks are copied before changes.
TEST(SceneMemory, ThatRunsOutLeavesASceneWithSnapshotsAsItWas) {
  World scene;
  const Ids ids = fill(scene, 100);
  scene.update();
  const auto snapshot = scene.snapshot();
  const Ids expected = snapshot->overlapping(Ball{{50, 0}, 9});
  EXPECT_GT(change_in_every_way(scene, ids), 30U);
  EXPECT_EQ(snapshot->overlapping(Ball{{50, 0}, 9}), expected);
  EXPECT_EQ(snapshot->pairs().size(), 99U);
}

/// Until the tables of all kinds have grown several times.
TEST(SceneMemory, ThatRunsOutWhileTheSceneGrowsKeepsWhatWasThere) {
  World scene;
  std::size_t failed = 0;
  for (int k = 0; k < 300; ++k) {
    for (std::size_t grants = 0;; ++grants, ++failed) {
      try {
        const ShortMemory memory(grants);
        scene.add(Ball{{2.0 * k, 0}, 1});
        break;
      } catch (const std::bad_alloc&) {
        ASSERT_EQ(scene.size(), static_cast<std::size_t>(k));
      }
    }
  }
  EXPECT_GT(failed, 20U);
  const Ids ids = scene.ids();
  for (std::size_t k = 0; k < 300; ++k) ASSERT_EQ(ids[k], (ObjectId{static_cast<std::uint32_t>(k), 1, ids[0].owner}));
  EXPECT_EQ(scene.update().began.size(), 299U);
  EXPECT_EQ(scene.overlapping(Ball{{50, 0}, 2}).size(), 3U);
}

/// A query may have to update the index; if that fails, it is repeated.
TEST(SceneMemory, ThatRunsOutInAQueryChangesNoAnswer) {
  World scene;
  const Ids ids = fill(scene, 100);
  std::size_t failed = 0;
  for (int round = 0; round < 5; ++round) {
    const auto ask = [&](const auto& question) {
      if (round > 0) {  // a few, or many
        for (std::size_t k = 0; k < ids.size(); k += round < 3 ? 9 : 1) {
          if (scene.contains(ids[k])) scene.move(ids[k], Ball{{static_cast<double>(k), 3.0 * (round % 3)}, 1});
        }
        scene.add(Ball{{50.0 + round, 0}, 1});
        const Ids there = scene.overlapping(V2(50, 0));
        if (!there.empty()) scene.remove(there.front());
        scene.move(scene.ids().front(), Ball{{1.0 * round, 5}, 1});
      }
      const auto expected = question(World(scene));
      for (std::size_t grants = 0;; ++grants, ++failed) {
        try {
          const ShortMemory memory(grants);
          const auto found = question(scene);
          test::heap_watch.grants_left = test::HeapWatch::no_end;
          EXPECT_TRUE(found == expected);
          break;
        } catch (const std::bad_alloc&) {
        }
      }
    };
    ask([](const World& world) { return world.overlapping(Ball{{50, 0}, 20}); });
    ask([](const World& world) { return world.cull(Ball{{50, 0}, 20}); });
    ask([](const World& world) { return world.nearest({50, 0}, 20); });
    ask([](const World& world) { return world.nearest(Ball{{50, 0}, 1}, 20); });
    ask([](const World& world) { return world.contacts_with(Ball{{50, 0}, 9}); });
    ask([](const World& world) { return world.ray_cast_all({{-9, 0.25}, {1, 0}}); });
    ask([](const World& world) { return world.ray_cast({{-9, 0.25}, {1, 0}}); });
  }
  EXPECT_GT(failed, 50U);
}

TEST(SceneMemory, OfASnapshotIsNoneForTheObjectsUntilTheyChange) {
  constexpr std::size_t count = 100'000;
  World scene;
  Ids ids;
  for (std::size_t k = 0; k < count; ++k) {
    ids.push_back(scene.add(Ball{{static_cast<double>(k % 300), static_cast<double>(k / 300)}, 0.25}));
  }
  scene.overlapping(Ball{});  // the index is up to date
  const std::size_t at_first = test::heap_watch.bytes;
  const auto snapshot = scene.snapshot();
  const std::size_t of_snapshot = test::heap_watch.bytes - at_first;
  EXPECT_LT(of_snapshot, 5 * count);
  const std::size_t before_move = test::heap_watch.bytes;
  scene.move(ids[7], Ball{{0, 0}, 1});
  const std::size_t of_move = test::heap_watch.bytes - before_move;
  EXPECT_GT(of_move, 0U);
  EXPECT_LT(of_move, 80 * sizeof(Object<2, double>));  // 64 of them, and their bookkeeping
  const std::size_t before_next = test::heap_watch.bytes;
  scene.move(ids[8], Ball{{0, 0}, 1});
  EXPECT_EQ(test::heap_watch.bytes, before_next);  // those are not shared any more
  EXPECT_EQ(snapshot->object(ids[8]).box.min, V2(7.75, -0.25));
}

TEST(SceneMemory, IsSeenWhereThereIsSome) {
  const std::size_t before = test::heap_watch.bytes;
  const std::string text(1000, 'x');
  EXPECT_GT(test::heap_watch.bytes, before + 999);
  const ShortMemory memory(0);
  bool was_refused = false;
  try {
    const std::string other(text);
  } catch (const std::bad_alloc&) {
    was_refused = true;
  }
  test::heap_watch.grants_left = test::HeapWatch::no_end;
  EXPECT_TRUE(was_refused);
}

/// The first query after a change brings the index up to date.
TEST(SceneMemory, ACastAllocatesNothing) {
  World scene;
  fill(scene, 1000);
  scene.shape_cast(Ball{}, {1, 0});
  EXPECT_EQ(test::requests_of([&scene] {
              EXPECT_TRUE(scene.shape_cast(Ball{{-9, 0}, 1}, {99, 0.5}));
              EXPECT_TRUE(scene.time_of_impact(Ball{{-9, 0}, 1}, {{99, 0.5}, 1, {-8, 0}}, {.layers = only_layer(0)}));
            }),
            0U);
}

}  // namespace
}  // namespace graze::scene_memory_test
