// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <graze/shape/point.hpp>
#include <graze/shape/shape.hpp>

#include "../catalogue/nasty.hpp"

namespace graze::point_test {
namespace {

static_assert(Convex<Vec<2, float>> && dimension_of<Vec<3, double>> == 3);

template <class S>
class PointIn : public testing::Test {};
TYPED_TEST_SUITE(PointIn, test::Spaces);

TYPED_TEST(PointIn, IsValidWhenEveryCoordinateIsFinite) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (Dim i = 0; i < N; ++i) {
    for (const T value : test::nasty_values<T>) {
      Vec<N, T> point(T(2));
      point[i] = value;
      EXPECT_EQ(defect(point), std::isfinite(value) ? "" : "has a coordinate that is not finite") << point;
      EXPECT_EQ(is_valid(point), std::isfinite(value)) << point;
    }
  }
}

TEST(Point, IsItsOwnSupport) {
  const Vec<2, float> point(0.1F, -2);
  EXPECT_EQ(support(point, {1, 0}), (Vec<2, double>(0.100000001490116119384765625, -2)));
  EXPECT_EQ(support(point, {-1e-300, 0}), support(point, {1, 0}));
}

}  // namespace
}  // namespace graze::point_test
