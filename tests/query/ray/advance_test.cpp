// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/ray/advance.hpp>
#include <graze/shape/polytope.hpp>

namespace graze::detail::ray_advance_test {
namespace {

using Point = Vec<3, double>;
constexpr double infinity = std::numeric_limits<double>::infinity();

Polytope<3, double> pyramid() {
  return convex_hull<3, double>(std::vector<Point>{{4, -1, -1}, {4, 1, -1}, {4, -1, 1}, {4, 1, 1}, {3, 0, 0}});
}

TEST(RayAdvance, StopsAtTheFaceAndKnowsItsNormal) {
  for (const auto& found : {advance_to(pyramid(), Path<3>{{0, 0.25, 0}, {2, 0, 0}, infinity}),
                            advance_by_distance(pyramid(), Path<3>{{0, 0.25, 0}, {2, 0, 0}, infinity})}) {
    EXPECT_EQ(found.verdict, RayVerdict::hits);
    EXPECT_NEAR(found.hit.t, 1.625, 1e-14);
    EXPECT_LE(found.hit.t, 1.625 + 1e-15);
    EXPECT_EQ(found.hit.status, Status::converged);
    EXPECT_LT(found.hit.error, 1e-13);
    const Point normal = found.hit.normal / std::sqrt(dot(found.hit.normal, found.hit.normal));
    EXPECT_NEAR(normal.x, -std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(normal.y, std::sqrt(0.5), 1e-12);
  }
}

/// A ray through the interior of a face needs no confirmation; one that meets an edge or a corner, or begins inside,
/// does.
TEST(RayAdvance, IsCertainOnlyWhereTheRayGoesThroughAFace) {
  EXPECT_TRUE(advance_to(pyramid(), Path<3>{{0, 0.25, 0}, {2, 0, 0}, infinity}).is_certain);
  EXPECT_FALSE(advance_to(pyramid(), Path<3>{{0, 0, 0}, {2, 0, 0}, infinity}).is_certain);
  EXPECT_FALSE(advance_to(pyramid(), Path<3>{{0, 0.25, 0.25}, {2, 0, 0}, infinity}).is_certain);
  EXPECT_FALSE(advance_to(pyramid(), Path<3>{{3.5, 0, 0}, {0, 1, 0}, infinity}).is_certain);
}

TEST(RayAdvance, MissesByAPlaneOrLeavesItOpen) {
  EXPECT_EQ(advance_to(pyramid(), {{0, 1.001, 0}, {1, 0, 0}, infinity}).verdict, RayVerdict::misses);
  EXPECT_EQ(advance_to(pyramid(), {{0, 0, 0}, {-1, 0, 0}, infinity}).verdict, RayVerdict::misses);
  EXPECT_EQ(advance_to(pyramid(), {{0, 0, 0}, {1, 0, 0}, 2.999}).verdict, RayVerdict::misses);
  EXPECT_NE(advance_to(pyramid(), {{0, 1, 0}, {1, 0, 0}, infinity}).verdict, RayVerdict::misses);
  EXPECT_NE(advance_to(pyramid(), {{0, 0, 0}, {1, 0, 0}, 3}).verdict, RayVerdict::misses);
}

TEST(RayAdvance, StartsInsideAtZero) {
  const RayFinding<3> inside = advance_to(pyramid(), {{3.5, 0, 0}, {0, 1, 0}, infinity});
  EXPECT_EQ(inside.verdict, RayVerdict::hits);
  EXPECT_EQ(inside.hit.t, 0);
  EXPECT_EQ(inside.hit.normal, Point(0.0));
}

TEST(RayAdvance, GrazesARoundShape) {
  // Newton's method at a double root: every step halves the distance, and still it terminates at the shape.
  const Capsule<3, double> capsule{{5, 0, -1}, {5, 0, 1}, 2};
  const RayFinding<3> found = advance_by_distance(capsule, Path<3>{{0, 2, 0}, {1, 0, 0}, infinity});
  EXPECT_NE(found.verdict, RayVerdict::misses);
  EXPECT_NEAR(found.hit.t, 5, 1e-6);
  EXPECT_LE(found.hit.t, 5 + 1e-15);
  EXPECT_LT(found.hit.error, 1e-13);
}

}  // namespace
}  // namespace graze::detail::ray_advance_test
