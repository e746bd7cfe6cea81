// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/convex/simplex.hpp>

#include "catalogue.hpp"
#include "exact/verdict_instances.hpp"

namespace graze::test::simplex_test {
namespace {

template <Dim N>
detail::Simplex<N> simplex_of(const std::vector<Vec<N, double>>& points) {
  detail::Simplex<N> simplex;
  for (const Vec<N, double>& point : points) simplex.push(point);
  return simplex;
}

template <Dim N>
struct Row {
  std::vector<Vec<N, double>> points;
  Vec<N, double> nearest;
  std::size_t face;  ///< The number of corners of the face that contains it.
};

template <Dim N>
void expect_rows(const std::vector<Row<N>>& rows) {
  for (const Row<N>& row : rows) {
    const auto found = detail::nearest_to_origin(simplex_of<N>(row.points));
    EXPECT_NEAR(max_abs(found.point - row.nearest), 0, 1e-15) << row.nearest;
    EXPECT_EQ(found.face.size, row.face) << row.nearest;
    EXPECT_NEAR(found.distance_squared, dot(row.nearest, row.nearest), 1e-15) << row.nearest;
  }
}

TEST(NearestToOrigin, InThePlaneIsACornerAnEdgeOrInside) {
  expect_rows<2>({{{{3, 4}}, {3, 4}, 1},
                  {{{1, -1}, {1, 5}}, {1, 0}, 2},
                  {{{1, 1}, {1, 5}}, {1, 1}, 1},
                  {{{-1, 0}, {1, 0}}, {0, 0}, 2},
                  {{{-1, -1}, {2, -1}, {0, 3}}, {0, 0}, 3},
                  {{{-1, 1}, {2, 1}, {0, 3}}, {0, 1}, 2},
                  {{{4, -2}, {-2, 4}, {5, 5}}, {1, 1}, 2}});
}

TEST(NearestToOrigin, InSpaceIsACornerAnEdgeATriangleOrInside) {
  expect_rows<3>({{{{1, 2, 2}}, {1, 2, 2}, 1},
                  {{{1, 1, -3}, {1, 1, 5}}, {1, 1, 0}, 2},
                  {{{-1, -1, 2}, {3, -1, 2}, {-1, 3, 2}}, {0, 0, 2}, 3},
                  {{{3, 0, 0}, {0, 3, 0}, {0, 0, 3}}, {1, 1, 1}, 3},
                  {{{-1, -1, -1}, {3, -1, -1}, {-1, 3, -1}, {-1, -1, 3}}, {0, 0, 0}, 4},
                  {{{-1, -1, 1}, {3, -1, 1}, {-1, 3, 1}, {-1, -1, 3}}, {0, 0, 1}, 3},
                  {{{1, -1, 1}, {1, 3, 1}, {5, 1, 1}, {4, 1, 6}}, {1, 0, 1}, 2}});
}

TEST(NearestToOrigin, OfPointsThatCoincideIsOneOfThem) {
  expect_rows<3>({{{{1, 2, 2}, {1, 2, 2}, {1, 2, 2}}, {1, 2, 2}, 1}, {{{0, 0, 0}, {0, 0, 0}}, {0, 0, 0}, 1}});
}

// The corners of a parallelogram up to rounding, which puts each corner on the origin's side of the others' plane.
TEST(NearestToOrigin, IsNotInsideFourPointsOfAPlane) {
  const std::vector<Vec<3, double>> corners = {{-1.0998810554725873, -0.037024804499777408, 1.732643681800659},
                                               {-1.4562714720618226, 0.51893114568603438, -3.4178124326249768},
                                               {-1.4638529959551376, 2.5708045531871928, 1.1049407566084},
                                               {-1.8202434125443729, 3.1267605033730046, -4.0455153578172354}};
  const auto found = detail::nearest_to_origin(simplex_of<3>(corners));
  EXPECT_NEAR(std::sqrt(found.distance_squared), 1.2249044152627, 1e-12);
  EXPECT_LT(found.face.size, 4U);
}

// A projection off along the edge by the rounding of its position would claim to be nearer to one end.
TEST(FootOnLine, IsAtRightAnglesToTheEdgeHoweverNear) {
  const Vec<3, double> edge(0.7, -0.3, 0.9);
  const Vec<3, double> across = cross(edge, Vec<3, double>(0.1, 0.2, 0.4));
  for (const double distance : {1.0, 1e-4, 1e-8, 1e-12}) {
    const Vec<3, double> closest = detail::closest_on_line<3>(across * distance - edge * 0.3, edge);
    EXPECT_LE(std::fabs(dot(closest, edge)), 1e-15 * max_abs(closest)) << distance;
    const Vec<2, double> flat = detail::closest_on_line<2>(Vec<2, double>(-0.3, 0.4 + distance), Vec<2, double>(3, -4));
    EXPECT_LE(std::fabs(dot(flat, Vec<2, double>(3, -4))), 1e-15 * max_abs(flat)) << distance;
  }
}

template <Dim N>
void expect_exact_distance() {
  check_property([] {
    const auto points =
        *some<Vec<N, double>>(static_cast<std::size_t>(N) + 1, source_of<N, double>(Kind::nudged).point);
    std::vector<RationalVec<N>> corners;
    double size = 0;
    for (const Vec<N, double>& point : points) {
      corners.push_back(exact(point));
      size = std::max(size, max_abs(point));
    }
    const DifferenceSet<N> set(hull_of<N>(corners), hull_of<N>({exact(Vec<N, double>(0.0))}));
    const double truth = std::max(0.0, solid_verdict(set, Rational(0), Measure::distance).gap);
    const auto found = detail::nearest_to_origin(simplex_of<N>(points));
    RC_ASSERT(std::fabs(std::sqrt(found.distance_squared) - truth) <= 32 * tolerance::epsilon * size);
  });
}

TEST(NearestToOrigin, IsAsFarAsTheExactOne) {
  expect_exact_distance<2>();
  expect_exact_distance<3>();
}

TEST(ForEachPerpendicular, VisitsCornersEdgesAndTriangles) {
  std::size_t count = 0;
  const auto simplex = simplex_of<3>({{1, 2, 3}, {4, -5, 6}, {-7, 8, 9}, {1, 1, 7}});
  detail::for_each_perpendicular(simplex, [&count](const Vec<3, double>&) { ++count; });
  EXPECT_EQ(count, 4U + 6U + 4U);
  count = 0;
  detail::for_each_perpendicular(simplex_of<2>({{1, 2}, {3, 4}, {3, 4}}), [&count](const Vec<2, double>&) { ++count; });
  EXPECT_EQ(count, 3U + 2U) << "equal corners span no edge";
}

}  // namespace
}  // namespace graze::test::simplex_test
