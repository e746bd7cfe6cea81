// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/shape/hull/frame.hpp>

#include "catalogue.hpp"
#include "query/point_sets.hpp"

namespace graze::detail::hull_frame_test {
namespace {

TEST(HullFrame, SeesPointsFromTheMiddleOfTheirBoxInUnits) {
  const std::vector<Vec<3, float>> points{{1, 2, 3}, {5, 2, 3}, {3, 3, 2}, {5, 1, 4}};
  const HullFrame<float> frame(points);
  EXPECT_EQ(frame.size(), 4U);
  EXPECT_EQ(frame.ends(), (std::array<std::uint32_t, 2>{0, 1}));
  EXPECT_EQ(frame.half_extents(), (Vec<3, double>(0.5, 0.25, 0.25)));
  EXPECT_EQ(frame.at(0).place, (Vec<3, double>(-0.5, 0, 0)));
  EXPECT_EQ(frame.at(3).place, (Vec<3, double>(0.5, -0.25, 0.25)));
  EXPECT_EQ(frame.at(3).index, 3U);
  EXPECT_EQ(frame.point(2), points[2]);
  EXPECT_EQ(all_points(frame)[2].place, frame.at(2).place);
}

TEST(HullFrame, OfOnePointHasNoExtent) {
  const std::vector<Vec<3, double>> points{{7, 8, 9}, {7, 8, 9}};
  const HullFrame<double> frame(points);
  EXPECT_EQ(frame.point(frame.ends()[0]), frame.point(frame.ends()[1]));
  EXPECT_EQ(frame.half_extents(), (Vec<3, double>(0)));
  EXPECT_EQ(frame.at(1).place, (Vec<3, double>(0)));
}

TEST(HullFrame, IsExactOnAGridOfFewStepsAlone) {
  const auto is_exact = [](double step, double far) {
    return HullFrame<double>(std::vector<Vec<3, double>>{{0, 0, 0}, {step, -3 * step, 0}, {far, far, far}}).is_exact();
  };
  EXPECT_TRUE(is_exact(1, 7));
  EXPECT_TRUE(is_exact(0x1p-5, 3));
  EXPECT_TRUE(is_exact(1, 32764));
  EXPECT_FALSE(is_exact(1, 131073));
  EXPECT_FALSE(is_exact(0.1, 0.9));
  EXPECT_FALSE(is_exact(1e-30, 1));
}

TEST(HullFrame, BringsNumbersIntoRange) {
  const double huge = std::numeric_limits<double>::max();
  const std::vector<Vec<3, double>> points{{huge, 0, 0}, {-huge, 0, 1}, {0, huge, -huge}, {0, -huge, 0x1p1000}};
  const HullFrame<double> frame(points);
  EXPECT_EQ(frame.at(0).place.x, 1 - 0x1p-53);
  EXPECT_EQ(frame.point(1).z, 0);
  EXPECT_GT(frame.point(3).z, 0);
  EXPECT_EQ(frame.orientation_of({0, 1, 2}, 3), frame.orientation_of({1, 2, 0}, 3));
  EXPECT_NE(frame.orientation_of({0, 1, 2}, 3), 0);
}

template <class T>
class HullFrameIn : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(HullFrameIn, Scalars);

TYPED_TEST(HullFrameIn, HasPlanesThatAreRightOrInDoubt) {
  using T = TypeParam;
  test::check_property([] {
    const std::vector<Vec<3, T>> points = test::draw_points<3, T>(12);
    const HullFrame<T> frame(points);
    const auto index = [&](std::size_t i) { return static_cast<std::uint32_t>((i * 7) % points.size()); };
    for (std::size_t i = 0; i < points.size(); ++i) {
      RC_ASSERT(max_abs(frame.at(index(i)).place) <= 1);
      const std::array<std::uint32_t, 3> corners{index(i), index(i + 1), index(i + 3)};
      const HullPlane plane = frame.plane(frame.at(corners[0]), frame.at(corners[1]), frame.at(corners[2]));
      for (std::uint32_t k = 0; k < points.size(); ++k) {
        const double height = plane.height(frame.at(k).place);
        const int side = frame.orientation_of(corners, k);
        if (height > plane.doubt) RC_ASSERT(side == 1);
        if (height < -plane.doubt) RC_ASSERT(side == -1);
        if (frame.is_exact()) RC_ASSERT(plane.doubt == 0 && side == (height > 0 ? 1 : 0) - (height < 0 ? 1 : 0));
      }
    }
  });
}

}  // namespace
}  // namespace graze::detail::hull_frame_test
