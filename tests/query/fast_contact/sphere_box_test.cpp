// SPDX-License-Identifier: MIT
// The fast contact of a 3D sphere and a box against the general method.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/fast_contact/sphere_box.hpp>
#include <graze/query/manifold.hpp>

#include "catalogue.hpp"

namespace graze::detail::ball_touch_test {
namespace {

using V3 = Vec<3, double>;
using Ball = Sphere<3, double>;
using Box = Obb<3, double>;

const Box brick{{0, 0, 0}, {3, 2, 1}};

void expect_touch(const Ball& sphere, const V3& normal, double depth, const Feature& feature) {
  const FastContact<3> touch = find_fast_contact(sphere, brick, false);
  ASSERT_TRUE(touch.is_known);
  ASSERT_TRUE(touch.meets);
  EXPECT_NEAR(length(touch.found.normal - normal), 0, 1e-15);
  EXPECT_NEAR(touch.found.depth, depth, touch.found.error);
  EXPECT_NEAR(length(touch.found.point_a - (sphere.center + normal * sphere.radius)), 0, 1e-14);
  EXPECT_NEAR(length(touch.found.point_b - (touch.found.point_a - normal * depth)), 0, 1e-14);
  EXPECT_EQ(touch.feature_b, feature);
  EXPECT_TRUE(touch.is_single);
}

TEST(BallOnBox, NamesTheFaceEdgeOrVertexThatItLiesOn) {
  expect_touch({{1, -1, 1.5}, 1}, {0, 0, -1}, 0.5, {FeatureKind::face, 5});
  expect_touch({{-3.25, 1, 0}, 0.5}, {1, 0, 0}, 0.25, {FeatureKind::face, 0});
  const double half = std::sqrt(0.5);
  expect_touch({{0, 3, -2}, 2}, {0, -half, half}, 2 - std::sqrt(2.0), {FeatureKind::edge, 1});   // along x, at +y, -z
  expect_touch({{4, 1, 2}, 2}, {-half, 0, -half}, 2 - std::sqrt(2.0), {FeatureKind::edge, 7});   // along y, at +z, +x
  expect_touch({{-4, 3, 0}, 2}, {half, -half, 0}, 2 - std::sqrt(2.0), {FeatureKind::edge, 10});  // along z, at -x, +y
  const double third = std::sqrt(1.0 / 3);
  expect_touch({{-4, 3, 2}, 2}, {third, -third, -third}, 2 - std::sqrt(3.0), {FeatureKind::vertex, 6});
}

TEST(BallOnBox, LeavesFromInsideThroughTheNearestFace) {
  expect_touch({{1, 1, -0.75}, 1}, {0, 0, 1}, 1.25, {FeatureKind::face, 4});
  expect_touch({{2.5, 0, 0.25}, 0.5}, {-1, 0, 0}, 1, {FeatureKind::face, 1});
}

TEST(BallOnBox, IsApartWhereNoPointIsNearEnough) {
  const FastContact<3> far = find_fast_contact(Ball{{4, 3, 2}, 1.7}, brick, false);
  EXPECT_TRUE(far.is_known);
  EXPECT_FALSE(far.meets);
}

TEST(BallOnBox, IsNotKnownWhereItIsTooCloseToTell) {
  const auto is_known = [](const Ball& sphere) { return find_fast_contact(sphere, brick, false).is_known; };
  EXPECT_FALSE(is_known({{0, 0, 2}, 1}));             // touches
  EXPECT_FALSE(is_known({{0, 0, 1}, 1}));             // its center on a face
  EXPECT_FALSE(is_known({{3, 0, 1.5}, 1}));           // above the line between face and edge
  EXPECT_FALSE(is_known({{0, 0, 0}, 1}));             // two faces are equally near
  EXPECT_FALSE(is_known({{2.5, 1.5, 0}, 1}));         // two faces are equally near
  EXPECT_FALSE(is_known({{0, 0, std::nan("")}, 1}));  // invalid
  EXPECT_FALSE(find_fast_contact(Ball{{0, 0, 0.5}, 1}, Box{{0, 0, 0}, {3, 2, 0}}, false).is_known);  // a flat box
}

// ---- Against the general method

double share() { return static_cast<double>(*test::choice(1001)) / 1000; }

std::pair<Ball, Box> draw() {
  const V3 axis = V3(share(), share(), share()) - 0.5;
  const Mat<3, double> turn = *test::choice(4) == 0
                                  ? Mat<3, double>(1.0)
                                  : rotation_matrix(length(axis) > 0.1 ? axis : V3(1, 0, 0), 360 * share());
  const double far = *test::choice(4) == 0 ? 1e6 : 1;
  Box drawn{V3(share(), share(), share()) * far, {0.1 + share(), 0.1 + share(), 0.1 + share()}, turn};
  if (*test::choice(8) == 0) drawn.half_extents[static_cast<Dim>(*test::choice(3))] = 0;
  V3 place = (V3(share(), share(), share()) * 2.0 - 1.0) * (drawn.half_extents + 0.5);
  for (Dim i = 0; i < 3; ++i) {
    if (*test::choice(8) == 0) place[i] = (share() < 0.5 ? -1 : 1) * drawn.half_extents[i] * (1 + 1e-6 * share());
  }
  return {{drawn.center + turn * place, *test::choice(8) == 0 ? 0 : share()}, drawn};
}

template <class T>
void expect_near(const Vec<3, T>& quick, const Vec<3, T>& plain, double allowed) {
  RC_ASSERT(static_cast<double>(max_abs(quick - plain)) <= allowed);
}

template <class T>
Obb<3, T> box_like(const Box& box, const Obb<3, T>&) {
  return {Vec<3, T>(box.center), Vec<3, T>(box.half_extents), Mat<3, T>(box.axes)};
}
template <class T>
Aabb<3, T> box_like(const Box& box, const Aabb<3, T>&) {
  return {Vec<3, T>(box.center - box.half_extents), Vec<3, T>(box.center + box.half_extents)};
}

/// The general answers, without the fast method. A point of the box may be off by the orthonormality error of its axes.
template <class BoxType>
void expect_the_same_answers() {
  using T = scalar_of<BoxType>;
  int known = 0;
  test::check_property([&known] {
    const auto [wide_ball, wide_box] = draw();
    const Sphere<3, T> sphere{Vec<3, T>(wide_ball.center), static_cast<T>(wide_ball.radius)};
    const BoxType box = box_like(wide_box, BoxType());
    RC_LOG() << test::to_source(sphere) << ", " << test::to_source(box) << "\n";
    const FastContact<3> quick = find_fast_contact(sphere, box, false);
    const bool is_apart = decide(sphere, box) == Relation::apart;
    if (quick.is_known) RC_ASSERT(quick.meets == !is_apart);
    RC_ASSERT(contact(sphere, box).has_value() == !is_apart);
    RC_ASSERT((manifold(box, sphere).size == 0) == is_apart);
    RC_PRE(quick.is_known && !is_apart);
    ++known;
    const WideManifold<3> plain = manifold_of_met(sphere, box);
    const double allowed = 4 * (quick.found.error + plain.found.error);
    RC_ASSERT(std::fabs(quick.found.depth - plain.found.depth) <= allowed);
    expect_near(quick.found.normal, plain.found.normal, 1e-9);
    const double allowed_off =
        allowed + 1e-9 * wide_ball.radius + tolerance::epsilon * static_cast<double>(max_abs(sphere.center));
    expect_near(quick.found.point_a, plain.found.point_a, allowed_off);
    expect_near(quick.found.point_b, plain.found.point_b, allowed_off + 1e-9 * plain.found.depth);
    RC_ASSERT(plain.size == 1U);
    RC_ASSERT(plain.pairs[0].feature_a == (Feature{FeatureKind::vertex, 0}));
    // Far from the origin the general method loses edges and vertices to rounding.
    if (max_abs(wide_box.center) <= 1) RC_ASSERT(plain.pairs[0].feature_b == quick.feature_b);
    const auto turned = manifold(box, sphere);
    RC_ASSERT(turned.points[0].id == (ContactId{quick.feature_b, {FeatureKind::vertex, 0}}));
    RC_ASSERT(turned.normal == -manifold(sphere, box).normal);
  });
  EXPECT_GT(known, 0);
}

TEST(BallOnBox, IsWhatAllShapesAnswer) {
  expect_the_same_answers<Obb<3, float>>();
  expect_the_same_answers<Obb<3, double>>();
  expect_the_same_answers<Aabb<3, float>>();
  expect_the_same_answers<Aabb<3, double>>();
}

}  // namespace
}  // namespace graze::detail::ball_touch_test
