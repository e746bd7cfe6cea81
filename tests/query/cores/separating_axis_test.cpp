// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/cores/separating_axis.hpp>

#include "catalogue.hpp"

namespace graze::detail::parting_axis_test {
namespace {

using V2 = Vec<2, double>;
using V3 = Vec<3, double>;
using Edge = Segment<3, double>;

template <class A, class B>
SeparatingAxis<dimension_of<A>> separating_axis(const A& a, const B& b) {
  SeparatingAxisSearch<A, B> search(a, b, size_around_zero(a) + size_around_zero(b));
  offer_faces(a, b, search);
  return search.best();
}

template <class A, class B, class V>
void expect_axis(const A& a, const B& b, const V& normal, double gap) {
  const auto axis = separating_axis(a, b);
  EXPECT_NEAR(length(axis.normal - normal), 0, 1e-15);
  EXPECT_NEAR(axis.gap, gap, 1e-15);
}

const Aabb<3, double> cube{{-1, -1, -1}, {1, 1, 1}};
const Triangle<3, double> triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

TEST(Directions, OfEdgesAndFacesAreThoseOfTheCore) {
  EXPECT_EQ(edge_directions(Edge{{1, 2, 3}, {2, 2, 3}}).at(0), V3(1, 0, 0));
  EXPECT_EQ(edge_directions(cube).at(2), V3(0, 0, 1));
  EXPECT_TRUE(edge_directions(V3(1, 2, 3)).empty());
  EXPECT_EQ(face_directions(triangle).at(0), V3(0, 0, 16));
  EXPECT_EQ(face_directions(cube).at(1), V3(0, 1, 0));
  EXPECT_TRUE(face_directions(Edge{}).empty());
  EXPECT_EQ((face_directions(Segment<2, double>{{0, 0}, {2, 0}}).at(0)), V2(0, -2));
}

// A flat box still has all its axes: without the half extent across, no face would be found along it.
TEST(Directions, OfAFlatBoxAreItsAxes) {
  const Obb<3, double> plate{{0, 0, 0}, {1, 0, 1}, Mat<3, double>(0, 1, 0, -1, 0, 0, 0, 0, 1)};
  EXPECT_EQ(edge_directions(plate).at(1), V3(-1, 0, 0));
  EXPECT_EQ(face_directions(plate).at(1), V3(-1, 0, 0));
}

TEST(SeparatingAxis, IsANormalOfTheNearestFace) {
  expect_axis(cube, Aabb<3, double>{{-1, 0.5, -0.75}, {1, 2.5, 1.25}}, V3(0, 1, 0), -0.5);
  expect_axis(cube, V3(0.25, 0, -0.75), V3(0, 0, -1), -0.25);
  expect_axis(triangle, Edge{{1, 1, -1}, {1, 1, 5}}, V3(0, 0, 1), -1);
}

TEST(SeparatingAxis, MayBeTheCommonNormalOfTwoEdges) {
  // Two roofs with crossing ridges.
  const Triangle<3, double> lower{{-2, 0, 0}, {2, 0, 0}, {0, 0, -9}};
  const Triangle<3, double> upper{{0, -2, -0.5}, {0, 2, -0.5}, {0, 0, 9}};
  expect_axis(lower, upper, V3(0, 0, 1), -0.5);
  expect_axis(Edge{{-1, 0, 0}, {1, 0, 0}}, Edge{{0, -1, 0}, {0, 1, 0}}, V3(0, 0, 1), 0);
}

TEST(SeparatingAxis, OfTheSameGapIsTheFirstOfferedThoughRoundingPrefersAnother) {
  const Obb<3, double> turned{{0, 1.5, 0}, {1, 1, 1}, rotation_matrix(V3(0, 1, 0), 30)};
  const auto axis = separating_axis(oriented(cube), turned);
  EXPECT_EQ(axis.normal, V3(0, 1, 0));
  EXPECT_EQ(separating_axis(cube, cube).normal, V3(1, 0, 0));
}

TEST(SeparatingAxis, OfWhatLiesOnOneLineIsStraightAcross) {
  expect_axis(Edge{{0, 0, 0}, {0, 0, 4}}, Edge{{0, 0, 1}, {0, 0, 9}}, V3(0, 1, 0), 0);
  expect_axis(Edge{{0, 0, 0}, {0, 0, 4}}, V3(0, 0, 1), V3(0, 1, 0), 0);
  expect_axis(Segment<2, double>{{0, 0}, {2, 0}}, V2(1, 0), V2(0, -1), 0);
  expect_axis(V3(1, 2, 3), V3(1, 2, 3), V3(1, 0, 0), 0);
}

TEST(SeparatingAxis, DependsOnNoSize) {
  for (const double size : {1e-130, 1.0, 1e130}) {
    const Triangle<3, double> scaled{triangle.a * size, triangle.b * size, triangle.c * size};
    const Edge through{V3(1, 1, -1) * size, V3(1, 1, 5) * size};
    const auto axis = separating_axis(scaled, through);
    EXPECT_EQ(axis.normal, V3(0, 0, 1));
    EXPECT_NEAR(axis.gap / size, -1, 1e-15);
  }
}

}  // namespace
}  // namespace graze::detail::parting_axis_test
