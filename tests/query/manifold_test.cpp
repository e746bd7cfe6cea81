// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/manifold.hpp>

#include "query/manifolds.hpp"
#include "query/placement.hpp"
#include "query/user_shapes.hpp"

namespace graze::test::manifold_test {
namespace {

using V2 = Vec<2, double>;
using V3 = Vec<3, double>;
using Any3 = AnyShape<3, double>;

Feature vertex(std::uint32_t index) { return {FeatureKind::vertex, index}; }
Feature face(std::uint32_t index) { return {FeatureKind::face, index}; }

/// A point on the surface of a, and its depth.
template <Dim N>
struct Expected {
  Vec<N, double> on_a;
  double depth;
};

/// Expects these points in any order, and the same in the other order of shapes.
template <Dim N>
void expect_manifold(const AnyShape<N, double>& a, const AnyShape<N, double>& b, const Vec<N, double>& normal,
                     const std::vector<Expected<N>>& points) {
  const auto found = manifold_of<N, double>(a, b);
  EXPECT_NEAR(length(found.normal - normal), 0, 1e-14);
  ASSERT_EQ(found.size, points.size());
  for (const Expected<N>& expected : points) {
    const bool is_there = std::any_of(found.contacts().begin(), found.contacts().end(), [&](const auto& point) {
      return length(point.point_a - expected.on_a) < 1e-13 && std::fabs(point.depth - expected.depth) < 1e-13 &&
             length(point.point_b - (expected.on_a - normal * expected.depth)) < 1e-13;
    });
    EXPECT_TRUE(is_there) << to_source(expected.on_a) << ", " << expected.depth;
  }
  const auto swapped = manifold_of<N, double>(b, a);
  ASSERT_EQ(swapped.size, found.size);
  for (std::size_t i = 0; i < found.size; ++i) {
    EXPECT_EQ(swapped.points[i].point_a, found.points[i].point_b);
    EXPECT_EQ(swapped.points[i].id.a, found.points[i].id.b);
  }
}

const Obb<3, double> table{{0, 0, 0}, {2, 2, 1}};

TEST(Manifold, OfABoxOnABoxIsItsFourCorners) {
  expect_manifold<3>(table, Obb<3, double>{{0.5, 0.5, 1.75}, {1, 1, 1}}, {0, 0, 1},
                     {{{-0.5, -0.5, 1}, 0.25}, {{1.5, -0.5, 1}, 0.25}, {{1.5, 1.5, 1}, 0.25}, {{-0.5, 1.5, 1}, 0.25}});
}

TEST(Manifold, OfABoxOverACornerIsWhatTheyShare) {
  const Obb<3, double> shifted{{1.5, 1.5, 1.75}, {1, 1, 1}};
  expect_manifold<3>(table, shifted, {0, 0, 1},
                     {{{0.5, 0.5, 1}, 0.25}, {{2, 0.5, 1}, 0.25}, {{2, 2, 1}, 0.25}, {{0.5, 2, 1}, 0.25}});
  const auto found = manifold(table, shifted);
  EXPECT_EQ(found.points[0].id, (ContactId{face(5), vertex(0)}));
  EXPECT_EQ(found.points[3].id, (ContactId{vertex(7), face(4)}));
}

TEST(Manifold, OfATiltedBoxReachesAsFarAsItOverlaps) {
  const double sine = 0.6;
  const double cosine = 0.8;
  const Mat<3, double> tilt(cosine, 0, -sine, 0, 1, 0, sine, 0, cosine);
  // The lower corners are at (cosine - sine, -sine - cosine), relative to the center: this is the depth of its edge.
  const Obb<3, double> tilted{{0, 0, 2.3}, {1, 1, 1}, tilt};
  const double depth = 1 - (2.3 - 1.4);
  expect_manifold<3>(Obb<3, double>{{0, 0, 0}, {3, 3, 1}}, tilted, {0, 0, 1},
                     {{{0.2, -1, 1}, depth},
                      {{0.2, 1, 1}, depth},
                      {{0.2 - depth * cosine / sine, -1, 1}, 0},
                      {{0.2 - depth * cosine / sine, 1, 1}, 0}});
}

TEST(Manifold, OfEdgesThatCrossIsOnePoint) {
  const Obb<3, double> below{{0, 0, 0}, {1, 1, 1}, rotation_matrix(V3(0, 1, 0), 45)};
  const Obb<3, double> above{{0, 0, 2.5}, {1, 1, 1}, rotation_matrix(V3(1, 0, 0), 45)};
  const auto found = manifold(below, above);
  ASSERT_EQ(found.size, 1U);
  EXPECT_NEAR(found.points[0].depth, 2 * std::sqrt(2.0) - 2.5, 1e-15);
  EXPECT_EQ(found.points[0].id.a.kind, FeatureKind::edge);
  EXPECT_EQ(found.points[0].id.b.kind, FeatureKind::edge);
}

TEST(Manifold, OfABallIsOnePoint) {
  expect_manifold<3>(table, Sphere<3, double>{{1, 1, 1.75}, 1}, {0, 0, 1}, {{{1, 1, 1}, 0.25}});
  expect_manifold<3>(Sphere<3, double>{{0, 0, 0}, 1}, Sphere<3, double>{{0, 0, 1.5}, 1}, {0, 0, 1}, {{{0, 0, 1}, 0.5}});
  EXPECT_EQ(manifold(table, Sphere<3, double>{{1, 1, 1.75}, 1}).points[0].id, (ContactId{face(5), vertex(0)}));
}

TEST(Manifold, OfACapsuleThatLiesIsItsTwoEndsAndOfOneThatStandsItsFoot) {
  const HalfSpace<3, double> ground{{0, 0, 1}, 0};
  expect_manifold<3>(ground, Capsule<3, double>{{0, 0, 0.75}, {5, 0, 0.5}, 1}, {0, 0, 1},
                     {{{0, 0, 0}, 0.25}, {{5, 0, 0}, 0.5}});
  expect_manifold<3>(ground, Capsule<3, double>{{0, 0, 0.75}, {0, 0, 4}, 1}, {0, 0, 1},
                     {{{0, 0, 0}, 0.25}, {{0, 0, 0}, 0}});
  expect_manifold<3>(Capsule<3, double>{{-5, 0, 1.25}, {1, 0, 1.25}, 0.5}, table, {0, 0, -1},
                     {{{-2, 0, 0.75}, 0.25}, {{1, 0, 0.75}, 0.25}});
}

TEST(Manifold, OfParallelCapsulesIsTheEndsOfWhatTheyShare) {
  expect_manifold<3>(Capsule<3, double>{{0, 0, 0}, {4, 0, 0}, 1}, Capsule<3, double>{{9, 0, 1}, {1, 0, 1}, 0.5},
                     {0, 0, 1}, {{{1, 0, 1}, 0.5}, {{4, 0, 1}, 0.5}});
  expect_manifold<3>(Capsule<3, double>{{0, 0, 0}, {4, 0, 0}, 1}, Capsule<3, double>{{2, 3, 1}, {2, -3, 1}, 0.5},
                     {0, 0, 1}, {{{2, 0, 1}, 0.5}});
}

TEST(Manifold, OfPolytopesAndTrianglesIsThatOfTheirFaces) {
  const auto roof =
      convex_hull<3, double>(std::vector<V3>{{-1, -1, 0.75}, {1, -1, 0.75}, {1, 1, 0.75}, {-1, 1, 0.75}, {0, 0, 3}});
  const std::vector<Expected<3>> corners{
      {{-1, -1, 1}, 0.25}, {{1, -1, 1}, 0.25}, {{1, 1, 1}, 0.25}, {{-1, 1, 1}, 0.25}};
  expect_manifold<3>(table, roof, {0, 0, 1}, corners);
  expect_manifold<3>(Triangle<3, double>{{-9, -9, 1}, {9, -9, 1}, {0, 9, 1}}, roof, {0, 0, 1}, corners);
  expect_manifold<3>(HalfSpace<3, double>{{0, 0, 2}, 2}, roof, {0, 0, 1}, corners);
}

// Everything that has a face, or a side, on a plane that is crossed from either side: the plane has no corners of its
// own.
TEST(Manifold, OnAPlaneIsThatOfTheWholeFaceWhateverHasIt) {
  const std::vector<Expected<3>> corners{{{1, 1, 0}, 0.25}, {{3, 1, 0}, 0.25}, {{1, 2, 0}, 0.25}, {{3, 2, 0}, 0.25}};
  const Obb<3, double> crate{{2, 1.5, 0.75}, {1, 0.5, 1}};
  const AnyShape<3, double> box = Aabb<3, double>{{1, 1, -0.25}, {3, 2, 1.75}};
  for (const auto& shape : {box, AnyShape<3, double>(crate), AnyShape<3, double>(compound_of<3, double>({crate}))}) {
    expect_manifold<3>(HalfSpace<3, double>{{0, 0, 1}, 0}, shape, {0, 0, 1}, corners);
    expect_manifold<3>(Plane<3, double>{{0, 0, 4}, 0}, shape, {0, 0, 1}, corners);
  }
  const std::vector<Expected<2>> ends{{{1, 0}, 0.25}, {{3, 0}, 0.25}};
  const std::vector<Vec<2, double>> points{{1, -0.25}, {3, -0.25}, {2, 9}};
  for (const AnyShape<2, double>& shape : {AnyShape<2, double>(Aabb<2, double>{{1, -0.25}, {3, 2}}),
                                           AnyShape<2, double>(Obb<2, double>{{2, 0.75}, {1, 1}}),
                                           AnyShape<2, double>(Segment<2, double>{{1, -0.25}, {3, -0.25}}),
                                           AnyShape<2, double>(Triangle<2, double>{points[0], points[1], points[2]}),
                                           AnyShape<2, double>(Capsule<2, double>{{1, 0.75}, {3, 0.75}, 1}),
                                           AnyShape<2, double>(convex_hull<2, double>(points))}) {
    expect_manifold<2>(HalfSpace<2, double>{{0, 1}, 0}, shape, {0, 1}, ends);
    expect_manifold<2>(shape, HalfSpace<2, double>{{0, 1}, 0}, {0, -1}, {{{1, -0.25}, 0.25}, {{3, -0.25}, 0.25}});
  }
}

TEST(Manifold, InThePlaneIsTheEndsOfWhatTheSidesShare) {
  const Aabb<2, double> floor_box{{0, 0}, {4, 1}};
  expect_manifold<2>(floor_box, Aabb<2, double>{{3, 0.75}, {6, 3}}, {0, 1}, {{{3, 1}, 0.25}, {{4, 1}, 0.25}});
  expect_manifold<2>(floor_box, Triangle<2, double>{{2, 0.5}, {9, 9}, {-5, 9}}, {0, 1},
                     {{{2, 1}, 0.5}, {{2 - 0.5 * 7 / 8.5, 1}, 0}});
  expect_manifold<2>(floor_box, Sphere<2, double>{{1, 1.5}, 1}, {0, 1}, {{{1, 1}, 0.5}});
  expect_manifold<2>(Capsule<2, double>{{0, 0}, {4, 0}, 1}, Capsule<2, double>{{1, 1.5}, {9, 2}, 1}, {0, 1},
                     {{{1, 1}, 0.5}, {{4, 1}, 0.5 - 0.5 * 3 / 8}});
}

TEST(Manifold, IsEmptyForShapesThatAreApart) {
  const auto none = manifold(table, Sphere<3, double>{{9, 0, 0}, 1});
  EXPECT_EQ(none.size, 0U);
  EXPECT_TRUE(none.contacts().empty());
  EXPECT_EQ(none.normal, V3(0, 0, 0));
}

TEST(Manifold, OfACompoundIsThatOfItsDeepestPartAndNamesIt) {
  const Any3 far = Sphere<3, double>{{9, 0, 0}, 1};
  const Any3 box = Obb<3, double>{{0.5, 0.5, 1.75}, {1, 1, 1}};
  const Any3 sphere = Sphere<3, double>{{-1, -1, 1.875}, 1};
  const auto found = manifold_of<3, double>(Any3(table), compound_of<3, double>({far, sphere, box}));
  ASSERT_EQ(found.size, 4U);
  EXPECT_EQ(found.points[0].id.part_b, 2U);
  EXPECT_EQ(found.points[0].id.part_a, 0U);
  const Any3 nested = compound_of<3, double>({far, compound_of<3, double>({far, sphere, box})});
  EXPECT_EQ((manifold_of<3, double>(nested, table).points[0].id.part_a), 2U * 2 + 1);
}

TEST(Manifold, OfUsersShapesAndRaysIsThePointOfTheContact) {
  const user::Cylinder<double> can{{0, 0, 2.5}, 1, 2};
  const auto found = manifold(HalfSpace<3, double>{{0, 0, 1}, 1}, can);
  ASSERT_EQ(found.size, 1U);
  EXPECT_EQ(found.points[0].depth, 0.5);
  EXPECT_EQ(manifold(Ray<3, double>{{0, 0, 0.5}, {0, 0, 1}}, table).size, 1U);
  EXPECT_EQ(manifold(Plane<3, double>{{0, 0, 1}, 1}, Plane<3, double>{{1, 0, 1}, 1}).size, 1U);
}

TEST(Manifold, OfAFlatTriangleHasTheDeepestPoint) {
  const Triangle<2, double> flat{{-1, 0}, {2, -1}, {0.5, -0.5}};
  const Triangle<2, double> across{{0.25, -1}, {1.25, -4}, {0.25, 1}};
  const auto deepest = contact(flat, across);
  ASSERT_TRUE(deepest);
  const auto found = manifold(flat, across);
  double depth = 0;
  for (std::size_t i = 0; i < found.size; ++i) depth = std::max(depth, found.points[i].depth);
  EXPECT_NEAR(depth, deepest->depth, 1e-14);
}

TEST(Manifold, HasNothingInThePlacesOfPointsThatItHasNot) {
  const Sphere<3, double> sphere{{1, 1, 1.75}, 1};
  const Capsule<3, double> capsule{{1, 1, 1.75}, {2, 1, 1.75}, 1};
  for (const Any3& above : {Any3(sphere), Any3(capsule)}) {
    const auto found = manifold(Any3(Obb<3, double>{{0, 0, 0}, {4, 4, 1}}), above);
    const bool is_ball = std::holds_alternative<Sphere<3, double>>(above);
    ASSERT_EQ(found.size, is_ball ? 1U : 2U);
    for (std::size_t i = found.size; i < found.points.size(); ++i) {
      EXPECT_EQ(found.points[i], (ManifoldPoint<3, double>{}));
    }
  }
}

}  // namespace
}  // namespace graze::test::manifold_test
