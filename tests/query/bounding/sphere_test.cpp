// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/bounding/sphere.hpp>
#include <graze/shape/polytope.hpp>

#include "exact/numbers.hpp"
#include "query/point_sets.hpp"

namespace graze::test::bounding_sphere_test {
namespace {

/// The center of the sphere through affinely independent points within their affine hull, in rational numbers: by
/// elimination of 2 e_i . sum x_j e_j = e_i . e_i. None for dependent points.
template <Dim N>
std::optional<RationalVec<N>> exact_center(const std::vector<RationalVec<N>>& corners) {
  const std::size_t n = corners.size() - 1;
  std::vector<std::vector<Rational>> rows(n, std::vector<Rational>(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    const RationalVec<N> e = corners[i + 1] - corners[0];
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = 2 * dot(e, corners[j + 1] - corners[0]);
    rows[i][n] = dot(e, e);
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (rows[k][k] == 0) return std::nullopt;  // a Gram matrix: its minors are zero only for dependent edges
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const Rational factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  RationalVec<N> center = corners[0];
  for (std::size_t k = 0; k < n; ++k) {
    const Rational share = rows[k][n] / rows[k][k];
    center = center + (corners[k + 1] - corners[0]) * share;
  }
  return center;
}

/// The squared radius of the smallest sphere around at least one point: the least one that contains all points among
/// the spheres of all subsets.
template <Dim N, class T>
Rational exact_radius_squared(std::vector<Vec<N, T>> points) {
  std::sort(points.begin(), points.end(), detail::lexicographically_less<N, T>);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<RationalVec<N>> all;
  for (const Vec<N, T>& point : points) all.push_back(exact(point));
  std::optional<Rational> least;
  for (std::size_t subset = 1; subset < (std::size_t{1} << all.size()); ++subset) {
    std::vector<RationalVec<N>> corners;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if ((subset >> i & 1U) != 0) corners.push_back(all[i]);
    }
    if (corners.size() > static_cast<std::size_t>(N) + 1) continue;
    const std::optional<RationalVec<N>> center = exact_center<N>(corners);
    if (!center) continue;
    const Rational squared = dot(corners[0] - *center, corners[0] - *center);
    if (least && squared >= *least) continue;
    const bool holds_all = std::all_of(
        all.begin(), all.end(), [&](const RationalVec<N>& p) { return dot(p - *center, p - *center) <= squared; });
    if (holds_all) least = squared;
  }
  return *least;
}

}  // namespace
}  // namespace graze::test::bounding_sphere_test

namespace graze::bounding_sphere_test {
namespace {

using test::contains_all;
using test::contains_exactly;
using test::exact;
using test::Rational;

template <Dim N, class T>
void expect_sphere(const std::vector<Vec<N, T>>& points, const Sphere<N, T>& expected) {
  const Sphere<N, T> sphere = bounding_sphere(points);
  EXPECT_EQ(sphere.center, expected.center);
  EXPECT_EQ(sphere.radius, expected.radius);
}

TEST(BoundingSphere, OfTwoPointsStandsOnThem) {
  expect_sphere<2, float>({{0, 0}, {2, 0}}, {{1, 0}, 1});
  expect_sphere<3, double>({{1, 2, 3}, {1, 2, 7}}, {{1, 2, 5}, 2});
}

TEST(BoundingSphere, OfAnObtuseTriangleStandsOnItsLongestSide) {
  expect_sphere<2, float>({{0, 0}, {1, 1}, {4, 0}}, {{2, 0}, 2});
  expect_sphere<3, double>({{-5, 0, 0}, {0, 1, 2}, {5, 0, 0}}, {{0, 0, 0}, 5});
}

TEST(BoundingSphere, OfARightTriangleIsThatOfThales) {
  expect_sphere<2, double>({{0, 0}, {6, 0}, {0, 8}}, {{3, 4}, 5});
}

TEST(BoundingSphere, OfAnAcuteTriangleGoesThroughAllCorners) {
  // |(3, 4)| = |(-3, 4)| = |(0, -5)| = 5, around (10, 20).
  expect_sphere<2, double>({{13, 24}, {7, 24}, {10, 15}, {10, 20}}, {{10, 20}, 5});
}

TEST(BoundingSphere, OfATetrahedronGoesThroughAllCorners) {
  // Every second corner of a cube of side 2: the radius sqrt(3), the least number above it.
  expect_sphere<3, double>({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 0, 0}, 1.7320508075688774});
  expect_sphere<3, float>({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 0, 0}, 1.7320509F});
}

TEST(BoundingSphere, OfCosphericalPointsIsTheirSphere) {
  expect_sphere<3, float>({{10, 3, 3}, {-4, 3, 3}, {3, 10, 3}, {3, -4, 3}, {5, 6, 9}, {1, 0, -3}, {9, 5, 0}, {0, 9, 5}},
                          {{3, 3, 3}, 7});
  const Sphere<2, double> disc = bounding_sphere<2, double>({{25, 0}, {7, 24}, {15, 20}, {-20, 15}, {0, -25}});
  EXPECT_NEAR(disc.center.x, 0, 1e-14);
  EXPECT_NEAR(disc.center.y, 0, 1e-14);
  EXPECT_NEAR(disc.radius, 25, 1e-14);
}

TEST(BoundingSphere, OfANearlyRightTriangleIsPutRightThoughItsRadiusHardlyGrows) {
  // The corner at the origin is 1.7e-4 outside of the sphere around the other two, which must grow by 1e-13 to contain
  // it.
  const std::vector<Vec<3, double>> points{{0, 0, 111019}, {-1, 0, 2}, {0, 0, 0}, {189335, 0, 0.00033818384745664103}};
  EXPECT_NEAR(bounding_sphere(points).radius, 109741.69730657342, 1e-10);
}

TEST(BoundingSphere, OfOnePointOrEqualPointsHasNoRadius) {
  expect_sphere<2, float>({{3, -4}}, {{3, -4}, 0});
  expect_sphere<3, double>({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {{1, 2, 3}, 0});
}

TEST(BoundingSphere, OfPointsOneStepApartHoldsBoth) {
  const double next = std::nextafter(1e7, 2e7);
  const Sphere<3, double> sphere = bounding_sphere<3, double>({{1e7, 1e7, 1e7}, {next, 1e7, 1e7}});
  EXPECT_EQ(sphere.radius, next - 1e7);  // the midpoint is not a double: the center is one of the points
  EXPECT_TRUE(contains_exactly(sphere, {1e7, 1e7, 1e7}));
  EXPECT_TRUE(contains_exactly(sphere, {next, 1e7, 1e7}));
}

/// Six points within a few steps of each other: some centers of four of them are NaN.
TEST(BoundingSphere, OfPointsAFewStepsApartHoldsThemInAnyOrder) {
  constexpr double x = 0x1p-48;
  constexpr double y = 0x1p-44;
  constexpr double z = 0x1p-53;
  const std::vector<Vec<3, double>> steps{{3, 0, 0},    {0, 0, 0},  {2, -3, -6}, {0, 0, 2},
                                          {-2, -3, -6}, {2, 2, -2}, {-3, 2, -2}};
  std::vector<Vec<3, double>> points;
  for (const Vec<3, double>& step : steps) points.emplace_back(16 + step.x * x, 257 + step.y * y, 1 + step.z * z);
  for (std::size_t turn = 0; turn < 2 * points.size(); ++turn) {
    if (turn == points.size()) std::reverse(points.begin(), points.end());
    std::rotate(points.begin(), points.begin() + 1, points.end());
    const Sphere<3, double> sphere = bounding_sphere(points);
    EXPECT_TRUE(is_valid(sphere)) << turn;
    EXPECT_TRUE(contains_all(sphere, points)) << turn;
    EXPECT_LT(sphere.radius, 3.01 * y) << turn;
    EXPECT_TRUE(is_valid(bounding_sphere_fast(points))) << turn;
  }
}

TEST(BoundingSphere, OfAHugeAndOfATinySetIsExact) {
  expect_sphere<2, double>({{-3e200, 0}, {3e200, 0}, {0, 1e200}}, {{0, 0}, 3e200});
  expect_sphere<3, double>({{0, 0, 0}, {0, 0, 6e-320}}, {{0, 0, 3e-320}, 3e-320});
  expect_sphere<2, float>({{-3e38F, 0}, {3e38F, 0}}, {{0, 0}, 3e38F});
}

TEST(BoundingSphere, HoldsPointsThatVanishBesideTheOthers) {
  const std::vector<Vec<2, double>> points{{-1e200, 1e-200}, {1e200, 1e-200}, {0, 0}};
  EXPECT_TRUE(contains_all(bounding_sphere(points), points));
  EXPECT_TRUE(contains_all(bounding_sphere_fast(points), points));
  EXPECT_LE(bounding_sphere(points).radius, std::nextafter(std::nextafter(1e200, 2e200), 2e200));
}

TEST(BoundingSphere, ThatNoNumberCanMeasureIsRefusedWithTheReason) {
  const float huge = std::numeric_limits<float>::max();
  const double large = std::numeric_limits<double>::max();
  const auto message_of = [](const auto& points) -> std::string {
    try {
      bounding_sphere(points);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  const std::string expected = "bounding_sphere: the points are too far apart for a finite radius";
  EXPECT_EQ(message_of(std::vector<Vec<2, float>>{{huge, huge}, {-huge, -huge}}), expected);
  EXPECT_EQ(message_of(std::vector<Vec<3, double>>{{large, 0, 0}, {-large, 0, 0}}), expected);
}

/// What the documentation permits beyond the true minimum.
template <Dim N, class T>
double allowed_excess(const Sphere<N, T>& sphere) {
  const double radius = static_cast<double>(sphere.radius);
  const double center = static_cast<double>(max_abs(sphere.center));
  return 4 * tolerance::epsilon * radius + static_cast<double>(std::numeric_limits<T>::epsilon()) * (radius + center);
}

template <class S>
class BoundingSphereIn : public testing::Test {};
TYPED_TEST_SUITE(BoundingSphereIn, test::Spaces);

TYPED_TEST(BoundingSphereIn, ContainsEveryPointExactlyAndIsTheSmallest) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const std::vector<Vec<N, T>> points = test::draw_points<N, T>(7);
    const Sphere<N, T> sphere = bounding_sphere(points);
    RC_ASSERT(is_valid(sphere));
    RC_ASSERT(contains_all(sphere, points));
    const Rational excess = exact(allowed_excess(sphere));
    const Rational reduced = exact(static_cast<double>(sphere.radius)) - excess;
    const Rational least = test::bounding_sphere_test::exact_radius_squared<N, T>(points);
    RC_ASSERT(reduced <= 0 || reduced * reduced <= least);
  });
}

TYPED_TEST(BoundingSphereIn, HasTheLeastRadiusForItsCenter) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const std::vector<Vec<N, T>> points = test::draw_points<N, T>(12);
    for (Sphere<N, T> sphere : {bounding_sphere(points), bounding_sphere_fast(points)}) {
      RC_ASSERT(contains_all(sphere, points));
      if (sphere.radius == T(0)) continue;
      sphere.radius = std::nextafter(sphere.radius, T(0));
      RC_ASSERT(!contains_all(sphere, points));
    }
  });
}

TYPED_TEST(BoundingSphereIn, DecidesExactlyWhatIsOutside) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const auto from = test::draw_source<N, T>();
    const Vec<N, T> point = *from.point;
    const Vec<N, T> center = *from.point;
    const Vec<N, double> to_point = wide<N, T>(point) - wide<N, T>(center);
    const T distance = static_cast<T>(std::sqrt(dot(to_point, to_point)));
    if (distance == T(0)) return;
    for (const double steps : {-8.0, -2.0, -1.0, 0.0, 1.0, 2.0, 8.0}) {
      const Sphere<N, T> sphere{center, test::stepped(distance, steps)};
      const double scale = std::ldexp(1.0, -std::ilogb(sphere.radius));
      RC_ASSERT(detail::is_outside(point, sphere, scale) == !contains_exactly(sphere, point));
    }
  });
}

TYPED_TEST(BoundingSphereIn, KeepsItsSizeWhenPointsComeInAnotherOrderOrFromInside) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    std::vector<Vec<N, T>> points = test::draw_points<N, T>(12);
    const Sphere<N, T> sphere = bounding_sphere(points);
    const double excess = 2 * allowed_excess(sphere);
    std::reverse(points.begin(), points.end());
    points.insert(points.begin(), points[points.size() / 2]);
    const Vec<N, T> inside = points.front() * T(0.5) + points.back() * T(0.5);
    if (contains_exactly(sphere, inside)) points.push_back(inside);
    const Sphere<N, T> other = bounding_sphere(points);
    RC_ASSERT(std::fabs(static_cast<double>(other.radius) - static_cast<double>(sphere.radius)) <= excess);
  });
}

TYPED_TEST(BoundingSphereIn, ScalesWithPowersOfTwoBitByBit) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const std::vector<Vec<N, T>> points = test::draw_points<N, T>(12);
    const int exponent =
        static_cast<int>(*test::drawn<double>([](rc::Random& random) { return test::whole(random, -60, 60); }));
    const T factor = static_cast<T>(std::ldexp(1.0, exponent));
    std::vector<Vec<N, T>> scaled;
    for (const Vec<N, T>& point : points) scaled.push_back(point * factor);
    const auto expect_scaled = [factor](const Sphere<N, T>& before, const Sphere<N, T>& after) {
      RC_ASSERT(after.center == before.center * factor);
      RC_ASSERT(after.radius == before.radius * factor);
    };
    expect_scaled(bounding_sphere(points), bounding_sphere(scaled));
    expect_scaled(bounding_sphere_fast(points), bounding_sphere_fast(scaled));
  });
}

TYPED_TEST(BoundingSphereIn, FastIsAtMostTwiceAsLarge) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const std::vector<Vec<N, T>> points = test::draw_points<N, T>(30);
    const Sphere<N, T> smallest = bounding_sphere(points);
    const Sphere<N, T> fast = bounding_sphere_fast(points);
    const double excess = allowed_excess(smallest) + allowed_excess(fast);
    RC_ASSERT(static_cast<double>(fast.radius) <= 2 * static_cast<double>(smallest.radius) + excess);
    RC_ASSERT(static_cast<double>(smallest.radius) <= static_cast<double>(fast.radius) + excess);
  });
}

template <Dim N>
std::vector<Vec<N, float>> cloud(std::size_t count, bool on_surface) {
  std::mt19937 random(5);
  std::vector<Vec<N, float>> points;
  while (points.size() < count) {
    Vec<N, double> point;
    for (Dim i = 0; i < N; ++i) point[i] = static_cast<double>(random()) * 0x1p-31 - 1;
    const double size = std::sqrt(dot(point, point));
    if (size > 1 || size < 0.1) continue;
    points.push_back(Vec<N, float>(on_surface ? point / size : point));
  }
  return points;
}

TEST(BoundingSphere, OfManyPointsContainsThemAndTheFastOneIsHardlyLarger) {
  for (const bool on_surface : {false, true}) {
    const auto check = [](const auto& points) {
      const auto smallest = bounding_sphere(points);
      const auto fast = bounding_sphere_fast(points);
      EXPECT_TRUE(contains_all(smallest, points));
      EXPECT_TRUE(contains_all(fast, points));
      EXPECT_LE(fast.radius, 1.05F * smallest.radius);
      EXPECT_NEAR(smallest.radius, 1, 0.02);
    };
    check(cloud<2>(5'000, on_surface));
    check(cloud<3>(5'000, on_surface));
  }
}

}  // namespace
}  // namespace graze::bounding_sphere_test
