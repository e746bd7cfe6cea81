// SPDX-License-Identifier: MIT
// The nearest objects of a scene and its closest pairs, compared with the distances of all objects.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/distance.hpp>
#include <graze/scene/plain_scene.hpp>
#include <graze/scene/scene.hpp>

#include "broad/box_worlds.hpp"
#include "catalogue.hpp"
#include "scene/judged_scene.hpp"

namespace graze::scene_near_test {
namespace {

using World = Scene<2, double>;
using Ball = Sphere<2, double>;
using Box = Aabb<2, double>;
using V2 = Vec<2, double>;
using Near = std::vector<NearObject<double>>;
using NearPairs = std::vector<NearPair<double>>;

TEST(SceneNear, NearestToAShapeComeByDistance) {
  World scene;
  const ObjectId far = scene.add(Ball{{9, 0}, 1});
  const ObjectId left = scene.add(Box{{-5, -1}, {-3, 1}}, {.layer = 3});
  const ObjectId right = scene.add(Box{{3, -1}, {5, 1}});
  const ObjectId floor = scene.add(HalfSpace<2, double>{{0, 1}, -1});
  const ObjectId touched = scene.add(Ball{{0, 2}, 1});
  scene.add(Compound<2, double>{});
  const Box body{{-1, -1}, {1, 1}};
  EXPECT_EQ(scene.nearest(body, 9), (Near{{floor, 0}, {touched, 0}, {left, 2}, {right, 2}, {far, 7}}));
  EXPECT_EQ(scene.nearest(body, 3), (Near{{floor, 0}, {touched, 0}, {left, 2}}));
  EXPECT_EQ(scene.nearest(body, 0), Near{});
  EXPECT_EQ(scene.nearest(body, 9, {.layers = only_layer(3)}), (Near{{left, 2}}));
  EXPECT_EQ(scene.nearest(body, 1, {.except = {&floor, 1}}), (Near{{touched, 0}}));
  EXPECT_EQ(scene.nearest(body, 1, {.predicate = [&](ObjectId id) { return id == far; }}), (Near{{far, 7}}));
  EXPECT_EQ(scene.nearest(Plane<2, double>{{1, 0}, 9.5}, 2), (Near{{far, 0}, {floor, 0}}));
  EXPECT_EQ(scene.nearest(Compound<2, double>{}, 9), Near{});
  EXPECT_EQ(scene.snapshot()->nearest(body, 1), (Near{{floor, 0}}));
}

TEST(SceneNear, ClosestPairsAreThoseWithinADistance) {
  World scene;
  const ObjectId a = scene.add(Ball{{0, 0}, 1});
  const ObjectId b = scene.add(Ball{{3, 0}, 1}, {.layer = 1});
  const ObjectId c = scene.add(Ball{{3, 2}, 1}, {.mobility = Mobility::fixed});
  scene.add(Ball{{3, 4}, 0.5}, {.layer = 2, .mask = 0});
  const ObjectId e = scene.add(Ball{{3, 5}, 1}, {.mobility = Mobility::fixed});
  scene.add(Compound<2, double>{});
  EXPECT_EQ(scene.closest_pairs(0), (NearPairs{{{b, c}, 0}}));
  EXPECT_EQ(scene.closest_pairs(1), (NearPairs{{{a, b}, 1}, {{b, c}, 0}}));
  EXPECT_EQ(scene.closest_pairs(0.99), (NearPairs{{{b, c}, 0}}));
  EXPECT_EQ(scene.closest_pairs(3), (NearPairs{{{a, b}, 1}, {{a, c}, std::sqrt(13.0) - 2}, {{b, c}, 0}, {{b, e}, 3}}));
  EXPECT_EQ(scene.closest_pairs(std::numeric_limits<double>::max()).size(), 5U);
}

template <class S>
void expect_refusals(const S& scene) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {nan, -1.0, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(scene.closest_pairs(bad), std::invalid_argument);
  }
  EXPECT_THROW(scene.nearest(Ball{{0, 0}, -1}, 1), std::invalid_argument);
  EXPECT_THROW(scene.nearest(Ball{{nan, 0}, 1}, 0), std::invalid_argument);
  EXPECT_TRUE(scene.nearest(Ball{{0, 0}, 1}, 9).empty());
  EXPECT_TRUE(scene.closest_pairs(9).empty());
}

TEST(SceneNear, NonsenseIsRefused) {
  expect_refusals(World());
  expect_refusals(PlainScene<2, double>());
  try {
    World().nearest(Ball{{0, 0}, -1}, 1);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "Scene: the shape, a sphere, has a negative radius");
  }
}

TEST(SceneNear, AreNoneAmongObjectsWithoutPoints) {
  World scene;
  for (int k = 0; k < 100; ++k) scene.add(Compound<2, double>{});
  EXPECT_TRUE(scene.nearest({0, 0}, 2).empty());
  EXPECT_TRUE(scene.nearest(Ball{{0, 0}, 1}, 2).empty());
  const ObjectId ball = scene.add(Ball{{4, 0}, 1});
  EXPECT_EQ(scene.nearest(Ball{{0, 0}, 1}, 2), (Near{{ball, 2}}));
}

/// Objects far away are not even asked for.
TEST(SceneNear, TestsFewObjects) {
  World scene;
  for (int row = 0; row < 100; ++row) {
    for (int k = 0; k < 100; ++k) scene.add(Ball{{3.0 * k, 3.0 * row}, 1});
  }
  int asked = 0;
  const SceneQuery query{.predicate = [&asked](ObjectId) { return ++asked > 0; }};
  EXPECT_EQ(scene.nearest(Box{{150.5, 150.5}, {151, 151}}, 4, query).size(), 4U);
  EXPECT_LE(asked, 24);
}

template <Dim N, class T>
class Trial : public test::JudgedScene<N, T> {
 public:
  using Judged = test::JudgedScene<N, T>;
  using typename Judged::Shape;

  bool agrees_on_nearest(const Shape& shape) const {
    for (const std::size_t count : {std::size_t{1}, std::size_t{3}, this->scene().size()}) {
      if (!agrees_on_nearest(shape, count, {})) return false;
    }
    return agrees_on_nearest(shape, 5, {.layers = only_layer(1)});
  }

  bool agrees_on_pairs(T within) const {
    const auto found = this->scene().closest_pairs(within);
    const auto expected = this->judge().closest_pairs(within);
    return std::equal(found.begin(), found.end(), expected.begin(), expected.end(),
                      [](const NearPair<T>& a, const NearPair<T>& b) {
                        return Judged::are_same(a.pair.a, b.pair.a) && Judged::are_same(a.pair.b, b.pair.b) &&
                               a.distance == b.distance;
                      });
  }

  /// A distance of zero is a touch.
  bool agrees_with_pairs() const {
    std::vector<ObjectPair> touching;
    for (const NearPair<T>& each : this->scene().closest_pairs(T(0))) touching.push_back(each.pair);
    return touching == this->scene().pairs();
  }

 private:
  /// And the distances are those of single calls.
  bool agrees_on_nearest(const Shape& shape, std::size_t count, const SceneQuery& query) const {
    const auto found = this->scene().nearest(shape, count, query);
    const auto expected = this->judge().nearest(shape, count, query);
    return std::equal(found.begin(), found.end(), expected.begin(), expected.end(),
                      [&](const NearObject<T>& a, const NearObject<T>& b) {
                        return Judged::are_same(a.id, b.id) && a.distance == b.distance &&
                               a.distance == graze::distance(shape, this->scene().object(a.id).shape);
                      });
  }
};

template <class SpaceType>
class SceneNearIn : public ::testing::Test {};
TYPED_TEST_SUITE(SceneNearIn, test::Spaces);

/// Shapes of all types that share numbers and points, so that ties and touches are common.
template <Dim N, class T>
void check_against_every_object() {
  using Shape = AnyShape<N, T>;
  const test::Source<N, T> drawn = test::draw_source<N, T>();
  const test::Source<N, T> source = test::sharing<N, T>(drawn, *drawn.point, *drawn.point);
  Trial<N, T> trial;
  for (const Shape& shape : *test::some<Shape>(12, test::any_shape_from<N, T>(source))) {
    trial.add(shape, {.layer = static_cast<Layer>(trial.size() % 2)});
    RC_LOG() << test::to_source<N, T>(shape) << "\n";
  }
  const Shape shape = *test::any_shape_from<N, T>(source);
  RC_LOG() << "nearest to " << test::to_source<N, T>(shape) << "\n";
  RC_ASSERT(trial.agrees_on_nearest(shape));
  RC_ASSERT(trial.agrees_with_pairs());
  const Vec<N, T> between = *source.point - *source.point;
  const T within = max_abs(between);
  if (within <= std::numeric_limits<T>::max()) RC_ASSERT(trial.agrees_on_pairs(within));
}

TYPED_TEST(SceneNearIn, AreThoseOfAllObjects) {
  EXPECT_TRUE(rc::check("the nearest are those of all objects",
                        [] { check_against_every_object<TypeParam::dimension, typename TypeParam::scalar>(); }));
}

/// Hundreds of small objects, so that the index has several levels, while they are moved.
TYPED_TEST(SceneNearIn, AreThoseOfAllObjectsAmongMany) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::Numbers numbers(20'261'131);
  Trial<N, T> trial;
  for (int k = 0; k < 300; ++k) {
    trial.add(test::small_shape<N, T>(numbers),
              {.layer = static_cast<Layer>(k % 3), .mobility = k % 7 == 0 ? Mobility::fixed : Mobility::moving});
  }
  for (int round = 0; round < 40; ++round) {
    ASSERT_TRUE(trial.agrees_on_nearest(test::small_shape<N, T>(numbers))) << "in round " << round;
    if (round % 10 == 0) {
      ASSERT_TRUE(trial.agrees_on_pairs(static_cast<T>(numbers.between(0.01, 1)))) << "in round " << round;
      ASSERT_TRUE(trial.agrees_with_pairs()) << "in round " << round;
    }
    for (int k = 0; k < 5; ++k)
      trial.move(static_cast<std::size_t>(numbers.between(0, 300)), test::small_shape<N, T>(numbers));
  }
}

/// A point that is given as a shape.
TYPED_TEST(SceneNearIn, APointIsAShape) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::Numbers numbers(20'261'132);
  Scene<N, T> scene;
  for (int k = 0; k < 200; ++k) {
    const auto at = numbers.point<N, T>(0, 20);
    scene.add(Aabb<N, T>{at, at + T(0.5)});
  }
  for (int round = 0; round < 50; ++round) {
    const auto point = numbers.point<N, T>(0, 20);
    ASSERT_EQ(scene.nearest(AnyShape<N, T>(point), 5), scene.nearest(point, 5)) << "in round " << round;
  }
}

}  // namespace
}  // namespace graze::scene_near_test
