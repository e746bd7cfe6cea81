// SPDX-License-Identifier: MIT
// Compares the kernels of every instruction set of this machine, and the scalar ones, with plain loops, bit for bit.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/bvh/build_kernels.hpp>
#include <graze/shape/shape.hpp>

#include "broad/box_worlds.hpp"
#include "broad/center_room.hpp"
#include "broad/simd_targets.hpp"
#include "spaces.hpp"

namespace graze::detail::center_kernels_test {
namespace {

template <class Space>
class CenterKernelsTest : public testing::Test {
 protected:
  /// Calls test(kernels) for each instruction set.
  template <class Test>
  void for_every_target(const Test& test) {
    for (const std::int64_t target : test::simd_targets()) {
      const test::ForcedTarget forced(target);
      const auto& kernels = build_kernels<Space::dimension, typename Space::scalar>();
      SCOPED_TRACE(kernels.target);
      test(kernels);
    }
  }
};

TYPED_TEST_SUITE(CenterKernelsTest, test::Spaces);

TYPED_TEST(CenterKernelsTest, FiniteCountsBoxesUpToTheFirstThatIsNot) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (auto& world : test::box_worlds<N, T>(70, 5)) {
    SCOPED_TRACE(world.name);
    world.boxes[40].max[N - 1] = std::numeric_limits<T>::quiet_NaN();
    this->for_every_target([&](const auto& kernels) {
      for (std::size_t first = 0; first <= world.boxes.size(); ++first) {
        std::size_t expected = first;
        while (expected < world.boxes.size() && is_valid(world.boxes[expected])) ++expected;
        ASSERT_EQ(kernels.finite(world.boxes.data() + first, world.boxes.size() - first), expected - first);
      }
    });
  }
}

TYPED_TEST(CenterKernelsTest, CentersAndTheirBoundsAreThoseOfTheBoxes) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (const auto& world : test::box_worlds<N, T>(70, 6)) {
    SCOPED_TRACE(world.name);
    std::vector<Aabb<N, T>> boxes;
    for (const Aabb<N, T>& box : world.boxes) {
      if (is_valid(box)) boxes.push_back(box);
    }
    this->for_every_target([&](const auto& kernels) {
      for (std::size_t count = 1; count <= boxes.size(); ++count) {
        test::CenterRoom<N, T> room(count);
        kernels.centers(boxes.data(), count, room.lists());
        Aabb<N, T> expected = Aabb<N, T>::nothing();
        for (std::size_t k = 0; k < count; ++k) {
          ASSERT_EQ(room.center(k), boxes[k].center());
          expected.grow(boxes[k].center());
        }
        ASSERT_EQ(kernels.bounds(room.lists(), count), expected);
      }
    });
  }
}

/// Numbers that are difficult for selection.
template <class T>
std::vector<std::vector<T>> rows_of_numbers(std::size_t count) {
  test::Numbers random(count);
  std::vector<std::vector<T>> rows;
  const auto row = [&](const auto& number_of) {
    rows.emplace_back();
    for (std::size_t k = 0; k < count; ++k) rows.back().push_back(static_cast<T>(number_of(k)));
  };
  row([&](std::size_t) { return random.between(-1, 1); });
  row([&](std::size_t) { return std::floor(random.between(0, 4)); });
  row([&](std::size_t k) { return k % 8 == 0 ? random.between(0, 1e9) : 0.0; });
  row([&](std::size_t k) { return k % 2 == 0 ? -0.0 : 0.0; });
  row([](std::size_t k) { return static_cast<double>(k); });
  row([](std::size_t k) { return -static_cast<double>(k); });
  row([](std::size_t k) { return std::ldexp(1.0, static_cast<int>(k % 100)); });
  row([&](std::size_t k) { return (k % 2 == 0 ? 1 : -1) * static_cast<double>(std::numeric_limits<T>::max()); });
  // at the sampled positions
  row([](std::size_t k) { return k % 16 == 8 ? 1e6 + static_cast<double>(k) : static_cast<double>(k); });
  return rows;
}

TYPED_TEST(CenterKernelsTest, SelectFindsWhatSortingDoes) {
  using T = typename TypeParam::scalar;
  for (const std::size_t count : {1U, 2U, 15U, 31U, 32U, 33U, 50U, 128U, 255U, 511U, 512U, 700U, 3001U}) {
    for (const std::vector<T>& numbers : rows_of_numbers<T>(count)) {
      std::vector<T> sorted = numbers;
      std::sort(sorted.begin(), sorted.end());
      this->for_every_target([&](const auto& kernels) {
        for (const std::size_t rank : {std::size_t{0}, count / 7, count / 2, count - 1}) {
          std::vector<T> room(count);
          std::vector<T> more_room(count);
          const Selected<T> found = kernels.select(numbers.data(), count, rank, room.data(), more_room.data());
          EXPECT_EQ(found.value, sorted[rank]) << rank << " of " << count;
          const auto less = std::lower_bound(sorted.begin(), sorted.end(), sorted[rank]) - sorted.begin();
          EXPECT_EQ(found.less, static_cast<std::size_t>(less)) << rank << " of " << count;
        }
      });
    }
  }
}

TYPED_TEST(CenterKernelsTest, PartKeepsTheOrderAndWritesNothingElse) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::Numbers random(9);
  for (std::size_t count = 1; count < 100; ++count) {
    test::CenterRoom<N, T> from(count);
    for (std::size_t k = 0; k < count; ++k) from.set(k, random.point<N, T>(0, 20), static_cast<std::uint32_t>(7 * k));
    for (Dim axis = 0; axis < N; ++axis) {
      const T border = std::floor(from.center(count / 2)[axis]);
      std::vector<std::uint32_t> expected(count);
      std::iota(expected.begin(), expected.end(), 0U);
      const auto middle = std::stable_partition(expected.begin(), expected.end(),
                                                [&](std::uint32_t k) { return from.center(k)[axis] < border; });
      const Selected<T> selected{border, static_cast<std::size_t>(middle - expected.begin())};
      this->for_every_target([&](const auto& kernels) {
        test::CenterRoom<N, T> to(count);
        test::CenterRoom<N, T> slots(count);
        kernels.part(from.lists(), count, axis, selected, to.lists());
        kernels.part_slots(from.lists(), count, axis, selected, slots.lists());
        for (std::size_t k = 0; k < count; ++k) {
          ASSERT_EQ(to.center(k), from.center(expected[k]));
          ASSERT_EQ(to.slot(k), from.slot(expected[k]));
          ASSERT_EQ(slots.slot(k), from.slot(expected[k]));
        }
        EXPECT_TRUE(to.is_untouched_around());
        EXPECT_TRUE(slots.is_untouched_around());
      });
    }
  }
}

RC_GTEST_PROP(BuildKernels, SelectFindsWhatSortingDoesInAnyNumbers, (const std::vector<short>& some)) {
  std::vector<float> numbers = {0.5F};
  for (int copy = 0; copy < 9; ++copy) {
    for (const short number : some) numbers.push_back(static_cast<float>(number % (1 << (copy + 2))));
  }
  std::vector<float> sorted = numbers;
  std::sort(sorted.begin(), sorted.end());
  const auto rank = *rc::gen::inRange<std::size_t>(0, numbers.size());
  std::vector<float> room(numbers.size());
  std::vector<float> more_room(numbers.size());
  const Selected<float> found =
      build_kernels<3, float>().select(numbers.data(), numbers.size(), rank, room.data(), more_room.data());
  RC_ASSERT(found.value == sorted[rank]);
  RC_ASSERT(static_cast<std::ptrdiff_t>(found.less) ==
            std::lower_bound(sorted.begin(), sorted.end(), sorted[rank]) - sorted.begin());
}

}  // namespace
}  // namespace graze::detail::center_kernels_test
