// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/bvh/part.hpp>

#include "broad/box_worlds.hpp"
#include "broad/center_room.hpp"
#include "broad/simd_targets.hpp"

namespace graze::detail::bvh_part_test {
namespace {

/// The indices of centers in order along an axis, ties by slot.
template <Dim N, class T>
std::vector<std::uint32_t> sorted_along(const test::CenterRoom<N, T>& centers, std::size_t count, Dim axis) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0U);
  std::sort(numbers.begin(), numbers.end(), [&](std::uint32_t a, std::uint32_t b) {
    const T at_a = centers.center(a)[axis];
    const T at_b = centers.center(b)[axis];
    return at_a != at_b ? at_a < at_b : centers.slot(a) < centers.slot(b);
  });
  return numbers;
}

/// The numbers of each of two parts in ascending order.
std::vector<std::uint32_t> in_their_order(std::vector<std::uint32_t> numbers, std::size_t lower) {
  std::sort(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(lower));
  std::sort(numbers.begin() + static_cast<std::ptrdiff_t>(lower), numbers.end());
  return numbers;
}

/// Centers with coordinates of a given number of distinct values, with shuffled slots.
template <Dim N, class T>
void expect_parts_as_sorted(std::size_t count, double kinds) {
  test::Numbers random(count);
  test::CenterRoom<N, T> here(count);
  for (std::size_t k = 0; k < count; ++k) {
    Vec<N, T> center = random.point<N, T>(0, kinds);
    for (Dim i = 0; i < N; ++i) center[i] = kinds < 10 ? std::floor(center[i]) : center[i];
    here.set(k, center, static_cast<std::uint32_t>(k * 7919 % 100'003));
  }
  for (Dim axis = 0; axis < N; ++axis) {
    const std::vector<std::uint32_t> sorted = sorted_along(here, count, axis);
    for (const std::size_t lower : {std::size_t{1}, count / 3, count / 2, count - 1}) {
      const std::vector<std::uint32_t> expected = in_their_order(sorted, lower);
      for (const std::int64_t target : test::simd_targets()) {
        const test::ForcedTarget forced(target);
        for (const BvhWanted wanted : {BvhWanted::all, BvhWanted::slots}) {
          test::CenterRoom<N, T> beside(count);
          const T border = part_centers<N, T>({here.lists(), beside.lists(), count}, lower, axis, wanted);
          EXPECT_EQ(border, here.center(sorted[lower])[axis]);
          for (std::size_t k = 0; k < count; ++k) {
            ASSERT_EQ(beside.slot(k), here.slot(expected[k])) << k << " of " << count << ", " << kinds << " kinds";
            ASSERT_TRUE(wanted == BvhWanted::slots || beside.center(k) == here.center(expected[k]));
          }
          EXPECT_TRUE(beside.is_untouched_around());
        }
      }
    }
  }
}

TEST(BvhPart, PartsAsSortingDoesAndKeepsTheOrder) {
  for (const std::size_t count : {2U, 17U, 32U, 33U, 63U, 64U, 200U, 1000U, 5000U}) {
    for (const double kinds : {1.0, 2.0, 9.0, 1e6}) {  // all equal, two, some, none
      expect_parts_as_sorted<2, float>(count, kinds);
      expect_parts_as_sorted<3, float>(count, kinds);
      expect_parts_as_sorted<3, double>(count, kinds);
    }
    expect_parts_as_sorted<2, double>(count, 2);
  }
}

}  // namespace
}  // namespace graze::detail::bvh_part_test
