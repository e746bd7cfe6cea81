// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/shape/hull/lexicographic.hpp>
#include <graze/shape/hull/vertices.hpp>

#include "catalogue.hpp"
#include "exact/extreme.hpp"
#include "query/point_sets.hpp"

namespace graze::detail::hull_vertices_test {
namespace {

template <class T>
std::vector<Vec<3, T>> vertices_of(const std::vector<Vec<3, T>>& points) {
  std::vector<Vec<3, T>> vertices;
  for (const std::uint32_t index : hull_vertices(std::span<const Vec<3, T>>(points))) vertices.push_back(points[index]);
  std::sort(vertices.begin(), vertices.end(), lexicographically_less<3, T>);
  return vertices;
}

TEST(HullVertices, OfAGridAreTheCornersOfItsBox) {
  std::vector<Vec<3, float>> points;
  for (const float x : {2.0F, 0.0F, 1.0F}) {
    for (const float y : {1.0F, 0.0F, 2.0F}) {
      for (const float z : {0.0F, 2.0F, 1.0F}) points.emplace_back(x, y, z);
    }
  }
  EXPECT_EQ(vertices_of(points),
            (std::vector<Vec<3, float>>{
                {0, 0, 0}, {0, 0, 2}, {0, 2, 0}, {0, 2, 2}, {2, 0, 0}, {2, 0, 2}, {2, 2, 0}, {2, 2, 2}}));
}

TEST(HullVertices, AreFewWhereThePointsAreFlat) {
  using Points = std::vector<Vec<3, double>>;
  EXPECT_EQ(vertices_of(Points{{3, 1, 4}}), (Points{{3, 1, 4}}));
  EXPECT_EQ(vertices_of(Points{{3, 1, 4}, {3, 1, 4}}), (Points{{3, 1, 4}}));
  EXPECT_EQ(vertices_of(Points{{1, 1, 1}, {3, 3, 3}, {2, 2, 2}, {3, 3, 3}}), (Points{{1, 1, 1}, {3, 3, 3}}));
  EXPECT_EQ(vertices_of(Points{{1, 1, 5}, {0, 0, 5}, {2, 0, 5}, {0, 2, 5}, {2, 2, 5}, {1, 0, 5}, {1, 1, 5}}),
            (Points{{0, 0, 5}, {0, 2, 5}, {2, 0, 5}, {2, 2, 5}}));
}

// The center of the top is one step of a double above, level, or below.
TEST(HullVertices, KnowOneBit) {
  const auto count_with = [](double z) {
    return vertices_of(std::vector<Vec<3, double>>{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}, {4, 4, 1}, {2, 2, -3}, {1, 2, z}})
        .size();
  };
  EXPECT_EQ(count_with(std::nextafter(1.0, 0.0)), 5U);
  EXPECT_EQ(count_with(1), 5U);
  EXPECT_EQ(count_with(std::nextafter(1.0, 2.0)), 6U);
}

TEST(HullVertices, AreRightForTheLargestAndLeastDoubles) {
  using Points = std::vector<Vec<3, double>>;
  for (const double size : {std::numeric_limits<double>::max(), 1e200, 1e-200, 0x1p-1070}) {
    const Points cube{{-size, -size, -size}, {-size, -size, size}, {-size, size, -size}, {-size, size, size},
                      {size, -size, -size},  {size, -size, size},  {size, size, -size},  {size, size, size}};
    Points points = cube;
    for (const double x : {-0.5, 0.0, 0.25, 0.5}) points.push_back({x * size, -x * size, 0.75 * size});
    points.push_back({size, size, 0});
    EXPECT_EQ(vertices_of(points), cube) << size;
  }
  // A position 1e-300 of the length beside the middle of an edge counts as zero.
  EXPECT_EQ(vertices_of(Points{{-1e200, 0, 0}, {1e200, 0, 0}, {0, 1e-100, 0}, {0, 0, 1e200}}).size(), 3U);
  // Below that limit, everything counts.
  EXPECT_EQ(vertices_of(Points{{-1e80, 0, 0}, {1e80, 0, 0}, {0, -1e-89, 0}, {0, 0, 1e80}, {0, 1e80, 0}}).size(), 5U);
}

template <class T>
class HullVerticesIn : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(HullVerticesIn, Scalars);

/// Points in one plane or two parallel ones, up to the rounding of coordinates, some of them off by a few bits.
template <class T>
std::vector<Vec<3, T>> draw_layers(std::size_t most) {
  const test::Source<3, T> source = test::draw_source<3, T>();
  const Vec<3, T> start = *source.point;
  const Vec<3, T> across = *source.direction;
  const Vec<3, T> along = *source.direction;
  const Vec<3, T> up = *source.direction;
  const bool is_nudged = *test::choice(2) == 1;
  return *test::some<Vec<3, T>>(
      most, rc::gen::exec([=] {
        const auto number = [](int low, int high) {
          return static_cast<T>(
              *test::drawn<double>([=](rc::Random& random) { return test::whole(random, low, high); }));
        };
        Vec<3, T> point = start + across * number(-2, 2) + along * number(-2, 2) + up * number(0, 1);
        if (is_nudged && point.z != T(0)) point.z = test::stepped(point.z, static_cast<double>(number(-1, 1)));
        return point;
      }));
}

TYPED_TEST(HullVerticesIn, AreThoseOfTheExactHull) {
  using T = TypeParam;
  test::check_property([] {
    const std::vector<Vec<3, T>> points = test::draw_points<3, T>(11);
    RC_ASSERT(vertices_of(points) == test::exact_corners(points));
  });
}

TYPED_TEST(HullVerticesIn, AreThoseOfTheExactHullOfLayers) {
  using T = TypeParam;
  test::check_property([] {
    const std::vector<Vec<3, T>> points = draw_layers<T>(11);
    RC_ASSERT(vertices_of(points) == test::exact_corners(points));
  });
}

/// The distribution of the points.
enum class PointCloud { grid, sphere, box, needle };

template <class T>
Vec<3, T> draw_member(PointCloud cluster, rc::Random& random) {
  const auto number = [&] { return test::between(random, -1, 1); };
  switch (cluster) {
    case PointCloud::grid:
      return {test::whole(random, -9, 9), test::whole(random, -9, 9), test::whole(random, -9, 9)};
    case PointCloud::sphere:
      return test::draw_cospherical<3, T>(random);
    case PointCloud::box:
      return {number(), number() + 3, number() * 7};
    default:
      return {1e7 + number(), 1e-6 * number(), number() * number() * number()};
  }
}

// Enough of them for the filter of deep points to work.
TYPED_TEST(HullVerticesIn, AreTheSameForManyPointsWithoutThoseInside) {
  using T = TypeParam;
  for (const PointCloud cluster : {PointCloud::grid, PointCloud::sphere, PointCloud::box, PointCloud::needle}) {
    rc::Random random(static_cast<std::uint64_t>(cluster));
    std::vector<Vec<3, T>> points;
    points.reserve(5000);
    for (int i = 0; i < 5000; ++i) points.push_back(draw_member<T>(cluster, random));
    // With a thousand at a time, nothing is filtered.
    std::vector<Vec<3, T>> expected;
    for (std::size_t first = 0; first < points.size(); first += 1000) {
      expected.insert(expected.end(), points.begin() + static_cast<std::ptrdiff_t>(first),
                      points.begin() + static_cast<std::ptrdiff_t>(first + 1000));
      expected = vertices_of(expected);
    }
    EXPECT_EQ(vertices_of(points), expected);
    std::reverse(points.begin(), points.end());
    EXPECT_EQ(vertices_of(points), expected);
  }
}

}  // namespace
}  // namespace graze::detail::hull_vertices_test
