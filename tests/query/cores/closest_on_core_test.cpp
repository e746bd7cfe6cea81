// SPDX-License-Identifier: MIT
// Projections to triangles and polygons that are long and thin, or far away, against the oracle.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/vec.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/cores/closest_on_core.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact/point.hpp"

namespace graze::test::foot_test {
namespace {

using D2 = Vec<2, double>;
using D3 = Vec<3, double>;

/// Numbers that are the same everywhere.
class Numbers {
 public:
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1p-53);
  }
  double power_of_two(int low, int high) { return std::ldexp(1.0, static_cast<int>(between(low, high + 1))); }
  double signed_number(int low, int high) {
    return power_of_two(low, high) * between(1, 2) * (between(0, 1) < 0.5 ? -1 : 1);
  }
  D3 vector(int low, int high) {
    return {signed_number(low, high), signed_number(low, high), signed_number(low, high)};
  }

 private:
  std::mt19937_64 engine_{7};
};

/// The error of the projection, in epsilon of the largest coordinate.
double projection_error(const Triangle<3, double>& triangle, const D3& p) {
  double largest = max_abs(p);
  for (const D3& corner : triangle.vertices()) largest = std::max(largest, max_abs(corner));
  const D3 closest = detail::closest_on(triangle, p).point;
  return exact_miss<3, double>(triangle, p, closest) / (largest * std::numeric_limits<double>::epsilon());
}

/// A triangle up to 2^45 times longer than wide, and a point on it, near it, or far above.
struct Needle {
  Triangle<3, double> triangle;
  D3 point;
};

Needle draw_needle(Numbers& numbers) {
  const D3 start = numbers.vector(-3, 3);
  const D3 way = numbers.vector(0, 3) * numbers.power_of_two(0, 20);
  const double width = max_abs(way) * numbers.power_of_two(-45, 0);
  const Triangle<3, double> needle{start, start + way,
                                   start + way * numbers.between(-0.2, 1.2) + numbers.vector(0, 2) * width};
  const double share = numbers.between(-0.1, 1.1);
  const D3 across = (needle.c - needle.a) * (numbers.between(-0.1, 1.1) * (1 - share));
  const double height = max_abs(way) * numbers.power_of_two(-45, 3);
  return {needle, needle.a + (needle.b - needle.a) * share + across + numbers.vector(0, 0) * height};
}

TEST(ClosestOnCore, OnANeedleInSpaceIsRightToAFewUlpWhereverItIsSeenFrom) {
  Numbers numbers;
  double worst = 0;
  std::size_t seen = 0;
  for (int i = 0; i < 4000; ++i) {
    const Needle drawn = draw_needle(numbers);
    if (!(exact_signed_distance<3, double>(drawn.triangle, drawn.point) > 0)) continue;
    worst = std::max(worst, projection_error(drawn.triangle, drawn.point));
    ++seen;
  }
  EXPECT_GT(seen, 3000U);
  EXPECT_LE(worst, 8) << "measured: 3.7";
}

TEST(ClosestOnCore, OfNeedlesThatOnceHadItAWidthAwayOrAtTheOtherEnd) {
  // The plane of the first was rotated by the rounding of its edges; the projections to the edges of the second were
  // equally far away as far as distances tell; the third's point is near the line of an edge, and behind it.
  const std::array<Needle, 3> needles = {{
      {{{-1.3628547356821441, -0.73907741331835841, -2.2332251308684317},
        {302.65205884602153, -196.34540069117796, 202.21576192904925},
        {256.56805548029547, -166.69447728297973, 171.22442753721205}},
       {91.798249618952482, -94.538154556905795, 214.14582635921442}},
      {{{12.554279316148257, 14.430749427336721, -0.44497417387128857},
        {-63911.456068518863, -153194.2069777147, -130869.23651985363},
        {-37940.332225809085, -90948.637312370905, -77700.640899036167}},
       {-671.25759748705605, -85908.491243267345, -56962.742588095338}},
      {{{-0.23075966827539102, -1.8449023457031415, -4.030486692410844},
        {-1251.6709204515828, -1887.6242233867795, -475.28512126333453},
        {-346.23316673475017, -523.23154529005944, -134.32456148131794}},
       {-345.1910254695249, -521.66115582266707, -133.93212250060941}},
  }};
  for (const Needle& needle : needles) EXPECT_LE(projection_error(needle.triangle, needle.point), 4);
}

TEST(ClosestOnCore, OnATriangleOfAnySizeScalesByPowersOfTwoExactly) {
  const Triangle<3, double> triangle{{0, 0, 0}, {3, 1, 0}, {1, 4, 0.5}};
  for (const D3 p : {D3(1, 1, 2), D3(5, 1, 1), D3(-1, -1, 3), D3(3, 4, -1)}) {
    const D3 closest = detail::closest_on(triangle, p).point;
    for (const double scale : {0x1p-460, 0x1p460}) {
      const Triangle<3, double> scaled{triangle.a * scale, triangle.b * scale, triangle.c * scale};
      EXPECT_EQ(detail::closest_on(scaled, p * scale).point, closest * scale);
    }
  }
}

TEST(ClosestOnCore, OfTrianglesThatAreLinesOrPointsIsThatOfTheirEdges) {
  const Triangle<3, double> line{{0, 0, 0}, {3, 3, 3}, {1, 1, 1}};
  EXPECT_EQ(detail::closest_on(line, D3(2, 2, 2) + D3(1, -1, 0)).point, D3(2, 2, 2));
  EXPECT_EQ(detail::closest_on(line, D3(4, 5, 6)).point, D3(3, 3, 3));
  EXPECT_EQ(detail::closest_on(line, D3(-1, 0, 0)).point, D3(0, 0, 0));
  const Triangle<3, double> point{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
  EXPECT_EQ(detail::closest_on(point, D3(1, 2, 8)).point, D3(1, 2, 3));
  EXPECT_EQ(detail::closest_on(point, D3(1, 2, 8)).off, D3(0, 0, 5));
}

/// A very blunt corner at zero, with a point beyond the edge before it, close to the corner: the projections to the
/// edge and to the corner are equally far.
TEST(ClosestOnCore, BesideABluntCornerOfAPolygonIsOnTheRightEdge) {
  const std::vector<D2> corners = {{-4, 1}, {-1, 0}, {0, 0}, {1, 0x1p-12}, {4, 2}};
  const Polytope<2, double> polygon = convex_hull<2, double>(corners);
  ASSERT_EQ(polygon.vertices().size(), 5U);
  for (const double place : {-1e-3, -1e-6, -1e-9, -1e-12, 0.0}) {
    for (const double height : {1e-3, 1.0, 1e3}) {
      const D2 p(place, -height);
      const D2 closest = closest_point(polygon, p);
      const double unit = std::max(4.0, height) * std::numeric_limits<double>::epsilon();
      EXPECT_LE((exact_miss<2, double>(polygon, p, closest)), 4 * unit) << place << " " << height;
    }
  }
}

TEST(ClosestOnCore, FromInsideAPolygonIsOnTheNearestEdge) {
  const std::array<D2, 4> square = {D2(0, 0), D2(4, 0), D2(4, 4), D2(0, 4)};
  const auto found = detail::closest_on_polygon<double>(square, D2(3, 2.5));
  EXPECT_TRUE(found.is_inside);
  EXPECT_EQ(found.closest.point, D2(4, 2.5));
  const auto corner = detail::closest_on_polygon<double>(square, D2(5, 7));
  EXPECT_FALSE(corner.is_inside);
  EXPECT_EQ(corner.closest.point, D2(4, 4));
  const std::array<D2, 2> line = {D2(0, 0), D2(4, 0)};
  EXPECT_EQ(detail::closest_on_polygon<double>(line, D2(1, 0)).closest.point, D2(1, 0));
  EXPECT_FALSE(detail::closest_on_polygon<double>(line, D2(1, 0)).is_inside);
}

TEST(FacedTriangle, HasANormalAboutAsLongAsOneAcrossAllButALine) {
  const detail::FacedTriangle face = detail::faced({{1, 1, 1}, {5, 1, 1}, {1, 4, 1}});
  EXPECT_EQ(abs(face.normal), D3(0, 0, 1));
  EXPECT_EQ(face.longest, 1U);
  const detail::FacedTriangle line = detail::faced({{1, 1, 1}, {2, 2, 2}, {4, 4, 4}});
  EXPECT_EQ(line.normal, D3(0, 0, 0));
  EXPECT_EQ(line.longest, 2U);
  EXPECT_EQ(closest_on(line, D3(3, 3, 3)).point, D3(3, 3, 3));
}

}  // namespace
}  // namespace graze::test::foot_test
