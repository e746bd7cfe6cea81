// SPDX-License-Identifier: MIT
// Moving shapes in a scene, compared with moving them past every object.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/ray_cast.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/time_of_impact.hpp>
#include <graze/scene/plain_scene.hpp>
#include <graze/scene/scene.hpp>

#include "broad/box_worlds.hpp"
#include "catalogue.hpp"
#include "scene/judged_scene.hpp"

namespace graze::scene_cast_test {
namespace {

using World = Scene<2, double>;
using Ball = Sphere<2, double>;
using Box = Aabb<2, double>;
using V2 = Vec<2, double>;
using Path = Motion<2, double>;
using Ids = std::vector<ObjectId>;
using Hits = std::vector<ObjectImpact<2, double>>;

Ids ids_of(const Hits& hits) {
  Ids ids;
  for (const auto& each : hits) ids.push_back(each.id);
  return ids;
}

TEST(SceneCast, TouchesObjectsInOrder) {
  World scene;
  const ObjectId far = scene.add(Ball{{9, 0}, 1});
  const ObjectId near = scene.add(Ball{{4, 0}, 1}, {.layer = 3});
  scene.add(Ball{{6, 2.5}, 1});
  const ObjectId behind_all = scene.add(HalfSpace<2, double>{{-1, 0}, -20});
  const Ball bullet{{0, 0}, 1};
  const auto first = scene.shape_cast(bullet, {20, 0});
  ASSERT_TRUE(first);
  EXPECT_EQ(first->id, near);
  EXPECT_EQ(first->impact.t, 0.1);
  EXPECT_EQ(first->impact.point, V2(3, 0));
  EXPECT_EQ(first->impact.normal, V2(1, 0));
  EXPECT_EQ(ids_of(scene.shape_cast_all(bullet, {20, 0})), (Ids{near, far, behind_all}));
  EXPECT_EQ(ids_of(scene.shape_cast_all(bullet, {18, 0})), (Ids{near, far}));
  EXPECT_EQ(scene.shape_cast(bullet, {20, 0}, {.layers = only_layer(0)})->id, far);
  EXPECT_FALSE(scene.shape_cast(bullet, {1.9, 0}));
  EXPECT_EQ(scene.shape_cast(bullet, {2, 0})->impact.t, 1);
  EXPECT_FALSE(scene.shape_cast(bullet, {-20, 0}));
}

TEST(SceneCast, AmongEqualTimesTheLowestIdIsFirst) {
  World scene;
  const ObjectId first = scene.add(Box{{2, -1}, {3, 1}});
  const ObjectId second = scene.add(Box{{2, -5}, {9, 5}});
  const ObjectId third = scene.add(HalfSpace<2, double>{{-1, 0}, -2});
  const Box mover{{-1, -1}, {0, 1}};
  EXPECT_EQ(ids_of(scene.shape_cast_all(mover, {4, 0})), (Ids{first, second, third}));
  EXPECT_EQ(scene.shape_cast(mover, {4, 0})->id, first);
  EXPECT_EQ(scene.time_of_impact(mover, Path{{4, 0}})->id, first);
  EXPECT_EQ(scene.shape_cast(mover, {4, 0}, {.except = {&first, 1}})->id, second);
}

TEST(SceneCast, WhatIsTouchedAtTheStartAndNotApproachedMayBeIgnored) {
  World scene;
  const ObjectId floor = scene.add(Box{{-9, -1}, {5, 0}});
  const ObjectId wall = scene.add(Box{{8, -9}, {9, 9}});
  const Box crate{{0, 0}, {1, 1}};
  EXPECT_EQ(ids_of(scene.shape_cast_all(crate, {14, 0})), (Ids{floor, wall}));
  EXPECT_EQ(ids_of(scene.shape_cast_all(crate, {14, 0}, {.ignore_initial_touch = true})), (Ids{wall}));
  const auto hit = scene.shape_cast(crate, {14, 0}, {.ignore_initial_touch = true});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->id, wall);
  EXPECT_EQ(hit->impact.t, 0.5);
  EXPECT_EQ(scene.shape_cast(crate, {14, -1}, {.ignore_initial_touch = true})->id, floor);  // it is approached
}

TEST(SceneCast, WhatIsTouchedAtTheStartIsTouchedAtZero) {
  World scene;
  const ObjectId floor = scene.add(HalfSpace<2, double>{{0, 1}, 0});
  const ObjectId wall = scene.add(Box{{5, -1}, {6, 9}});
  const Box crate{{0, 0}, {1, 1}};
  for (const V2& motion : {V2(9, 0), V2(0, 0), V2(0, 9)}) {
    const auto first = scene.shape_cast(crate, motion);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->id, floor);
    EXPECT_EQ(first->impact.t, 0);
    EXPECT_EQ(first->impact.normal, V2(0, -1));
  }
  EXPECT_EQ(ids_of(scene.shape_cast_all(crate, {9, 0})), (Ids{floor, wall}));
  EXPECT_EQ(ids_of(scene.shape_cast_all(crate, {0, 0})), (Ids{floor}));
  EXPECT_FALSE(scene.shape_cast(Box{{0, 2}, {1, 3}}, {0, 0}));  // a zero motion touches nothing new
  EXPECT_FALSE(scene.time_of_impact(Box{{0, 2}, {1, 3}}, Path{}));
}

TEST(SceneCast, AnObjectThatIsCastFromItsPlaceExceptsItself) {
  World scene;
  const ObjectId ball = scene.add(Ball{{0, 0}, 1});
  const ObjectId wall = scene.add(Box{{5, -1}, {6, 1}});
  const AnyShape<2, double>& shape = scene.object(ball).shape;
  EXPECT_EQ(scene.shape_cast(shape, {9, 0})->id, ball);
  EXPECT_EQ(scene.shape_cast(shape, {9, 0}, {.except = {&ball, 1}})->id, wall);
  const std::array<ObjectId, 2> both{wall, ball};
  EXPECT_FALSE(scene.shape_cast(shape, {9, 0}, {.except = both}));
  EXPECT_FALSE(scene.time_of_impact(shape, Path{{9, 0}, 1}, {.except = both}));
  EXPECT_TRUE(scene.shape_cast_all(shape, {9, 0}, {.except = both}).empty());
}

TEST(SceneCast, APredicateDecidesWhatMayBeTouched) {
  World scene;
  Ids ids;
  for (int k = 0; k < 10; ++k) {
    ids.push_back(scene.add(Ball{{3.0 * k + 3, 0}, 1}, {.user = static_cast<std::uint64_t>(k)}));
  }
  const auto is_odd = [&scene](ObjectId id) { return scene.object(id).user % 2 == 1; };
  const Ball bullet{{0, 0}, 0.5};
  EXPECT_EQ(scene.shape_cast(bullet, {99, 0}, {.predicate = is_odd})->id, ids[1]);
  EXPECT_EQ(scene.time_of_impact(bullet, Path{{99, 0}, 1}, {.predicate = is_odd})->id, ids[1]);
  EXPECT_EQ(ids_of(scene.shape_cast_all(bullet, {99, 0}, {.predicate = is_odd})),
            (Ids{ids[1], ids[3], ids[5], ids[7], ids[9]}));
  EXPECT_FALSE(scene.shape_cast(bullet, {99, 0}, {.predicate = [](ObjectId) { return false; }}));
  const auto refuse = [](ObjectId) -> bool { throw std::runtime_error("no"); };
  EXPECT_THROW(scene.shape_cast(bullet, {99, 0}, {.predicate = refuse}), std::runtime_error);
  const auto has_one_behind = [&](ObjectId id) {  // a query within a query
    return scene.shape_cast(scene.object(id).shape, {99, 0}, {.except = {&id, 1}}).has_value();
  };
  EXPECT_EQ(scene.shape_cast_all(bullet, {99, 0}, {.predicate = has_one_behind}).size(), 9U);
}

/// The objects far behind the first one, and those beside the path, are not even asked for.
TEST(SceneCast, TestsFewObjects) {
  World scene;
  for (int row = -50; row <= 50; ++row) {
    for (int k = 0; k < 100; ++k) scene.add(Ball{{3.0 * k + 3, 3.0 * row}, 1});
  }
  int asked = 0;
  const SceneQuery query{.predicate = [&asked](ObjectId) { return ++asked > 0; }};
  EXPECT_EQ(scene.shape_cast(Ball{{0, 0}, 0.5}, {300, 1}, query)->id.index, 5000U);
  EXPECT_LE(asked, 2);
  asked = 0;
  EXPECT_EQ(scene.time_of_impact(Ball{{0, 0}, 0.5}, Path{{300, 1}, 9, {0, 0}}, query)->id.index, 5000U);
  EXPECT_LE(asked, 2);
  asked = 0;
  EXPECT_FALSE(scene.shape_cast(Ball{{0, 1.5}, 0.25}, {300, 0}, query));
  EXPECT_EQ(asked, 0);
  EXPECT_EQ(scene.shape_cast_all(Ball{{0, 0}, 0.5}, {300, 0}, query).size(), 100U);
  EXPECT_LE(asked, 101);
}

template <class S>
void expect_refusals(const S& scene) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Ball ball{{0, 0}, 1};
  for (const double bad : {nan, infinity, -infinity}) {
    EXPECT_THROW(scene.shape_cast(ball, {0, bad}), std::invalid_argument);
    EXPECT_THROW(scene.shape_cast_all(ball, {bad, 0}), std::invalid_argument);
    EXPECT_THROW(scene.time_of_impact(ball, Path{{bad, 0}}), std::invalid_argument);
    EXPECT_THROW(scene.time_of_impact(ball, Path{{1, 0}, bad}), std::invalid_argument);
    EXPECT_THROW(scene.time_of_impact(ball, Path{{1, 0}, 1, {0, bad}}), std::invalid_argument);
  }
  EXPECT_THROW(scene.shape_cast(Ball{{0, 0}, -1}, {1, 0}), std::invalid_argument);
  EXPECT_THROW(scene.shape_cast_all(V2(nan, 0), {1, 0}), std::invalid_argument);
  EXPECT_THROW(scene.time_of_impact(Ball{{infinity, 0}, 1}, Path{}), std::invalid_argument);
  EXPECT_FALSE(scene.shape_cast(ball, {1, 0}));
  EXPECT_TRUE(scene.shape_cast_all(ball, {1, 0}).empty());
  EXPECT_FALSE(scene.time_of_impact(ball, Path{{1, 0}, 1}));
}

TEST(SceneCast, NonsenseIsRefused) {
  expect_refusals(World());
  expect_refusals(PlainScene<2, double>());
  try {
    World().shape_cast(Ball{{0, 0}, -1}, {1, 0});
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "Scene: the moving shape, a sphere, has a negative radius");
  }
}

template <Dim N, class T>
class Trial : public test::JudgedScene<N, T> {
 public:
  using Judged = test::JudgedScene<N, T>;
  using typename Judged::Shape;

  /// Whether the scene's answers are those of single calls, and the judge's.
  bool agrees_on_cast(const Shape& shape, const Vec<N, T>& motion) const {
    const auto expected = earliest([&](const Shape& other) { return graze::shape_cast(shape, motion, other); });
    const auto judged = this->judge().shape_cast_all(shape, motion);
    const auto first = this->scene().shape_cast(shape, motion);
    const auto first_judged = this->judge().shape_cast(shape, motion);
    return this->scene().shape_cast_all(shape, motion) == expected && are_same(judged, expected) &&
           are_same(listed(first), head(expected)) && are_same(listed(first_judged), head(expected));
  }
  bool agrees_on_time(const Shape& shape, const Motion<N, T>& motion) const {
    const auto expected =
        earliest([&](const Shape& other) { return graze::time_of_impact(shape, motion, other, Motion<N, T>{}); });
    return are_same(listed(this->scene().time_of_impact(shape, motion)), head(expected)) &&
           are_same(listed(this->judge().time_of_impact(shape, motion)), head(expected));
  }
  bool agrees_with(const Shape& shape, const Vec<N, T>& motion, LayerMask layers, std::size_t excepted) const {
    SceneQuery query{.layers = layers, .except = {&this->held(excepted).id, 1}};
    SceneQuery judged{.layers = layers, .except = {&this->held(excepted).judged, 1}};
    const bool agrees = agrees_on_queries(shape, motion, query, judged);
    query.ignore_initial_touch = true;
    judged.ignore_initial_touch = true;
    return agrees && agrees_on_queries(shape, motion, query, judged);
  }

 private:
  bool agrees_on_queries(const Shape& shape, const Vec<N, T>& motion, const SceneQuery& query,
                         const SceneQuery& judged) const {
    return are_same(this->scene().shape_cast_all(shape, motion, query),
                    this->judge().shape_cast_all(shape, motion, judged)) &&
           are_same(listed(this->scene().shape_cast(shape, motion, query)),
                    listed(this->judge().shape_cast(shape, motion, judged)));
  }

  using List = std::vector<ObjectImpact<N, T>>;

  static List listed(const std::optional<ObjectImpact<N, T>>& impact) { return impact ? List{*impact} : List{}; }
  static List head(const List& list) { return list.empty() ? List{} : List{list.front()}; }

  static bool are_same(const List& a, const List& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
      return Judged::are_same(one.id, other.id) && one.impact == other.impact;
    });
  }

  template <class Find>
  List earliest(const Find& find) const {
    List result;
    for (const ObjectId id : this->scene().ids()) {
      if (const auto impact = find(this->scene().object(id).shape)) result.push_back({id, *impact});
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const auto& a, const auto& b) { return a.impact.t < b.impact.t; });
    return result;
  }
};

template <Dim N, class T>
Turn<N, T> any_turn() {
  const auto angle = [] { return *rc::gen::element(T(0), T(0.125), T(-1), T(3), T(-7)); };
  if constexpr (N == 2) {
    return angle();
  } else {
    const T x = angle();
    const T y = angle();
    return {x, y, angle()};
  }
}

template <class SpaceType>
class SceneCastIn : public ::testing::Test {
 public:
  static constexpr Dim dimension = SpaceType::dimension;
  using Number = typename SpaceType::scalar;
};
TYPED_TEST_SUITE(SceneCastIn, test::Spaces);

/// Shapes of all types that share numbers and points, so that ties and touches at the start are common; some are moved
/// and removed between the casts. One motion in four is zero.
template <Dim N, class T>
void check_against_every_object() {
  using Shape = AnyShape<N, T>;
  const test::Source<N, T> drawn = test::draw_source<N, T>();
  const test::Source<N, T> source = test::sharing<N, T>(drawn, *drawn.point, *drawn.point);
  Trial<N, T> trial;
  for (const Shape& shape : *test::some<Shape>(12, test::any_shape_from<N, T>(source))) trial.add(shape);
  for (int round = 0; round < 3; ++round) {
    for (std::size_t k = 0; k < trial.size(); ++k) RC_LOG() << test::to_source<N, T>(trial.shape(k)) << "\n";
    const Shape shape = *test::any_shape_from<N, T>(source);
    const Vec<N, T> between = *source.point - *source.point;
    const Vec<N, T> motion = between * *rc::gen::element(T(0), T(1), T(2), T(-0.5));
    const Motion<N, T> rotating{motion, any_turn<N, T>(), *source.point};
    RC_LOG() << "cast: " << test::to_source<N, T>(shape) << ", " << test::initializer(motion) << "; rotating by "
             << test::initializer(rotating.angular) << " about " << test::initializer(rotating.center) << "\n";
    RC_ASSERT(trial.agrees_on_cast(shape, motion));
    RC_ASSERT(trial.agrees_on_time(shape, rotating));
    trial.move(0, *test::any_shape_from<N, T>(source));
    if (trial.size() > 2) trial.remove(1);
  }
}

TYPED_TEST(SceneCastIn, TouchesWhatEveryObjectSays) {
  EXPECT_TRUE(rc::check("touches what every object says",
                        [] { check_against_every_object<TypeParam::dimension, typename TypeParam::scalar>(); }));
}

/// Hundreds of small objects, so that the index has several levels, while they are moved, removed and added.
TYPED_TEST(SceneCastIn, TouchesWhatEveryObjectSaysAmongMany) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  using Shape = AnyShape<N, T>;
  test::Numbers numbers(20'261'128);
  Trial<N, T> trial;
  for (int k = 0; k < 400; ++k) {
    trial.add(test::small_shape<N, T>(numbers), {.layer = static_cast<Layer>(k % 3)});
  }
  const auto any_place = [&] {
    return static_cast<std::size_t>(numbers.between(0, static_cast<double>(trial.size())));
  };
  for (int round = 0; round < 150; ++round) {
    const Shape shape = test::small_shape<N, T>(numbers);
    const Vec<N, T> motion = numbers.point<N, T>(-20, 20) * (round % 4 == 0 ? T(0.01) : T(1));
    ASSERT_TRUE(trial.agrees_on_cast(shape, motion)) << "in round " << round;
    ASSERT_TRUE(trial.agrees_with(shape, motion, only_layer(1) | only_layer(2), any_place())) << "in round " << round;
    if (round % 3 == 0) {
      Motion<N, T> rotating{motion, Turn<N, T>(0), numbers.point<N, T>(0, 20)};
      if constexpr (N == 2) rotating.angular = static_cast<T>(numbers.between(0.04, 4));
      if constexpr (N == 3) rotating.angular = numbers.point<N, T>(-2, 2);
      ASSERT_TRUE(trial.agrees_on_time(shape, rotating)) << "in round " << round;
    }
    for (int k = 0; k < 5; ++k) trial.move(any_place(), test::small_shape<N, T>(numbers));
    if (round % 2 == 0) trial.remove(any_place());
    if (round % 3 == 0) trial.add(test::small_shape<N, T>(numbers));
  }
}

/// Boxes in a row that a ball, a box or a point passes as closely as T permits.
TYPED_TEST(SceneCastIn, MissesNoNearMiss) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::Numbers numbers(20'261'129);
  for (int round = 0; round < 60; ++round) {
    const double far = round % 2 == 0 ? 1 : 1000;
    const auto at = numbers.point<N, T>(-far, far);
    const auto motion = numbers.point<N, T>(-20, 20);
    const std::array<AnyShape<N, T>, 3> movers{at, Sphere<N, T>{at, T(0.25)}, Aabb<N, T>{at - T(0.25), at + T(0.25)}};
    const AnyShape<N, T>& mover = movers[static_cast<std::size_t>(round % 3)];
    const Aabb<N, T> box = bounds(mover);
    Trial<N, T> trial;
    for (int k = 0; k < 30; ++k) {
      const Vec<N, double> way = wide<N, T>(motion) * numbers.between(0, 1.1);
      Vec<N, T> corner;  // beside the path along the first axis, and a little before it
      for (Dim i = 0; i < N; ++i)
        corner[i] = static_cast<T>(static_cast<double>(i == 0 ? box.max[i] : box.min[i]) + way[i]);
      const Vec<N, T> other = corner + abs(numbers.point<N, T>(0.1, 0.5)) * (k % 2 == 0 ? T(1) : T(-1));
      trial.add(Aabb<N, T>{min(corner, other), max(corner, other)});
    }
    ASSERT_TRUE(trial.agrees_on_cast(mover, motion)) << "in round " << round;
    ASSERT_TRUE(trial.agrees_on_time(mover, {motion})) << "in round " << round;
  }
}

/// A point that moves is a ray.
TYPED_TEST(SceneCastIn, OfAPointIsARayCast) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::Numbers numbers(20'261'130);
  Scene<N, T> scene;
  for (int k = 0; k < 200; ++k) scene.add(Sphere<N, T>{numbers.point<N, T>(0, 20), T(1)});
  std::size_t found = 0;
  for (int round = 0; round < 50; ++round) {
    const auto point = numbers.point<N, T>(0, 20);
    const auto motion = numbers.point<N, T>(-20, 20);
    const auto impacts = scene.shape_cast_all(point, motion);
    const auto hits = scene.ray_cast_all(Ray<N, T>{point, motion}, T(1));
    ASSERT_EQ(impacts.size(), hits.size());
    for (std::size_t k = 0; k < hits.size(); ++k) ASSERT_EQ(impacts[k].id, hits[k].id);
    found += hits.size();
  }
  EXPECT_GT(found, 30U);
}

}  // namespace
}  // namespace graze::scene_cast_test
