// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <graze/math/exact/twofold.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/query/convex/depth_face.hpp>

namespace graze::detail::depth_face_test {
namespace {

using V2 = Vec<2, double>;
using V3 = Vec<3, double>;

/// Without rounding errors.
template <Dim N>
TwofoldVec<N> at(const Vec<N, double>& corner) {
  return twofold_difference(corner, Vec<N, double>(0.0));
}

DepthFace<2> face_of(const V2& a, const V2& b) { return depth_face<2>({at(a), at(b)}); }
DepthFace<3> face_of(const V3& a, const V3& b, const V3& c) { return depth_face<3>({at(a), at(b), at(c)}); }

TEST(DepthFace, OfAnEdgeIsOnItsRight) {
  const DepthFace<2> face = face_of({2, -1}, {2, 3});
  EXPECT_EQ(face.normal, V2(1, 0));
  EXPECT_EQ(face.height, 2);
  EXPECT_EQ(face.outside, 0);
}

TEST(DepthFace, SaysHowFarTheFootIsOutsideAnEdge) {
  EXPECT_EQ(face_of({2, 1}, {2, 3}).outside, 1);
  EXPECT_EQ(face_of({2, -5}, {2, -2}).outside, 2);
}

TEST(DepthFace, OfATriangleLooksToWhereItsCornersAreCounterClockwise) {
  const DepthFace<3> face = face_of({-1, -1, 2}, {3, -1, 2}, {-1, 3, 2});
  EXPECT_EQ(face.normal, V3(0, 0, 1));
  EXPECT_EQ(face.height, 2);
  EXPECT_EQ(face.outside, 0);
}

TEST(DepthFace, SaysHowFarTheFootIsOutsideATriangle) {
  EXPECT_EQ(face_of({-1, 1, 2}, {3, 1, 2}, {-1, 3, 2}).outside, 1);
  EXPECT_NEAR(face_of({-3, -3, 2}, {1, -3, 2}, {-3, 1, 2}).outside, std::sqrt(2.0), 1e-15);
}

TEST(DepthFace, OfCornersOnALineHasNoNormal) {
  const DepthFace<3> face = face_of({0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  EXPECT_EQ(face.normal, V3(0.0));
  EXPECT_EQ(face.outside, std::numeric_limits<double>::infinity());
}

// Two edges that are 2^-40 off parallel, far from each other's ends: their differences, rounded, turn the normal.
TEST(DepthFace, OfRoundedCornersIsThatOfExactOnes) {
  const double little = 0x1p-40;
  const V3 a0(1, 0.1, 0.7);
  const V3 a1(-2, 0.1, 0.7);
  const V3 b0(0.3, 0.1, 0.2);
  const V3 b1(-0.9, 0.1 + little, 0.2);
  const DepthFace<3> face =
      depth_face<3>({twofold_difference(a0, b0), twofold_difference(a1, b0), twofold_difference(a0, b1)});
  EXPECT_NEAR(std::fabs(face.normal.z), 1, tolerance::epsilon);
  EXPECT_EQ(face.normal.x, 0);
  EXPECT_EQ(face.normal.y, 0);
}

}  // namespace
}  // namespace graze::detail::depth_face_test
