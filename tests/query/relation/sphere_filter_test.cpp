// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <graze/query/distance_squared.hpp>
#include <graze/query/relation/sphere_filter.hpp>

namespace graze::ball_filter_test {
namespace {

template <class T>
Vec<3, T> any_vector(std::mt19937& random) {
  std::uniform_real_distribution<T> coordinate(-2, 2);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

/// Reaches from far to just beyond and just within a distance. A decided answer equals that of the exact comparison, up
/// to rounding.
template <class T, class Filter>
void check_filter(double distance, const Filter& filter, int& answers) {
  for (const double off : {-1.0, -1e-3, -1e-5, -1e-7, -1e-9, -1e-12, 0.0, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3, 1.0}) {
    const T reach = static_cast<T>(distance + off);
    if (reach <= 0) continue;
    const auto quick = filter(reach);
    if (!quick) continue;
    ++answers;
    const bool is_apart = static_cast<double>(reach) < distance;
    EXPECT_EQ(*quick, is_apart ? Relation::apart : Relation::overlapping) << distance << ", off by " << off;
  }
}

template <class T>
class BallFilterIn : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(BallFilterIn, Scalars);

TYPED_TEST(BallFilterIn, AgreesWithTheDistanceOfPoints) {
  using T = TypeParam;
  std::mt19937 random(20261121);
  int answers = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto a = any_vector<T>(random);
    const auto b = any_vector<T>(random);
    const auto filter = [&](T reach) { return detail::filter_of_spheres(a, b, reach); };
    check_filter<T>(std::sqrt(distance_squared(a, b)), filter, answers);
  }
  EXPECT_GT(answers, 20000);
}

TYPED_TEST(BallFilterIn, AgreesWithTheDistanceFromABox) {
  using T = TypeParam;
  std::mt19937 random(20261121);
  int answers = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto center = any_vector<T>(random);
    const auto box = Aabb<3, T>::from_corners(any_vector<T>(random), any_vector<T>(random));
    const auto filter = [&](T reach) { return detail::filter_of_sphere(center, box, reach); };
    check_filter<T>(std::sqrt(distance_squared(center, box)), filter, answers);
  }
  EXPECT_GT(answers, 20000);
}

TEST(BallFilter, AgreesWithTheDistanceFromARay) {
  std::mt19937 random(20261121);
  int answers = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto direction = any_vector<double>(random);
    const auto center = any_vector<double>(random);
    const Segment<3, double> way{Vec<3, double>(0.0), direction * (9.0 / std::sqrt(dot(direction, direction)))};
    const auto filter = [&](double reach) { return detail::filter_of_ray_and_sphere(direction, center, reach); };
    check_filter<double>(std::sqrt(distance_squared(center, way)), filter, answers);
  }
  EXPECT_GT(answers, 20000);
}

TEST(BallFilter, LeavesTouchingToTheCarefulForm) {
  const Vec<2, float> center(5, 0);
  EXPECT_FALSE(detail::filter_of_spheres(Vec<2, float>(0, 0), center, 5.0F));
  EXPECT_FALSE(detail::filter_of_spheres(center, center, 0.0F));
  EXPECT_FALSE((detail::filter_of_sphere(center, Aabb<2, float>{{0, 0}, {3, 3}}, 2.0F)));
  EXPECT_FALSE(detail::filter_of_ray_and_sphere(Vec<2, double>(0, 1), Vec<2, double>(2, 7), 2.0));
}

TEST(BallFilter, LeavesWhatIsTooSmallOrTooLargeToSquare) {
  EXPECT_FALSE(detail::filter_of_spheres(Vec<2, float>(0, 0), Vec<2, float>(1e-21F, 0), 1e-22F));
  EXPECT_FALSE(detail::filter_of_spheres(Vec<2, float>(0, 0), Vec<2, float>(1e20F, 0), 1.1e20F));
  EXPECT_FALSE((detail::filter_of_sphere(Vec<2, float>(1e20F, 0), Aabb<2, float>{{0, 0}, {1, 1}}, 1.1e20F)));
  EXPECT_FALSE(detail::filter_of_ray_and_sphere(Vec<2, double>(1e-150, 0), Vec<2, double>(1, 1), 0.1));
  EXPECT_FALSE(detail::filter_of_ray_and_sphere(Vec<2, double>(1, 0), Vec<2, double>(1e150, 1e150), 1e140));
}

TEST(BallFilter, HasNoAnswerForNaN) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Aabb<2, double> box{{0, 0}, {1, 1}};
  const Vec<2, double> center(0.5, 0.5);
  EXPECT_FALSE(detail::filter_of_sphere(Vec<2, double>(nan, 0.5), box, 1.0));
  EXPECT_FALSE((detail::filter_of_sphere(center, Aabb<2, double>{{nan, 0}, {1, 1}}, 1.0)));
  EXPECT_FALSE((detail::filter_of_sphere(center, Aabb<2, double>{{0, 0}, {1, nan}}, 1.0)));
  EXPECT_FALSE(detail::filter_of_sphere(center, box, nan));
  EXPECT_FALSE(detail::filter_of_spheres(center, Vec<2, double>(nan, 0), 1.0));
  EXPECT_FALSE(detail::filter_of_ray_and_sphere(Vec<2, double>(nan, 1), center, 1.0));
  EXPECT_FALSE(detail::filter_of_ray_and_sphere(Vec<2, double>(1, 1), Vec<2, double>(0, nan), 1.0));
  EXPECT_FALSE(detail::filter_of_ray_and_sphere(Vec<2, double>(1, 1), center, nan));
}

}  // namespace
}  // namespace graze::ball_filter_test
