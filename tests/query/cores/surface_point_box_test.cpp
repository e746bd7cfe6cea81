// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include <graze/math/vec.hpp>
#include <graze/query/cores/surface_point_box.hpp>

namespace graze::test::surface_point_box_test {
namespace {

using D2 = Vec<2, double>;
using D3 = Vec<3, double>;

TEST(SurfacePointBox, AnObliqueBoxIsTakenAsStored) {
  // The second axis is tilted by nearly the maximum: the box is a parallelogram.
  const double lean = 0.9e-4;
  const Obb<2, double> box{{0, 0}, {1, 1}, {{1, 0}, {lean, 1}}};
  const auto corner = detail::surface_point(box, D2(5, 5));
  EXPECT_NEAR(max_abs(corner.point - D2(1 + lean, 1)), 0, 1e-15);
  const auto right = detail::surface_point(box, D2(5, 0));
  // From (5, 0) perpendicular to the tilted face, x = 1 + lean y.
  const double y = lean * 4 / (1 + lean * lean);
  EXPECT_NEAR(max_abs(right.point - D2(1 + lean * y, y)), 0, 1e-15);
  EXPECT_NEAR(right.distance, 4 / std::sqrt(1 + lean * lean), 1e-15);
  const auto inside = detail::surface_point(box, D2(0.5, 0));
  EXPECT_NEAR(inside.distance, -0.5 / std::sqrt(1 + lean * lean), 1e-15);
  EXPECT_NEAR(inside.point.x - lean * inside.point.y, 1, 1e-15);
}

TEST(SurfacePointBox, FaceNormalsInvertTheAxes) {
  const Mat<3, double> axes({1, 5e-5, 0}, {0, 1, -5e-5}, {3e-5, 0, 1});
  const Mat<3, double> normals = detail::face_normals(axes);
  for (Dim i = 0; i < 3; ++i) {
    for (Dim j = 0; j < 3; ++j) EXPECT_NEAR(dot(normals[i], axes[j]), i == j ? 1 : 0, 1e-15);
  }
}

TEST(SurfacePointBox, APlaceBeyondACornerIsTheCorner) {
  const Obb<3, double> box{{1, 1, 1}, {1, 2, 3}, Mat<3, double>(1.0)};
  const auto found = detail::place_in(box, D3(9, 9, -9));
  EXPECT_EQ(found.place, D3(1, 2, -3));
  EXPECT_EQ(found.off, D3(7, 6, -7));
}

}  // namespace
}  // namespace graze::test::surface_point_box_test
