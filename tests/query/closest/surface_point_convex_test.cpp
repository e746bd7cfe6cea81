// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/query/closest/surface_point_convex.hpp>

#include "catalogue.hpp"

namespace graze::test::surface_point_convex_test {
namespace {

using D3 = Vec<3, double>;

/// A box given by its corners, so that GJK and EPA are used.
Polytope<3, double> hull_of_box(const Aabb<3, double>& box) {
  std::vector<D3> corners;
  for (const double x : {box.min.x, box.max.x}) {
    for (const double y : {box.min.y, box.max.y}) {
      for (const double z : {box.min.z, box.max.z}) corners.emplace_back(x, y, z);
    }
  }
  return convex_hull<3, double>(corners);
}

TEST(SurfacePointConvex, OfTheHullOfABoxIsThatOfTheBox) {
  check_property([] {
    const auto [box, point] = *any_pair<Aabb<3, double>, Vec<3, double>>();
    const auto closed_form = detail::surface_point(box, point);
    const auto generic = detail::surface_point(hull_of_box(box), point);
    const double size = std::max({max_abs(box.min), max_abs(box.max), max_abs(point)});
    RC_ASSERT(std::fabs(generic.distance - closed_form.distance) <= 64 * tolerance::epsilon * size);
    if (closed_form.distance <= 64 * tolerance::epsilon * size) return;
    RC_ASSERT(max_abs(generic.point - closed_form.point) <= 8 * tolerance::epsilon * size);
  });
}

TEST(SurfacePointConvex, FindsTheRightOneOfNearlyFlatFaces) {
  // A roof with a height of 1e-7: its two sides are nearly equally near, but their nearest points are far apart. A
  // distance accurate to 1e-12 would not distinguish them.
  const auto roof = convex_hull<3, double>(
      std::array{D3(-1, -1, 0), D3(1, -1, 0), D3(-1, 1, 0), D3(1, 1, 0), D3(0, -1, 1e-7), D3(0, 1, 1e-7)});
  const D3 point(0.5, 0, 1);
  const auto found = detail::surface_point(roof, point);
  const double slope = 1e-7;
  const double along = (0.5 - slope * (1 - 1e-7)) / (1 + slope * slope);  // z = 1e-7 (1 - x)
  EXPECT_NEAR(found.point.x, along, 1e-12);
  EXPECT_NEAR(found.point.z, 1e-7 * (1 - found.point.x), 1e-15);
}

TEST(SurfacePointConvex, AnswersACornerAsItIsStored) {
  const auto hull = hull_of_box({{0.1, 0.2, 0.3}, {0.7, 0.8, 0.9}});
  EXPECT_EQ(detail::surface_point(hull, D3(1e7, 1e8, 1e9)).point, D3(0.7, 0.8, 0.9));
}

TEST(SurfacePointConvex, TheMiddleOfAHullIsInsideUnlessItIsFlat) {
  const D3 middle = detail::middle_of(hull_of_box({{1, 2, 3}, {3, 4, 5}}));
  EXPECT_NEAR(max_abs(middle - D3(2, 3, 4)), 0, 1e-15);
}

}  // namespace
}  // namespace graze::test::surface_point_convex_test
