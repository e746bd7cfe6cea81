// SPDX-License-Identifier: MIT
// How much a walk looks at, counted; what it finds is held to BruteForce in spatial_index_laws.hpp.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/bvh_query.hpp>
#include <graze/broad/bvh_tree.hpp>

#include "box_worlds.hpp"
#include "bvh_checks.hpp"

namespace graze::detail::bvh_query_test {
namespace {

/// A row of unit cubes with gaps, inserted one by one from one end to the other.
template <Dim N, class T>
BvhTree<N, T> row(std::uint32_t length) {
  BvhTree<N, T> tree(0);
  for (std::uint32_t k = 0; k < length; ++k) {
    Vec<N, T> low(T(0));
    low[0] = static_cast<T>(2 * k);
    tree.insert(k, {low, low + T(1)});
  }
  return tree;
}

constexpr std::uint32_t length = 1U << 14U;

/// Two bounds a level along the path to the one that is there.
constexpr std::size_t path = 2 * 40;

TEST(BvhQuery, LooksAtOnePathForOneBox) {
  const BvhTree<2, float> tree = row<2, float>(length);
  for (std::uint32_t k = 0; k < length; k += 97) {
    const test::Effort effort = test::effort_of(tree, tree.box(k));
    EXPECT_EQ(effort.found, 1U);
    EXPECT_LE(effort.looks, path);
  }
  EXPECT_EQ(test::effort_of(tree, Aabb<2>{{0, 5}, {1e6F, 6}}).looks, 1U);
  EXPECT_EQ(test::effort_of(tree, Aabb<2>{{100, 0}, {198.5F, 1}}).found, 50U);
  EXPECT_LE(test::effort_of(tree, Aabb<2>{{100, 0}, {198.5F, 1}}).looks, 2 * 50 + 2 * path);
}

TEST(BvhQuery, EndsWhenTheVisitorDoes) {
  const BvhTree<2, float> tree = row<2, float>(1000);
  const test::CountingRegion<2, float> everything{Aabb<2>::everything()};
  int visits = 0;
  EXPECT_FALSE(visit_met(tree, everything, [&visits](std::uint32_t) { return ++visits < 3; }));
  EXPECT_EQ(visits, 3);
  EXPECT_LE(everything.looks, path);
  EXPECT_TRUE(visit_met(tree, everything, [](std::uint32_t) { return true; }));
}

TEST(BvhQuery, AFrontGivesTheLowestRankAndNodesBeforeBoxes) {
  BvhFront front;
  for (const double rank : {3.0, 1.0, 2.0, 2.0, 5.0}) front.push({rank, 7, true});
  front.push({2, 9, false});
  front.push({2, 4, true});
  std::vector<std::pair<double, std::uint32_t>> popped;
  while (!front.empty()) {
    const BvhRanked next = front.pop();
    popped.emplace_back(next.rank, next.index);
    if (popped.size() == 2) front.push({0.5, 1, true});
  }
  EXPECT_EQ(popped, (std::vector<std::pair<double, std::uint32_t>>{
                        {1, 7}, {2, 9}, {0.5, 1}, {2, 4}, {2, 7}, {2, 7}, {3, 7}, {5, 7}}));
}

/// A ray that counts the bounds it is shown.
struct CountingRay {
  RayProbe<3, double> probe;
  mutable std::size_t looks = 0;

  std::optional<double> entry(const Aabb<3, double>& box) const { return probe.entry(box); }
  std::optional<double> soonest(const Aabb<3, double>& bounds) const {
    ++looks;
    return probe.soonest(bounds);
  }
};

TEST(BvhQuery, FollowsARayOnlyAsFarAsItIsAsked) {
  const BvhTree<3, double> tree = row<3, double>(length);
  const Ray<3, double> along{{-10, 0.5, 0.5}, {1, 0, 0}};
  const CountingRay ray{RayProbe(along)};
  std::vector<std::pair<std::uint32_t, double>> hits;
  visit_along(tree, ray, [&hits](std::uint32_t slot, double t) {
    hits.emplace_back(slot, t);
    return hits.size() < 3;
  });
  EXPECT_EQ(hits, (std::vector<std::pair<std::uint32_t, double>>{{0, 10}, {1, 12}, {2, 14}}));
  EXPECT_LE(ray.looks, 2 * path);  // down to the first, and again for what follows
}

TEST(BvhQuery, TheFirstBoxOnARayTakesOnePathDown) {
  const BvhTree<3, double> tree = row<3, double>(length);
  for (const double x : {-10.0, 3.25, 30'000.5}) {
    const Ray<3, double> along{{x, 0.5, 0.5}, {1, 0, 0}};
    const CountingRay ray{RayProbe(along)};
    const std::optional<BvhHit> first = first_along(tree, ray);
    const double slot = std::max(0.0, std::ceil((x - 1) / 2));  // boxes from 2 slot to 2 slot + 1
    ASSERT_TRUE(first.has_value());
    EXPECT_EQ(first->slot, static_cast<std::uint32_t>(slot));
    EXPECT_EQ(first->t, std::max(0.0, 2 * slot - x));
    EXPECT_LE(ray.looks, path);
  }
  const Ray<3, double> beside{{-10, 0.5, 2}, {1, 0, 0}};
  EXPECT_FALSE(first_along(tree, RayProbe(beside)).has_value());
}

TEST(BvhQuery, OfBoxesOnARayAtOncePrefersTheLowestSlot) {
  for (const double margin : {0.0, 0.5}) {
    BvhTree<3, double> tree(margin);
    const Aabb<3, double> box{{4, 0, 0}, {5, 1, 1}};
    for (const std::uint32_t slot : {7U, 3U, 9U, 5U}) tree.insert(slot, box);
    tree.insert(1, {{6, 0, 0}, {7, 1, 1}});
    tree.insert(2, {{4, -1, 0}, {std::numeric_limits<double>::infinity(), 1, 1}});  // beside the tree
    const Ray<3, double> along{{0, 0.5, 0.5}, {2, 0, 0}};
    const RayProbe ray(along);
    std::vector<BvhHit> hits;
    visit_along(tree, ray, [&hits](std::uint32_t slot, double t) {
      hits.push_back({t, slot});
      return true;
    });
    EXPECT_EQ(hits, (std::vector<BvhHit>{{2, 2}, {2, 3}, {2, 5}, {2, 7}, {2, 9}, {3, 1}}));
    EXPECT_EQ(first_along(tree, ray), (BvhHit{2, 2}));
  }
}

TEST(BvhQuery, LooksForTheNearestOnlyNearby) {
  const BvhTree<3, double> tree = row<3, double>(length);
  for (const double x : {-5.0, 1.25, 20'001.5, 1e6}) {
    std::size_t offers = 0;
    double reach = std::numeric_limits<double>::infinity();
    const auto offer = [&](std::uint32_t, double distance) {
      ++offers;
      reach = std::min(reach, distance);
    };
    visit_near(tree, Vec<3, double>(x, 0.5, 0.5), offer, [&reach] { return reach; });
    const double right_of_box = std::fmod(x, 2) - 1;
    const double distance = x < 0 ? 5 : x > 1e5 ? 1e6 - 2 * length + 1 : std::min(right_of_box, 1 - right_of_box);
    EXPECT_EQ(reach, distance * distance) << x;
    EXPECT_LE(offers, 12U) << x;
  }
}

/// The bounds of boxes are entered no later than any of them.
template <class T>
void bounds_come_first(double size) {
  const auto number = rc::gen::map(rc::gen::inRange(-1000, 1001), [size](int n) { return size * n / 7; });
  const auto point = [&] {
    return Vec<3, T>(static_cast<T>(*number), static_cast<T>(*number), static_cast<T>(*number));
  };
  const Aabb<3, T> box = Aabb<3, T>::from_corners(point(), point());
  Aabb<3, T> bounds = box;
  if (*rc::gen::arbitrary<bool>()) bounds.grow(point());
  Ray<3, T> ray{point(), point()};
  if (*rc::gen::arbitrary<bool>()) ray.direction[*rc::gen::inRange(0, 3)] = T(0);
  if (*rc::gen::arbitrary<bool>()) ray.direction = box.min - ray.origin;  // at a corner
  if (!is_valid(ray)) ray.direction = Vec<3, T>(T(1));
  const RayProbe<3, T> probe(ray);
  const std::optional<double> entry = probe.entry(box);
  if (!entry) return;
  RC_ASSERT(probe.soonest(bounds).has_value());
  RC_ASSERT(*probe.soonest(bounds) <= *entry);
}

RC_GTEST_PROP(BvhQuery, ARayEntersBoundsNoLaterThanTheBoxesInThem, ()) {
  bounds_come_first<float>(*rc::gen::element(1.0, 1e-42, 1e35));
  bounds_come_first<double>(*rc::gen::element(1.0, 1e-320, 1e-300, 1e150, 1e304));
}

TEST(BvhQuery, APathOfTheTallestTreeFitsItsList) {
  // A tree of as many leaves as there may be, each child 4/5 of its node.
  double leaves = bvh_most;
  std::size_t height = 0;
  for (; leaves >= 2; leaves = std::floor(leaves * 0.8)) ++height;
  EXPECT_LE(height, bvh_height_limit);
  EXPECT_EQ(bvh_height_limit, static_cast<std::size_t>(31 * std::log(2.0) / std::log(1.25)));
}

}  // namespace
}  // namespace graze::detail::bvh_query_test
