// SPDX-License-Identifier: MIT
// The defects of each shape are in its own test.
#include <limits>

#include <gtest/gtest.h>

#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/defect.hpp>
#include <graze/shape/frustum.hpp>

namespace graze::defect_test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST(Defect, IsTheFirstOne) {
  EXPECT_EQ(defect(Sphere<2>{{0, nan}, -1}), "has a center that is not finite");
  EXPECT_EQ(defect(Sphere<2>{{0, 1}, -1}), "has a negative radius");
  EXPECT_EQ(defect(Segment<2>{{0, 1}, {0, nan}}), "has an end that is not finite");
  EXPECT_EQ(defect(Obb<2>{{0, 0}, {1, nan}, {}}), "has half_extents that are not finite");
  EXPECT_EQ(defect(Sphere<2>{{0, 1}, 0}), "");
}

TEST(Defect, NamesTheElementsOfAList) {
  Frustum<2> frustum;
  EXPECT_EQ(defect(frustum), "");
  frustum.corners.back().x = nan;
  EXPECT_EQ(defect(frustum), "has a corner that is not finite");
  EXPECT_EQ(defect(Compound<2>{{{Sphere<2>{{0, 0}, -1}, {}}}}), "has a part that is not valid");
}

}  // namespace
}  // namespace graze::defect_test
