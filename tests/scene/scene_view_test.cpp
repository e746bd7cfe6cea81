// SPDX-License-Identifier: MIT
// Queries on a scene, compared with testing every object.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/index/region.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/scene/plain_scene.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/scene_view.hpp>
#include <graze/shape/pick.hpp>

#include "../cameras.hpp"
#include "../unbounded_compound.hpp"
#include "catalogue.hpp"

namespace graze::scene_view_test {
namespace {

using World = Scene<2, double>;
using Ball = Sphere<2, double>;
using V2 = Vec<2, double>;
using Ids = std::vector<ObjectId>;

TEST(SceneView, OfAnEmptySceneFindsNothing) {
  const World scene;
  EXPECT_TRUE(scene.ids().empty());
  EXPECT_TRUE(scene.pairs().empty());
  EXPECT_TRUE(scene.overlapping(Ball{{0, 0}, 9}).empty());
  EXPECT_TRUE(scene.cull(Ball{{0, 0}, 9}).empty());
  EXPECT_TRUE(scene.nearest({0, 0}, 3).empty());
}

TEST(SceneView, OverlappingIsExactAndCullAsksBoxes) {
  World scene;
  const ObjectId touching = scene.add(Ball{{2, 0}, 1});
  const ObjectId at_its_corner = scene.add(Ball{{1.9, 1.9}, 1});
  const ObjectId away = scene.add(Ball{{9, 0}, 1});
  const ObjectId floor = scene.add(HalfSpace<2, double>{{0, 1}, -0.5});
  const Ball region{{0, 0}, 1};
  EXPECT_EQ(scene.overlapping(region), (Ids{touching, floor}));
  EXPECT_EQ(scene.cull(Aabb<2, double>{{-1, -1}, {1, 1}}), (Ids{touching, at_its_corner, floor}));
  EXPECT_EQ(scene.overlapping(Segment<2, double>{{-9, 0}, {9, 0}}), (Ids{touching, away}));
}

/// Scene and PlainScene.
template <class S>
void expect_that_queries_leave_out_objects() {
  S scene;
  const ObjectId first = scene.add(Ball{{2, 0}, 1});
  const ObjectId second = scene.add(Ball{{3, 0}, 1}, {.layer = 1});
  const ObjectId third = scene.add(Ball{{4, 0}, 1}, {.layer = 1});
  const Ball region{{3, 0}, 1};
  const Frustum<2, double> everything{{V2(-9, -9), V2(9, -9), V2(-9, 9), V2(9, 9)}};
  const Ray<2, double> ray{{0, 0}, {1, 0}};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto expect = [&](const SceneQuery& query, const Ids& expected) {
    EXPECT_EQ(scene.overlapping(region, query), expected);
    EXPECT_EQ(scene.cull(region, query), expected);
    EXPECT_EQ(scene.cull(everything, query), expected);
    Ids near;
    Ids hit;
    for (const auto& each : scene.nearest({0, 0}, 9, query)) near.push_back(each.id);
    for (const auto& each : scene.ray_cast_all(ray, infinity, query)) hit.push_back(each.id);
    EXPECT_EQ(near, expected);
    EXPECT_EQ(hit, expected);
    const auto first_hit = scene.ray_cast(ray, infinity, query);
    EXPECT_EQ(first_hit ? Ids{first_hit->id} : Ids{}, expected.empty() ? Ids{} : Ids{expected.front()});
  };
  expect({}, {first, second, third});
  expect({.layers = only_layer(1)}, {second, third});
  expect({.except = {&first, 1}}, {second, third});
  expect({.predicate = [second](ObjectId id) { return id != second; }}, {first, third});
  expect({.layers = only_layer(1), .except = {&second, 1}}, {third});
  expect({.layers = only_layer(1), .except = {&second, 1}, .predicate = [](ObjectId) { return false; }}, {});
}

TEST(SceneView, QueriesLeaveOutObjects) {
  expect_that_queries_leave_out_objects<World>();
  expect_that_queries_leave_out_objects<PlainScene<2, double>>();
}

TEST(SceneView, ACameraSeesTheObjectsInItsFrustum) {
  Scene<3, float> scene;
  const ObjectId ahead = scene.add(Sphere<3>{{0, 0, 5}, 1}, {.layer = 3});
  const ObjectId beside = scene.add(Sphere<3>{{7, 0, 5}, 1.5F});
  scene.add(Sphere<3>{{9, 0, 5}, 1.5F});  // within the bounds of the frustum
  scene.add(Sphere<3>{{0, 0, -5}, 1});    // behind
  const ObjectId floor = scene.add(HalfSpace<3>{{0, 1, 0}, -2});
  Frustum<3> frustum;  // upwards from the origin, as wide to either side as it is high
  for (std::size_t k = 0; k < 8; ++k) frustum.corners[k] *= k < 4 ? 1.0F : 10.0F;
  for (std::size_t k = 0; k < 4; ++k) frustum.corners[k].z = 1;
  EXPECT_EQ(scene.cull(frustum), (Ids{ahead, beside, floor}));
  EXPECT_EQ(scene.cull(frustum, only_layer(3)), (Ids{ahead}));
  EXPECT_EQ(scene.snapshot()->cull(frustum).size(), 3U);
  EXPECT_EQ((scene.overlapping(convex_hull<3, float>(frustum.corners))), (Ids{ahead, beside, floor}));
  EXPECT_EQ(scene.ray_cast(pick_ray(Mat<4, float>(1), {0, 0}))->id, ahead);
  frustum.corners[2].y = std::numeric_limits<float>::infinity();
  EXPECT_THROW(scene.cull(frustum), std::invalid_argument);
}

TEST(SceneView, OnlyTheLayersAskedForAreFound) {
  World scene;
  const ObjectId low = scene.add(Ball{{0, 0}, 1}, {.layer = 2});
  const ObjectId high = scene.add(Ball{{0, 0}, 2}, {.layer = 5});
  EXPECT_EQ(scene.overlapping(V2(0, 0), only_layer(2)), (Ids{low}));
  EXPECT_EQ(scene.cull(V2(0, 0), only_layer(5)), (Ids{high}));
  EXPECT_EQ(scene.nearest({0, 0}, 9, only_layer(5)), (std::vector<NearObject<double>>{{high, 0}}));
  EXPECT_TRUE(scene.overlapping(V2(0, 0), only_layer(3)).empty());
}

TEST(SceneView, TheNearestComeByTheirShapesAndEqualOnesById) {
  World scene;
  const ObjectId corner = scene.add(Triangle<2, double>{{4, 4}, {9, 4}, {4, 9}});
  const ObjectId left = scene.add(Ball{{-3, 0}, 1});
  const ObjectId right = scene.add(Ball{{3, 0}, 1});
  const ObjectId plane = scene.add(Plane<2, double>{{0, 1}, -1});
  const ObjectId nothing = scene.add(Compound<2, double>{});
  EXPECT_EQ(scene.nearest({0, 0}, 3), (std::vector<NearObject<double>>{{plane, 1}, {left, 2}, {right, 2}}));
  EXPECT_EQ(scene.nearest({0, 0}, 9).size(), 4U);
  EXPECT_EQ(scene.nearest({0, -3}, 1), (std::vector<NearObject<double>>{{plane, 2}}));  // from below, too
  EXPECT_EQ(scene.nearest({5, 5}, 1), (std::vector<NearObject<double>>{{corner, 0}}));
  EXPECT_TRUE(scene.nearest({0, 0}, 0).empty());
  EXPECT_TRUE(scene.contains(nothing));
}

TEST(SceneView, NonsenseIsRefused) {
  World scene;
  scene.add(Ball{});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(scene.overlapping(Ball{{0, 0}, -1}), std::invalid_argument);
  EXPECT_THROW(scene.cull(Ball{{nan, 0}, 1}), std::invalid_argument);
  EXPECT_THROW(scene.nearest({nan, 0}, 1), std::invalid_argument);
  EXPECT_THROW(scene.nearest({nan, 0}, 0), std::invalid_argument);
}

// Each thread may be the first to query after a change: the index is updated once.
TEST(SceneView, ManyThreadsMayAskAtOnce) {
  World scene;
  std::vector<ObjectId> ids;
  for (int i = 0; i < 200; ++i) ids.push_back(scene.add(Ball{{i, 0}, 0.75}));
  for (int round = 0; round < 20; ++round) {
    for (int i = round; i < 200; i += 7) scene.move(ids[static_cast<std::size_t>(i)], Ball{{i, round % 2}, 0.75});
    const World& reading = scene;
    const Ids expected = World(scene).overlapping(Ball{{50, 0.5}, 20});
    std::vector<Ids> found(4);
    std::vector<std::thread> threads;
    for (Ids& mine : found) threads.emplace_back([&] { mine = reading.overlapping(Ball{{50, 0.5}, 20}); });
    for (std::thread& thread : threads) thread.join();
    for (const Ids& mine : found) EXPECT_EQ(mine, expected);
  }
}

// Each reader has a snapshot while the scene changes; an update uses the threads of oneTBB.
TEST(SceneView, ThreadsMayReadASnapshotWhileTheSceneMovesOn) {
  World scene;
  std::vector<ObjectId> ids;
  for (int i = 0; i < 3000; ++i) ids.push_back(scene.add(Ball{{i, 0}, 0.75}));
  for (int round = 0; round < 4; ++round) {
    scene.update();
    const auto snapshot = scene.snapshot();
    const Ids expected = snapshot->overlapping(Ball{{50, 0.5}, 20});
    std::vector<std::thread> readers;
    for (int reader = 0; reader < 2; ++reader) {
      readers.emplace_back([&] {
        for (int time = 0; time < 20; ++time) EXPECT_EQ(snapshot->overlapping(Ball{{50, 0.5}, 20}), expected);
        EXPECT_EQ(snapshot->pairs().size(), 2999U - static_cast<std::size_t>(round));
      });
    }
    for (const ObjectId id : ids) scene.move(id, Ball{{static_cast<double>(id.index), 3.0 * round}, 0.75});
    scene.remove(ids.back());
    ids.pop_back();
    scene.update();
    EXPECT_EQ(scene.pairs().size(), ids.size() - 1);
    for (std::thread& reader : readers) reader.join();
  }
}

// The box of a compound with a plane among its parts is infinite, and does not show how large the coordinates of others
// are, which determine the band of `relation`.
TEST(SceneView, FindsWhatTouchesAFarPartOfACompoundThatIsNotBounded) {
  using Any = AnyShape<2, double>;
  const Any ray = test::along_x<2, double>();
  for (const Any& far : test::far_shapes<2, double>()) {
    const Any compound = test::beside_a_plane<2, double>(far);
    ASSERT_EQ(relation(compound, ray), Relation::touching);
    World scene;
    PlainScene<2, double> plain;
    scene.add(Ball{{-9, 0}, 1});
    plain.add(Ball{{-9, 0}, 1});
    const ObjectId a = scene.add(compound);
    const ObjectId b = scene.add(ray);
    plain.add(compound);
    plain.add(ray);
    const std::vector<ObjectPair> pairs{{a, b}};
    const std::vector<ObjectPair> candidates = scene.candidates();
    EXPECT_NE(std::find(candidates.begin(), candidates.end(), pairs.front()), candidates.end());
    EXPECT_EQ(scene.pairs(), pairs);
    EXPECT_EQ(plain.pairs().size(), 1U);
    EXPECT_EQ(scene.update().began, pairs);
    EXPECT_EQ(scene.contacts().size(), 1U);
    EXPECT_EQ(scene.overlapping(ray), (Ids{a, b}));
    EXPECT_EQ(scene.overlapping(compound), (Ids{a, b}));
    EXPECT_EQ(plain.overlapping(ray).size(), 2U);
    EXPECT_EQ(plain.overlapping(compound).size(), 2U);
    const auto& way = std::get<Ray<2, double>>(ray);
    const auto hit = graze::ray_cast(compound, way);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(scene.ray_cast_all(way),
              (std::vector<ObjectHit<2, double>>{{b, {*graze::ray_cast(ray, way)}}, {a, {*hit}}}));
    // Repaired, because only one of many has moved.
    for (int k = 0; k < 40; ++k) scene.add(Ball{{-9.0 - 9 * k, 0}, 1});
    scene.move(a, Ball{{-9, 9}, 1});
    EXPECT_EQ(scene.update().ended, pairs);
    scene.move(a, compound);
    EXPECT_EQ(scene.update().began, pairs);
  }
}

/// Exactly those objects whose boxes meet the frustum, up to rounding.
template <Dim N, class T>
void check_what_a_camera_sees(const Scene<N, T>& scene) {
  const Frustum<N, T> frustum = test::any_frustum<N, T>(test::draw_source<N, T>());
  if (!is_valid(frustum)) return;
  RC_LOG() << test::to_source(frustum) << "\n";
  const detail::RegionProbe<Inflated<Frustum<N, T>>> probe(Inflated<Frustum<N, T>>{frustum});
  Ids expected;
  for (const ObjectId id : scene.ids()) {
    const Aabb<N, T>& box = scene.object(id).box;
    const bool is_seen = !is_nothing(box) && probe.meets(touching_bounds(scene.object(id)));
    if (is_seen) expected.push_back(id);
    if (is_valid(box) && intersects(frustum, box)) RC_ASSERT(is_seen);
  }
  RC_ASSERT(scene.cull(frustum) == expected);
}

template <Dim N, class T>
void check_against_every_object() {
  Scene<N, T> scene;
  for (int round = 0; round < 3; ++round) {
    for (const AnyShape<N, T>& shape : *test::some<AnyShape<N, T>>(10, test::any_shape<N, T>())) {
      const Ids ids = scene.ids();
      if (ids.empty() || *rc::gen::inRange(0, 3) > 0) {
        scene.add(shape);
      } else if (const ObjectId id = ids[*rc::gen::inRange<std::size_t>(0, 1000) % ids.size()];
                 *rc::gen::inRange(0, 2) > 0) {
        scene.move(id, shape);
      } else {
        scene.remove(id);
      }
    }
    const AnyShape<N, T> region = *test::any_shape<N, T>();
    const Vec<N, T> point = *test::any<Vec<N, T>>();
    Ids overlapping;
    std::vector<NearObject<T>> nearest;
    for (const ObjectId id : scene.ids()) {
      const AnyShape<N, T>& shape = scene.object(id).shape;
      if (relation(region, shape) != Relation::apart) overlapping.push_back(id);
      const T distance = signed_distance(shape, point);
      const T off = std::holds_alternative<Plane<N, T>>(shape) ? std::fabs(distance) : std::max(distance, T(0));
      if (off < std::numeric_limits<T>::infinity()) nearest.push_back({id, off});
    }
    for (const ObjectId id : scene.ids()) RC_LOG() << test::to_source<N, T>(scene.object(id).shape) << "\n";
    RC_LOG() << "region " << test::to_source<N, T>(region) << "\n";
    RC_ASSERT(scene.overlapping(region) == overlapping);
    const Ids seen = scene.cull(region);
    RC_ASSERT(std::includes(seen.begin(), seen.end(), overlapping.begin(), overlapping.end()));
    std::stable_sort(nearest.begin(), nearest.end(),
                     [](const auto& a, const auto& b) { return a.distance < b.distance; });
    const std::size_t count = *rc::gen::inRange<std::size_t>(0, 8);
    nearest.resize(std::min(nearest.size(), count));
    RC_ASSERT(scene.nearest(point, count) == nearest);
    RC_ASSERT(scene.snapshot()->overlapping(region) == overlapping);
    check_what_a_camera_sees(scene);
  }
}

RC_GTEST_PROP(SceneView, AnswersAsEveryObjectDoes2f, ()) { check_against_every_object<2, float>(); }
RC_GTEST_PROP(SceneView, AnswersAsEveryObjectDoes3f, ()) { check_against_every_object<3, float>(); }
RC_GTEST_PROP(SceneView, AnswersAsEveryObjectDoes2d, ()) { check_against_every_object<2, double>(); }
RC_GTEST_PROP(SceneView, AnswersAsEveryObjectDoes3d, ()) { check_against_every_object<3, double>(); }

}  // namespace
}  // namespace graze::scene_view_test
