// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <graze/shape/half_space.hpp>

#include "../catalogue/nasty.hpp"

namespace graze::half_space_test {
namespace {

template <class S>
class HalfSpaceIn : public testing::Test {};
TYPED_TEST_SUITE(HalfSpaceIn, test::Spaces);

TYPED_TEST(HalfSpaceIn, NamesTheDefectOfEveryNumber) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  EXPECT_EQ(
      test::expect_defects(HalfSpace<N, T>{},
                           test::direction_along(1, "has a normal that is not finite", "has a normal of length zero"),
                           test::finite("has an offset that is not finite")),
      (N + 1) * 11);
}

TEST(HalfSpace, DefaultsToTheGroundAndWhatIsBelow) {
  EXPECT_EQ((HalfSpace<3>{}.normal), (Vec<3, float>(0, 1, 0)));
  EXPECT_EQ((HalfSpace<3>{}.offset), 0);
}

TEST(HalfSpace, IsBoundedByItsPlane) {
  const Plane<2, double> plane = boundary(HalfSpace<2, double>{{3, 4}, -5});
  EXPECT_EQ(plane.normal, (Vec<2, double>(3, 4)));
  EXPECT_EQ(plane.offset, -5);
}

TEST(HalfSpace, MovesWithItsPlane) {
  const Pose<2, double> pose{rotation_matrix(90), {10, 20}};
  const HalfSpace<2, double> moved = transformed(HalfSpace<2, double>{{0, 2}, 6}, pose);
  EXPECT_EQ(moved.normal, (Vec<2, double>(-2, 0)));
  EXPECT_EQ(moved.offset, -14);
}

}  // namespace
}  // namespace graze::half_space_test
