// SPDX-License-Identifier: MIT
// A triangle is never nearer than the least distance of its lane, never farther than the most, and hardly between.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <graze/query/closest/triangle_lanes.hpp>
#include <graze/query/signed_distance.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail::closest_triangle_lanes_test {
namespace {

template <class T>
class LanesOfPoints : public ::testing::Test {
 public:
  using Number = T;
  using Point = Vec<3, T>;

  static Point draw_point(std::mt19937& random) {
    std::uniform_real_distribution<double> anywhere(-1, 1);
    return Point(Vec<3, double>(anywhere(random), anywhere(random), anywhere(random)));
  }

  /// Of several kinds: any triangles, needles, those without area, points.
  static Triangle<3, T> draw_triangle(std::mt19937& random, T size, unsigned kind) {
    const Point a = draw_point(random);
    const Point edge = size * draw_point(random);
    const Point other = size * draw_point(random);
    const T share = static_cast<T>(random() % 5) / 4;
    if (kind == 0) return {a, a + edge, a + other};
    if (kind == 1) return {a, a + edge, a + share * edge + other / T(1000)};
    if (kind == 2) return {a, a + edge, a + share * edge};
    return {a, a, a};
  }

  static double exact_squared(const Triangle<3, T>& triangle, const Point& point) {
    const Triangle<3, double> there{wide<3, T>(triangle.a), wide<3, T>(triangle.b), wide<3, T>(triangle.c)};
    const double distance = signed_distance(there, wide<3, T>(point));
    return distance * distance;
  }
};
using Numbers = ::testing::Types<float, double>;
TYPED_TEST_SUITE(LanesOfPoints, Numbers);

TYPED_TEST(LanesOfPoints, AreOnBothSidesOfTheirTriangles) {
  using T = typename TestFixture::Number;
  std::mt19937 random(1);
  const Aabb<3, T> around{Vec<3, T>(T(-3)), Vec<3, T>(T(3))};
  int clear = 0;
  int count = 0;
  for (const T size : {T(1), T(0.01), T(1e-5)}) {
    for (unsigned kind = 0; kind < 4; ++kind) {
      for (int round = 0; round < 300; ++round) {
        TriangleBlock<3, T> block;
        for (std::size_t lane = 0; lane < row_length; ++lane) {
          block.set(lane, TestFixture::draw_triangle(random, size, kind));
        }
        Vec<3, T> point = T(2) * TestFixture::draw_point(random);
        if (round % 3 == 0) point = block.triangle(0).a + size * TestFixture::draw_point(random);
        const T most = static_cast<T>(random() % 8);
        SquaredDistances<T> squared;
        const LaneMask lanes = find_squared_distances(block, lane_point(point, around, 0), most, squared);
        for (std::size_t lane = 0; lane < row_length; ++lane) {
          const double exact = TestFixture::exact_squared(block.triangle(lane), point);
          const auto least = static_cast<double>(squared.least[lane]);
          const auto greatest = static_cast<double>(squared.most[lane]);
          EXPECT_LE(least, exact * (1 + 0x1p-48)) << "kind " << kind;
          EXPECT_GE(greatest, exact * (1 - 0x1p-48)) << "kind " << kind;
          if (kind == 0 && size == T(1)) {
            EXPECT_GE(least, exact * 0.99 - 0.001);
            clear += greatest <= exact * 1.01 + 0.001 ? 1 : 0;
            ++count;
          }
          EXPECT_EQ((lanes >> lane & 1U) != 0, squared.least[lane] <= most);
        }
      }
    }
  }
  EXPECT_GE(clear, 0.99 * count);  // the rest are points above an edge, or nearly
}

// An uncertainty of the corners only widens the range.
TYPED_TEST(LanesOfPoints, AllowForTheErrorOfThePlace) {
  using T = typename TestFixture::Number;
  std::mt19937 random(2);
  const Aabb<3, T> around{Vec<3, T>(T(-3)), Vec<3, T>(T(3))};
  constexpr T error = T(1e-3);
  for (int round = 0; round < 1000; ++round) {
    TriangleBlock<3, T> block;
    TriangleBlock<3, T> moved;
    for (std::size_t lane = 0; lane < row_length; ++lane) {
      const Triangle<3, T> triangle = TestFixture::draw_triangle(random, T(1), 0);
      block.set(lane, triangle);
      moved.set(lane, {triangle.a + error * TestFixture::draw_point(random),
                       triangle.b + error * TestFixture::draw_point(random),
                       triangle.c + error * TestFixture::draw_point(random)});
    }
    const Vec<3, T> point = T(2) * TestFixture::draw_point(random);
    SquaredDistances<T> squared;
    find_squared_distances(moved, lane_point(point, around, error), T(0), squared);
    for (std::size_t lane = 0; lane < row_length; ++lane) {
      const double exact = TestFixture::exact_squared(block.triangle(lane), point);
      EXPECT_LE(static_cast<double>(squared.least[lane]), exact);
      EXPECT_GE(static_cast<double>(squared.most[lane]), exact);
    }
  }
}

TYPED_TEST(LanesOfPoints, TellNothingWhereProductsOverflow) {
  using T = typename TestFixture::Number;
  const T far = std::sqrt(std::numeric_limits<T>::max());
  TriangleBlock<3, T> block;
  for (std::size_t lane = 0; lane < row_length; ++lane) block.set(lane, {Vec<3, T>(far), Vec<3, T>(-far), {}});
  SquaredDistances<T> squared;
  const Aabb<3, T> around{Vec<3, T>(-far), Vec<3, T>(far)};
  EXPECT_EQ(find_squared_distances(block, lane_point(Vec<3, T>(T(1)), around, 0), T(0), squared),
            first_lanes(row_length));
  EXPECT_EQ(squared.least[5], T(0));
  EXPECT_EQ(squared.most[5], std::numeric_limits<T>::max());
}

// Numbers whose products vanish.
TYPED_TEST(LanesOfPoints, AreOnBothSidesOfTinyTriangles) {
  using T = typename TestFixture::Number;
  std::mt19937 random(3);
  for (const T scale : {std::sqrt(std::numeric_limits<T>::min()), std::numeric_limits<T>::min()}) {
    for (int round = 0; round < 300; ++round) {
      TriangleBlock<3, T> block;
      for (std::size_t lane = 0; lane < row_length; ++lane) {
        const Triangle<3, T> triangle = TestFixture::draw_triangle(random, T(1), 0);
        block.set(lane, {scale * triangle.a, scale * triangle.b, scale * triangle.c});
      }
      const Vec<3, T> point = scale * T(2) * TestFixture::draw_point(random);
      SquaredDistances<T> squared;
      const Aabb<3, T> around{Vec<3, T>(T(-3)), Vec<3, T>(T(3))};
      find_squared_distances(block, lane_point(point, around, 0), T(0), squared);
      for (std::size_t lane = 0; lane < row_length; ++lane) {
        const double exact = TestFixture::exact_squared(block.triangle(lane), point);
        EXPECT_LE(static_cast<double>(squared.least[lane]), exact * (1 + 0x1p-48) + 0x1p-1000);
        EXPECT_GE(static_cast<double>(squared.most[lane]), exact * (1 - 0x1p-48));
      }
    }
  }
}

}  // namespace
}  // namespace graze::detail::closest_triangle_lanes_test

#endif
