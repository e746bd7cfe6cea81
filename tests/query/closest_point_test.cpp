// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/closest_point.hpp>

#include "catalogue.hpp"
#include "query/user_shapes.hpp"

namespace graze::test::closest_point_test {
namespace {

using V2 = Vec<2, float>;
using V3 = Vec<3, float>;
using D2 = Vec<2, double>;
using D3 = Vec<3, double>;

template <class P>
struct Answer {
  P point;
  P closest;
};

template <class S, class P>
void expect(const S& shape, const std::vector<Answer<P>>& answers) {
  for (const auto& [point, closest] : answers) {
    EXPECT_EQ(closest_point(shape, point), closest) << to_source(shape) << ", " << to_source(point);
  }
}

// ---- By hand

TEST(ClosestPoint, OfBoundedShapesIsAsComputedByHand) {
  expect<V2, V2>({1, 2}, {{{5, 5}, {1, 2}}, {{1, 2}, {1, 2}}});
  expect<Segment<2>, V2>({{0, 0}, {4, 4}}, {{{4, 0}, {2, 2}}, {{-1, -2}, {0, 0}}, {{9, 3}, {4, 4}}, {{1, 1}, {1, 1}}});
  expect<Sphere<3>, V3>({{1, 2, 3}, 2}, {{{1, 2, 9}, {1, 2, 5}}, {{1, 3, 3}, {1, 3, 3}}, {{1, 2, 3}, {1, 2, 3}}});
  expect<Aabb<3>, V3>({{0, 0, 0}, {1, 2, 3}},
                      {{{2, 3, 4}, {1, 2, 3}}, {{-1, 1, 5}, {0, 1, 3}}, {{1, 1, 1}, {1, 1, 1}}});
  expect<Obb<2>, V2>({{1, 1}, {2, 1}, {{0, 1}, {-1, 0}}}, {{{5, 2}, {2, 2}}, {{-3, -9}, {0, -1}}, {{1, 2}, {1, 2}}});
  expect<Capsule<2>, V2>({{0, 0}, {4, 0}, 1},
                         {{{2, 5}, {2, 1}}, {{-3, 0}, {-1, 0}}, {{2, 0}, {2, 0}}, {{9, 0}, {5, 0}}});
  expect<Polytope<2>, V2>(convex_hull<2, float>(std::array{V2(0, 0), V2(4, 0), V2(0, 4)}),
                          {{{4, 4}, {2, 2}}, {{-1, 2}, {0, 2}}, {{6, -1}, {4, 0}}, {{1, 1}, {1, 1}}});
  expect<Polytope<3>, V3>(
      convex_hull<3, float>(std::array{V3(0, 0, 0), V3(4, 0, 0), V3(0, 4, 0), V3(0, 0, 4)}),
      {{{1, 1, -3}, {1, 1, 0}}, {{-1, -1, 9}, {0, 0, 4}}, {{4, 4, -1}, {2, 2, 0}}, {{1, 1, 1}, {1, 1, 1}}});
}

TEST(ClosestPoint, OfUnboundedShapesIsAsComputedByHand) {
  expect<Ray<2>, V2>({{1, 1}, {3, 0}}, {{{7, 5}, {7, 1}}, {{-4, 2}, {1, 1}}});
  expect<Plane<3>, V3>({{0, 0, 2}, 4}, {{{7, -5, 9}, {7, -5, 2}}, {{1, 1, -3}, {1, 1, 2}}});
  expect<HalfSpace<3>, V3>({{0, 0, 2}, 4}, {{{7, -5, 9}, {7, -5, 2}}, {{1, 1, -3}, {1, 1, -3}}});
}

TEST(ClosestPoint, OfATriangleFindsTheFaceAndEveryEdgeAndCorner) {
  expect<Triangle<3>, V3>({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{{1, 1, 5}, {1, 1, 0}},
                                                              {{-1, -1, 2}, {0, 0, 0}},
                                                              {{7, -1, 2}, {4, 0, 0}},
                                                              {{-1, 7, 2}, {0, 4, 0}},
                                                              {{2, -3, 1}, {2, 0, 0}},
                                                              {{-3, 1, 1}, {0, 1, 0}},
                                                              {{4, 4, 1}, {2, 2, 0}}});
  expect<Triangle<2>, V2>({{0, 0}, {0, 4}, {4, 0}}, {{{4, 4}, {2, 2}}, {{2, -3}, {2, 0}}, {{1, 1}, {1, 1}}});
}

TEST(ClosestPoint, OfACompoundIsThatOfItsNearestPart) {
  const auto pair = compound_of<2, float>({Circle<>{{0, 0}, 1}, compound_of<2, float>({Rect<>{{4, 0}, {5, 1}}})});
  expect<Compound<2, float>, V2>(pair, {{{2, 0}, {1, 0}}, {{3.5F, 0.5F}, {4, 0.5F}}, {{0.5F, 0}, {0.5F, 0}}});
  expect<AnyShape<2, float>, V2>(pair, {{{2, 0}, {1, 0}}});
  // 1.5 from both: the first part decides.
  expect<Compound<2, float>, V2>(pair, {{{2.5F, 0}, {1, 0}}});
  const V2 none = closest_point(Compound<2, float>(), V2(1, 2));
  EXPECT_TRUE(std::isnan(none.x) && std::isnan(none.y));
}

// ---- Errors of the usual methods

TEST(ClosestPoint, InABoxClampsEachCoordinateAgainstItsOwnBounds) {
  // Clamping y and z against the bounds of x gives (1, 1, 1).
  EXPECT_EQ(closest_point(Aabb<3>{{0, 10, 100}, {1, 11, 101}}, V3(5, 50, 500)), V3(1, 11, 101));
  EXPECT_EQ(closest_point(Aabb<3>{{0, 10, 100}, {1, 11, 101}}, V3(-5, -5, -5)), V3(0, 10, 100));
}

TEST(ClosestPoint, FromTheCenterOfASphereIsTheCenter) {
  // Scaling center - center to length r divides by zero; and for an inner point, a sphere, like a box, returns the
  // point itself.
  EXPECT_EQ(closest_point(Sphere<3>{{1, 2, 3}, 2}, V3(1, 2, 3)), V3(1, 2, 3));
  EXPECT_EQ(closest_point(Sphere<3>{{1, 2, 3}, 0}, V3(1, 2, 3)), V3(1, 2, 3));
  EXPECT_EQ(closest_point(Sphere<3>{{1, 2, 3}, 0}, V3(7, 2, 3)), V3(1, 2, 3));
}

TEST(ClosestPoint, OnASegmentOfLengthZeroIsItsPoint) {
  // The usual parameter is 0 / 0.
  EXPECT_EQ(closest_point(Segment<3>{{1, 2, 3}, {1, 2, 3}}, V3(5, 5, 5)), V3(1, 2, 3));
  EXPECT_EQ(closest_point(Segment<3>{{1, 2, 3}, {1, 2, 3}}, V3(1, 2, 3)), V3(1, 2, 3));
  EXPECT_EQ(closest_point(Capsule<2>{{1, 2}, {1, 2}, 1}, V2(5, 2)), V2(2, 2));
  EXPECT_EQ(closest_point(Capsule<2>{{1, 2}, {1, 2}, 0}, V2(5, 2)), V2(1, 2));
}

TEST(ClosestPoint, OnADegenerateTriangleIsThatOfTheSegmentOrPointThatItIs) {
  // Barycentric coordinates divide by the area.
  const Triangle<3> line{{0, 0, 0}, {1, 1, 1}, {4, 4, 4}};
  EXPECT_EQ(closest_point(line, V3(2, 2, 2)), V3(2, 2, 2));
  EXPECT_EQ(closest_point(line, V3(9, 9, 0)), V3(4, 4, 4));
  EXPECT_EQ(closest_point(line, V3(3, 3, 0)), V3(2, 2, 2));
  const V3 p(1, 2, 3);
  EXPECT_EQ(closest_point(Triangle<3>{p, p, p}, V3(4, 5, 6)), p);
  EXPECT_EQ(closest_point(Triangle<2>{{1, 2}, {1, 2}, {3, 4}}, V2(3, 2)), V2(2, 3));
}

TEST(ClosestPoint, OnBoxesOfZeroExtentStaysOnTheirFaceEdgeOrPoint) {
  const Mat<3, float> axes(1.0F);
  EXPECT_EQ(closest_point(Obb<3>{{1, 2, 3}, {1, 1, 0}, axes}, V3(9, 2, 7)), V3(2, 2, 3));
  EXPECT_EQ(closest_point(Obb<3>{{1, 2, 3}, {0, 1, 0}, axes}, V3(9, 9, 7)), V3(1, 3, 3));
  EXPECT_EQ(closest_point(Obb<3>{{1, 2, 3}, {0, 0, 0}, axes}, V3(9, 9, 7)), V3(1, 2, 3));
  EXPECT_EQ(closest_point(Aabb<3>{{1, 2, 3}, {1, 2, 3}}, V3(9, 9, 7)), V3(1, 2, 3));
}

// The result was slightly off zero, and zero is the only coordinate that a line through the origin permits there.
TEST(ClosestPoint, OfAPlaneThroughTheOriginIsOnItFromAHairAway) {
  for (const double height : {0x1p-52, 0x1p-60, 1e-200, 3e-16}) {
    for (const double length : {-2.9999999999999987, 1.0, 0.1, 7e5}) {
      const Plane<2, double> line{{0, length}, 0};
      EXPECT_EQ(closest_point(line, Vec<2, double>{0, height}), (Vec<2, double>{0, 0})) << height << ", " << length;
      const Plane<3, double> slope{{length, 3 * length, -length / 7}, 0};
      const Vec<3, double> point{height, -height / 3, 2 * height};
      EXPECT_TRUE(contains(slope, closest_point(slope, point))) << height << ", " << length;
    }
  }
}

TEST(ClosestPoint, TakesNormalsAndDirectionsOfAnyLength) {
  for (const float length : {1e-15F, 1e-3F, 1e3F, 1e15F}) {
    EXPECT_EQ(closest_point(Plane<2>{{0, length}, 2 * length}, V2(3, 7)), V2(3, 2)) << length;
    EXPECT_EQ(closest_point(HalfSpace<2>{{0, length}, 2 * length}, V2(3, 7)), V2(3, 2)) << length;
    EXPECT_EQ(closest_point(Ray<2>{{0, 2}, {length, 0}}, V2(3, 7)), V2(3, 2)) << length;
  }
}

// ---- Rounding

TEST(ClosestPoint, OfASolidIsRoundedInward) {
  // In about half of all directions the nearest float is outside.
  const Sphere<3> sphere{{0.1F, 0.2F, 0.3F}, 1};
  for (int i = 0; i < 1000; ++i) {
    const double angle = 0.001 + i;
    const V3 far(D3(std::cos(angle), std::sin(angle), 0.5 * std::cos(3 * angle)) * 7.0);
    const D3 radius = D3(closest_point(sphere, far)) - D3(sphere.center);
    EXPECT_LE(dot(radius, radius), 1 + 1e-14) << to_source(far);
    EXPECT_GE(dot(radius, radius), 1 - 1e-6) << to_source(far);
  }
}

TEST(ClosestPoint, OfALongPolygonStaysNearThoughItIsRoundedInward) {
  // Moving towards the center until inside would move along the edge by a thousand times the rounding error.
  const Mat<2, double> turn = rotation_matrix(31);
  std::vector<V2> corners;
  for (const D2 corner : {D2(-1000, -1), D2(1000, -1), D2(1000, 1), D2(-1000, 1)}) corners.emplace_back(turn * corner);
  const auto plank = convex_hull<2, float>(corners);
  for (int i = -990; i < 1000; i += 20) {
    const V2 closest = closest_point(plank, V2(turn * D2(i, 5)));
    EXPECT_TRUE(contains(plank, closest));
    const D2 back = D2(closest) * turn;
    EXPECT_NEAR(back.x, i, 5e-4) << i;
    EXPECT_NEAR(back.y, 1, 5e-4) << i;
  }
}

TEST(ClosestPoint, FromVeryFarIsStillOnTheShape) {
  const D3 far(3e15, -4e15, 1e15);
  const Triangle<3, double> triangle{{0.1, 0.2, 0.3}, {1.1, 0.3, 0.5}, {0.4, 1.7, 0.9}};
  EXPECT_TRUE(contains(triangle, closest_point(triangle, far)));
  const Plane<3, double> plane{{3e5, -4e5, 1e5}, 1e5};
  EXPECT_TRUE(contains(plane, closest_point(plane, far)));
  EXPECT_LT(max_abs(closest_point(plane, far)), 8);
  const Segment<3, double> segment{{0.1, 0.2, 0.3}, {1.1, 0.3, 0.5}};
  EXPECT_TRUE(contains(segment, closest_point(segment, far)));
}

TEST(ClosestPoint, OfNonsenseEnds) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const float x : {nan, infinity, -infinity, 3e38F}) {
    closest_point(Sphere<3>{}, V3(x, 0, 0));
    closest_point(Obb<3>{}, V3(x, 0, 0));
    closest_point(Capsule<3>{}, V3(x, x, 0));
    closest_point(HalfSpace<3>{}, V3(x, x, 0));
    closest_point(Triangle<3>{}, V3(x, 0, x));
    closest_point(Triangle<2>{}, V2(x, 0));
    closest_point(convex_hull<3, float>(std::array{V3(0, 0, 0), V3(1, 0, 0)}), V3(0, x, 0));
  }
}

TEST(ClosestPoint, OfASmallShapeIsRightFromFarAway) {
  // The squared distances to all of its points are the same up to rounding.
  for (const double side : {1.0, 1e-2, 1e-4}) {
    for (const double distance : {1e3, 1e6, 1e9}) {
      SCOPED_TRACE(testing::Message() << side << " from " << distance);
      const Triangle<3, double> triangle{{0, 0, 0}, {side, 0, 0}, {0, side, 0}};
      EXPECT_NEAR(max_abs(closest_point(triangle, D3(-distance, side / 4, distance)) - D3(0, side / 4, 0)), 0, 1e-15);
      const Triangle<2, double> flat{{0, 0}, {side, 0}, {0, side}};
      EXPECT_NEAR(max_abs(closest_point(flat, D2(-distance, side / 4)) - D2(0, side / 4)), 0, 1e-15);
      const auto square = convex_hull<2, double>(std::array{D2(0, 0), D2(side, 0), D2(side, side), D2(0, side)});
      EXPECT_NEAR(max_abs(closest_point(square, D2(distance, side / 4)) - D2(side, side / 4)), 0, 1e-15);
    }
  }
}

// ---- User-defined shapes

TEST(ClosestPoint, OfAUsersShapeIsFoundByItsSupportPoints) {
  const user::Cylinder<double> can{{0, 0, 0}, 1, 2};
  const D3 above = closest_point(can, D3(0.25, 0.5, 7));
  EXPECT_NEAR(max_abs(above - D3(0.25, 0.5, 2)), 0, 1e-6);
  const D3 beside = closest_point(can, D3(3, 4, 1));
  EXPECT_NEAR(max_abs(beside - D3(0.6, 0.8, 1)), 0, 1e-5);
  EXPECT_TRUE(contains(can, above));
  EXPECT_TRUE(contains(can, beside));
  EXPECT_EQ(closest_point(can, D3(0.5, 0.5, 1)), D3(0.5, 0.5, 1));
}

}  // namespace
}  // namespace graze::test::closest_point_test
