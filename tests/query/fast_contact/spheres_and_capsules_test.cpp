// SPDX-License-Identifier: MIT
// The fast contact of spheres and capsules against the general method.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <gtest/gtest.h>

#include <graze/query/contact.hpp>
#include <graze/query/fast_contact/spheres_and_capsules.hpp>
#include <graze/query/manifold.hpp>

#include "catalogue.hpp"

namespace graze::detail::round_touch_test {
namespace {

using V3 = Vec<3, double>;
using Ball = Sphere<3, double>;
using Pill = Capsule<3, double>;

constexpr Feature edge{FeatureKind::edge, 0};
constexpr Feature start{FeatureKind::vertex, 0};
constexpr Feature end{FeatureKind::vertex, 1};

template <class A, class B>
void expect_touch(const A& a, const B& b, const V3& normal, double depth, const Feature& of_a, const Feature& of_b) {
  const FastContact<3> look = find_fast_contact(a, b, false);
  ASSERT_TRUE(look.is_known && look.meets && look.is_single);
  EXPECT_NEAR(length(look.found.normal - normal), 0, 1e-15);
  EXPECT_NEAR(look.found.depth, depth, look.found.error);
  EXPECT_NEAR(length(look.found.point_b - (look.found.point_a - normal * depth)), 0, 1e-14);
  EXPECT_EQ(look.feature_a, of_a);
  EXPECT_EQ(look.feature_b, of_b);
}

TEST(RoundTouch, IsAsCalculatedByHand) {
  const Ball sphere{{1, 2, 3}, 2};
  const Pill pill{{5, 0, 0}, {5, 10, 0}, 1};
  expect_touch(sphere, Ball{{1, 2, 5.5}, 1}, {0, 0, 1}, 0.5, start, start);
  expect_touch(Ball{{2.5, 4, 0}, 2}, pill, {1, 0, 0}, 0.5, start, edge);
  expect_touch(Ball{{5, -2, 0}, 1.5}, pill, {0, 1, 0}, 0.5, start, start);
  expect_touch(Ball{{5, 12, 0}, 1.5}, pill, {0, -1, 0}, 0.5, start, end);
  expect_touch(Pill{{3.5, 4, -5}, {3.5, 4, 9}, 1}, pill, {1, 0, 0}, 0.5, edge, edge);
  expect_touch(pill, Pill{{5, 11.5, 0}, {9, 11.5, 0}, 1}, {0, 1, 0}, 0.5, end, start);
}

TEST(RoundTouch, IsApartWhereNoPointIsNearEnough) {
  const FastContact<3> look = find_fast_contact(Ball{{0, 0, 0}, 1}, Ball{{3, 0, 0}, 1.9}, false);
  EXPECT_TRUE(look.is_known);
  EXPECT_FALSE(look.meets);
}

TEST(RoundTouch, IsNotKnownWhereItIsTooCloseToTell) {
  const Ball sphere{{0, 0, 0}, 1};
  const Pill pill{{-1, 0, 0}, {1, 0, 0}, 1};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(find_fast_contact(sphere, Ball{{3, 0, 0}, 2}, false).is_known) << "touching";
  EXPECT_FALSE(find_fast_contact(sphere, Ball{{0, 0, 0}, 2}, false).is_known) << "one center";
  EXPECT_FALSE(find_fast_contact(sphere, Ball{{nan, 0, 0}, 2}, false).is_known);
  EXPECT_FALSE(find_fast_contact(sphere, pill, false).is_known) << "a center on an axis";
  EXPECT_FALSE(find_fast_contact(sphere, Pill{{1, 0, 0}, {1, 0, 0}, 1}, false).is_known) << "an axis without length";
  EXPECT_FALSE(find_fast_contact(pill, Pill{{-1, 1, 0}, {1, 1.1, 0}, 1}, false).is_known) << "nearly parallel";
  EXPECT_FALSE(find_fast_contact(pill, Pill{{0, -1, 0}, {0, 1, 0}, 1}, false).is_known) << "axes that cross";
  EXPECT_FALSE(find_fast_contact(sphere, Pill{{1, 1e-11, 0}, {-1, 1e-11, 1e-6}, 1}, false).is_known) << "nearly so";
  EXPECT_FALSE(
      find_fast_contact(Ball{{-1 - 1e-13, 1, 0}, 1}, Pill{{-1 - 1e-13 - 1e-12, 0, 0}, {1, 0, 0}, 1}, false).is_single)
      << "over an end, or not";
}

// ---- Against the general method

double share() { return static_cast<double>(*test::choice(1001)) / 1000; }

template <Dim N>
Vec<N, double> place() {
  Vec<N, double> result;
  for (Dim i = 0; i < N; ++i) result[i] = 2 * share() - 1;
  return result;
}

double radius() { return *test::choice(8) == 0 ? 0 : share(); }

template <Dim N, class T>
void draw(Sphere<N, T>& sphere, const Vec<N, double>& far) {
  sphere = {Vec<N, T>(place<N>() + far), static_cast<T>(radius())};
}

template <Dim N, class T>
void draw(Capsule<N, T>& capsule, const Vec<N, double>& far) {
  const Vec<N, double> a = place<N>();
  const double length = std::pow(10.0, -6 * share());
  capsule = {Vec<N, T>(a + far), Vec<N, T>(a + place<N>() * length + far), static_cast<T>(radius())};
}

template <class V>
void expect_near(const V& quick, const V& plain, double allowed) {
  RC_ASSERT(static_cast<double>(max_abs(quick - plain)) <= allowed);
}

template <class A, class B>
void expect_the_same_answers() {
  constexpr Dim N = dimension_of<A>;
  int known = 0;
  int apart = 0;
  test::check_property([&] {
    A a;
    B b;
    const double distance = *test::choice(4) == 0 ? 1e6 : 1;
    const Vec<N, double> far = place<N>() * distance;
    draw(a, far);
    draw(b, far);
    RC_LOG() << test::to_source(a) << ", " << test::to_source(b) << "\n";
    const FastContact<N> quick = find_fast_contact(a, b, false);
    const bool is_apart = decide(a, b) == Relation::apart;
    if (quick.is_known) RC_ASSERT(quick.meets == !is_apart);
    if (quick.is_known && is_apart) ++apart;
    RC_ASSERT(contact(a, b).has_value() == !is_apart);
    RC_ASSERT((manifold(b, a).size == 0) == is_apart);
    RC_PRE(quick.is_known && !is_apart);
    ++known;
    const WideManifold<N> plain = manifold_of_met(a, b);
    const double allowed = 4 * (quick.found.error + plain.found.error);
    RC_ASSERT(std::fabs(quick.found.depth - plain.found.depth) <= allowed);
    // Close to the end of an axis the general method may be off by this much; the fast one is not.
    expect_near(quick.found.normal, plain.found.normal, 3e-8);
    const double allowed_off = allowed + 3e-8 + tolerance::epsilon * distance;
    expect_near(quick.found.point_a, plain.found.point_a, allowed_off);
    expect_near(quick.found.point_b, plain.found.point_b, allowed_off);
    const auto turned = manifold(b, a);
    const auto same = manifold(a, b);
    RC_ASSERT(turned.size == same.size && turned.normal == -same.normal);
    for (std::size_t i = 0; i < same.size; ++i) {
      RC_ASSERT(turned.points[i].id.a == same.points[i].id.b && turned.points[i].id.b == same.points[i].id.a);
      RC_ASSERT(turned.points[i].point_a == same.points[i].point_b);
    }
    if (!quick.is_single) return;
    RC_ASSERT(plain.size == 1U);
    if (distance > 1) return;  // the general method loses ends to rounding
    RC_ASSERT(plain.pairs[0].feature_a == quick.feature_a);
    RC_ASSERT(plain.pairs[0].feature_b == quick.feature_b);
  });
  EXPECT_GT(known, 0);
  EXPECT_GT(apart, 0);
}

template <Dim N, class T>
void expect_the_same_of_all() {
  expect_the_same_answers<Sphere<N, T>, Sphere<N, T>>();
  expect_the_same_answers<Sphere<N, T>, Capsule<N, T>>();
  expect_the_same_answers<Capsule<N, T>, Capsule<N, T>>();
}

TEST(RoundTouch, IsWhatAllShapesAnswerInThePlane) {
  expect_the_same_of_all<2, float>();
  expect_the_same_of_all<2, double>();
}

TEST(RoundTouch, IsWhatAllShapesAnswerInSpace) {
  expect_the_same_of_all<3, float>();
  expect_the_same_of_all<3, double>();
}

}  // namespace
}  // namespace graze::detail::round_touch_test
