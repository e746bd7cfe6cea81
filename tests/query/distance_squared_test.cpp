// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iostream>

#include <gtest/gtest.h>

#include <graze/query/distance_squared.hpp>

#include "catalogue.hpp"
#include "exact.hpp"

namespace graze::test::distance_squared_test {
namespace {

TEST(DistanceSquared, OfPointsAndSegmentsIsAsComputedByHand) {
  using V2 = Vec<2, float>;
  const Segment<2, float> segment{{0, 0}, {4, 0}};
  EXPECT_EQ(distance_squared(V2(1, 2), V2(4, 6)), 25);
  EXPECT_EQ(distance_squared(V2(2, 3), segment), 9);
  EXPECT_EQ(distance_squared(V2(-3, 4), segment), 25);
  EXPECT_EQ(distance_squared(V2(7, 4), segment), 25);
  EXPECT_EQ(distance_squared(V2(7, 4), Segment<2, float>{{4, 0}, {4, 0}}), 25);
}

TEST(DistanceSquared, OfSegmentsIsAsComputedByHand) {
  using S3 = Segment<3, double>;
  const S3 along{{-1, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(distance_squared(along, S3{{0, -1, 2}, {0, 1, 2}}), 4);
  EXPECT_EQ(distance_squared(along, S3{{0, -1, 0}, {0, 1, 0}}), 0);
  EXPECT_EQ(distance_squared(along, S3{{3, 1, 2}, {3, 5, 2}}), 9);
  EXPECT_EQ(distance_squared(along, S3{{-9, 3, 4}, {9, 3, 4}}), 25);
  EXPECT_EQ(distance_squared(along, S3{{4, 0, 4}, {9, 0, 4}}), 25);
  EXPECT_EQ(distance_squared(along, S3{{4, 4, 0}, {4, 4, 0}}), 25);
  EXPECT_EQ(distance_squared(along, along), 0);
}

TEST(DistanceSquared, OfBoxesIsAsComputedByHand) {
  using V3 = Vec<3, double>;
  const Aabb<3, double> box{{-1, -1, -1}, {1, 1, 1}};
  const Obb<3, double> turned{{0, 0, 0}, {1, 1, 1}, Mat<3, double>(0, 1, 0, -1, 0, 0, 0, 0, 1)};
  EXPECT_EQ(distance_squared(V3(2, 3, 3), box), 9);
  EXPECT_EQ(distance_squared(V3(0.5, 1, 0), box), 0);
  EXPECT_EQ(distance_squared(V3(2, 3, 3), turned), 9);
  EXPECT_EQ(distance_squared(V3(0.5, 1, 0), turned), 0);
  const Segment<3, double> beside{{-9, 4, 5}, {9, 4, 5}};
  const Segment<3, double> through{{-9, 0.5, 0}, {9, 0.5, 0}};
  const Segment<3, double> at_corner{{3, 0, 1}, {0, 3, 1}};
  EXPECT_EQ(distance_squared(beside, box), 25);
  EXPECT_EQ(distance_squared(through, box), 0);
  EXPECT_NEAR(distance_squared(at_corner, box), 0.5, 1e-15);
  EXPECT_EQ(distance_squared(beside, turned), 25);
  EXPECT_EQ(distance_squared(through, turned), 0);
  EXPECT_NEAR(distance_squared(at_corner, turned), 0.5, 1e-15);
  EXPECT_EQ(distance_squared(Segment<3, double>{{2, 3, 3}, {2, 3, 3}}, box), 9);
}

TEST(DistanceSquared, OfAxisAlignedBoxesIsAsComputedByHand) {
  using Box = Aabb<2, float>;
  const Box box{{-1, -1}, {2, 1}};
  EXPECT_EQ(distance_squared(box, Box{{5, 5}, {9, 9}}), 25);
  EXPECT_EQ(distance_squared(Box{{-4, -1}, {-3, 7}}, box), 4);
  EXPECT_EQ(distance_squared(box, Box{{2, 1}, {9, 9}}), 0);
  EXPECT_EQ(distance_squared(box, Box{{1, -9}, {1, 9}}), 0);
  const Vec<2, float> point(7, -3);
  EXPECT_EQ(distance_squared(box, Box{point, point}), distance_squared(point, box));
}

TEST(DistanceSquared, OfTrianglesIsAsComputedByHand) {
  using V3 = Vec<3, double>;
  using S3 = Segment<3, double>;
  const Triangle<3, double> triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  EXPECT_EQ(distance_squared(V3(1, 1, 3), triangle), 9);
  EXPECT_EQ(distance_squared(V3(1, -3, 4), triangle), 25);
  EXPECT_EQ(distance_squared(V3(4, 4, 1), triangle), 9);
  EXPECT_EQ(distance_squared(V3(-3, -4, 0), triangle), 25);
  EXPECT_EQ(distance_squared(V3(1, 1, 0), triangle), 0);
  EXPECT_EQ(distance_squared(S3{{1, 1, -1}, {1, 1, 7}}, triangle), 0);
  EXPECT_EQ(distance_squared(S3{{-9, 1, 3}, {9, 1, 3}}, triangle), 9);
  EXPECT_EQ(distance_squared(S3{{-9, -3, 4}, {9, -3, 4}}, triangle), 25);
  EXPECT_EQ(distance_squared(S3{{1, 1, 2}, {1, 1, 9}}, triangle), 4);
  const Triangle<2, float> flat{{0, 0}, {4, 0}, {0, 4}};
  EXPECT_EQ(distance_squared(Vec<2, float>(1, 1), flat), 0);
  EXPECT_EQ(distance_squared(Vec<2, float>(5, 5), flat), 18);
  EXPECT_EQ(distance_squared(Segment<2, float>{{1, 1}, {2, 1}}, flat), 0);
  EXPECT_EQ(distance_squared(Segment<2, float>{{5, -3}, {5, 3}}, flat), 1);
}

// A projection outside of a needle is easily taken for one inside, and the distance to the needle is long.
TEST(DistanceSquared, OfANeedleIsMeasuredToOneOfItsPoints) {
  for (const double half_width : {1e-3, 1e-8, 1e-12, 1e-16, 0.0}) {
    const Triangle<3, double> needle{{0, 0, 0}, {1, half_width, 0}, {1, -half_width, 0}};
    EXPECT_NEAR(std::sqrt(distance_squared(Vec<3, double>(-0.3, 0, 0.4), needle)), 0.5, 1e-15);
    EXPECT_NEAR(std::sqrt(distance_squared(Vec<3, double>(0.7, 0, 0.4), needle)), 0.4, 1e-15);
    EXPECT_NEAR(std::sqrt(distance_squared(Segment<3, double>{{-0.3, -1, 0.4}, {-0.3, 1, 0.4}}, needle)), 0.5, 1e-15);
  }
}

// The square of the common perpendicular's length is above all doubles, or below.
TEST(DistanceSquared, OfVeryLargeAndVerySmallShapesIsThatOfMediumOnes) {
  for (const double size : {0x1p-460, 1.0, 0x1p460}) {
    const auto at = [size](double x, double y, double z) { return Vec<3, double>(x, y, z) * size; };
    const Segment<3, double> along{at(-1, 0, 0), at(1, 0, 0)};
    const Triangle<3, double> triangle{at(0, 0, 0), at(4, 0, 0), at(0, 4, 0)};
    EXPECT_EQ(distance_squared(along, Segment<3, double>{at(0, -1, 2), at(0, 1, 2)}), 4 * size * size);
    EXPECT_EQ(distance_squared(at(1, 1, 3), triangle), 9 * size * size);
    EXPECT_EQ(distance_squared(Segment<3, double>{at(1, 1, -1), at(1, 1, 7)}, triangle), 0);
  }
}

// Both cross, and both once got a distance of 2e-4 and more: the determinant of the two lines was mostly rounding, so
// the crossing was taken to be outside.
TEST(DistanceSquared, OfSegmentsThatCrossAtAlmostNoAngleIsZero) {
  const Segment<2, float> small{{-0.27411723F, -0.003531331F}, {0.0023997936F, -0.0020539726F}};
  const Segment<2, float> large{{1732.4413F, -5.4925604F}, {-2665.351F, 8.444495F}};
  const Segment<2, float> larger{{2198.622F, -6.9720592F}, {-2199.1702F, 6.9649963F}};
  EXPECT_LE(distance_squared(small, large), 1e-24);
  EXPECT_LE(distance_squared(small, larger), 1e-24);
}

/// The largest error, as a distance, in units of the vectors between and along the shapes.
template <class A, class B>
void expect_exact(double allowed) {
  double worst = 0;
  check_property([&] {
    const auto [a, b] = *any_pair<A, B>();
    const ExactVerdict truth = exact_verdict_of(a, b);
    const double found = std::sqrt(distance_squared(a, b));
    RC_ASSERT(std::isfinite(found));
    const double error = std::fabs(found - std::max(0.0, truth.gap));
    RC_ASSERT(error <= allowed * tolerance::epsilon * truth.own_size);
    if (truth.own_size > 0) worst = std::max(worst, error / truth.own_size);
  });
  std::cout << Entry<A>::name << ", " << Entry<B>::name << ": off by at most " << worst << " of the size\n";
}

TEST(DistanceSquared, IsWithinAFewEpsilonOfTheExactOne) {
  expect_exact<Vec<3, double>, Segment<3, double>>(8);
  expect_exact<Segment<2, double>, Segment<2, double>>(8);
  expect_exact<Segment<3, float>, Segment<3, float>>(8);
  expect_exact<Segment<3, double>, Segment<3, double>>(8);
  expect_exact<Vec<3, double>, Aabb<3, double>>(8);
  expect_exact<Segment<2, float>, Aabb<2, float>>(8);
  expect_exact<Segment<3, double>, Aabb<3, double>>(8);
  expect_exact<Vec<3, double>, Obb<3, double>>(16);
  expect_exact<Segment<2, float>, Obb<2, float>>(16);
  expect_exact<Segment<3, double>, Obb<3, double>>(16);
  expect_exact<Vec<2, float>, Triangle<2, float>>(16);
  expect_exact<Vec<3, double>, Triangle<3, double>>(16);
  expect_exact<Segment<2, double>, Triangle<2, double>>(16);
  expect_exact<Segment<3, double>, Triangle<3, double>>(16);
}

TEST(DistanceSquared, OfSwappedSegmentsIsTheSameToTheBit) {
  check_property([] {
    const auto [a, b] = *any_pair<Segment<3, double>, Segment<3, double>>();
    RC_ASSERT(distance_squared(a, b) == distance_squared(b, a));
  });
  check_property([] {
    const auto [a, b] = *any_pair<Segment<2, float>, Segment<2, float>>();
    RC_ASSERT(distance_squared(a, b) == distance_squared(b, a));
  });
}

}  // namespace
}  // namespace graze::test::distance_squared_test
