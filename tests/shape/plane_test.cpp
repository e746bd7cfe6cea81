// SPDX-License-Identifier: MIT
#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/shape/plane.hpp>

#include "../catalogue/nasty.hpp"

namespace graze::plane_test {
namespace {

template <class S>
class PlaneIn : public testing::Test {};
TYPED_TEST_SUITE(PlaneIn, test::Spaces);

TYPED_TEST(PlaneIn, NamesTheDefectOfEveryNumber) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  EXPECT_EQ(
      test::expect_defects(Plane<N, T>{},
                           test::direction_along(1, "has a normal that is not finite", "has a normal of length zero"),
                           test::finite("has an offset that is not finite")),
      (N + 1) * 11);
}

TYPED_TEST(PlaneIn, MovesWithItsPoints) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const Pose<N, T> pose = *test::any<Pose<N, T>>();
    const auto from = test::draw_source<N, T>();
    const Vec<N, T> point = *from.point;
    const Vec<N, T> normal = *from.direction;
    const double offset = dot(wide<N, T>(normal), wide<N, T>(point));
    const Plane<N, T> moved = transformed(Plane<N, T>{normal, static_cast<T>(offset)}, pose);
    const Vec<N, double> image = wide<N, T>(transformed(point, pose));
    const double size = static_cast<double>(max_abs(point)) + static_cast<double>(max_abs(pose.position));
    const double band =
        32 * static_cast<double>(std::numeric_limits<T>::epsilon()) * size * static_cast<double>(sum_abs(normal));
    RC_ASSERT(std::fabs(dot(wide<N, T>(moved.normal), image) - static_cast<double>(moved.offset)) <= band);
  });
}

TEST(Plane, DefaultsToTheGround) {
  EXPECT_EQ((Plane<2>{}.normal), (Vec<2, float>(0, 1)));
  EXPECT_EQ((Plane<3, double>{}.normal), (Vec<3, double>(0, 1, 0)));
  EXPECT_EQ((Plane<3, double>{}.offset), 0);
}

TEST(Plane, ThroughThreePointsFacesTheSideFromWhichTheyRunCounterClockwise) {
  const Plane<3, float> plane = plane_through(Vec<3, float>(0, 0, 5), Vec<3, float>(2, 0, 5), Vec<3, float>(0, 3, 5));
  EXPECT_EQ(plane.normal, (Vec<3, float>(0, 0, 6)));  // twice the area
  EXPECT_EQ(plane.offset, 30);
}

TEST(Plane, ThroughTwoPointsFacesLeft) {
  const Plane<2, float> line = plane_through(Vec<2, float>(1, 1), Vec<2, float>(4, 1));
  EXPECT_EQ(line.normal, (Vec<2, float>(0, 3)));
  EXPECT_EQ(line.offset, 3);
}

TEST(Plane, ThroughPointsOnALineIsRefusedWithTheReason) {
  const Vec<3, double> a(1, 2, 3);
  for (const Vec<3, double>& c : {a, Vec<3, double>(2, 4, 6), Vec<3, double>(0, 0, 0)}) {
    try {
      plane_through(a, Vec<3, double>(2, 4, 6), c);
      ADD_FAILURE() << "accepted " << c;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()), "plane_through: the three points lie on one line");
    }
  }
}

TEST(Plane, ThroughPointsOfOneLineIsRefusedThoughTheirCrossProductRoundsToSomething) {
  const Vec<3, double> v(0.1, 0.7, 0.3);
  ASSERT_NE(cross(v * 2.0 - v, v * 4.0 - v), (Vec<3, double>(0.0))) << "the usual check would do";
  EXPECT_THROW(plane_through(v, Vec<3, double>(v * 2.0), Vec<3, double>(v * 4.0)), std::invalid_argument);
}

TEST(Plane, ThroughPointsThatAreAlmostOnOneLineHasTheRightNormal) {
  // (1, 0, 0) x (1, 2^-52, 0) = (0, 0, 2^-52).
  const double little = 0x1p-52;
  const Plane<3, double> plane =
      plane_through(Vec<3, double>(0, 0, 0), Vec<3, double>(1, 0, 0), Vec<3, double>(1, little, 0));
  EXPECT_EQ(plane.normal, (Vec<3, double>(0, 0, little)));
}

TEST(Plane, ThroughEqualPointsIsRefusedWithTheReason) {
  try {
    plane_through(Vec<2, float>(1, 2), Vec<2, float>(1, 2));
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "plane_through: the two points are equal");
  }
}

TEST(Plane, ThatItsNumbersCannotHoldIsRefusedWithTheReason) {
  const std::string reason =
      "plane_through: the points are too close together or too far away for the normal and offset to be numbers of "
      "their type";
  const auto refusal = [](const auto&... points) -> std::string {
    try {
      plane_through(points...);
      return "";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  const Vec<3, float> origin(0);
  // A normal of 1e-60 and of 1e60, then an offset of 1e45: no floats.
  EXPECT_EQ(refusal(origin, Vec<3, float>(1e-30F, 0, 0), Vec<3, float>(0, 1e-30F, 0)), reason);
  EXPECT_EQ(refusal(origin, Vec<3, float>(1e30F, 0, 0), Vec<3, float>(0, 1e30F, 0)), reason);
  EXPECT_EQ(refusal(Vec<2, float>(1e30F, 0), Vec<2, float>(1e30F, 1e15F)), reason);
  EXPECT_EQ(refusal(Vec<2, float>(1e15F, 0), Vec<2, float>(1e15F, 1e15F)), "");
}

TEST(Plane, TurnsItsNormalAndShiftsItsOffset) {
  const Pose<2, double> pose{rotation_matrix(90), {10, 20}};
  const Plane<2, double> moved = transformed(Plane<2, double>{{0, 2}, 6}, pose);  // y = 3 becomes x = 10 - 3
  EXPECT_EQ(moved.normal, (Vec<2, double>(-2, 0)));
  EXPECT_EQ(moved.offset, -14);
}

TEST(UnitPlane, has_a_normal_of_length_one_whatever_its_scale) {
  for (const double scale : {1.0, 1e-300, 1e300}) {
    const Plane<2, double> unit = unit_plane(Plane<2, double>{{3 * scale, 4 * scale}, 10 * scale});
    EXPECT_NEAR(unit.normal.x, 0.6, 1e-15);
    EXPECT_NEAR(unit.normal.y, 0.8, 1e-15);
    EXPECT_NEAR(unit.offset, 2, 1e-14);
  }
}

}  // namespace
}  // namespace graze::plane_test
