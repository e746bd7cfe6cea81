// SPDX-License-Identifier: MIT
// The fast contact of spheres, capsules and boxes with planes and half-spaces against the general method for convex
// shapes.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/fast_contact/half_space.hpp>
#include <graze/query/manifold.hpp>

#include "catalogue.hpp"

namespace graze::detail::level_touch_test {
namespace {

using V3 = Vec<3, double>;
const HalfSpace<3, double> ground{{0, 0, 2}, 2};  // up to z = 1

TEST(HalfSpaceContact, IsAsCalculatedByHand) {
  const FastContact<3> sphere = find_fast_contact(Sphere<3, double>{{5, 6, 1.5}, 1}, ground, false);
  ASSERT_TRUE(sphere.is_known && sphere.meets && sphere.is_single);
  EXPECT_EQ(sphere.found.normal, V3(0, 0, -1));
  EXPECT_EQ(sphere.found.depth, 0.5);
  EXPECT_EQ(sphere.found.point_a, V3(5, 6, 0.5));
  EXPECT_EQ(sphere.found.point_b, V3(5, 6, 1));
  const FastContact<3> turned = find_fast_contact(Sphere<3, double>{{5, 6, 1.5}, 1}, ground, true);
  EXPECT_EQ(turned.found.normal, V3(0, 0, 1));
  EXPECT_EQ(turned.found.point_b, V3(5, 6, 0.5));
  EXPECT_EQ(turned.feature_a, (Feature{FeatureKind::face, 0}));
  const FastContact<3> pill = find_fast_contact(ground, Capsule<3, double>{{0, 0, 4}, {3, 0, 1.75}, 1}, false);
  EXPECT_EQ(pill.found.depth, 0.25);
  EXPECT_EQ(pill.found.normal, V3(0, 0, 1));
  EXPECT_EQ(pill.found.point_b, V3(3, 0, 0.75));
}

TEST(HalfSpaceContact, OfAPlaneIsToTheNearerSide) {
  const Plane<3, double> plane = boundary(ground);
  const FastContact<3> above = find_fast_contact(Aabb<3, double>{{0, 0, 0}, {1, 1, 4}}, plane, false);
  EXPECT_EQ(above.found.depth, 1);
  EXPECT_EQ(above.found.normal, V3(0, 0, -1));
  const FastContact<3> below = find_fast_contact(Aabb<3, double>{{0, 0, -9}, {1, 1, 2}}, plane, false);
  EXPECT_EQ(below.found.depth, 1);
  EXPECT_EQ(below.found.normal, V3(0, 0, 1));
}

TEST(HalfSpaceContact, IsNotKnownWhereItIsTooCloseToTell) {
  const Plane<3, double> plane = boundary(ground);
  EXPECT_FALSE(find_fast_contact(Sphere<3, double>{{0, 0, 2}, 1}, ground, false).is_known) << "touches";
  EXPECT_TRUE(find_fast_contact(Sphere<3, double>{{0, 0, 1}, 1}, ground, false).is_known);
  EXPECT_FALSE(find_fast_contact(Sphere<3, double>{{0, 0, 1}, 1}, plane, false).is_known)
      << "both sides are equally near";
  EXPECT_FALSE(find_fast_contact(Sphere<3, double>{{0, 0, std::nan("")}, 1}, ground, false).is_known);
  EXPECT_FALSE(find_fast_contact(ground, Capsule<3, double>{{0, 0, 0}, {0, 0, std::nan("")}, 1}, false).is_known);
  EXPECT_FALSE(find_fast_contact(Aabb<3, double>{{0, 0, 0}, {1, 1, std::nan("")}}, ground, false).is_known);
  EXPECT_FALSE(
      find_fast_contact(Sphere<3, double>{{0, 0, 0}, 1}, HalfSpace<3, double>{{0, 0, 1e-90}, 1e-90}, false).is_known);
}

TEST(HalfSpaceContact, ABoxOnTheGroundStandsOnFourCorners) {
  const Obb<3, double> box{{3, 4, 1.5}, {2, 1, 0.75}, rotation_matrix(V3(0, 0, 1), 30)};
  const auto found = manifold(ground, box);
  ASSERT_EQ(found.size, 4U);
  for (const auto& point : found.contacts()) {
    EXPECT_NEAR(point.depth, 0.25, 1e-15);
    EXPECT_EQ(point.id.a, (Feature{FeatureKind::face, 0}));
    EXPECT_EQ(point.id.b.kind, FeatureKind::vertex);
    EXPECT_LT(point.id.b.index, 4U) << "of those below";
  }
}

// ---- Against the general method for convex shapes

double share() { return static_cast<double>(*test::choice(1001)) / 1000; }

template <Dim N>
Vec<N, double> place() {
  Vec<N, double> result;
  for (Dim i = 0; i < N; ++i) result[i] = 2 * share() - 1;
  return result;
}

template <Dim N>
Mat<N, double> turn() {
  if constexpr (N == 2) {
    return rotation_matrix(*test::choice(3) == 0 ? 0.0 : 360 * share());
  } else {
    const V3 axis = place<3>();
    return rotation_matrix(*test::choice(3) == 0 || length(axis) < 0.1 ? V3(0, 0, 1) : axis, 360 * share());
  }
}

template <Dim N, class T>
void draw(Sphere<N, T>& sphere, double far) {
  sphere = {Vec<N, T>(place<N>() * far), static_cast<T>(share())};
}
template <Dim N, class T>
void draw(Capsule<N, T>& capsule, double far) {
  const Vec<N, double> start = place<N>() * far;
  capsule = {Vec<N, T>(start), Vec<N, T>(start + place<N>()), static_cast<T>(share())};
}
template <Dim N, class T>
void draw(Aabb<N, T>& box, double far) {
  const Vec<N, double> center = place<N>() * far;
  const Vec<N, double> half = abs(place<N>());
  box = {Vec<N, T>(center - half), Vec<N, T>(center + half)};
}
template <Dim N, class T>
void draw(Obb<N, T>& box, double far) {
  box = {Vec<N, T>(place<N>() * far), Vec<N, T>(abs(place<N>())), Mat<N, T>(turn<N>())};
}

template <class Level, class S>
Level draw_level(const S& shape) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  Vec<N, double> normal = place<N>();
  if (*test::choice(3) == 0 || max_abs(normal) == 0) normal = unit_axis<N>(N - 1);
  normal *= std::pow(10.0, 6 * share() - 3);
  const auto box = bounds(shape);
  const Vec<N, double> through =
      Vec<N, double>(box.min) + (Vec<N, double>(box.max) - Vec<N, double>(box.min)) * place<N>();
  return {Vec<N, T>(normal), static_cast<T>(dot(normal, through))};
}

template <class Level, class S>
void expect_the_same_answers() {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  int known = 0;
  test::check_property([&] {
    const double far = *test::choice(4) == 0 ? 1e6 : 1;
    S shape;
    draw(shape, far);
    const auto level = draw_level<Level>(shape);
    RC_LOG() << test::to_source(level) << ", " << test::to_source(shape) << "\n";
    const FastContact<N> quick = fast_contact(level, shape);
    const bool is_apart = decide(level, shape) == Relation::apart;
    if (quick.is_known) RC_ASSERT(quick.meets == !is_apart);
    RC_ASSERT(contact(level, shape).has_value() == !is_apart);
    RC_PRE(quick.is_known && !is_apart);
    ++known;
    const WideManifold<N> plain = manifold_of_met(level, shape);
    const double allowed = 2 * (quick.found.error + plain.found.error);
    RC_ASSERT(std::fabs(quick.found.depth - plain.found.depth) <= allowed);
    RC_ASSERT(max_abs(quick.found.normal - plain.found.normal) <= 1e-15);
    const Vec<N, double> rest = quick.found.point_a - quick.found.point_b - quick.found.normal * quick.found.depth;
    RC_ASSERT(max_abs(rest) <= allowed);
    const auto found = manifold(level, shape);
    const auto turned = manifold(shape, level);
    RC_ASSERT(found.size == plain.size && turned.size == plain.size);
    const double ulp = static_cast<double>(std::numeric_limits<T>::epsilon());
    for (std::size_t i = 0; i < found.size; ++i) {
      RC_ASSERT(turned.points[i].id.a == found.points[i].id.b && turned.points[i].point_a == found.points[i].point_b);
      const auto same = std::find_if(plain.pairs.begin(), plain.pairs.begin() + plain.size, [&](const auto& pair) {
        return pair.feature_a == found.points[i].id.a && pair.feature_b == found.points[i].id.b;
      });
      if (same == plain.pairs.begin() + plain.size) {
        RC_ASSERT(far > 1);  // far away, rounding decides which corners a patch has
        continue;
      }
      RC_ASSERT(max_abs(Vec<N, double>(found.points[i].point_b) - same->point_b) <= allowed + ulp * (far + 4));
      RC_ASSERT(std::fabs(static_cast<double>(found.points[i].depth) - same->depth) <= allowed + 4 * ulp);
    }
  });
  EXPECT_GT(known, 0);
}

template <Dim N, class T>
void expect_the_same_of_all() {
  expect_the_same_answers<Plane<N, T>, Sphere<N, T>>();
  expect_the_same_answers<HalfSpace<N, T>, Sphere<N, T>>();
  expect_the_same_answers<Plane<N, T>, Capsule<N, T>>();
  expect_the_same_answers<HalfSpace<N, T>, Capsule<N, T>>();
  expect_the_same_answers<Plane<N, T>, Aabb<N, T>>();
  expect_the_same_answers<HalfSpace<N, T>, Aabb<N, T>>();
  expect_the_same_answers<Plane<N, T>, Obb<N, T>>();
  expect_the_same_answers<HalfSpace<N, T>, Obb<N, T>>();
}

TEST(HalfSpaceContact, IsWhatAllShapesAnswerInThePlane) {
  expect_the_same_of_all<2, float>();
  expect_the_same_of_all<2, double>();
}

TEST(HalfSpaceContact, IsWhatAllShapesAnswerInSpace) {
  expect_the_same_of_all<3, float>();
  expect_the_same_of_all<3, double>();
}

}  // namespace
}  // namespace graze::detail::level_touch_test
