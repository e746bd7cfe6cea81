// SPDX-License-Identifier: MIT
#include <cmath>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/bounding/fitted_axes.hpp>
#include <graze/shape/obb.hpp>

#include "query/point_sets.hpp"

namespace graze::fitted_axes_test {
namespace {

using Points = std::vector<Vec<3, double>>;

Points corners_of_box(const Mat<3, double>& axes, const Vec<3, double>& half) {
  Points corners;
  for (const double x : {-half.x, half.x}) {
    for (const double y : {-half.y, half.y}) {
      for (const double z : {-half.z, half.z}) corners.push_back(axes * Vec<3, double>(x, y, z));
    }
  }
  return corners;
}

TEST(FittedAxes, MeasureBoxesByTheirSurface) {
  EXPECT_EQ(detail::surface_of({1, 2, 3}), 2 + 6 + 3);
  const Points corners = corners_of_box(Mat<3, double>(1.0), {0.5, 1, 1.5});
  EXPECT_EQ(detail::surface_along(Mat<3, double>(1.0), corners), 2 + 6 + 3);  // of the sides: half
}

TEST(FittedAxes, StartFromAnEdgeAndANormal) {
  const Mat<3, double> axes = detail::axes_from({0, 2, 0}, {1, 5, 0});
  EXPECT_EQ(axes, (Mat<3, double>({0, 1, 0}, {0, 0, 1}, {1, 0, 0})));
  for (const Vec<3, double>& normal : {Vec<3, double>(0.0), Vec<3, double>(1, 2, 3), Vec<3, double>(-2, -4, -6)}) {
    const Mat<3, double> any = detail::axes_from({1, 2, 3}, normal);
    EXPECT_LE((orthonormal_error<3, double>(any)), 1e-15);
    EXPECT_NEAR(dot(cross(any[0], any[1]), any[2]), 1, 1e-15);
    EXPECT_NEAR(dot(any[0], Vec<3, double>(1, 2, 3)), std::sqrt(14.0), 1e-15 * 8);
  }
}

TEST(FittedAxes, TurnAboutOneAxisUntilTheBoxFits) {
  const Points corners = corners_of_box(rotation_matrix(Vec<3, double>(0, 0, 1), 30), {3, 2, 1});
  const Mat<3, double> turned = detail::turned_about(2, Mat<3, double>(1.0), corners);
  EXPECT_NEAR(detail::surface_along(turned, corners), 4 * (6 + 2 + 3), 1e-13);
  EXPECT_EQ(turned[2], (Vec<3, double>(0, 0, 1)));
  EXPECT_NEAR(dot(cross(turned[0], turned[1]), turned[2]), 1, 1e-15);
}

TEST(FittedAxes, OfADoubleTetrahedronLieOnItsFaces) {
  // A corner of a cube: its longest edge is a face diagonal of the cube, and the best face one of its faces.
  const Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_NEAR(detail::surface_along(detail::ditetrahedron_axes(points), points), 3, 1e-14);
}

RC_GTEST_PROP(FittedAxes, AreRightHandedAndNeverWorseThanTheCoordinateAxesOnFewPoints, ()) {
  const std::vector<Vec<3, float>> points = test::draw_points<3, float>(60);
  const Aabb<3, float> box = bounding_box(points);
  if (detail::largest_side(box) == 0) return;
  const detail::LocalFrame<3> frame = detail::local_frame(box);
  const Mat<3, double> axes = detail::fitted_axes(std::span<const Vec<3, float>>(points), frame);
  RC_ASSERT((orthonormal_error<3, double>(axes)) <= 4 * tolerance::epsilon);
  RC_ASSERT(dot(cross(axes[0], axes[1]), axes[2]) > 0.5);
  Points local;
  for (const Vec<3, float>& point : points) local.push_back(frame.local(point));
  const double upright = detail::surface_along(Mat<3, double>(1.0), local);
  RC_ASSERT(detail::surface_along(axes, local) <= upright + 4 * tolerance::rounding);
}

}  // namespace
}  // namespace graze::fitted_axes_test
