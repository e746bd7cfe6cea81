// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/closest_points.hpp>

#include "query/placement.hpp"
#include "query/proximities.hpp"
#include "query/row_of_shapes.hpp"
#include "query/user_shapes.hpp"

namespace graze::test::closest_points_test {
namespace {

using V2 = Vec<2, double>;
using V3 = Vec<3, double>;
using Any3 = AnyShape<3, double>;

template <class A, class B, class V>
void expect_closest(const A& a, const B& b, const V& on_a, const V& on_b) {
  const auto found = closest_points(a, b);
  const double distance = std::sqrt(dot(on_b - on_a, on_b - on_a));
  EXPECT_NEAR(found.distance, distance, 1e-15);
  EXPECT_NEAR(length(found.point_a - on_a), 0, 1e-15);
  EXPECT_NEAR(length(found.point_b - on_b), 0, 1e-15);
  EXPECT_NEAR(length(found.normal - (on_b - on_a) / distance), 0, 1e-15);
  EXPECT_EQ(found.relation, Relation::apart);
  EXPECT_EQ(found.status, Status::converged);
  EXPECT_EQ(closest_points(b, a), detail::exchanged(found));
}

TEST(ClosestPoints, OfRoundShapesAreAsComputedByHand) {
  const Sphere<3, double> sphere{{0, 0, 0}, 1};
  const Capsule<3, double> pill{{4, -3, 0}, {4, 3, 0}, 2};
  expect_closest(V3(0, 5, 0), sphere, V3(0, 5, 0), V3(0, 1, 0));
  expect_closest(sphere, Sphere<3, double>{{3, 4, 0}, 2}, V3(0.6, 0.8, 0), V3(1.8, 2.4, 0));
  expect_closest(sphere, pill, V3(1, 0, 0), V3(2, 0, 0));
  expect_closest(Segment<3, double>{{0, 0, -1}, {0, 0, 9}}, pill, V3(0, 0, 0), V3(2, 0, 0));
  expect_closest(Ray<3, double>{{-5, 0, 4}, {1, 0, 0}}, pill, V3(4, 0, 4), V3(4, 0, 2));
  expect_closest(Aabb<3, double>{{0, 8, -1}, {1, 9, 1}}, pill, V3(1, 8, 0),
                 V3(4, 3, 0) + V3(-6, 10, 0) / std::sqrt(34.0));
}

TEST(ClosestPoints, OfFlatShapesAreAsComputedByHand) {
  const Aabb<3, double> box{{-1, -1, -1}, {1, 1, 1}};
  const Triangle<3, double> roof{{0, 0, 3}, {5, 5, 6}, {-5, -5, 6}};
  expect_closest(box, roof, V3(0, 0, 1), V3(0, 0, 3));
  expect_closest(V3(3, 4, 0), box, V3(3, 4, 0), V3(1, 1, 0));
  expect_closest(box, Aabb<3, double>{{4, 5, 0}, {6, 6, 1}}, V3(1, 1, 0.5), V3(4, 5, 0.5));
  expect_closest(Segment<3, double>{{2, 0, 9}, {2, 0, -9}}, Segment<3, double>{{4, -5, 1}, {4, 5, 1}}, V3(2, 0, 1),
                 V3(4, 0, 1));
  expect_closest(Triangle<2, double>{{0, 0}, {2, 0}, {0, 2}}, V2(2, 2), V2(1, 1), V2(2, 2));
}

TEST(ClosestPoints, OfPlanesAndHalfSpacesAreAsComputedByHand) {
  const Plane<3, double> floor{{0, 0, 2}, 4};
  const HalfSpace<3, double> ground{{0, 0, 2}, 4};
  expect_closest(Sphere<3, double>{{1, 2, 9}, 3}, floor, V3(1, 2, 6), V3(1, 2, 2));
  expect_closest(Sphere<3, double>{{1, 2, -9}, 3}, floor, V3(1, 2, -6), V3(1, 2, 2));
  expect_closest(ground, Capsule<3, double>{{1, 2, 9}, {5, 5, 12}, 3}, V3(1, 2, 2), V3(1, 2, 6));
  expect_closest(Ray<3, double>{{1, 2, 9}, {1, 0, 1}}, ground, V3(1, 2, 9), V3(1, 2, 2));
  expect_closest(Ray<3, double>{{1, 2, -9}, {1, 0, -1}}, floor, V3(1, 2, -9), V3(1, 2, 2));
  const auto hull = convex_hull<3, double>(std::vector<V3>{{0, 0, 5}, {9, 0, 7}, {0, 9, 7}, {-9, -9, 7}});
  expect_closest(floor, hull, V3(0, 0, 2), V3(0, 0, 5));
}

// Shapes of the row extend from -1 to 1 on the x axis; unbounded ones from one side only.
TEST(ClosestPoints, OfEveryPairOfTypesInARowAreTheirEnds) {
  for (std::size_t a = 0; a < row_types; ++a) {
    for (std::size_t b = 0; b < row_types; ++b) {
      const Any3 left = row_shape<3, double>(a, 1.0);
      const Any3 right = moved<3, double>(row_shape<3, double>(b, -1.0), V3(5, 0, 0));
      const auto found = closest_points_of<3, double>(left, right);
      EXPECT_NEAR(found.distance, 3, 1e-14) << shape_type_names[a] << ", " << shape_type_names[b];
      EXPECT_NEAR(found.point_a.x, 1, 1e-14) << shape_type_names[a] << ", " << shape_type_names[b];
      EXPECT_NEAR(found.point_b.x, 4, 1e-14) << shape_type_names[a] << ", " << shape_type_names[b];
      EXPECT_NEAR(length(found.normal - V3(1, 0, 0)), 0, 1e-14) << shape_type_names[a] << ", " << shape_type_names[b];
    }
  }
}

TEST(ClosestPoints, OfRoundShapesThatMeetAreInBothAndTheNormalLeadsFromCoreToCore) {
  const auto found = closest_points(Sphere<3, double>{{0, 0, 0}, 2}, Sphere<3, double>{{3, 0, 0}, 3});
  EXPECT_EQ(found.distance, 0);
  EXPECT_EQ(found.relation, Relation::overlapping);
  EXPECT_EQ(found.error, 0);
  EXPECT_EQ(found.point_a, V3(1, 0, 0));  // in the middle of 0 to 2
  EXPECT_EQ(found.point_b, found.point_a);
  EXPECT_EQ(found.normal, V3(1, 0, 0));
  const auto touching = closest_points(Sphere<3, double>{{0, 0, 0}, 2}, Aabb<3, double>{{2, -1, -1}, {4, 1, 1}});
  EXPECT_EQ(touching.relation, Relation::touching);
  EXPECT_EQ(touching.point_a, V3(2, 0, 0));
  EXPECT_EQ(touching.normal, V3(1, 0, 0));
}

TEST(ClosestPoints, OfCoresThatMeetHaveNoNormal) {
  const auto found = closest_points(Aabb<3, double>{{0, 0, 0}, {4, 4, 4}}, Aabb<3, double>{{2, 2, 4}, {8, 8, 8}});
  EXPECT_EQ(found.relation, Relation::touching);
  EXPECT_EQ(found.point_a, V3(3, 3, 4));
  EXPECT_EQ(found.normal, V3(0, 0, 0));
  const Sphere<3, double> sphere{};
  EXPECT_EQ(closest_points(sphere, sphere).normal, V3(0, 0, 0));
  EXPECT_EQ(closest_points(V3(0, 0, 0), sphere).normal, V3(0, 0, 0));
}

TEST(ClosestPoints, OfACompoundAreThoseOfItsNearestPartTheFirstOfSeveral) {
  const Any3 near = Sphere<3, double>{{4, 0, 0}, 1};
  const Any3 as_near = Sphere<3, double>{{-4, 0, 0}, 1};
  const Any3 far = Sphere<3, double>{{0, 9, 0}, 1};
  const Any3 origin = V3(0, 0, 0);
  const auto nearest_part = [&](const std::vector<Any3>& parts) {
    return closest_points_of<3, double>(origin, compound_of<3, double>(parts)).point_b;
  };
  EXPECT_EQ(nearest_part({far, near, as_near}), V3(3, 0, 0));
  EXPECT_EQ(nearest_part({far, as_near, near}), V3(-3, 0, 0));
  const Any3 inside = Sphere<3, double>{{0, 0, 1}, 1};
  const auto found = closest_points_of<3, double>(compound_of<3, double>({near, inside, far}), origin);
  EXPECT_EQ(found.relation, Relation::touching);
  EXPECT_EQ(found.point_a, V3(0, 0, 0));
}

TEST(ClosestPoints, OfACompoundWithoutPartsAreNowhere) {
  const Any3 nothing = Compound<3, double>{};
  for (const Any3& other : {Any3(V3(0, 0, 0)), nothing}) {
    const auto found = closest_points_of<3, double>(nothing, other);
    EXPECT_EQ(found.distance, std::numeric_limits<double>::infinity());
    EXPECT_EQ(found.relation, Relation::apart);
    EXPECT_TRUE(std::isnan(found.point_a.x) && std::isnan(found.point_b.x));
    EXPECT_EQ(found.normal, V3(0, 0, 0));
  }
}

TEST(ClosestPoints, OfUsersShapesAreFoundByGjk) {
  const user::Ellipsoid<double> egg{{0, 0, 0}, {3, 2, 1}};
  const auto found = closest_points(egg, Sphere<3, double>{{0, 0, 7}, 2});
  EXPECT_NEAR(found.distance, 4, 1e-11);
  EXPECT_NEAR(length(found.point_a - V3(0, 0, 1)), 0, 1e-5);
  EXPECT_NEAR(length(found.point_b - V3(0, 0, 5)), 0, 1e-5);
  const user::Cylinder<float> can{{0, 0, 0}, 1, 2};
  const auto to_plane = closest_points(can, Plane<3, float>{{0, 0, 1}, 6});
  EXPECT_EQ(to_plane.distance, 4.0F);
  EXPECT_EQ(to_plane.normal, (Vec<3, float>(0, 0, 1)));
  const auto to_ray = closest_points(Ray<3, float>{{-9, 5, 0}, {1, 0, 0}}, can);
  EXPECT_NEAR(to_ray.distance, 4.0F, 1e-5F);
  EXPECT_GT(to_ray.error, 1e-7);  // its support calculates in float
}

// Far from the origin doubles are 1e-7 apart, but results calculated from them lose nothing.
TEST(ClosestPoints, FarFromTheOriginAreAsGoodAsNearIt) {
  const V3 far(0x1p30, -0x1p30, 0x1p30);
  const Segment<3, double> along{far + V3(-1, 0, 0), far + V3(1, 0, 0)};
  const Obb<3, double> box{far + V3(0, 0, 4), {1, 1, 1}, Mat<3, double>(0.6, 0, 0.8, 0, 1, 0, -0.8, 0, 0.6)};
  const auto found = closest_points(along, box);
  EXPECT_NEAR(found.distance, 4 - 1.4, 2e-15);
  EXPECT_LE(found.error, 1e-13);
}

// A plane that crosses another at a tiny angle once got a point 1e-9 beside it.
TEST(ClosestPoints, OfNearlyParallelPlanesAreOnBoth) {
  const Plane<2, double> a{{-1.115586234173383, 1.6599600459417239}, -2};
  const Plane<2, double> b{{0.5577931262562497, -0.8299800168084045}, 0.9999999894411289};
  const auto found = closest_points(a, b);
  EXPECT_NEAR(dot(a.normal, found.point_a), a.offset, 1e-14);
  EXPECT_NEAR(dot(b.normal, found.point_a), b.offset, 1e-14);
}

// One box ends a single bit before the other begins. Relative to the other's far corner, the bit is lost.
TEST(ClosestPoints, OfBoxesOneBitApartKnowTheBit) {
  const Aabb<2, double> above{{0, 1}, {0, 3}};
  const Aabb<2, double> below{{-2.286401304093366, -4}, {1.713598695906634, 0.9999999999999996}};
  const auto found = closest_points(above, below);
  EXPECT_EQ(found.distance, 1 - 0.9999999999999996);
  EXPECT_EQ(found.normal, V2(0, -1));
}

// For the sliver that GJK ended with, the common point was once 1e-5 beside the box.
TEST(ClosestPoints, OfASliverAndABoxAreInBoth) {
  const Aabb<3, double> box{{-119670.40975183659, -0.07036795463211229, 0.05157870694539393},
                            {4744.089200361004, -0.001892105407816108, 1.17168655883947}};
  const auto sliver =
      convex_hull<3, double>(std::vector<V3>{{-70632.92364993691, 391953.7306749222, 620821.1384529023},
                                             {-54567.44762892965, -72048.26290845644, -114087.3823021474},
                                             {-54567.42563132619, -73293.6651760102, -114087.3882928305},
                                             {-54567.425486789994, -72048.26278417622, -114116.75828990107}});
  const auto found = closest_points(box, sliver);
  ASSERT_EQ(found.relation, Relation::overlapping);
  EXPECT_LE(closest_points(found.point_a, box).distance, 1e-9);
  EXPECT_LE(closest_points(found.point_a, sliver).distance, 1e-9);
}

}  // namespace
}  // namespace graze::test::closest_points_test
