// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/orientation.hpp>
#include <graze/shape/hull/octagon.hpp>
#include <graze/shape/polytope.hpp>

namespace graze::detail::hull_octagon_test {
namespace {

template <class T>
using Points = std::vector<Vec<2, T>>;

/// The hull without the octagon filter.
template <class T>
Points<T> plain_hull(Points<T> points) {
  sort_and_forget_duplicates<2, T>(points);
  return monotone_chain(points);
}

template <class T>
HullOctagon octagon_of(const Points<T>& points) {
  return HullOctagon(std::span<const Vec<2, T>>(points));
}

template <class T>
class HullOctagonOf : public testing::Test {
 protected:
  T number(double low, double high) {
    return static_cast<T>(std::uniform_real_distribution<double>(low, high)(random_));
  }
  Vec<2, T> vector() { return {number(-1, 1), number(-1, 1)}; }

  Points<T> disk(std::size_t count) {
    Points<T> points;
    while (points.size() < count) {
      const Vec<2, T> point = vector();
      if (dot(point, point) <= 1) points.push_back(point);
    }
    return points;
  }

  /// The share of points that the octagon contains; all must be strictly inside the hull, by exact orientation.
  static double share_held(const Points<T>& points) {
    const HullOctagon octagon = octagon_of(points);
    const Points<T> hull = plain_hull(points);
    std::size_t held = 0;
    for (const Vec<2, T>& point : points) {
      if (!octagon.holds(wide<2, T>(point))) continue;
      ++held;
      for (std::size_t i = 0; i < hull.size(); ++i) {
        if (orientation(hull[i], hull[(i + 1) % hull.size()], point) <= 0) ADD_FAILURE() << "held on the boundary";
      }
    }
    return static_cast<double>(held) / static_cast<double>(points.size());
  }

 private:
  std::mt19937 random_{12};
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(HullOctagonOf, Scalars);

TYPED_TEST(HullOctagonOf, ADiskHoldsMostOfItWhereverItIs) {
  EXPECT_GT(this->share_held(this->disk(2000)), 0.85);
  Points<TypeParam> far = this->disk(2000);
  for (auto& point : far) point = point * TypeParam(16) + Vec<2, TypeParam>(1000, -3000);
  EXPECT_GT(this->share_held(far), 0.85);
}

TYPED_TEST(HullOctagonOf, ATriangleHoldsItsInsideAlone) {
  const auto octagon = octagon_of<TypeParam>({{0, 0}, {4, 0}, {0, 4}});
  EXPECT_TRUE(octagon.holds({1, 1}));
  EXPECT_TRUE(octagon.holds({0x1p-20, 0x1p-20}));
  for (const Vec<2, double>& outside : {Vec<2, double>(0, 0), {2, 0}, {0, 2}, {2, 2}, {3, 3}, {-1, 1}, {1, -0x1p-40}}) {
    EXPECT_FALSE(octagon.holds(outside)) << outside.x << ' ' << outside.y;
  }
}

TYPED_TEST(HullOctagonOf, AGridHoldsItsInside) {
  Points<TypeParam> grid;
  for (int x = 0; x < 16; ++x) {
    for (int y = 0; y < 16; ++y) grid.push_back(Vec<2, TypeParam>(x, y) * TypeParam(0.1));
  }
  EXPECT_EQ(this->share_held(grid), 14.0 * 14.0 / 256.0);
}

TYPED_TEST(HullOctagonOf, PointsOnALineOrAtOnePlaceHoldNothing) {
  Points<TypeParam> line;
  for (int i = 0; i < 200; ++i) line.push_back(Vec<2, TypeParam>(3, -2) * TypeParam(i));
  EXPECT_FALSE(octagon_of(line).holds_something());
  EXPECT_FALSE(octagon_of(Points<TypeParam>(200, {7, 7})).holds_something());
  EXPECT_FALSE(octagon_of(Points<TypeParam>{{7, 7}}).holds({7, 7}));
}

TYPED_TEST(HullOctagonOf, NearlyFlatPointsLoseNoCorner) {
  for (const double height : {1e-3, 1e-7, 1e-15, 1e-17, 1e-30}) {
    Points<TypeParam> points;
    for (int i = 0; i < 500; ++i) {
      const auto along = this->number(-1, 1);
      points.push_back({along, along + static_cast<TypeParam>(height) * this->number(-1, 1)});
    }
    this->share_held(points);
    const auto hull = convex_hull(points);
    EXPECT_EQ(Points<TypeParam>(hull.vertices().begin(), hull.vertices().end()), plain_hull(points)) << height;
  }
}

TEST(HullOctagon, HullsAreTheSameWithItAtEveryMagnitudeOfDouble) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const double size : {1e-320, 1e-300, 1e-160, 1e-120, 1e-20, 1.0, 1e20, 1e120, 1e150, 1e300, 1.7e308}) {
    Points<double> points;
    for (int i = 0; i < 1000; ++i) points.push_back({uniform(random) * size, uniform(random) * size});
    const auto hull = convex_hull(points);
    EXPECT_EQ(Points<double>(hull.vertices().begin(), hull.vertices().end()), plain_hull(points)) << size;
  }
}

TYPED_TEST(HullOctagonOf, OuterPointsAreAllPointsOfAFewAndOfManyTheOuterOnes) {
  const Points<TypeParam> few = this->disk(100);
  EXPECT_EQ(outer_points<TypeParam>(few), few);
  const Points<TypeParam> many = this->disk(2000);
  const Points<TypeParam> outer = outer_points<TypeParam>(many);
  EXPECT_LT(outer.size(), many.size() / 5);
  EXPECT_EQ(plain_hull(outer), plain_hull(many));
}

}  // namespace
}  // namespace graze::detail::hull_octagon_test
