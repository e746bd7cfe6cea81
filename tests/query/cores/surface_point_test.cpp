// SPDX-License-Identifier: MIT
// Delicate cases of the functions under the four point queries, whose own tests compare with the oracle and with
// results by hand.
#include <cmath>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/cores/surface_point.hpp>

namespace graze::test::surface_point_test {
namespace {

using D2 = Vec<2, double>;
using D3 = Vec<3, double>;

TEST(SurfacePoint, UnitVectorsOfTinyVectorsAreNotLostToUnderflow) {
  EXPECT_EQ(detail::unit_or(D2(3e-200, 4e-200), D2(1, 0)), D2(0.6, 0.8));
  EXPECT_EQ(detail::unit_or(D2(0, 0), D2(1, 0)), D2(1, 0));
}

TEST(SurfacePoint, AcrossIsAtRightAnglesToAnyEdge) {
  for (const D3 edge : {D3(1, 0, 0), D3(0, -2, 0), D3(0, 0, 3), D3(1, 2, 3), D3(1e-9, 1, 1)}) {
    EXPECT_NEAR(dot(detail::across(edge), edge), 0, 1e-15);
    EXPECT_NEAR(dot(detail::across(edge), detail::across(edge)), 1, 1e-15);
  }
  EXPECT_EQ(detail::across(D3(0, 0, 0)), D3(1, 0, 0));
  EXPECT_EQ(detail::across(D2(0, 0)), D2(1, 0));
}

TEST(SurfacePoint, ANeedleTriangleIsHitOnItsFaceEdgesAndCorners) {
  // A million times as long as wide, seen from a height of a million times its width.
  const Triangle<3, double> needle{{0, 0, 0}, {1, 0, 0}, {1, 1e-6, 0}};
  const auto above = detail::surface_point(needle, D3(0.75, 5e-7, 1));
  EXPECT_NEAR(max_abs(above.point - D3(0.75, 5e-7, 0)), 0, 1e-16);
  EXPECT_NEAR(above.distance, 1, 1e-15);
  const auto beside = detail::surface_point(needle, D3(0.75, 1, 0));
  EXPECT_NEAR(max_abs(beside.point - D3(0.75 + 2.5e-7, 7.5e-7, 0)), 0, 1e-6);
  const auto behind = detail::surface_point(needle, D3(2, 1e-6, 0));
  EXPECT_EQ(behind.point, D3(1, 1e-6, 0));
}

TEST(SurfacePoint, AHeightOverAPlaneKeepsWhatItsProductsLose) {
  // 3 * 0.1 is 2^-55 above 0.3.
  EXPECT_EQ(detail::height_over(Plane<2, double>{{0.1, 0}, 0.3}, D2(3, 0)), 0x1p-55);
  EXPECT_EQ(detail::height_over(Plane<2, double>{{1e15, 1}, 1e30}, D2(1e15, 0.5)), std::fma(1e15, 1e15, -1e30) + 0.5);
}

TEST(SurfacePoint, TheFootOnAPlaneIsAsExactAsItsOwnSize) {
  const Plane<2, double> plane{{1, 3}, 1};
  const D2 closest = detail::surface_point(plane, D2(1e12, 3e12 + 7)).point;
  EXPECT_NEAR(closest.x + 3 * closest.y, 1, 1e-14);
}

TEST(SurfacePoint, APolygonKnowsItsInsideExactly) {
  // The point is on the diagonal: exactly on an edge of the first triangle, whichever way it runs.
  const D2 p(0.1, 0.1);
  EXPECT_LE(detail::surface_point(Triangle<2, double>{{0, 0}, {1, 0}, {1, 1}}, p).distance, 0);
  EXPECT_LE(detail::surface_point(Triangle<2, double>{{0, 0}, {1, 1}, {1, 0}}, p).distance, 0);
  const D2 below(0.1, std::nextafter(0.1, 0.0));
  EXPECT_LT(detail::surface_point(Triangle<2, double>{{0, 0}, {1, 0}, {1, 1}}, below).distance, 0);
  EXPECT_GT(detail::surface_point(Triangle<2, double>{{0, 0}, {1, 1}, {0, 1}}, below).distance, 0);
}

TEST(SurfacePoint, StraightenedVectorsStandAtRightAnglesOrVanish) {
  const D3 edge(1, 2, 3);
  const D3 across = detail::straightened(D3(1e-3, 2e-3 + 1e-9, 3e-3), edge);
  EXPECT_NEAR(dot(across, edge) / std::sqrt(dot(across, across)), 0, 1e-14);
  const D3 nothing = detail::straightened(edge * 1e-17, edge);
  EXPECT_LE(max_abs(nothing), 1e-32);
}

}  // namespace
}  // namespace graze::test::surface_point_test
