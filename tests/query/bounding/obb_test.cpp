// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/bounding/obb.hpp>

#include "exact/holds_instances.hpp"
#include "query/point_sets.hpp"

namespace graze::test::bounding_obb_test {
namespace {

/// The area of the smallest rectangle around points that do not all coincide, exactly: among those with a side along
/// the line through two of the points, the smallest that contains all.
template <class T>
Rational exact_least_area(const std::vector<Vec<2, T>>& points) {
  std::optional<Rational> least;
  const auto extent_along = [&points](const RationalVec<2>& direction) {
    Rational low = dot(exact(points[0]), direction);
    Rational high = low;
    for (const Vec<2, T>& point : points) {
      const Rational height = dot(exact(point), direction);
      low = std::min(low, height);
      high = std::max(high, height);
    }
    return Rational(high - low);
  };
  for (const Vec<2, T>& a : points) {
    for (const Vec<2, T>& b : points) {
      const RationalVec<2> edge = exact(b) - exact(a);
      if (is_zero(edge)) continue;
      const RationalVec<2> across = {-edge[1], edge[0]};
      const Rational area = extent_along(edge) * extent_along(across) / dot(edge, edge);
      if (!least || area < *least) least = area;
    }
  }
  return *least;
}

}  // namespace
}  // namespace graze::test::bounding_obb_test

namespace graze::bounding_obb_test {
namespace {

using test::contains_all;
using test::exact;
using test::Rational;

template <Dim N, class T>
void expect_upright(const Obb<N, T>& box, const Vec<N, T>& center, const Vec<N, T>& half_extents) {
  EXPECT_EQ(box.center, center);
  EXPECT_EQ(box.half_extents, half_extents);
  for (Dim i = 0; i < N; ++i) EXPECT_EQ(box.axes[i], (unit_axis<N, T>(i)));
}

/// An eighth of the surface; in 2D a quarter of the area.
template <Dim N, class T>
double size_of(const Obb<N, T>& box) {
  return detail::size_of(box, 1);
}

TEST(BoundingObb, OfAnUprightRectangleIsThatRectangleExactly) {
  expect_upright(bounding_obb<2, float>({{1, 1}, {5, 1}, {5, 3}, {1, 3}, {2, 2}}), {3, 2}, {2, 1});
  expect_upright(
      bounding_obb<3, double>({{0, 0, 0}, {2, 4, 6}, {2, 0, 0}, {0, 4, 0}, {0, 0, 6}, {2, 4, 0}, {2, 0, 6}, {0, 4, 6}}),
      {1, 2, 3}, {1, 2, 3});
}

TEST(BoundingObb, OfATurnedRectangleIsThatRectangle) {
  // Half edges (6, 8) and (-4, 3) around (10, 20): half extents 10 and 5, axes (0.6, 0.8) and (-0.8, 0.6).
  const Obb<2, double> box = bounding_obb<2, double>({{12, 31}, {20, 25}, {0, 15}, {8, 9}});
  EXPECT_NEAR(box.center.x, 10, 1e-14);
  EXPECT_NEAR(box.center.y, 20, 1e-14);
  EXPECT_NEAR(box.half_extents.x, 10, 4e-14);
  EXPECT_NEAR(box.half_extents.y, 5, 4e-14);
  EXPECT_NEAR(box.axes[0].x, 0.6, 1e-15);
  EXPECT_NEAR(box.axes[0].y, 0.8, 1e-15);
}

TEST(BoundingObb, OfATriangleLiesAlongASide) {
  // Sides 3, 4, 5: the area is 12 along the legs and along the hypotenuse, 5 * 2.4. The axis-aligned one is chosen.
  expect_upright(bounding_obb<2, double>({{0, 0}, {4, 0}, {0, 3}}), {2, 1.5}, {2, 1.5});
}

TEST(BoundingObb, OfPointsOnALineIsThatLine) {
  const Obb<2, float> diagonal = bounding_obb<2, float>({{1, 1}, {5, 5}, {3, 3}, {2, 2}});
  EXPECT_EQ(diagonal.center, (Vec<2, float>(3, 3)));
  EXPECT_EQ(diagonal.half_extents.y, 0);
  EXPECT_NEAR(diagonal.half_extents.x, 2 * std::sqrt(2.0), 1e-6);
  expect_upright(bounding_obb<3, float>({{7, 1, 2}, {7, 5, 2}, {7, 2, 2}}), {7, 3, 2}, {0, 2, 0});
  const Obb<3, double> slanted = bounding_obb<3, double>({{0, 0, 0}, {1, 2, 2}, {2, 4, 4}});
  std::array<double, 3> half = {slanted.half_extents.x, slanted.half_extents.y, slanted.half_extents.z};
  std::sort(half.begin(), half.end());
  EXPECT_LE(half[1], 3e-14);
  EXPECT_NEAR(half[2], 3, 3e-14);
}

TEST(BoundingObb, OfOnePointOrEqualPointsHasNoExtents) {
  expect_upright(bounding_obb<2, double>({{3, 4}}), {3, 4}, {0, 0});
  expect_upright(bounding_obb<3, float>({{1, 2, 3}, {1, 2, 3}}), {1, 2, 3}, {0, 0, 0});
}

TEST(BoundingObb, OfPointsTooFarApartToTurnIsUpright) {
  const double large = std::numeric_limits<double>::max();
  expect_upright(bounding_obb<2, double>({{-large, -large}, {large, large}}), {0, 0}, {large, large});
  const float huge = std::numeric_limits<float>::max();
  expect_upright(bounding_obb<2, float>({{-huge, -huge}, {huge, huge}}), {0, 0}, {huge, huge});
}

template <class S>
class BoundingObbIn : public testing::Test {};
TYPED_TEST_SUITE(BoundingObbIn, test::Spaces);

TYPED_TEST(BoundingObbIn, IsValidContainsEveryPointExactlyAndIsNoLargerThanTheUprightBox) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const std::vector<Vec<N, T>> points = test::draw_points<N, T>(20);
    const Obb<N, T> box = bounding_obb(points);
    RC_ASSERT(is_valid(box));
    const Rational determinant = test::replaced_determinant<N, T>(box, 0, exact<N, T>(box.axes[0]));
    RC_ASSERT(determinant > 0);
    RC_ASSERT(orthonormal_error(wide_matrix<N, T>(box.axes)) <=
              4 * static_cast<double>(std::numeric_limits<T>::epsilon()));
    RC_ASSERT(contains_all(box, points));
    RC_ASSERT(size_of(box) <= size_of(detail::upright_obb(bounding_box(points))));
  });
}

TYPED_TEST(BoundingObbIn, ScalesWithPowersOfTwoBitByBit) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const std::vector<Vec<N, T>> points = test::draw_points<N, T>(12);
    const int exponent =
        static_cast<int>(*test::drawn<double>([](rc::Random& random) { return test::whole(random, -60, 60); }));
    const T factor = static_cast<T>(std::ldexp(1.0, exponent));
    std::vector<Vec<N, T>> scaled;
    for (const Vec<N, T>& point : points) scaled.push_back(point * factor);
    const Obb<N, T> before = bounding_obb(points);
    const Obb<N, T> after = bounding_obb(scaled);
    RC_ASSERT(after.center == before.center * factor);
    RC_ASSERT(after.half_extents == before.half_extents * factor);
    RC_ASSERT(after.axes == before.axes);
  });
}

TYPED_TEST(BoundingObbIn, OfTheLeastAndTheLargestNumbersContainsEveryPointAndIsAsSmall) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  using Limits = std::numeric_limits<T>;
  for (const int exponent :
       {Limits::min_exponent - Limits::digits + 8, Limits::min_exponent - 8, Limits::max_exponent - 6}) {
    const T unit = std::ldexp(T(1), exponent);
    std::vector<Vec<N, T>> points;
    for (int i = 0; i < 9; ++i) {
      Vec<N, T> point(T(i % 3));
      point[0] = T(4 * i - 16);
      point[1] = T(3 * i - 8 + i * i % 5);
      points.push_back(point);
    }
    const Obb<N, T> expected = bounding_obb(points);
    for (Vec<N, T>& point : points) point *= unit;
    const Obb<N, T> box = bounding_obb(points);
    EXPECT_TRUE(contains_all(box, points)) << "times 2^" << exponent;
    if (N == 2) {
      EXPECT_EQ(box.axes, expected.axes) << "times 2^" << exponent;
    }
    const double step = static_cast<double>(std::max(Limits::denorm_min() / unit, 4 * Limits::epsilon()));
    for (Dim i = 0; i < N; ++i) {
      EXPECT_NEAR(static_cast<double>(box.half_extents[i]) / static_cast<double>(unit),
                  static_cast<double>(expected.half_extents[i]), 4 * step * 32);
    }
  }
}

TYPED_TEST(BoundingObbIn, FindsTheBoxOfWhichThePointsAreTheCorners) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const Mat<N, T> axes = *test::any_rotation<N, T>();
    Vec<N, T> half;
    for (Dim i = 0; i < N; ++i) {
      half[i] = *test::drawn<T>([](rc::Random& random) { return static_cast<T>(test::between(random, 0.5, 5)); });
    }
    std::vector<Vec<N, T>> corners;
    for (unsigned k = 0; k < (1U << static_cast<unsigned>(N)); ++k) {
      Vec<N, T> u = half;
      for (Dim i = 0; i < N; ++i) {
        if ((k >> static_cast<unsigned>(i) & 1U) != 0) u[i] = -u[i];
      }
      corners.push_back(axes * u);
    }
    const double expected = size_of(Obb<N, T>{Vec<N, T>(T(0)), half, axes});
    const double slack = 32 * static_cast<double>(std::numeric_limits<T>::epsilon());
    RC_ASSERT(size_of(bounding_obb(corners)) <= expected * (1 + 20 * slack));
  });
}

template <class T>
class BoundingRectangleIn : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(BoundingRectangleIn, Scalars);

TYPED_TEST(BoundingRectangleIn, HasTheLeastAreaUpToRounding) {
  using T = TypeParam;
  test::check_property([] {
    const std::vector<Vec<2, T>> points = test::draw_points<2, T>(10);
    const Obb<2, T> box = bounding_obb(points);
    const Aabb<2, T> range = bounding_box(points);
    const double size = detail::largest_side(range);
    if (size == 0) return;
    // The growth of half extents that the documentation permits; they are at most the size themselves.
    const double growth =
        2 * static_cast<double>(std::numeric_limits<T>::epsilon()) * (size + test::largest_coordinate(points)) +
        16 * tolerance::epsilon * size;
    const Rational area =
        exact(static_cast<double>(box.half_extents.x)) * exact(static_cast<double>(box.half_extents.y));
    const Rational least = test::bounding_obb_test::exact_least_area(points) / 4;
    RC_ASSERT(area <= least + exact(growth) * exact(2 * size + growth));
  });
}

TYPED_TEST(BoundingRectangleIn, DoesNotDependOnTheOrderOfPoints) {
  using T = TypeParam;
  test::check_property([] {
    std::vector<Vec<2, T>> points = test::draw_points<2, T>(20);
    const Obb<2, T> box = bounding_obb(points);
    std::reverse(points.begin(), points.end());
    points.push_back(points.front());
    const Obb<2, T> other = bounding_obb(points);
    RC_ASSERT(other.center == box.center);
    RC_ASSERT(other.half_extents == box.half_extents);
    RC_ASSERT(other.axes == box.axes);
  });
}

TEST(BoundingObb, OfManyPointsInATurnedBoxIsAboutThatBox) {
  std::mt19937 random(11);
  const auto uniform = [&random] { return static_cast<double>(random()) * 0x1p-31 - 1; };
  const Mat<3, double> axes = rotation_matrix(Vec<3, double>(1, 2, 3), 40);
  std::vector<Vec<3, float>> points;
  std::vector<Vec<2, float>> flat;
  for (int i = 0; i < 5'000; ++i) {
    const Vec<3, double> u(5 * uniform(), 2 * uniform(), uniform());
    points.push_back(Vec<3, float>(Vec<3, double>(100, 0, -7) + axes * u));
    flat.push_back(Vec<2, float>(rotation_matrix(25) * Vec<2, double>(u.x, u.y)));
  }
  const Obb<3, float> box = bounding_obb(points);
  EXPECT_TRUE(contains_all(box, points));
  EXPECT_LE(size_of(box), 1.001 * (10 + 2 + 5));
  const Obb<2, float> rectangle = bounding_obb(flat);
  EXPECT_TRUE(contains_all(rectangle, flat));
  EXPECT_LE(size_of(rectangle), 1.001 * 10);
}

}  // namespace
}  // namespace graze::bounding_obb_test
