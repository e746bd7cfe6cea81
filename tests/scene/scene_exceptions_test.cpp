// SPDX-License-Identifier: MIT
// Excepted pairs: a scene without them is a scene whose results lack them.
#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/scene/plain_scene.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/visit_candidates.hpp>

#include "catalogue.hpp"

namespace graze::scene_exceptions_test {
namespace {

using World = Scene<2, double>;
using Ball = Sphere<2, double>;
using Pairs = std::vector<ObjectPair>;

/// Three balls that touch each other.
struct Three {
  World scene;
  ObjectId a = scene.add(Ball{{0, 0}, 2});
  ObjectId b = scene.add(Ball{{1, 0}, 2});
  ObjectId c = scene.add(Ball{{0, 1}, 2});
};

TEST(SceneExceptions, ThePairIsNotReported) {
  Three three;
  auto& [scene, a, b, c] = three;
  scene.except(c, a);
  EXPECT_TRUE(scene.excepted(a, c) && scene.excepted(c, a));
  EXPECT_FALSE(scene.excepted(a, b));
  EXPECT_EQ(scene.excepted_pairs(), (Pairs{{a, c}}));
  EXPECT_EQ(scene.pairs(), (Pairs{{a, b}, {b, c}}));
  EXPECT_EQ(scene.candidates(9), (Pairs{{a, b}, {b, c}}));
  EXPECT_EQ(scene.contacts().size(), 2U);
  EXPECT_EQ(scene.closest_pairs(9).size(), 2U);
  std::size_t visited = 0;
  visit_candidates<2, double>(scene, [&](std::span<const ObjectPair> pairs) {
    visited += pairs.size();
    return true;
  });
  EXPECT_EQ(visited, 2U);
  EXPECT_EQ(scene.update().began, (Pairs{{a, b}, {b, c}}));
  EXPECT_EQ(scene.pairs(), (Pairs{{a, b}, {b, c}}));
  EXPECT_EQ(scene.overlapping(Ball{{0, 0}, 1}).size(), 3U);  // both objects are still found
  EXPECT_EQ(scene.contacts_with(Ball{{0, 0}, 1}).size(), 3U);
}

TEST(SceneExceptions, APairThatTouchesEndsAndBeginsAgain) {
  Three three;
  auto& [scene, a, b, c] = three;
  scene.update();
  scene.except(a, b);
  EXPECT_EQ(scene.pairs(), (Pairs{{a, c}, {b, c}}));
  EXPECT_EQ(scene.update().ended, (Pairs{{a, b}}));
  EXPECT_EQ(scene.events().stayed, (Pairs{{a, c}, {b, c}}));
  EXPECT_TRUE(scene.update().ended.empty());
  scene.move(a, Ball{{0.1, 0}, 2});
  EXPECT_TRUE(scene.update().began.empty());
  scene.accept(b, a);
  EXPECT_EQ(scene.pairs(), (Pairs{{a, b}, {a, c}, {b, c}}));
  EXPECT_EQ(scene.update().began, (Pairs{{a, b}}));
  scene.except(a, b);
  scene.accept(a, b);
  EXPECT_EQ(scene.update().stayed.size(), 3U);
  EXPECT_TRUE(scene.events().began.empty() && scene.events().ended.empty());
}

TEST(SceneExceptions, AreForgottenWithAnObject) {
  Three three;
  auto& [scene, a, b, c] = three;
  scene.except(a, b);
  scene.except(c, b);
  scene.except(c, a);
  scene.update();
  scene.remove(b);
  EXPECT_EQ(scene.excepted_pairs(), (Pairs{{a, c}}));
  EXPECT_THROW(scene.excepted(a, b), std::out_of_range);
  const ObjectId d = scene.add(Ball{{1, 0}, 2});
  EXPECT_EQ(d.index, b.index);
  EXPECT_FALSE(scene.excepted(a, d));
  EXPECT_EQ(scene.update().began, (Pairs{{a, d}, {d, c}}));
}

TEST(SceneExceptions, ASnapshotKeepsIts) {
  Three three;
  auto& [scene, a, b, c] = three;
  scene.except(a, b);
  const auto before = scene.snapshot();
  World copy = scene;
  scene.accept(a, b);
  scene.except(a, c);
  EXPECT_TRUE(before->excepted(a, b));
  EXPECT_FALSE(before->excepted(a, c));
  EXPECT_EQ(before->pairs(), (Pairs{{a, c}, {b, c}}));
  EXPECT_EQ(copy.pairs(), before->pairs());
  EXPECT_EQ(scene.pairs(), (Pairs{{a, b}, {b, c}}));
  copy.accept(a, b);
  EXPECT_EQ(copy.pairs().size(), 3U);
  EXPECT_TRUE(before->excepted(a, b));
}

TEST(SceneExceptions, WithoutAChangeEverythingStaysCurrent) {
  Three three;
  auto& [scene, a, b, c] = three;
  scene.except(a, b);
  scene.update();
  scene.except(b, a);
  scene.accept(a, c);
  EXPECT_EQ(scene.update().stayed, (Pairs{{a, c}, {b, c}}));
}

template <class S>
void expect_refusals(S scene) {
  const ObjectId a = scene.add(Ball{{0, 0}, 2});
  const ObjectId gone = scene.add(Ball{{0, 0}, 2});
  scene.remove(gone);
  for (const ObjectId& bad : {gone, ObjectId{}, ObjectId{a.index, a.generation, a.owner + 1}}) {
    EXPECT_THROW(scene.except(a, bad), std::out_of_range);
    EXPECT_THROW(scene.except(bad, a), std::out_of_range);
    EXPECT_THROW(scene.accept(a, bad), std::out_of_range);
    EXPECT_THROW(static_cast<void>(scene.excepted(bad, a)), std::out_of_range);
    EXPECT_THROW(scene.except(bad, bad), std::out_of_range);
  }
  EXPECT_THROW(scene.except(a, a), std::invalid_argument);
  EXPECT_THROW(scene.accept(a, a), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(scene.excepted(a, a)), std::invalid_argument);
  EXPECT_TRUE(scene.excepted_pairs().empty());
}

TEST(SceneExceptions, NonsenseIsRefused) {
  expect_refusals(World());
  expect_refusals(PlainScene<2, double>());
  World scene;
  const ObjectId a = scene.add(Ball{});
  const ObjectId gone = scene.add(Ball{});
  scene.remove(gone);
  try {
    scene.except(a, gone);
    FAIL();
  } catch (const std::out_of_range& error) {
    EXPECT_STREQ(error.what(), "Scene: the id (index 1, generation 1) names no object any more; it was removed");
  }
}

/// `all` without the excepted pairs.
template <class Results, class PairOf>
Results without(Results all, const Pairs& excepted, const PairOf& pair_of) {
  std::erase_if(all, [&](const auto& each) {
    return std::find(excepted.begin(), excepted.end(), pair_of(each)) != excepted.end();
  });
  return all;
}

/// Of two scenes that differ in nothing else, the results differ by the excepted pairs.
template <Dim N, class T>
void check_law() {
  Scene<N, T> scene;
  for (const AnyShape<N, T>& shape : *test::some<AnyShape<N, T>>(10, test::any_shape<N, T>())) scene.add(shape);
  Scene<N, T> all = scene;
  const std::vector<ObjectId> ids = scene.ids();
  const auto any_id = [&ids] { return ids[*rc::gen::inRange<std::size_t>(0, 1000) % ids.size()]; };
  if (*rc::gen::inRange(0, 2) == 0) scene.update();
  for (int k = *rc::gen::inRange(0, 20); k > 0; --k) {
    const ObjectId a = any_id();
    const ObjectId b = any_id();
    if (a != b) *rc::gen::inRange(0, 4) == 0 ? scene.accept(a, b) : scene.except(a, b);
    if (*rc::gen::inRange(0, 5) == 0) scene.update();
  }
  const Pairs excepted = scene.excepted_pairs();
  const auto itself = [](const ObjectPair& pair) { return pair; };
  const auto member = [](const auto& each) { return each.pair; };
  RC_ASSERT(scene.pairs() == without(all.pairs(), excepted, itself));
  RC_ASSERT(scene.candidates(1) == without(all.candidates(1), excepted, itself));
  RC_ASSERT(scene.contacts() == without(all.contacts(), excepted, member));
  RC_ASSERT(scene.closest_pairs(T(1)) == without(all.closest_pairs(T(1)), excepted, member));
  const Pairs before = scene.pairs();
  scene.update();
  RC_ASSERT(scene.pairs() == before);
  Scene<N, T> fresh = all;
  for (const auto& [a, b] : excepted) fresh.except(a, b);
  RC_ASSERT(fresh.update().began == before);
}

RC_GTEST_PROP(SceneExceptions, AreRemovedFromTheResults2f, ()) { check_law<2, float>(); }
RC_GTEST_PROP(SceneExceptions, AreRemovedFromTheResults3d, ()) { check_law<3, double>(); }

}  // namespace
}  // namespace graze::scene_exceptions_test
