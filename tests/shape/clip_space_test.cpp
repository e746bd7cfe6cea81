// SPDX-License-Identifier: MIT
#include <limits>

#include <gtest/gtest.h>

#include <graze/shape/clip_space.hpp>

namespace graze::clip_space_test {
namespace {

using detail::ClipPlane;
using detail::ClipSpace;
using detail::meeting_point;

TEST(ClipSpace, KnowsWhereEachConventionHasNearAndFar) {
  EXPECT_EQ(detail::near_depth(ClipDepth::minus_one_to_one), -1);
  EXPECT_EQ(detail::near_depth(ClipDepth::zero_to_one), 0);
  EXPECT_EQ(detail::near_depth(ClipDepth::one_to_zero), 1);
  EXPECT_EQ(detail::far_depth(ClipDepth::minus_one_to_one), 1);
  EXPECT_EQ(detail::far_depth(ClipDepth::zero_to_one), 1);
  EXPECT_EQ(detail::far_depth(ClipDepth::one_to_zero), 0);
}

TEST(ClipSpace, ReadsAMatrixByItsRows) {
  Mat<4, float> matrix(0);  // x = 2 X + 3, y = 5 Y, z = Z, w = -Z + 7, by columns
  matrix[0] = {2, 0, 0, 0};
  matrix[1] = {0, 5, 0, 0};
  matrix[2] = {0, 0, 1, -1};
  matrix[3] = {3, 0, 0, 7};
  const ClipSpace<3> clip(matrix);
  EXPECT_EQ(clip.w().height({1, 1, 2}), 5);
  EXPECT_EQ(clip.level(0, 0).height({1, 1, 2}), 5);
  // x = -w there: 2 X + 3 + 7 - Z = 0
  EXPECT_EQ(clip.level(0, -1).normal, (Vec<3, double>(2, 0, -1)));
  EXPECT_EQ(clip.level(0, -1).offset, 10);
  EXPECT_EQ(clip.level(1, 1).height({9, 2, 3}), 6);
  EXPECT_TRUE(clip.has_finite_numbers());
}

TEST(ClipSpace, SeesANumberThatIsNotFiniteWhereverItIs) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    for (Dim column = 0; column < 4; ++column) {
      for (Dim row = 0; row < 4; ++row) {
        Mat<4, float> matrix(1);
        matrix[column][row] = bad;
        EXPECT_FALSE(ClipSpace<3>(matrix).has_finite_numbers());
      }
    }
  }
}

TEST(ClipSpace, FindsThePointThatPlanesShare) {
  // 2 x = 3; x + y = 2 in 2D
  EXPECT_EQ(meeting_point({ClipPlane<2>{{2, 0}, -3}, ClipPlane<2>{{1, 1}, -2}}), (Vec<2, double>(1.5, 0.5)));
  // x = 4; y + z = 1; z = 3 in 3D, in two orders
  const ClipPlane<3> a{{1, 0, 0}, -4};
  const ClipPlane<3> b{{0, 1, 1}, -1};
  const ClipPlane<3> c{{0, 0, -2}, 6};
  EXPECT_EQ(meeting_point({a, b, c}), (Vec<3, double>(4, -2, 3)));
  EXPECT_EQ(meeting_point({c, a, b}), (Vec<3, double>(4, -2, 3)));
}

TEST(ClipSpace, ParallelPlanesShareNoPoint) {
  const ClipPlane<3> a{{1, 0, 0}, -4};
  EXPECT_FALSE(is_finite(meeting_point({a, ClipPlane<3>{{-2, 0, 0}, 1}, ClipPlane<3>{{0, 0, 1}, 1}})));
  EXPECT_FALSE(is_finite(meeting_point({ClipPlane<2>{{1, 1}, -4}, ClipPlane<2>{{0, 0}, 1}})));
}

}  // namespace
}  // namespace graze::clip_space_test
