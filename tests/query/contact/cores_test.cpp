// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contact/cores.hpp>

#include "catalogue.hpp"

namespace graze::detail::penetration_cores_test {
namespace {

using V3 = Vec<3, double>;

TEST(CutForDepth, LeavesTheRayTwiceAsLongAsAnythingIsAway) {
  const Ray<3, double> ray{{1, 0, 0}, {0, 1e-20, 0}};
  const Segment<3, double> cut = cut_for_depth(ray, Aabb<3, double>{{0, -3, -4}, {2, 3, 4}});
  EXPECT_EQ(cut.start, V3(1, 0, 0));
  EXPECT_EQ(cut.end.x, 1);
  EXPECT_GE(cut.end.y, 2 * std::sqrt(26.0));
  EXPECT_EQ(cut_for_depth(ray, V3(1, 0, 0)).end, V3(1, 1e-20, 0));
}

// A thin box, pierced a hundred times its own height below: the shortest way out is through the side, not back along
// the ray. The end where the ray is truncated must not matter.
TEST(PenetrationOfSimple, OfARayThroughABoxLeadsToTheSide) {
  const Ray<3, double> ray{{0.5, 0, -100}, {0, 0, 1}};
  const Penetration<3> found = penetration_of_simple(ray, Aabb<3, double>{{-3, -4, 0}, {3, 4, 1}});
  EXPECT_EQ(found.normal, V3(-1, 0, 0));
  EXPECT_NEAR(found.depth, 2.5, 1e-13);
}

TEST(PenetrationOfSimple, OfBoxesAlongTheAxesIsTheirOverlapInTheMiddleOfTheFaces) {
  const Penetration<3> found =
      penetration_of_simple(Aabb<3, double>{{0, 0, 0}, {4, 4, 4}}, Aabb<3, double>{{2, 2, -3}, {8, 8, 1}});
  EXPECT_EQ(found.normal, V3(0, 0, -1));
  EXPECT_EQ(found.depth, 1);
  EXPECT_EQ(found.point_a, V3(3, 3, 0));
  EXPECT_EQ(found.point_b, V3(3, 3, 1));
}

// The distance from center to face is a rounding error, and so is its direction; the face's normal is not.
TEST(PenetrationOfSimple, OfABallWhoseCenterIsARoundingAboveAFaceIsAlongItsNormal) {
  const Obb<3, double> box{{0, 0, 0}, {1, 1, 1}, rotation_matrix(V3(1, 2, 3), 40)};
  const V3 up = box.axes[2];
  const V3 along = box.axes[0];
  for (const double height : {0.0, 1e-17, 1e-16, 1e-15, 1e-13, 1e-10, 1e-7, 1e-5, 1e-3}) {
    for (const double place : {0.0, 0.3, 0.999}) {
      const Sphere<3, double> sphere{up * (1 + height) + along * place, 0.5};
      const Penetration<3> found = penetration_of_simple(sphere, box);
      EXPECT_NEAR(length(found.normal + up), 0, 1e-9) << height << " at " << place;
      EXPECT_NEAR(found.depth, 0.5 - height, 1e-15) << height << " at " << place;
      EXPECT_LE(found.error, 1e-12);
    }
  }
}

TEST(PenetrationOfSimple, OfCapsulesWhoseAxesAlmostTouchIsAcrossBoth) {
  for (const double height : {1e-17, 1e-15, 1e-12, 1e-8, 1e-5, 1e-2}) {
    const Capsule<3, double> a{{-3, -1, 0}, {3, 1, 0}, 1};
    const Capsule<3, double> b{{-1, 2, height}, {1, -2, height}, 1};
    const Penetration<3> found = penetration_of_simple(a, b);
    EXPECT_NEAR(length(found.normal - V3(0, 0, 1)), 0, 1e-15) << height;
    EXPECT_NEAR(found.depth, 2 - height, 1e-15) << height;
  }
}

}  // namespace
}  // namespace graze::detail::penetration_cores_test
