// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <graze/scene/update/box_depth.hpp>
#include <graze/scene/update/depth_kernels.hpp>

#include "broad/simd_targets.hpp"

namespace graze::detail::depth_kernels_test {
namespace {

/// Small integers, so that many boxes only touch; some infinite, some empty; one more than is named.
template <Dim N>
std::vector<Aabb<N, float>> some_boxes(std::size_t count, std::mt19937& random) {
  std::vector<Aabb<N, float>> boxes(count + 1);
  for (Aabb<N, float>& box : boxes) {
    for (Dim i = 0; i < N; ++i) {
      box.min[i] = static_cast<float>(random() % 9);
      box.max[i] = box.min[i] + static_cast<float>(random() % 4);
      if (random() % 16 == 0) box.max[i] = std::numeric_limits<float>::infinity();
      if (random() % 16 == 0) box.min[i] = -std::numeric_limits<float>::infinity();
    }
    if (random() % 10 == 0) box = Aabb<N, float>::nothing();
  }
  return boxes;
}

template <class Space>
class DepthKernels : public testing::Test {};

template <Dim n>
struct Space {
  static constexpr Dim N = n;
};

using Spaces = testing::Types<Space<2>, Space<3>>;
TYPED_TEST_SUITE(DepthKernels, Spaces);

TYPED_TEST(DepthKernels, MarkWhatIsDeepAndListWhatIsNeitherDeepNorApart) {
  constexpr Dim N = TypeParam::N;
  std::mt19937 random(4);
  for (std::size_t count = 0; count < 90; ++count) {
    const std::size_t row = 1 + count % 30;
    const std::vector<Aabb<N, float>> boxes = some_boxes<N>(row, random);
    const float certain = count % 2 == 0 ? 1e-6F : 1.5F;
    std::vector<Pair> pairs(count);
    std::vector<char> expected;
    std::vector<std::size_t> expected_open;
    for (Pair& pair : pairs) {
      pair = {static_cast<std::uint32_t>(random() % row), static_cast<std::uint32_t>(random() % row)};
      const float depth = box_depth(boxes[pair.a], boxes[pair.b]);
      if (!(depth > certain) && depth >= -certain) expected_open.push_back(expected.size());
      expected.push_back(depth > certain ? 1 : 0);
    }
    for (const std::int64_t target : test::simd_targets()) {
      const test::ForcedTarget forced(target);
      for (const std::size_t said_row : {row, std::size_t{1} << 20U}) {  // the second enables prefetching
        std::vector<char> touches(count + 1, 7);
        std::vector<std::size_t> open(count);
        open.resize(graze::detail::depth_kernels<N>().judge(boxes.data(), said_row, pairs.data(), count, certain,
                                                            touches.data(), open.data()));
        EXPECT_EQ(touches.back(), 7) << hwy::TargetName(target);
        touches.pop_back();
        EXPECT_EQ(touches, expected) << hwy::TargetName(target);
        EXPECT_EQ(open, expected_open) << hwy::TargetName(target);
      }
    }
  }
}

}  // namespace
}  // namespace graze::detail::depth_kernels_test
