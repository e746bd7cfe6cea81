// SPDX-License-Identifier: MIT
// A triangle that a ray hits is never left out, however near to its edge; most others are.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <graze/query/ray/triangle_lanes.hpp>
#include <graze/query/ray_cast.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail::ray_triangle_lanes_test {
namespace {

template <class T>
class LanesOfRays : public ::testing::Test {
 public:
  using Number = T;
  using Point = Vec<3, T>;

  static Point draw_point(std::mt19937& random) {
    std::uniform_real_distribution<double> anywhere(-1, 1);
    return Point(Vec<3, double>(anywhere(random), anywhere(random), anywhere(random)));
  }

  static TriangleBlock<3, T> draw_block(std::mt19937& random, T size, const Point& around) {
    TriangleBlock<3, T> block;
    for (std::size_t lane = 0; lane < row_length; ++lane) {
      const Point center = around + draw_point(random);
      block.set(lane, {center + size * draw_point(random), center + size * draw_point(random),
                       center + size * draw_point(random)});
    }
    return block;
  }

  /// The lanes that a query visits, and how many of them are hit; none of the others may be.
  static LaneMask met(const TriangleBlock<3, T>& block, const Ray<3, T>& ray, double size) {
    const double grown = tolerance::box_slack * (size + static_cast<double>(max_abs(ray.origin)));
    const LaneMask lanes =
        met_lanes(block, lane_line<T>(wide<3, T>(ray.origin), wide<3, T>(ray.direction), size, grown));
    for (std::size_t lane = 0; lane < row_length; ++lane) {
      const bool is_hit = ray_cast(block.triangle(lane), ray).has_value();
      EXPECT_TRUE(!is_hit || (lanes >> lane & 1U) != 0) << lane;
    }
    return lanes;
  }

  static double size_from(const TriangleBlock<3, T>& block, const Point& origin) {
    double size = 0;
    for (std::size_t lane = 0; lane < row_length; ++lane) {
      for (const Point& corner : block.triangle(lane).vertices()) {
        size = std::max(size, sum_abs(wide<3, T>(corner) - wide<3, T>(origin)));
      }
    }
    return size;
  }
};
using Numbers = ::testing::Types<float, double>;
TYPED_TEST_SUITE(LanesOfRays, Numbers);

TYPED_TEST(LanesOfRays, HoldEveryTriangleThatIsHit) {
  using T = typename TestFixture::Number;
  std::mt19937 random(1);
  for (const T size : {T(1), T(0.01), T(1e-4)}) {
    for (const T away : {T(0), T(1000)}) {
      for (int round = 0; round < 300; ++round) {
        const Vec<3, T> around(away);
        const TriangleBlock<3, T> block = TestFixture::draw_block(random, size, around);
        const Triangle<3, T> aim = block.triangle(random() % row_length);
        const Vec<3, T> origin = around + T(10) * TestFixture::draw_point(random);
        // At a corner, an edge, or inside.
        const T part = static_cast<T>(random() % 3) / 2;
        const Vec<3, T> target = aim.a + part * (aim.b - aim.a);
        const Ray<3, T> ray{origin, (target - origin) * T(0.37)};
        TestFixture::met(block, ray, TestFixture::size_from(block, origin));
      }
    }
  }
}

TYPED_TEST(LanesOfRays, LeaveOutMostTrianglesThatAreMissed) {
  using T = typename TestFixture::Number;
  std::mt19937 random(2);
  std::size_t visited = 0;
  std::size_t hit = 0;
  for (int round = 0; round < 2000; ++round) {
    const TriangleBlock<3, T> block = TestFixture::draw_block(random, T(0.5), Vec<3, T>(T(0)));
    const Vec<3, T> origin = T(5) * TestFixture::draw_point(random);
    const Vec<3, T> direction = TestFixture::draw_point(random) - origin;
    const LaneMask lanes = TestFixture::met(block, {origin, direction}, TestFixture::size_from(block, origin));
    visited += static_cast<std::size_t>(std::popcount(lanes));
    for (std::size_t lane = 0; lane < row_length; ++lane) {
      const Ray<3, T> both_ways{origin - T(100) * direction, direction};
      hit += ray_cast(block.triangle(lane), both_ways) ? 1U : 0U;
    }
  }
  EXPECT_GT(hit, 200U);
  EXPECT_LT(visited, hit + hit / 100 + 5);
}

// Where products overflow or vanish, no triangle is left out.
TYPED_TEST(LanesOfRays, HoldAllTrianglesOutOfRange) {
  using T = typename TestFixture::Number;
  std::mt19937 random(3);
  const T large = std::sqrt(std::numeric_limits<T>::max());
  const T small = std::sqrt(std::numeric_limits<T>::min());
  for (const T scale : {large, small}) {
    for (int round = 0; round < 100; ++round) {
      TriangleBlock<3, T> block = TestFixture::draw_block(random, T(0.5), Vec<3, T>(T(0)));
      for (auto& corner : block.corners) {
        for (Row<T>& row : corner) {
          for (T& coordinate : row) coordinate *= scale;
        }
      }
      const Vec<3, T> origin = scale * T(2) * TestFixture::draw_point(random);
      const Triangle<3, T> aim = block.triangle(0);
      const Vec<3, T> direction = aim.a / T(3) + aim.b / T(3) + aim.c / T(3) - origin;
      TestFixture::met(block, {origin, direction}, TestFixture::size_from(block, origin));
    }
  }
}

}  // namespace
}  // namespace graze::detail::ray_triangle_lanes_test

#endif
