// SPDX-License-Identifier: MIT
// Posed corners are bit-identical to those of a plain calculation, and the farthest is the first that a plain search
// finds, or up to eight corners one that is as far up to its error, by vectors of any width.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/closest/few_corners.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail::few_corners_test {
namespace {

using Point = Vec<3, double>;

template <class T>
struct Case {
  std::vector<Vec<3, T>> corners;
  Mat<3, double> rotation = Mat<3, double>(1.0);
  Point shift = Point(0.0);
  std::vector<Point> directions;
};

/// With coordinates on a lattice, or not: on a lattice, several corners are farthest along an axis.
template <class T>
Case<T> draw(std::mt19937& engine) {
  const auto number = [&](double size) { return std::uniform_real_distribution<double>(-size, size)(engine); };
  const auto vector = [&](double size) { return Point(number(size), number(size), number(size)); };
  const bool is_coarse = number(1) < 0;
  Case<T> result;
  result.corners.resize(std::uniform_int_distribution<std::size_t>(1, FewCorners::room)(engine));
  for (Vec<3, T>& corner : result.corners) {
    const Point place = vector(3);
    corner = Vec<3, T>(is_coarse ? Point(std::round(place.x), std::round(place.y), std::round(place.z)) : place);
  }
  if (!is_coarse) result.rotation = rotation_matrix(vector(1) + Point(0, 0, 2), number(180));
  if (!is_coarse) result.shift = vector(10);
  result.directions = {vector(1), vector(1), Point(1, 0, 0), Point(0, 0, -1), Point(0.0)};
  return result;
}

template <std::size_t lanes, class T>
[[gnu::always_inline]] inline void answer(const Case<T>& given, bool is_turned, FewCorners& few,
                                          std::uint32_t* farthest) {
  const CornerRows<3, T> rows{std::span<const Vec<3, T>>(given.corners)};
  if (is_turned) {
    few.put<lanes>(rows, given.rotation, given.shift);
  } else {
    few.put<lanes>(rows, given.shift);
  }
  for (const Point& direction : given.directions) *farthest++ = few.farthest<lanes>(direction);
}

template <class T>
void by_two(const Case<T>& given, bool is_turned, FewCorners& few, std::uint32_t* farthest) {
  answer<2>(given, is_turned, few, farthest);
}
#ifdef GRAZE_HAS_WIDER_LANES
template <class T>
[[gnu::target("avx2")]] void by_four(const Case<T>& given, bool is_turned, FewCorners& few, std::uint32_t* farthest) {
  answer<4>(given, is_turned, few, farthest);
}
template <class T>
[[gnu::target("avx512f")]] void by_eight(const Case<T>& given, bool is_turned, FewCorners& few,
                                         std::uint32_t* farthest) {
  answer<8>(given, is_turned, few, farthest);
}
#endif

template <class T, class Answer>
void expect_as_plain(const Case<T>& given, bool is_turned, Answer answer_of) {
  FewCorners few;
  std::vector<std::uint32_t> farthest(given.directions.size());
  answer_of(given, is_turned, few, farthest.data());
  for (std::size_t i = 0; i < given.corners.size(); ++i) {
    const Point corner = wide<3, T>(given.corners[i]);
    ASSERT_EQ(few[i], is_turned ? given.rotation * corner + given.shift : corner - given.shift) << i;
  }
  for (std::size_t k = 0; k < farthest.size(); ++k) {
    std::uint32_t best = 0;
    for (std::uint32_t i = 1; i < given.corners.size(); ++i) {
      if (dot(few[i], given.directions[k]) > dot(few[best], given.directions[k])) best = i;
    }
    ASSERT_LT(farthest[k], given.corners.size());
    if (given.corners.size() > 8) {
      ASSERT_EQ(farthest[k], best) << given.corners.size();
    } else {
      const double height = dot(few[farthest[k]], given.directions[k]);
      const double highest = dot(few[best], given.directions[k]);
      ASSERT_LE(highest - height, FewCorners::farthest_error * std::max(std::fabs(height), std::fabs(highest)));
    }
  }
}

template <class T>
void compare_random_corners() {
  std::mt19937 engine(17);
  for (int i = 0; i < 4'000 && !testing::Test::HasFailure(); ++i) {
    const Case<T> given = draw<T>(engine);
    for (const bool is_turned : {false, true}) {
      expect_as_plain(given, is_turned, by_two<T>);
#ifdef GRAZE_HAS_WIDER_LANES
      if (__builtin_cpu_supports("avx2")) expect_as_plain(given, is_turned, by_four<T>);
      if (__builtin_cpu_supports("avx512f")) expect_as_plain(given, is_turned, by_eight<T>);
#endif
    }
  }
}

TEST(FewCorners, StandWhereTheyAreSeenAndAreSearchedAsPlainly) {
  compare_random_corners<double>();
  compare_random_corners<float>();
}

}  // namespace
}  // namespace graze::detail::few_corners_test

#endif
