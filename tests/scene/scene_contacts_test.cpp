// SPDX-License-Identifier: MIT
// The contacts of a scene, compared with the manifolds of every two objects.
#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/executor.hpp>
#include <graze/math/random/linear_congruential.hpp>
#include <graze/math/rotation.hpp>
#include <graze/query/manifold.hpp>
#include <graze/scene/plain_scene.hpp>
#include <graze/scene/scene.hpp>

#include "broad/thread_executor.hpp"
#include "catalogue.hpp"
#include "query/row_of_shapes.hpp"

namespace graze::scene_contacts_test {
namespace {

using World = Scene<2, double>;
using Box = Aabb<2, double>;
using V2 = Vec<2, double>;
using Pairs = std::vector<ObjectPair>;

TEST(SceneContacts, SayHowDeepAndWhereFromTheFirstToTheSecond) {
  World scene;
  const ObjectId floor = scene.add(HalfSpace<2, double>{{0, 1}, 0}, {.mobility = Mobility::fixed});
  const ObjectId crate = scene.add(Box{{1, -0.25}, {3, 2}});
  const ObjectId sphere = scene.add(Sphere<2, double>{{3.5, 1}, 1});
  scene.add(Sphere<2, double>{{9, 9}, 1});
  const std::vector<ObjectContact<2, double>> contacts = scene.contacts();
  ASSERT_EQ(contacts.size(), 3U);
  EXPECT_EQ(contacts[0].pair, (ObjectPair{floor, crate}));
  EXPECT_EQ(contacts[0].manifold.normal, V2(0, 1));
  ASSERT_EQ(contacts[0].manifold.size, 2U);
  for (const ManifoldPoint<2, double>& corner : contacts[0].manifold.contacts()) EXPECT_EQ(corner.depth, 0.25);
  EXPECT_NE(contacts[0].manifold.points[0].id, contacts[0].manifold.points[1].id);
  EXPECT_EQ(contacts[1].pair, (ObjectPair{floor, sphere}));
  EXPECT_EQ(contacts[1].manifold.points[0].depth, 0);
  EXPECT_EQ(contacts[1].manifold.points[0].point, V2(3.5, 0));
  EXPECT_EQ(contacts[2].pair, (ObjectPair{crate, sphere}));
  EXPECT_EQ(contacts[2].manifold.normal, V2(1, 0));
  EXPECT_EQ(contacts[2].manifold.points[0].depth, 0.5);
}

TEST(SceneContacts, KeepTheirIdsWhileThingsLieOnEachOther) {
  World scene;
  scene.add(Box{{0, 0}, {9, 1}});
  const ObjectId crate = scene.add(Box{{1, 0.875}, {3, 2}});
  const auto ids_of = [&scene] {
    std::vector<ContactId> ids;
    const std::vector<ObjectContact<2, double>> contacts = scene.contacts();
    for (const auto& point : contacts.at(0).manifold.contacts()) ids.push_back(point.id);
    return ids;
  };
  const std::vector<ContactId> before = ids_of();
  scene.move(crate, Box{{4, 0.75}, {6, 2}});
  EXPECT_EQ(before.size(), 2U);
  EXPECT_EQ(ids_of(), before);
}

TEST(SceneContacts, OfASnapshotStayWhileTheSceneMovesOn) {
  World scene;
  const ObjectId a = scene.add(Box{{0, 0}, {2, 2}});
  const ObjectId b = scene.add(Box{{1, 0}, {3, 2}});
  scene.update();
  const auto snapshot = scene.snapshot();
  const auto before = scene.contacts();
  scene.move(b, Box{{9, 0}, {11, 2}});
  EXPECT_TRUE(scene.contacts().empty());
  EXPECT_EQ(snapshot->contacts(), before);
  EXPECT_EQ(before.at(0).pair, (ObjectPair{a, b}));
}

TEST(SceneContacts, AreNoneWhereMasksForbidTouching) {
  World scene;
  scene.add(Box{}, {.layer = 1, .mask = only_layer(2)});
  scene.add(Box{}, {.layer = 1});
  EXPECT_TRUE(scene.contacts().empty());
  EXPECT_TRUE(World().contacts().empty());
}

TEST(SceneContacts, CandidatesWithAMarginReachFarther) {
  World scene;
  const ObjectId a = scene.add(Box{{0, 0}, {1, 1}});
  const ObjectId b = scene.add(Box{{1.5, 0}, {2, 1}});
  const ObjectId c = scene.add(Box{{0, 3}, {1, 4}});
  EXPECT_EQ(scene.candidates(), Pairs{});
  EXPECT_EQ(scene.candidates(0.49), Pairs{});
  EXPECT_EQ(scene.candidates(0.5), (Pairs{{a, b}}));
  EXPECT_EQ(scene.candidates(2), (Pairs{{a, b}, {a, c}, {b, c}}));
  for (const double bad : {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(scene.candidates(bad), std::invalid_argument);
  }
}

TEST(SceneContacts, WithAShapeGoFromTheShapeToTheObjects) {
  World scene;
  const ObjectId floor = scene.add(HalfSpace<2, double>{{0, 1}, 0}, {.mobility = Mobility::fixed});
  const ObjectId crate = scene.add(Box{{2, 0}, {4, 2}}, {.layer = 3, .mask = 0});
  scene.add(Sphere<2, double>{{9, 9}, 1});
  scene.add(Compound<2, double>{});
  const Box body{{1, -0.25}, {2.5, 1}};
  const std::vector<ObjectTouch<2, double>> touches = scene.contacts_with(body);
  ASSERT_EQ(touches.size(), 2U);
  EXPECT_EQ(touches[0].id, floor);
  EXPECT_EQ(touches[0].manifold.normal, V2(0, -1));
  EXPECT_EQ(touches[0].manifold.size, 2U);
  EXPECT_EQ(touches[0].manifold.points[0].depth, 0.25);
  EXPECT_EQ(touches[1].id, crate);
  EXPECT_EQ(touches[1].manifold.normal, V2(1, 0));
  EXPECT_EQ(touches[1].manifold.points[0].depth, 0.5);
  EXPECT_EQ(scene.contacts_with(body, {.layers = only_layer(3)}).at(0).id, crate);
  EXPECT_EQ(scene.contacts_with(body, {.except = {&crate, 1}}).at(0).id, floor);
  EXPECT_EQ(scene.contacts_with(body, {.predicate = [&](ObjectId id) { return id != floor; }}).at(0).id, crate);
  EXPECT_TRUE(scene.contacts_with(Box{{5, 1}, {6, 2}}).empty());
  EXPECT_TRUE(scene.contacts_with(Compound<2, double>{}).empty());
  EXPECT_EQ(scene.contacts_with(Plane<2, double>{{0, 1}, 1}).at(0).id, crate);
  EXPECT_EQ(scene.snapshot()->contacts_with(body), touches);
}

TEST(SceneContacts, WithAnInvalidShapeAreRefused) {
  const Sphere<2, double> bad{{0, 0}, -1};
  PlainScene<2, double> plain;
  EXPECT_THROW(plain.contacts_with(bad), std::invalid_argument);
  EXPECT_THROW(World().contacts_with(V2(std::numeric_limits<double>::quiet_NaN(), 0)), std::invalid_argument);
  try {
    World().contacts_with(bad);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "Scene: the shape, a sphere, has a negative radius");
  }
}

/// Whether the touches of a shape are its manifolds with each object.
template <Dim N, class T>
bool touches_what_each_object_says(const Scene<N, T>& scene, const AnyShape<N, T>& shape) {
  std::vector<ObjectTouch<N, T>> expected;
  for (const ObjectId id : scene.ids()) {
    const Manifold<N, T> found = manifold(shape, scene.object(id).shape);
    if (found.size > 0) expected.push_back({id, found});
  }
  return scene.contacts_with(shape) == expected;
}

template <Dim N, class T>
void check_against_every_pair() {
  const auto shapes = *test::some<AnyShape<N, T>>(12, test::any_shape<N, T>());
  Scene<N, T> scene;
  for (const AnyShape<N, T>& shape : shapes) scene.add(shape);
  for (const AnyShape<N, T>& shape : shapes) RC_LOG() << test::to_source<N, T>(shape) << "\n";
  std::vector<ObjectContact<N, T>> expected;
  const std::vector<ObjectId> ids = scene.ids();
  for (std::size_t a = 0; a < ids.size(); ++a) {
    for (std::size_t b = a + 1; b < ids.size(); ++b) {
      const Manifold<N, T> found = manifold(shapes[a], shapes[b]);
      if (found.size > 0) expected.push_back({{ids[a], ids[b]}, found});
    }
  }
  RC_ASSERT(scene.contacts() == expected);
  RC_ASSERT(scene.contacts(serial_executor()) == expected);
  for (const AnyShape<N, T>& shape : shapes) RC_ASSERT((touches_what_each_object_says<N, T>(scene, shape)));
  RC_ASSERT((touches_what_each_object_says<N, T>(scene, *test::any_shape<N, T>())));
}

RC_GTEST_PROP(SceneContacts, AreTheManifoldsOfAllPairs2f, ()) { check_against_every_pair<2, float>(); }
RC_GTEST_PROP(SceneContacts, AreTheManifoldsOfAllPairs3f, ()) { check_against_every_pair<3, float>(); }
RC_GTEST_PROP(SceneContacts, AreTheManifoldsOfAllPairs2d, ()) { check_against_every_pair<2, double>(); }
RC_GTEST_PROP(SceneContacts, AreTheManifoldsOfAllPairs3d, ()) { check_against_every_pair<3, double>(); }

/// Towers of stacked boxes, rotated, every seventh arbitrarily. At the first tower there is also a shape of each type,
/// some of which meet all towers.
template <Dim N, class T>
Scene<N, T> towers() {
  Scene<N, T> scene;
  detail::LinearCongruential random;
  for (std::size_t i = 0; i < 720; ++i) {
    Vec<N, double> center(0.0);
    center[0] = 3.0 * static_cast<double>(i / 24);
    center[N - 1] = 0.95 * static_cast<double>(i % 24);
    const auto degrees = static_cast<double>(random.below(360));
    Obb<N, T> box{Vec<N, T>(center), Vec<N, T>(T(0.5))};
    if constexpr (N == 2) {
      box.axes = Mat<N, T>(rotation_matrix(degrees));
    } else {
      box.axes = Mat<N, T>(rotation_matrix(i % 7 == 0 ? Vec<3, double>(1, 2, 3) : Vec<3, double>(0, 0, 1), degrees));
    }
    scene.add(box);
    if (i % 60 == 30) scene.add(test::row_shape<N, T>(i / 60, T(-1)));
  }
  return scene;
}

template <Dim N, class T>
std::vector<ObjectContact<N, T>> contacts_of_single_calls(const Scene<N, T>& scene) {
  std::vector<ObjectContact<N, T>> result;
  for (const ObjectPair& pair : scene.pairs()) {
    result.push_back({pair, manifold(scene.object(pair.a).shape, scene.object(pair.b).shape)});
  }
  return result;
}

template <class Space>
class ContactsOfTowers : public testing::Test {};
TYPED_TEST_SUITE(ContactsOfTowers, test::Spaces);

TYPED_TEST(ContactsOfTowers, AreThoseOfSingleCallsWhoeverRunsThem) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  Scene<N, T> scene = towers<N, T>();
  const std::array<test::ThreadExecutor, 3> executors{test::ThreadExecutor(1), test::ThreadExecutor(2),
                                                      test::ThreadExecutor(7)};
  const auto expected = contacts_of_single_calls(scene);
  const auto are_boxes = [&scene](const ObjectContact<N, T>& contact) {
    return std::holds_alternative<Obb<N, T>>(scene.object(contact.pair.a).shape) &&
           std::holds_alternative<Obb<N, T>>(scene.object(contact.pair.b).shape);
  };
  const auto of_boxes = static_cast<std::size_t>(std::count_if(expected.begin(), expected.end(), are_boxes));
  EXPECT_GT(of_boxes, 600U);                    // several tasks
  EXPECT_GT(expected.size(), of_boxes + 256U);  // and as many of other kinds
  for (const bool is_updated : {false, true}) {
    if (is_updated) scene.update();
    EXPECT_TRUE(scene.contacts() == expected);
    EXPECT_TRUE(scene.contacts(serial_executor()) == expected);
    for (const test::ThreadExecutor& executor : executors) EXPECT_TRUE(scene.contacts(executor) == expected);
  }
}

TEST(SceneContacts, ThrowWhatTheExecutorThrows) {
  struct Broken final : Executor {
    void parallel_for(std::size_t, const std::function<void(std::size_t)>&) const override {
      throw std::runtime_error("no thread is left");
    }
    std::size_t concurrency() const override { return 1; }
  };
  World scene;
  scene.add(Box{});
  scene.add(Box{});
  EXPECT_THROW(scene.contacts(Broken()), std::runtime_error);
}

/// No two boxes within the margin along every axis are missed, however large the margin is.
RC_GTEST_PROP(SceneContacts, CandidatesMissNoBoxesWithinTheMargin, ()) {
  const auto shapes =
      *test::some<AnyShape<2, float>>(8, test::any_shape_at<2, float>(test::shape_index<Aabb<2, float>>));
  Scene<2, float> scene;
  for (const AnyShape<2, float>& shape : shapes) scene.add(shape);
  const std::vector<ObjectId> ids = scene.ids();
  for (std::size_t a = 0; a < ids.size(); ++a) {
    for (std::size_t b = a + 1; b < ids.size(); ++b) {
      const Aabb<2, float>& first = scene.object(ids[a]).box;
      const Aabb<2, float>& second = scene.object(ids[b]).box;
      double margin = 0;
      for (Dim i = 0; i < 2; ++i) {
        margin = std::max(margin, static_cast<double>(first.min[i]) - static_cast<double>(second.max[i]));
        margin = std::max(margin, static_cast<double>(second.min[i]) - static_cast<double>(first.max[i]));
      }
      RC_LOG() << first << " " << second << "\n";
      const Pairs found = scene.candidates(margin);
      RC_ASSERT(std::find(found.begin(), found.end(), ObjectPair{ids[a], ids[b]}) != found.end());
    }
  }
}

}  // namespace
}  // namespace graze::scene_contacts_test
