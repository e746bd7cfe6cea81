// SPDX-License-Identifier: MIT
// Many threads send all queries to a scene, or snapshots of it, at once, and get the answers of single-threaded calls.
// ./dev test tsan runs this under the thread sanitizer.
#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/executor.hpp>
#include <graze/query/bounds.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/scene_view.hpp>
#include <graze/shape/frustum.hpp>

#include "catalogue.hpp"

namespace graze::scene_threads_test {
namespace {

/// The answers to one query of each kind, twice if there are two variants.
template <Dim N, class T>
struct Answers {
  std::size_t size;
  std::vector<ObjectId> ids;
  std::vector<ObjectId> vacant;
  std::optional<ObjectId> found;
  std::vector<ObjectPair> candidates;
  std::vector<ObjectPair> wide_candidates;
  std::vector<ObjectPair> pairs;
  std::vector<ObjectContact<N, T>> contacts;
  std::vector<ObjectContact<N, T>> contacts_of_one_thread;
  std::vector<ObjectId> overlapping;
  std::vector<ObjectId> culled;
  std::vector<ObjectId> in_view;
  std::vector<NearObject<T>> nearest;
  std::optional<ObjectHit<N, T>> first_hit;
  std::vector<ObjectHit<N, T>> hits;
  std::optional<ObjectImpact<N, T>> first_impact;
  std::vector<ObjectImpact<N, T>> impacts;

  friend bool operator==(const Answers&, const Answers&) = default;
};

constexpr int objects = 150;
constexpr std::size_t threads = 4;

template <Dim N, class T>
Vec<N, T> place(double x, double y) {
  Vec<N, T> point(T(0));
  point[0] = static_cast<T>(x);
  point[1] = static_cast<T>(y);
  return point;
}

/// A truncated pyramid, or triangle, opening upwards along the last axis.
template <Dim N, class T>
Frustum<N, T> view() {
  Frustum<N, T> frustum;
  for (std::size_t k = 0; k < frustum.corners.size(); ++k) {
    const bool is_far = k >= frustum.corners.size() / 2;
    frustum.corners[k] *= is_far ? T(40) : T(1);
    frustum.corners[k][N - 1] = is_far ? T(40) : T(-1);
  }
  return frustum;
}

/// Each thread starts with another query, so that every query runs concurrently with every other one.
template <Dim N, class T>
Answers<N, T> ask(const SceneView<N, T>& scene, std::size_t start = 0) {
  Answers<N, T> all{};
  const Sphere<N, T> region{place<N, T>(40, 0.5), T(15)};
  const Ray<N, T> ray{place<N, T>(-9, 0.25), place<N, T>(1, 0)};
  for (std::size_t k = 0; k < 8; ++k) {
    switch ((start + k) % 8) {
      case 0:
        all.nearest = scene.nearest(place<N, T>(30, 1), 5);
        break;
      case 1:
        all.first_hit = scene.ray_cast(ray);
        all.hits = scene.ray_cast_all(ray, T(60));
        break;
      case 2:
        all.culled = scene.cull(region);
        all.in_view = scene.cull(view<N, T>());
        break;
      case 3:
        all.overlapping = scene.overlapping(region);
        break;
      case 4:
        all.candidates = scene.candidates();
        all.wide_candidates = scene.candidates(1.5);
        break;
      case 5:
        all.contacts = scene.contacts();
        all.contacts_of_one_thread = scene.contacts(serial_executor());
        break;
      case 6:
        all.first_impact = scene.shape_cast(Sphere<N, T>{ray.origin, T(1)}, ray.direction * T(60));
        all.impacts = scene.shape_cast_all(Sphere<N, T>{ray.origin, T(1)}, ray.direction * T(60));
        break;
      default:
        all.pairs = scene.pairs();
        all.size = scene.size();
        all.ids = scene.ids();
        all.vacant = scene.vacant_ids();
        all.found = scene.find("7");
        break;
    }
  }
  return all;
}

/// Starts many threads at the same time, and waits for them.
void run_at_once(const auto& work) {
  std::atomic<std::size_t> arrived = 0;
  std::vector<std::thread> running;
  for (std::size_t k = 0; k < threads; ++k) {
    running.emplace_back([&, k] {
      ++arrived;
      while (arrived < threads) std::this_thread::yield();
      work(k);
    });
  }
  for (std::thread& each : running) each.join();
}

/// Balls in a row on a floor, with a few boxes and compounds.
template <Dim N, class T>
std::vector<ObjectId> fill(Scene<N, T>& scene) {
  std::vector<ObjectId> ids;
  const std::vector<AnyShape<N, T>> parts{Sphere<N, T>{place<N, T>(80, 0), T(1)}, Aabb<N, T>{}};
  ids.push_back(scene.add(HalfSpace<N, T>{place<N, T>(0, 1), T(-0.5)}, {.mobility = Mobility::fixed}));
  ids.push_back(scene.add(compound_of<N, T>(parts)));
  for (int k = 2; k < objects; ++k) {
    ids.push_back(scene.add(Sphere<N, T>{place<N, T>(k, 0), T(0.75)}, {.name = std::to_string(k)}));
  }
  return ids;
}

/// Moves some to one side and back, changes one to a shape of another type, removes one, and adds another in its slot.
template <Dim N, class T>
void stir(Scene<N, T>& scene, std::vector<ObjectId>& ids, int round) {
  for (int k = 2 + round; k < objects; k += 7) {
    scene.move(ids[static_cast<std::size_t>(k)], Sphere<N, T>{place<N, T>(k, round % 2), T(0.75)});
  }
  const Vec<N, T> corner = place<N, T>(round, 0);
  scene.move(ids[3], Aabb<N, T>{corner, corner + T(2)});
  scene.remove(ids[50]);
  ids[50] = scene.add(Sphere<N, T>{place<N, T>(50 - round, 0), T(1)});
}

/// Checks that the answers are not empty, because comparing empty answers proves nothing.
template <Dim N, class T>
void expect_all_to_say_something(const Answers<N, T>& all) {
  EXPECT_EQ(all.size, static_cast<std::size_t>(objects));
  EXPECT_TRUE(all.found);
  EXPECT_FALSE(all.pairs.empty());
  EXPECT_GE(all.candidates.size(), all.pairs.size());
  EXPECT_GT(all.wide_candidates.size(), all.candidates.size());
  EXPECT_EQ(all.contacts.size(), all.pairs.size());
  EXPECT_EQ(all.contacts_of_one_thread, all.contacts);
  EXPECT_GT(all.overlapping.size(), 10U);
  EXPECT_GE(all.culled.size(), all.overlapping.size());
  EXPECT_GT(all.in_view.size(), 2U);
  EXPECT_EQ(all.nearest.size(), 5U);
  EXPECT_TRUE(all.first_hit);
  EXPECT_GT(all.hits.size(), 10U);
  EXPECT_TRUE(all.first_impact);
  EXPECT_GE(all.impacts.size(), all.hits.size());
}

template <class Space>
class SceneOfMany : public testing::Test {};
TYPED_TEST_SUITE(SceneOfMany, test::Spaces);

/// Each may be the first query after a change, before or after an update: the index is updated once.
TYPED_TEST(SceneOfMany, ThreadsMayAskEverythingAtOnce) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  Scene<N, T> scene;
  std::vector<ObjectId> ids = fill(scene);
  for (int round = 0; round < 4; ++round) {
    stir(scene, ids, round);
    if (round % 2 == 1) scene.update();
    const Answers<N, T> expected = ask<N, T>(Scene<N, T>(scene));
    expect_all_to_say_something(expected);
    const Scene<N, T>& reading = scene;
    std::vector<Answers<N, T>> found(threads);
    run_at_once([&](std::size_t k) { found[k] = ask<N, T>(reading, 2 * k); });
    for (const Answers<N, T>& mine : found) EXPECT_TRUE(mine == expected);
  }
}

/// The current snapshot and one of each earlier state, all queried at once while the scene changes.
TYPED_TEST(SceneOfMany, ThreadsMayAskSnapshotsOldAndNewEverythingWhileTheSceneMovesOn) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  Scene<N, T> scene;
  std::vector<ObjectId> ids = fill(scene);
  std::vector<std::shared_ptr<const SceneView<N, T>>> snapshots;
  std::vector<Answers<N, T>> expected;
  for (int round = 0; round < 4; ++round) {
    stir(scene, ids, round);
    if (round % 2 == 1) scene.update();
    snapshots.push_back(scene.snapshot());
    expected.push_back(ask<N, T>(Scene<N, T>(scene)));
    expect_all_to_say_something(expected.back());
  }
  std::vector<std::vector<Answers<N, T>>> found(threads);
  run_at_once([&](std::size_t k) {
    if (k > 0) {
      for (std::size_t each = 0; each < snapshots.size(); ++each) {
        found[k].push_back(ask<N, T>(*snapshots[(each + k) % snapshots.size()], 2 * k));
      }
      return;
    }
    for (int round = 4; round < 7; ++round) {  // the one that writes
      stir(scene, ids, round);
      scene.update();
      scene.overlapping(Sphere<N, T>{});
      scene.snapshot();
    }
  });
  for (std::size_t k = 1; k < threads; ++k) {
    for (std::size_t each = 0; each < snapshots.size(); ++each) {
      EXPECT_TRUE(found[k][each] == expected[(each + k) % snapshots.size()]) << k << ", " << each;
    }
  }
  EXPECT_FALSE((ask<N, T>(scene) == expected.back()));
}

/// A snapshot may be the last owner of a state, and whoever drops it last frees that.
TEST(SceneOfSome, ThreadsMayKeepAndDropSnapshotsAsTheyLike) {
  using World = Scene<2, double>;
  World scene;
  std::vector<ObjectId> ids = fill(scene);
  for (int round = 0; round < 10; ++round) {
    stir(scene, ids, round);
    scene.update();
    std::vector<std::shared_ptr<const SceneView<2, double>>> mine(threads, scene.snapshot());
    const std::size_t expected = scene.pairs().size();
    run_at_once([&](std::size_t k) {
      if (k == 0) stir(scene, ids, round + 1);
      EXPECT_EQ(mine[k]->pairs().size(), expected);
      mine[k].reset();
    });
  }
  EXPECT_EQ(scene.size(), static_cast<std::size_t>(objects));
}

}  // namespace
}  // namespace graze::scene_threads_test
