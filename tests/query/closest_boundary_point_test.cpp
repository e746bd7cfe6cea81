// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/closest_boundary_point.hpp>

#include "catalogue.hpp"
#include "query/user_shapes.hpp"

namespace graze::test::closest_boundary_point_test {
namespace {

using V2 = Vec<2, float>;
using V3 = Vec<3, float>;
using D3 = Vec<3, double>;

template <class P>
struct Answer {
  P point;
  P boundary;
};

template <class S, class P>
void expect(const S& shape, const std::vector<Answer<P>>& answers) {
  for (const auto& [point, boundary] : answers) {
    EXPECT_EQ(closest_boundary_point(shape, point), boundary) << to_source(shape) << ", " << to_source(point);
  }
}

// ---- By hand

TEST(ClosestBoundaryPoint, FromInsideIsOnTheNearestPartOfTheSurface) {
  expect<Sphere<3>, V3>({{1, 2, 3}, 2}, {{{1, 2, 4}, {1, 2, 5}}, {{0.5F, 2, 3}, {-1, 2, 3}}});
  expect<Aabb<3>, V3>({{0, 0, 0}, {4, 4, 4}},
                      {{{1, 2, 2}, {0, 2, 2}}, {{2, 3, 2}, {2, 4, 2}}, {{2, 2, 3.5F}, {2, 2, 4}}});
  expect<Obb<2>, V2>({{1, 1}, {2, 1}, {{0, 1}, {-1, 0}}},
                     {{{1.5F, 1}, {2, 1}}, {{1, 2.5F}, {1, 3}}, {{0.5F, 0}, {0, 0}}});
  expect<Triangle<2>, V2>({{0, 0}, {8, 0}, {0, 8}}, {{{1, 2}, {0, 2}}, {{2, 1}, {2, 0}}, {{3, 4}, {3.5F, 4.5F}}});
  expect<Capsule<2>, V2>({{0, 0}, {4, 0}, 2}, {{{2, 1}, {2, 2}}, {{2, -1}, {2, -2}}, {{5, 0}, {6, 0}}});
  expect<Polytope<2>, V2>(convex_hull<2, float>(std::array{V2(0, 0), V2(4, 0), V2(4, 4), V2(0, 4)}),
                          {{{2, 3}, {2, 4}}, {{1, 2}, {0, 2}}});
  expect<HalfSpace<3>, V3>({{0, 0, 2}, 4}, {{{1, 1, -3}, {1, 1, 2}}, {{1, 1, 9}, {1, 1, 2}}});
  const D3 on_tetrahedron = closest_boundary_point(
      convex_hull<3, double>(std::array{D3(0, 0, 0), D3(4, 0, 0), D3(0, 4, 0), D3(0, 0, 4)}), D3(1, 1, 0.25));
  EXPECT_NEAR(max_abs(on_tetrahedron - D3(1, 1, 0)), 0, 1e-12);
}

TEST(ClosestBoundaryPoint, FromOutsideAndOfSetsWithoutInsideIsTheClosestPoint) {
  expect<Sphere<3>, V3>({{1, 2, 3}, 2}, {{{1, 2, 9}, {1, 2, 5}}});
  expect<Aabb<2>, V2>({{0, 0}, {1, 2}}, {{{5, 5}, {1, 2}}, {{1, 1}, {1, 1}}});
  expect<Segment<2>, V2>({{0, 0}, {4, 0}}, {{{2, 3}, {2, 0}}, {{2, 0}, {2, 0}}});
  expect<Plane<2>, V2>({{0, 3}, 6}, {{{7, -5}, {7, 2}}});
  expect<Triangle<3>, V3>({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{{1, 1, 5}, {1, 1, 0}}});
  expect<V2, V2>({1, 2}, {{{5, 5}, {1, 2}}});
}

// ---- Several nearest points

TEST(ClosestBoundaryPoint, FromTheCenterOfASphereIsInDirectionX) {
  // Scaling center - center to length r divides by zero.
  EXPECT_EQ(closest_boundary_point(Sphere<3>{{1, 2, 3}, 2}, V3(1, 2, 3)), V3(3, 2, 3));
  EXPECT_EQ(closest_boundary_point(Circle<>{{1, 2}, 0}, V2(1, 2)), V2(1, 2));
}

TEST(ClosestBoundaryPoint, FromTheAxisOfACapsuleIsStraightAcross) {
  EXPECT_EQ(closest_boundary_point(Capsule<2>{{0, 0}, {4, 0}, 2}, V2(1, 0)), V2(1, 2));
  EXPECT_EQ(closest_boundary_point(Capsule<2>{{0, 0}, {4, 0}, 2}, V2(0, 0)), V2(0, 2));
  EXPECT_EQ(closest_boundary_point(Capsule<2>{{1, 1}, {1, 1}, 2}, V2(1, 1)), V2(3, 1));
  const Capsule<3, double> orthonormality_error{{0.1, 0.2, 0.3}, {1.3, -0.4, 2.2}, 1};
  for (int i = 0; i <= 20; ++i) {
    const double share = i / 20.0;
    const D3 on_axis = orthonormality_error.a * (1 - share) +
                       orthonormality_error.b * share;  // up to rounding, which tilts along the axis
    const D3 out = closest_boundary_point(orthonormality_error, on_axis) - on_axis;
    EXPECT_NEAR(std::sqrt(dot(out, out)), 1, 1e-14) << i;
    EXPECT_NEAR(dot(out, orthonormality_error.b - orthonormality_error.a), 0, 1e-14) << i;
  }
}

TEST(ClosestBoundaryPoint, FromTheMiddleOfABoxIsOnTheFirstFace) {
  EXPECT_EQ(closest_boundary_point(Aabb<3>{{0, 0, 0}, {2, 2, 2}}, V3(1, 1, 1)), V3(0, 1, 1));
  EXPECT_EQ(closest_boundary_point(Obb<3>{{1, 1, 1}, {1, 1, 1}, Mat<3, float>(1.0F)}, V3(1, 1, 1)), V3(0, 1, 1));
  EXPECT_EQ(closest_boundary_point(Aabb<2>{{0, 0}, {4, 2}}, V2(1, 1)), V2(0, 1));
}

// ---- Compounds, user-defined shapes

TEST(ClosestBoundaryPoint, OfACompoundIsThatOfThePartThatDecides) {
  const auto pair = compound_of<2, float>({Circle<>{{0, 0}, 1}, Rect<>{{4, 0}, {6, 2}}});
  expect<Compound<2, float>, V2>(pair, {{{0.5F, 0}, {1, 0}}, {{5.5F, 1}, {6, 1}}, {{2, 0}, {1, 0}}});
  // Deepest in the second part, whose nearest face is inside the first.
  const auto overlapping = compound_of<2, float>({Rect<>{{0, 0}, {4, 4}}, Rect<>{{3, -4}, {9, 8}}});
  expect<AnyShape<2, float>, V2>(overlapping, {{{5, 2}, {3, 2}}});
  const V2 none = closest_boundary_point(Compound<2, float>(), V2(1, 2));
  EXPECT_TRUE(std::isnan(none.x) && std::isnan(none.y));
}

TEST(ClosestBoundaryPoint, OfAUsersShapeIsItsNearestSurface) {
  const user::Cylinder<double> can{{0, 0, 0}, 1, 2};
  EXPECT_NEAR(max_abs(closest_boundary_point(can, D3(0.125, 0.25, 1.75)) - D3(0.125, 0.25, 2)), 0, 1e-9);
  EXPECT_NEAR(max_abs(closest_boundary_point(can, D3(0, 0, 5)) - D3(0, 0, 2)), 0, 1e-9);
}

}  // namespace
}  // namespace graze::test::closest_boundary_point_test
