// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/shape/parts/spatial_order.hpp>

#include "catalogue.hpp"

namespace graze::test::spatial_order_test {
namespace {

constexpr std::size_t width = 16;

template <class SpaceType>
class SpatialOrderIn : public ::testing::Test {
 public:
  static constexpr Dim dimension = SpaceType::dimension;
  using Number = typename SpaceType::scalar;
  using Boxes = std::vector<Aabb<dimension, Number>>;

  static Boxes draw_boxes(std::size_t count, std::mt19937& random, unsigned side) {
    Boxes boxes;
    for (std::size_t i = 0; i < count; ++i) {
      Vec<dimension, Number> center;
      for (Dim k = 0; k < dimension; ++k) center[k] = static_cast<Number>(random() % side);
      boxes.push_back(Aabb<dimension, Number>::from_center(center, Vec<dimension, Number>(Number(0.5))));
    }
    return boxes;
  }

  static std::vector<std::uint32_t> sorted(const Boxes& boxes) {
    std::vector<std::uint32_t> order(boxes.size());
    std::iota(order.begin(), order.end(), 0U);
    detail::put_in_spatial_order<width>(std::span<const Aabb<dimension, Number>>(boxes),
                                        std::span<std::uint32_t>(order), detail::OneByOne());
    return order;
  }

  /// The sum of the sizes of the boxes around each block of boxes.
  static double size_of_blocks(const Boxes& boxes, const std::vector<std::uint32_t>& order, std::size_t block) {
    double sum = 0;
    for (std::size_t first = 0; first < order.size(); first += block) {
      Aabb<dimension, Number> around = Aabb<dimension, Number>::nothing();
      for (std::size_t i = first; i < std::min(first + block, order.size()); ++i) around.grow(boxes[order[i]]);
      sum += static_cast<double>(sum_abs(around.max - around.min));
    }
    return sum;
  }
};
TYPED_TEST_SUITE(SpatialOrderIn, Spaces);

TYPED_TEST(SpatialOrderIn, HoldsEveryBoxOnce) {
  std::mt19937 random(1);
  for (const std::size_t count : {0U, 1U, 16U, 17U, 255U, 257U, 4097U}) {
    std::vector<std::uint32_t> order = TestFixture::sorted(TestFixture::draw_boxes(count, random, 10));
    std::sort(order.begin(), order.end());
    std::vector<std::uint32_t> expected(count);
    std::iota(expected.begin(), expected.end(), 0U);
    EXPECT_EQ(order, expected);
  }
}

// A random order has blocks of nearly the size of the whole.
TYPED_TEST(SpatialOrderIn, HasSmallBlocksOnEveryLevel) {
  std::mt19937 random(2);
  const auto boxes = TestFixture::draw_boxes(10'000, random, 1000);
  const std::vector<std::uint32_t> order = TestFixture::sorted(boxes);
  std::vector<std::uint32_t> as_drawn(boxes.size());
  std::iota(as_drawn.begin(), as_drawn.end(), 0U);
  for (const std::size_t block : {width, width * width}) {
    const double drawn = TestFixture::size_of_blocks(boxes, as_drawn, block);
    EXPECT_LT(TestFixture::size_of_blocks(boxes, order, block), drawn / (block == width ? 4 : 2));
  }
}

TYPED_TEST(SpatialOrderIn, KeepsTheOrderOfEqualBoxesWithinABlock) {
  const typename TestFixture::Boxes boxes(40, Aabb<TypeParam::dimension, typename TypeParam::scalar>{});
  std::vector<std::uint32_t> order = TestFixture::sorted(boxes);
  for (std::size_t first = 0; first < order.size(); first += width) {
    const auto begin = order.begin() + static_cast<std::ptrdiff_t>(first);
    std::sort(begin, begin + static_cast<std::ptrdiff_t>(std::min(width, order.size() - first)));
  }
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
}

}  // namespace
}  // namespace graze::test::spatial_order_test
