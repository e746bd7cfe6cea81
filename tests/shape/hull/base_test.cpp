// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/shape/hull/base.hpp>

namespace graze::detail::hull_base_test {
namespace {

using V = Vec<3, double>;

std::vector<V> base_of(const std::vector<V>& points) {
  const HullFrame<double> frame{std::span<const V>(points)};
  const HullBase<double> base(frame, all_points(frame));
  std::vector<V> result;
  for (const std::uint32_t place : base.places()) result.push_back(points[place]);
  return result;
}

TEST(HullBase, HasAsManyPointsAsTheirSpanHasDimensionsAndOneMore) {
  EXPECT_EQ(base_of({V(1, 2, 3), V(1, 2, 3)}).size(), 1U);
  EXPECT_EQ(base_of({V(0, 0, 0), V(1, 1, 1), V(3, 3, 3), V(2, 2, 2)}).size(), 2U);
  EXPECT_EQ(base_of({V(0, 0, 1), V(4, 0, 1), V(2, 2, 1), V(1, 1, 1)}).size(), 3U);
  EXPECT_EQ(base_of({V(0, 0, 1), V(4, 0, 1), V(2, 2, 1), V(1, 1, std::nextafter(1.0, 2.0))}).size(), 4U);
}

TEST(HullBase, OfNearlyFlatPointsTakesOneThatIsOffForCertain) {
  // After rounding, all but the second-last are on the line x = y = z.
  std::vector<V> points;
  for (int i = 0; i < 20; ++i) points.push_back(V(0.1) * static_cast<double>(i));
  points.emplace_back(1, 1, std::nextafter(1.0, 2.0));
  points.emplace_back(1.5, 1.5, 1.5);
  EXPECT_EQ(base_of(points).size(), 3U);
}

TEST(HullBase, OfATetrahedronHasItsLastCornerOnTheInnerSide) {
  const std::vector<V> base = base_of({V(0, 0, 0), V(8, 1, 0), V(2, 5, 1), V(3, 2, 4), V(3, 2, 1)});
  ASSERT_EQ(base.size(), 4U);
  EXPECT_LT(orientation(base[0], base[1], base[2], base[3]), 0);
}

}  // namespace
}  // namespace graze::detail::hull_base_test
