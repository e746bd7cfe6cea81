// SPDX-License-Identifier: MIT
// The fast contact of a 3D sphere and a triangle against the general method.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include <graze/query/contact.hpp>
#include <graze/query/fast_contact/sphere_triangle.hpp>
#include <graze/query/manifold.hpp>

#include "catalogue.hpp"

namespace graze::detail::triangle_touch_test {
namespace {

using V3 = Vec<3, double>;
using Ball = Sphere<3, double>;
using Roof = Triangle<3, double>;

const Roof roof{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

void expect_touch(const Ball& sphere, const V3& normal, double depth, const Feature& feature) {
  const FastContact<3> look = find_fast_contact(sphere, roof, false);
  ASSERT_TRUE(look.is_known && look.meets && look.is_single);
  EXPECT_NEAR(length(look.found.normal - normal), 0, 1e-15);
  EXPECT_NEAR(look.found.depth, depth, look.found.error);
  EXPECT_NEAR(length(look.found.point_b - (look.found.point_a - normal * depth)), 0, 1e-14);
  EXPECT_EQ(look.feature_b, feature);
}

TEST(BallOnTriangle, NamesTheFaceSideOrCornerThatItLiesOn) {
  const double half = std::sqrt(0.5);
  expect_touch({{1, 1, 1.5}, 2}, {0, 0, -1}, 0.5, {FeatureKind::face, 0});
  expect_touch({{1, 1, -1.5}, 2}, {0, 0, 1}, 0.5, {FeatureKind::face, 0});
  expect_touch({{2, -1, 1}, 2}, {0, half, -half}, 2 - std::sqrt(2.0), {FeatureKind::edge, 0});
  expect_touch({{3, 3, 0}, 2}, {-half, -half, 0}, 2 - std::sqrt(2.0), {FeatureKind::edge, 1});
  expect_touch({{-1, 2, 1}, 2}, {half, 0, -half}, 2 - std::sqrt(2.0), {FeatureKind::edge, 2});
  expect_touch({{-1, -1, 0}, 2}, {half, half, 0}, 2 - std::sqrt(2.0), {FeatureKind::vertex, 0});
  expect_touch({{5, 0, 1}, 2}, {-half, 0, -half}, 2 - std::sqrt(2.0), {FeatureKind::vertex, 1});
  expect_touch({{0, 5.5, 0}, 2}, {0, -1, 0}, 0.5, {FeatureKind::vertex, 2});
}

TEST(BallOnTriangle, IsNotKnownWhereItIsTooCloseToTell) {
  const auto is_known = [](const Ball& sphere, const Roof& triangle) {
    return find_fast_contact(sphere, triangle, false).is_known;
  };
  EXPECT_TRUE(is_known({{1, 1, 3}, 1}, roof)) << "apart";
  EXPECT_FALSE(is_known({{1, 1, 1}, 1}, roof)) << "touches";
  EXPECT_FALSE(is_known({{1, 1, 0}, 1}, roof)) << "its center on the triangle";
  EXPECT_FALSE(is_known({{1, 1, std::nan("")}, 1}, roof));
  EXPECT_FALSE(is_known({{1, 0, 1}, 2}, Roof{{0, 0, 0}, {4, 0, 0}, {4, 0.1, 0}})) << "a needle";
  EXPECT_FALSE(is_known({{1, 0, 1}, 2}, Roof{{0, 0, 0}, {0, 0, 0}, {4, 0, 0}})) << "two corners at one place";
  EXPECT_FALSE(find_fast_contact(Ball{{2, -1e-9, 1}, 2}, roof, false).is_single) << "barely beside the face";
}

// ---- Against the general method

double share() { return static_cast<double>(*test::choice(1001)) / 1000; }
V3 place() { return V3(share(), share(), share()) * 2.0 - 1.0; }

template <class T>
void expect_the_same_answers() {
  int known = 0;
  test::check_property([&known] {
    const double far = *test::choice(4) == 0 ? 1e6 : 1;
    const V3 at = place() * far;
    const V3 a = place();
    const V3 b = place();
    const V3 c = *test::choice(4) == 0 ? a + (b - a) * share() + place() * 1e-3 : place();
    V3 center = place();
    if (*test::choice(4) == 0) center = a + (b - a) * share() + V3(0, 0, share());
    const Triangle<3, T> triangle{Vec<3, T>(a + at), Vec<3, T>(b + at), Vec<3, T>(c + at)};
    const Sphere<3, T> sphere{Vec<3, T>(center + at), static_cast<T>(*test::choice(8) == 0 ? 0 : share())};
    RC_LOG() << test::to_source(sphere) << ", " << test::to_source(triangle) << "\n";
    const FastContact<3> quick = find_fast_contact(sphere, triangle, false);
    const bool is_apart = decide(sphere, triangle) == Relation::apart;
    if (quick.is_known) RC_ASSERT(quick.meets == !is_apart);
    RC_ASSERT(contact(sphere, triangle).has_value() == !is_apart);
    RC_ASSERT((manifold(triangle, sphere).size == 0) == is_apart);
    RC_PRE(quick.is_known && !is_apart);
    ++known;
    const WideManifold<3> plain = manifold_of_met(sphere, triangle);
    const double allowed = 4 * (quick.found.error + plain.found.error);
    RC_ASSERT(std::fabs(quick.found.depth - plain.found.depth) <= allowed);
    RC_ASSERT(max_abs(quick.found.normal - plain.found.normal) <= 1e-8);
    const double allowed_off = allowed + 1e-8 + tolerance::epsilon * far;
    RC_ASSERT(max_abs(quick.found.point_a - plain.found.point_a) <= allowed_off);
    RC_ASSERT(max_abs(quick.found.point_b - plain.found.point_b) <= allowed_off);
    const auto turned = manifold(triangle, sphere);
    const auto same = manifold(sphere, triangle);
    RC_ASSERT(same.size == 1U && turned.size == 1U && plain.size == 1U);
    RC_ASSERT(turned.normal == -same.normal && turned.points[0].point_a == same.points[0].point_b);
    RC_ASSERT(turned.points[0].id.a == same.points[0].id.b);
    if (!quick.is_single || far > 1) return;  // far from the origin, rounding decides on which feature a point is
    RC_ASSERT(plain.pairs[0].feature_a == quick.feature_a);
    RC_ASSERT(plain.pairs[0].feature_b == quick.feature_b);
  });
  EXPECT_GT(known, 0);
}

TEST(BallOnTriangle, IsWhatAllShapesAnswer) {
  expect_the_same_answers<float>();
  expect_the_same_answers<double>();
}

}  // namespace
}  // namespace graze::detail::triangle_touch_test
