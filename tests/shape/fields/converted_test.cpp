// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include <graze/shape/fields/converted.hpp>
#include <graze/shape/frustum.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/point.hpp>

namespace graze::converted_test {
namespace {

TEST(Converted, ChangesEveryNumber) {
  const Obb<2, double> box{{1, 2}, {3, 4}, {{5, 6}, {7, 8}}};
  const Obb<2, float> twice =
      detail::converted<float>(box, [](double number) { return static_cast<float>(2 * number); });
  EXPECT_EQ(twice.center, (Vec<2, float>(2, 4)));
  EXPECT_EQ(twice.half_extents, (Vec<2, float>(6, 8)));
  EXPECT_EQ(twice.axes, (Mat<2, float>(10, 12, 14, 16)));
}

TEST(Converted, WidensExactly) {
  Frustum<2, float> frustum;
  frustum.corners[3] = {0.1F, -0.0F};
  const Frustum<2, double> wide = detail::widened(frustum);
  EXPECT_EQ(wide.corners[0], (Vec<2, double>(-1, -1)));
  EXPECT_EQ(wide.corners[3].x, static_cast<double>(0.1F));
  EXPECT_TRUE(std::signbit(wide.corners[3].y));
}

}  // namespace
}  // namespace graze::converted_test
