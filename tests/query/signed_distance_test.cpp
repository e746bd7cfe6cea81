// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/signed_distance.hpp>

#include "catalogue.hpp"
#include "query/user_shapes.hpp"

namespace graze::test::signed_distance_test {
namespace {

using V2 = Vec<2, float>;
using V3 = Vec<3, float>;
using D3 = Vec<3, double>;

template <class P>
struct Answer {
  P point;
  double distance;
};

template <class S, class P>
void expect(const S& shape, const std::vector<Answer<P>>& answers) {
  for (const auto& [point, distance] : answers) {
    EXPECT_EQ(signed_distance(shape, point), distance) << to_source(shape) << ", " << to_source(point);
  }
}

// ---- By hand

TEST(SignedDistance, OfSetsWithoutAnInsideIsNeverNegative) {
  expect<V2, V2>({1, 2}, {{{4, 6}, 5}, {{1, 2}, 0}});
  expect<Segment<2>, V2>({{0, 0}, {4, 0}}, {{{2, 3}, 3}, {{-3, 4}, 5}, {{7, 4}, 5}, {{2, 0}, 0}});
  expect<Segment<2>, V2>({{4, 0}, {4, 0}}, {{{7, 4}, 5}, {{4, 0}, 0}});
  expect<Ray<2>, V2>({{1, 1}, {3, 0}}, {{{7, 5}, 4}, {{-2, -3}, 5}});
  expect<Triangle<3>, V3>({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{{1, 1, 5}, 5}, {{1, 1, -5}, 5}, {{-3, 1, 4}, 5}});
}

TEST(SignedDistance, OfSolidsIsNegativeInside) {
  expect<Sphere<3>, V3>({{1, 2, 3}, 2}, {{{1, 2, 9}, 4}, {{1, 2, 4}, -1}, {{1, 2, 3}, -2}, {{1, 2, 5}, 0}});
  expect<Aabb<3>, V3>({{0, 0, 0}, {2, 4, 8}}, {{{5, 8, 4}, 5}, {{1, 2, 7}, -1}, {{1, 2, 4}, -1}, {{0, 3, 3}, 0}});
  expect<Obb<2>, V2>({{1, 1}, {2, 1}, {{0, 1}, {-1, 0}}}, {{{5, 7}, 5}, {{1, 1}, -1}, {{1, 2.5F}, -0.5F}, {{2, 1}, 0}});
  expect<Triangle<2>, V2>({{0, 0}, {8, 0}, {0, 8}}, {{{1, 2}, -1}, {{2, 1}, -1}, {{-3, -4}, 5}, {{4, 4}, 0}});
  expect<Triangle<2>, V2>({{0, 0}, {0, 8}, {8, 0}}, {{{1, 2}, -1}, {{2, 1}, -1}, {{-3, -4}, 5}, {{4, 4}, 0}});
  expect<Capsule<2>, V2>({{0, 0}, {4, 0}, 2}, {{{2, 5}, 3}, {{2, 1}, -1}, {{2, 0}, -2}, {{7, 4}, 3}, {{-1, 0}, -1}});
  expect<Polytope<2>, V2>(convex_hull<2, float>(std::array{V2(0, 0), V2(4, 0), V2(4, 4), V2(0, 4)}),
                          {{{2, 3}, -1}, {{7, 8}, 5}, {{4, 2}, 0}});
  expect<HalfSpace<3>, V3>({{0, 0, 2}, 4}, {{{7, -5, 9}, 7}, {{1, 1, -3}, -5}, {{1, 1, 2}, 0}});
}

TEST(SignedDistance, OfAPolytopeInSpaceIsItsDepthInside) {
  std::vector<V3> corners;
  for (const float x : {-1.0F, 1.0F}) {
    for (const float y : {-2.0F, 2.0F}) {
      for (const float z : {-3.0F, 3.0F}) corners.emplace_back(x, y, z);
    }
  }
  const auto box = convex_hull<3, float>(corners);
  EXPECT_NEAR(signed_distance(box, V3(0, 0, 0)), -1, 1e-6);
  EXPECT_NEAR(signed_distance(box, V3(0.25F, -1.5F, 1)), -0.5, 1e-6);
  EXPECT_NEAR(signed_distance(box, V3(4, 6, 3)), 5, 1e-6);
  EXPECT_EQ(signed_distance(box, V3(1, 0, 0)), 0);
}

TEST(SignedDistance, OfAPlaneHasTheSideOfItsNormalAndUnitsOfLength) {
  for (const float length : {1e-15F, 0.1F, 1.0F, 1e15F}) {
    expect<Plane<2>, V2>({{0, length}, 2 * length}, {{{3, 7}, 5}, {{3, -2}, -4}, {{9, 2}, 0}});
    expect<Plane<2>, V2>({{0, -length}, -2 * length}, {{{3, 7}, -5}, {{3, -2}, 4}, {{9, 2}, 0}});
  }
  EXPECT_EQ(signed_distance(Plane<3, double>{{3, 0, 4}, 10}, D3(2, 9, 6)), 4);
}

TEST(SignedDistance, OfACompoundIsTheLeastOfItsParts) {
  const auto pair = compound_of<2, float>({Circle<>{{0, 0}, 1}, compound_of<2, float>({Rect<>{{4, 0}, {6, 2}}})});
  expect<Compound<2, float>, V2>(pair, {{{2, 0}, 1}, {{3.5F, 1}, 0.5F}, {{0, 0.5F}, -0.5F}, {{5, 1}, -1}});
  // If parts overlap: the depth in the deepest, 1, although the surface of the union is 2 away.
  const auto bar = compound_of<2, float>({Rect<>{{0, 0}, {4, 2}}, Rect<>{{0, 2}, {4, 4}}, Rect<>{{0, 1}, {4, 3}}});
  expect<AnyShape<2, float>, V2>(bar, {{{2, 2}, -1}, {{7, 8}, 5}});
  EXPECT_EQ(signed_distance(Compound<2, float>(), V2(0, 0)), std::numeric_limits<float>::infinity());
}

// ---- Accuracy

TEST(SignedDistance, IsZeroOrLessExactlyWhereASolidContains) {
  const Sphere<2> sphere{{0.1F, 0.2F}, 0.7F};
  for (int i = 0; i < 2000; ++i) {
    const double angle = i;
    const V2 point(Vec<2, double>(sphere.center) + Vec<2, double>(std::cos(angle), std::sin(angle)) * 0.7);
    EXPECT_EQ(signed_distance(sphere, point) <= 0, contains(sphere, point)) << to_source(point);
  }
}

TEST(SignedDistance, NextToASurfaceIsNotLostInTheSizeOfTheShape) {
  // In float 1e6 + 0.001 is 1e6.
  EXPECT_FLOAT_EQ(signed_distance(Plane<2>{{1, 1}, 0}, V2(1e6F, std::nextafter(-1e6F, 0.0F))),
                  0.0625F / std::sqrt(2.0F));
  EXPECT_FLOAT_EQ(signed_distance(Sphere<2>{{0, 1e6F}, 1e6F}, V2(0, -1e-3F)), 1e-3F);
  EXPECT_FLOAT_EQ(signed_distance(Sphere<2>{{0, 1e6F}, 1e6F}, V2(0, 1e-3F)), -1e-3F);
  EXPECT_FLOAT_EQ(signed_distance(Capsule<2>{{-5, 1e6F}, {5, 1e6F}, 1e6F}, V2(0, -1e-3F)), 1e-3F);
}

TEST(SignedDistance, ToAPlaneInDoubleIsRightWhereItsProductsCancel) {
  // 0.1 * 3 - 0.3, each rounded: 2.8e-17 exactly, 5.6e-17 by product and difference.
  const Plane<2, double> plane{{0.1, 0}, 0.3};
  EXPECT_NEAR(signed_distance(plane, Vec<2, double>(3, 0)), 0x1p-55 / 0.1, 1e-30);
}

TEST(SignedDistance, IsNeverMinusZero) {
  EXPECT_FALSE(std::signbit(signed_distance(Aabb<2>{}, V2(1, 0))));
  EXPECT_FALSE(std::signbit(signed_distance(Obb<2>{}, V2(1, 0))));
  EXPECT_FALSE(std::signbit(signed_distance(Sphere<2>{}, V2(1, 0))));
  EXPECT_FALSE(std::signbit(signed_distance(Triangle<2>{}, V2(0, 0))));
}

TEST(SignedDistance, OfAUsersShapeIsWhatItsSupportPointsSay) {
  const user::Cylinder<double> can{{0, 0, 0}, 1, 2};
  EXPECT_NEAR(signed_distance(can, D3(3, 4, 0)), 4, 1e-10);
  EXPECT_NEAR(signed_distance(can, D3(0, 0, 5)), 3, 1e-10);
  EXPECT_NEAR(signed_distance(can, D3(0, 0, 1.75)), -0.25, 1e-10);
}

}  // namespace
}  // namespace graze::test::signed_distance_test
