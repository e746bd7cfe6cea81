// SPDX-License-Identifier: MIT
// The common contract of all bounding volumes of points.
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/bounding.hpp>
#include <graze/query/intersects.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/shape.hpp>

#include "../catalogue/nasty.hpp"

namespace graze::bounding_test {
namespace {

/// The message with which a function rejects points, or an empty string.
template <class Function>
std::string refusal(Function function) {
  try {
    function();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// The rejections of all bounding volumes, in the order of `names`.
constexpr std::array<const char*, 4> names = {"bounding_box", "bounding_sphere", "bounding_sphere_fast",
                                              "bounding_obb"};
template <Dim N, class T>
std::array<std::string, 4> refusals(const std::vector<Vec<N, T>>& points) {
  return {refusal([&] { EXPECT_TRUE(is_valid(bounding_box(points))); }),
          refusal([&] { EXPECT_TRUE(is_valid(bounding_sphere(points))); }),
          refusal([&] { EXPECT_TRUE(is_valid(bounding_sphere_fast(points))); }),
          refusal([&] { EXPECT_TRUE(is_valid(bounding_obb(points))); })};
}

template <class S>
class BoundingIn : public testing::Test {};
TYPED_TEST_SUITE(BoundingIn, test::Spaces);

TYPED_TEST(BoundingIn, TakesAnyRowOfPoints) {
  using V = Vec<TypeParam::dimension, typename TypeParam::scalar>;
  const std::array<V, 2> array{V(1), V(2)};
  const std::vector<V> list(array.begin(), array.end());
  EXPECT_EQ(bounding_box(array), bounding_box(list));
  EXPECT_EQ(bounding_box(array), (Aabb<TypeParam::dimension, typename TypeParam::scalar>{V(1), V(2)}));
  EXPECT_EQ(bounding_sphere(array).center, bounding_sphere(std::span<const V>(list)).center);
  EXPECT_EQ(bounding_sphere_fast(array).radius, bounding_sphere_fast(list).radius);
  EXPECT_EQ(bounding_obb(array).center, bounding_obb(list).center);
  constexpr Dim N = TypeParam::dimension;
  EXPECT_EQ(bounding_box<N>(array), bounding_box<N>(list));
  EXPECT_EQ(bounding_sphere<N>(array).center, bounding_sphere<N>(list).center);
  EXPECT_EQ(bounding_sphere_fast<N>(array).radius, bounding_sphere_fast<N>(std::span<const V>(list)).radius);
  EXPECT_EQ(bounding_obb<N>(array).center, bounding_obb<N>(list).center);
}

TYPED_TEST(BoundingIn, RefusesNoPointsWithTheReason) {
  const auto messages = refusals(std::vector<Vec<TypeParam::dimension, typename TypeParam::scalar>>{});
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(messages[i], std::string(names[i]) + ": there are no points");
  }
}

TYPED_TEST(BoundingIn, RefusesEveryNumberThatIsNotFiniteAndNamesThePoint) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (std::size_t k = 0; k < 3; ++k) {
    for (Dim i = 0; i < N; ++i) {
      for (const T value : test::nasty_values<T>) {
        std::vector<Vec<N, T>> points{unit_axis<N, T>(0), unit_axis<N, T>(1), Vec<N, T>(T(2))};
        points[k][i] = value;
        const auto messages = refusals(points);
        for (std::size_t f = 0; f < names.size(); ++f) {
          const std::string reason = ": point " + std::to_string(k) + " has a coordinate that is not finite";
          EXPECT_EQ(messages[f], std::isfinite(value) ? "" : names[f] + reason) << points[k];
        }
      }
    }
  }
}

TYPED_TEST(BoundingIn, TakesSpansAndVectorsAndWhatConvertsToASpan) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const std::vector<Vec<N, T>> points{Vec<N, T>(T(-1)), Vec<N, T>(T(1))};
  const std::span<const Vec<N, T>> span(points);
  const std::array<Vec<N, T>, 2> array{points[0], points[1]};
  EXPECT_EQ(bounding_box(points), bounding_box(span));
  EXPECT_EQ((bounding_box<N, T>(array)), (Aabb<N, T>{}));
  static_assert(std::is_same_v<decltype(bounding_sphere(span)), Sphere<N, T>>);
  EXPECT_EQ(bounding_sphere(points).radius, (bounding_sphere<N, T>(array).radius));
  EXPECT_EQ(bounding_sphere_fast(span).radius, (bounding_sphere_fast<N, T>(points).radius));
  EXPECT_EQ(bounding_obb(span).half_extents, (bounding_obb<N, T>(array).half_extents));
}

// Both have helpers for the farthest point, whose names once collided.
TYPED_TEST(BoundingIn, LivesInOneProgramWithTheRelationsOfRays) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const std::vector<Vec<N, T>> points{Vec<N, T>(T(-1)), Vec<N, T>(T(1))};
  const Ray<N, T> ray{unit_axis<N, T>(0) * T(9), unit_axis<N, T>(0) * T(-1)};
  EXPECT_TRUE(intersects(bounding_sphere(points), ray));
  EXPECT_TRUE(intersects(bounding_obb(points), ray));
}

}  // namespace
}  // namespace graze::bounding_test
