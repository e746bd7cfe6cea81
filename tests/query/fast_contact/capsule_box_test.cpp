// SPDX-License-Identifier: MIT
// The fast contact of a 3D capsule and a box against the general method.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/fast_contact/capsule_box.hpp>
#include <graze/query/manifold.hpp>

#include "catalogue.hpp"

namespace graze::detail::capsule_touch_test {
namespace {

using V3 = Vec<3, double>;
using Pill = Capsule<3, double>;
using Box = Obb<3, double>;

const Box brick{{0, 0, 0}, {3, 2, 1}};

constexpr Feature edge{FeatureKind::edge, 0};
constexpr Feature start{FeatureKind::vertex, 0};
constexpr Feature end{FeatureKind::vertex, 1};

void expect_touch(const Pill& pill, const V3& normal, double depth, const Feature& of_box, const Feature& of_pill) {
  const FastContact<3> look = find_fast_contact(brick, pill, false);
  ASSERT_TRUE(look.is_known && look.meets);
  EXPECT_NEAR(length(look.found.normal - normal), 0, 1e-15);
  EXPECT_NEAR(look.found.depth, depth, look.found.error);
  EXPECT_NEAR(length(look.found.point_b - (look.found.point_a - normal * depth)), 0, 1e-14);
  EXPECT_EQ(look.feature_a, of_box);
  EXPECT_EQ(look.feature_b, of_pill);
  EXPECT_EQ(look.is_single, of_box.kind != FeatureKind::face);
}

TEST(CapsuleOnBox, NamesWhatLiesOnWhat) {
  const double half = std::sqrt(0.5);
  const double third = std::sqrt(1.0 / 3);
  const Feature top{FeatureKind::face, 5};
  expect_touch({{1, -1, 1.5}, {2, 0, 4}, 1}, {0, 0, 1}, 0.5, top, start);
  expect_touch({{2, 0, 4}, {1, -1, 1.5}, 1}, {0, 0, 1}, 0.5, top, end);
  expect_touch({{4, 1, 2}, {9, 1, 9}, 2}, {half, 0, half}, 2 - std::sqrt(2.0), {FeatureKind::edge, 7}, start);
  expect_touch({{9, 9, 9}, {4, 3, 2}, 2}, V3(third), 2 - std::sqrt(3.0), {FeatureKind::vertex, 7}, end);
  // Past the edge along y at +z, +x, and past the corner at +x, +y, +z.
  expect_touch({{2, 1, 4}, {6, 1, 0}, 2}, {half, 0, half}, 2 - std::sqrt(2.0), {FeatureKind::edge, 7}, edge);
  expect_touch({V3(4, 3, 2) + V3(3, -3, 0), V3(4, 3, 2) - V3(3, -3, 0), 2}, V3(third), 2 - std::sqrt(3.0),
               {FeatureKind::vertex, 7}, edge);
}

TEST(CapsuleOnBox, LeavesTheBoxByTheShortestWay) {
  const double half = std::sqrt(0.5);
  expect_touch({{0, 0, 0.5}, {1, 1, 0.7}, 0.25}, {0, 0, 1}, 0.75, {FeatureKind::face, 5}, start);
  expect_touch({{-9, 0, 0.5}, {-2.75, 0, 0.25}, 0.5}, {-1, 0, 0}, 0.75, {FeatureKind::face, 0}, end);
  // Past the edge along x at +y and +z.
  expect_touch({{0.1, -1.2, 4}, {0.2, 4, -1.2}, 0.5}, {0, half, half}, 0.5 + 0.2 * half, {FeatureKind::edge, 3}, edge);
}

void expect_pair(const SurfacePair<3>& pair, const V3& on_box, double depth, const Feature& of_box,
                 const Feature& of_pill) {
  EXPECT_NEAR(length(pair.point_a - on_box), 0, 1e-14);
  EXPECT_NEAR(pair.depth, depth, 1e-14);
  EXPECT_EQ(pair.feature_a, of_box);
  EXPECT_EQ(pair.feature_b, of_pill);
}

TEST(CapsuleOnBox, HasTwoPointsOnAFace) {
  const Feature top{FeatureKind::face, 5};
  const Feature left{FeatureKind::edge, 5};
  const Feature right{FeatureKind::edge, 7};
  std::array<SurfacePair<3>, 2> pairs;
  ASSERT_EQ(find_fast_contact(brick, Pill{{-2, 0, 1.5}, {2, 0, 3.5}, 1}, false).put_points(pairs.data()), 2U);
  expect_pair(pairs[0], {-2, 0, 1}, 0.5, top, start);
  expect_pair(pairs[1], {-1, 0, 1}, 0, top, edge);
  ASSERT_EQ(find_fast_contact(brick, Pill{{5, 0, 1.5}, {-5, 0, 1.5}, 1}, false).put_points(pairs.data()), 2U);
  expect_pair(pairs[0], {3, 0, 1}, 0.5, right, edge);
  expect_pair(pairs[1], {-3, 0, 1}, 0.5, left, edge);
  ASSERT_EQ(find_fast_contact(brick, Pill{{-5, 0, 0.875}, {2, 0, 0.75}, 1}, false).put_points(pairs.data()), 2U);
  expect_pair(pairs[1], {2, 0, 1}, 1.25, top, end);
  expect_pair(pairs[0], {-3, 0, 1}, 1.25 - 0.125 * 5 / 7, left, edge);
}

TEST(CapsuleOnBox, LyingFlatIsAsDeepAsItsEnds) {
  const Pill pill{{-2, -1, 1.5}, {2, 1, 1.5}, 1};
  const FastContact<3> look = find_fast_contact(brick, pill, false);
  ASSERT_TRUE(look.is_known && look.meets);
  EXPECT_FALSE(look.is_single);
  EXPECT_NEAR(look.found.depth, 0.5, look.found.error);
  const auto found = manifold(brick, pill);
  ASSERT_EQ(found.size, 2U);
  for (const auto& point : found.contacts()) EXPECT_NEAR(point.depth, 0.5, found.error);
}

TEST(CapsuleOnBox, IsApartWherePlainToSee) {
  const FastContact<3> past_edge = find_fast_contact(brick, Pill{{2, 1, 4}, {6, 1, 0}, 1}, false);
  EXPECT_TRUE(past_edge.is_known);
  EXPECT_FALSE(past_edge.meets);
}

TEST(CapsuleOnBox, IsNotKnownWhereItIsTooCloseToTell) {
  const auto is_known = [](const Pill& pill) { return find_fast_contact(brick, pill, false).is_known; };
  EXPECT_FALSE(is_known({{0, 0, 2}, {0, 0, 5}, 1})) << "touches";
  EXPECT_FALSE(is_known({{0, 0, 0}, {5, 0, 0}, 1})) << "equally far from two faces";
  EXPECT_FALSE(is_known({{-9, 0, 0}, {9, 0, 0}, 1})) << "its axis in the middle of the box";
  EXPECT_FALSE(is_known({{-5, 0, 1.5}, {5, 0, 1.5 + 1e-12}, 1})) << "nearly level, and longer than the face";
  EXPECT_FALSE(is_known({{-5, 2, 1.5}, {5, 2, 1.5}, 1})) << "level above an edge";
  EXPECT_FALSE(is_known({{0, 0, std::nan("")}, {0, 0, 5}, 1}));
  EXPECT_FALSE(find_fast_contact(Box{{0, 0, 0}, {3, 2, 0}}, Pill{{2, 1, 2}, {6, 1, -2}, 2}, false).is_known)
      << "a flat box";
}

// ---- Against the general method

double share() { return static_cast<double>(*test::choice(1001)) / 1000; }
V3 place() { return V3(share(), share(), share()) * 2.0 - 1.0; }

struct Drawn {
  Box box;
  Pill pill;
  double far;
};

Drawn draw() {
  const V3 axis = place();
  Mat<3, double> turn = *test::choice(4) == 0 ? Mat<3, double>(1.0)
                                              : rotation_matrix(length(axis) > 0.1 ? axis : V3(1, 0, 0), 360 * share());
  if (*test::choice(4) == 0) {  // as skew as boxes may be
    for (Dim i = 0; i < 3; ++i) turn[i] += place() * 2e-5;
  }
  const double far = *test::choice(4) == 0 ? 1e6 : 1;
  Box box{place() * far, {0.1 + share(), 0.1 + share(), 0.1 + share()}, turn};
  if (*test::choice(8) == 0) box.half_extents[static_cast<Dim>(*test::choice(3))] = 0;
  V3 low = place() * (box.half_extents + 0.5);
  for (Dim i = 0; i < 3; ++i) {
    if (*test::choice(8) == 0) low[i] = (share() < 0.5 ? -1 : 1) * box.half_extents[i] * (1 + 1e-6 * share());
  }
  V3 high = place() * (box.half_extents + 1.0);
  if (*test::choice(4) == 0) high[static_cast<Dim>(*test::choice(3))] = low[static_cast<Dim>(*test::choice(3))];
  if (*test::choice(8) == 0) high = low + place() * 1e-4;
  if (*test::choice(16) == 0) high = low;
  if (*test::choice(8) == 0) high = low + unit_axis<3>(static_cast<Dim>(*test::choice(3))) * share();
  double radius = *test::choice(8) == 0 ? 0 : share();
  if (*test::choice(4) == 0) {  // as for stacked objects
    const auto in_quarters = [](const V3& v) {
      return V3(std::round(4 * v.x), std::round(4 * v.y), std::round(4 * v.z)) / 4.0;
    };
    box.half_extents = in_quarters(box.half_extents + 0.2);
    low = in_quarters(low);
    high = in_quarters(high);
    radius = std::round(radius * 4) / 4;
  }
  return {box, {box.center + turn * low, box.center + turn * high, radius}, far};
}

template <class T>
Obb<3, T> box_like(const Box& box, const Obb<3, T>&) {
  return {Vec<3, T>(box.center), Vec<3, T>(box.half_extents), Mat<3, T>(box.axes)};
}
template <class T>
Aabb<3, T> box_like(const Box& box, const Aabb<3, T>&) {
  return {Vec<3, T>(box.center - box.half_extents), Vec<3, T>(box.center + box.half_extents)};
}

template <class V>
void expect_near(const V& quick, const V& plain, double allowed) {
  RC_ASSERT(static_cast<double>(max_abs(quick - plain)) <= allowed);
}

/// Compares the points over a face one by one.
void expect_the_same_pairs(const CapsuleResult& quick, const WideManifold<3>& plain, double allowed, double allowed_off,
                           double far) {
  std::array<SurfacePair<3>, 2> pairs;
  if (quick.put_points(pairs.data()) == 0) return;
  RC_ASSERT(plain.size == 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    // If a side is passed at a small angle, both positions are off by more than their depths there.
    const double moved = length(pairs[i].point_b - plain.pairs[i].point_b);
    RC_ASSERT(std::fabs(pairs[i].depth - plain.pairs[i].depth) <= allowed + moved + tolerance::epsilon * far);
    expect_near(pairs[i].point_a, plain.pairs[i].point_a, allowed_off);
    expect_near(pairs[i].point_b, plain.pairs[i].point_b, allowed_off);
    if (far > 1) continue;
    RC_ASSERT(pairs[i].feature_a == plain.pairs[i].feature_a);
    RC_ASSERT(pairs[i].feature_b == plain.pairs[i].feature_b);
  }
}

constexpr double least_turn = 3e-8;

/// Close to the end of an axis, the general method may find a position beside the nearest one, because rounding hides
/// that it is farther: an offset of x perpendicular to the distance d lengthens it by x^2 / 2d. The fast method is not
/// affected.
double hidden_turn(const Drawn& drawn, double depth) {
  const double distance = std::fabs(drawn.pill.radius - depth);
  const double hidden = 8 * tolerance::epsilon * (max_abs(drawn.box.half_extents) + distance);
  return std::max(least_turn, std::sqrt(2 * hidden / distance));
}

template <class BoxType>
void expect_the_same_answers() {
  using T = scalar_of<BoxType>;
  int known = 0;
  test::check_property([&known] {
    const Drawn drawn = draw();
    const Capsule<3, T> pill{Vec<3, T>(drawn.pill.a), Vec<3, T>(drawn.pill.b), static_cast<T>(drawn.pill.radius)};
    const BoxType box = box_like(drawn.box, BoxType());
    RC_LOG() << test::to_source(box) << ", " << test::to_source(pill) << "\n";
    const CapsuleResult quick = find_fast_contact(box, pill, false);
    const bool is_apart = decide(box, pill) == Relation::apart;
    if (quick.is_known) RC_ASSERT(quick.meets == !is_apart);
    RC_ASSERT(contact(box, pill).has_value() == !is_apart);
    RC_ASSERT((manifold(pill, box).size == 0) == is_apart);
    RC_PRE(quick.is_known && !is_apart);
    ++known;
    const WideManifold<3> plain = manifold_of_met(box, pill);
    const double allowed = 4 * (quick.found.error + plain.found.error);
    RC_ASSERT(std::fabs(quick.found.depth - plain.found.depth) <= allowed);
    expect_near(quick.found.normal, plain.found.normal, hidden_turn(drawn, quick.found.depth));
    const auto turned = manifold(pill, box);
    const auto same = manifold(box, pill);
    RC_ASSERT(turned.size == same.size && turned.normal == -same.normal);
    for (std::size_t i = 0; i < same.size; ++i) {
      RC_ASSERT(turned.points[i].id.a == same.points[i].id.b && turned.points[i].id.b == same.points[i].id.a);
      RC_ASSERT(turned.points[i].point_a == same.points[i].point_b);
    }
    if (same.size != plain.size) {  // after rounding, two may coincide
      RC_ASSERT(same.size == 1 && plain.size == 2);
      expect_near(plain.pairs[0].point_a, plain.pairs[1].point_a, allowed);
    }
    const double allowed_off = allowed + hidden_turn(drawn, quick.found.depth) + tolerance::epsilon * drawn.far;
    const bool is_on_face = (quick.feature_a.kind == FeatureKind::face);
    if (is_on_face) expect_the_same_pairs(quick, plain, allowed, allowed_off, drawn.far);
    if (!quick.is_single) return;  // for a capsule that lies flat, any position is as deep
    RC_ASSERT(plain.size == 1U);
    const V3 way = V3(pill.b) - V3(pill.a);
    const bool is_one_place = std::fabs(dot(way, quick.found.normal)) > 1e-7 * max_abs(way) + allowed;
    if (quick.feature_b.kind == FeatureKind::vertex && !is_one_place) return;  // also along an edge
    expect_near(quick.found.point_a, plain.found.point_a, allowed_off);
    expect_near(quick.found.point_b, plain.found.point_b, allowed_off);
    if (drawn.far > 1) return;  // the general method loses edges and vertices to rounding
    RC_ASSERT(plain.pairs[0].feature_a == quick.feature_a);
    RC_ASSERT(plain.pairs[0].feature_b == quick.feature_b);
  });
  EXPECT_GT(known, 0);
}

/// Boxes and capsules of about unit size that overlap.
template <class BoxType>
double share_with_known_points() {
  std::mt19937 random(5);
  const auto number = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto vector = [&number](double size) {
    return V3(number(-size, size), number(-size, size), number(-size, size));
  };
  int known = 0;
  int count = 0;
  while (count < 2000) {
    const Box drawn{vector(0.6), abs(vector(0.8)) + 0.01, rotation_matrix(vector(1) + V3(0, 0, 1.5), number(0, 360))};
    const BoxType box = box_like(drawn, BoxType());
    using T = scalar_of<BoxType>;
    const V3 low = vector(1.2);
    const Capsule<3, T> pill{Vec<3, T>(low), Vec<3, T>(low + vector(1)), static_cast<T>(number(0.1, 0.4))};
    if (decide(box, pill) == Relation::apart) continue;
    ++count;
    const CapsuleResult look = find_fast_contact(box, pill, false);
    std::array<SurfacePair<3>, 2> pairs;
    known += look.is_known && look.put_points(pairs.data()) > 0 ? 1 : 0;
  }
  return static_cast<double>(known) / count;
}

TEST(CapsuleOnBox, IsKnownOfNearlyAll) {
  EXPECT_GT((share_with_known_points<Obb<3, float>>()), 0.99);
  EXPECT_GT((share_with_known_points<Obb<3, double>>()), 0.99);
  EXPECT_GT((share_with_known_points<Aabb<3, float>>()), 0.99);
  EXPECT_GT((share_with_known_points<Aabb<3, double>>()), 0.99);
}

TEST(CapsuleOnBox, IsWhatAllShapesAnswer) {
  expect_the_same_answers<Obb<3, float>>();
  expect_the_same_answers<Obb<3, double>>();
  expect_the_same_answers<Aabb<3, float>>();
  expect_the_same_answers<Aabb<3, double>>();
}

}  // namespace
}  // namespace graze::detail::capsule_touch_test
