// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/batch/neighbours.hpp>

#include "catalogue/numbers.hpp"
#include "spaces.hpp"

namespace graze::test::neighbours_test {
namespace {

template <class SpaceType>
class IndicesAlongCurve : public ::testing::Test {
 public:
  static constexpr Dim N = SpaceType::dimension;
  using T = typename SpaceType::scalar;
  using Point = Vec<N, T>;
  using Points = std::vector<Point>;

  static Points draw_points(std::size_t count, rc::Random& random) {
    Points points(count);
    for (Point& point : points) {
      for (Dim i = 0; i < N; ++i) point[i] = static_cast<T>(between(random, -1, 3));
    }
    return points;
  }

  static std::vector<std::uint32_t> order_of(const Points& points) {
    return detail::indices_along_curve(std::span<const Point>(points));
  }

  static void expect_each_once(const Points& points) {
    std::vector<std::uint32_t> indices = order_of(points);
    std::vector<std::uint32_t> all(points.size());
    std::iota(all.begin(), all.end(), 0);
    std::sort(indices.begin(), indices.end());
    EXPECT_EQ(indices, all);
  }

  static void expect_each_of_any_points_once() {
    rc::Random random(1);
    for (const std::size_t count : {0U, 1U, 2U, 3U, 100U, 4097U}) expect_each_once(draw_points(count, random));
    Points points = draw_points(100, random);
    points[3] = Point(std::numeric_limits<T>::quiet_NaN());
    points[5] = Point(std::numeric_limits<T>::infinity());
    points[7] = -points[5];
    points[11] = Point(std::numeric_limits<T>::max());
    points[13] = -points[11];
    expect_each_once(points);
  }

  static void expect_order_at_one_place() {
    const std::vector<std::uint32_t> indices = order_of(Points(50, Point(T(2))));
    EXPECT_TRUE(std::is_sorted(indices.begin(), indices.end()));
    EXPECT_EQ(indices.size(), 50U);
  }

  /// The length of the way through all points.
  template <class IndexAt>
  static double length_of_way(const Points& points, const IndexAt& index_at) {
    double sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vec<N, double> step(points[index_at(i)] - points[index_at(i - 1)]);
      sum += std::sqrt(dot(step, step));
    }
    return sum;
  }

  static void expect_short_way() {
    rc::Random random(2);
    const Points points = draw_points(4000, random);
    const std::vector<std::uint32_t> indices = order_of(points);
    const double sorted = length_of_way(points, [&indices](std::size_t i) { return indices[i]; });
    const double drawn = length_of_way(points, [](std::size_t i) { return i; });
    EXPECT_LT(sorted, (N == 2 ? 0.05 : 0.15) * drawn);
  }
};
TYPED_TEST_SUITE(IndicesAlongCurve, Spaces);

TYPED_TEST(IndicesAlongCurve, ContainEachPointOnce) { TestFixture::expect_each_of_any_points_once(); }

TYPED_TEST(IndicesAlongCurve, AscendForPointsAtOnePlace) { TestFixture::expect_order_at_one_place(); }

// Many times shorter than in the order in which the points were drawn.
TYPED_TEST(IndicesAlongCurve, AreAShortWay) { TestFixture::expect_short_way(); }

}  // namespace
}  // namespace graze::test::neighbours_test
