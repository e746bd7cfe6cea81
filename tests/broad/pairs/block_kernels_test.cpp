// SPDX-License-Identifier: MIT
// Compares the kernels of every instruction set of this machine, and the scalar ones, with plain loops, bit for bit.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/pairs/block_kernels.hpp>

#include "broad/box_worlds.hpp"
#include "broad/simd_targets.hpp"
#include "spaces.hpp"

namespace graze::detail::block_kernels_test {
namespace {

template <class Space>
class BlockKernelsTest : public testing::Test {
 protected:
  /// Calls test(kernels) for each instruction set.
  template <class Test>
  void for_every_target(const Test& test) {
    for (const std::int64_t target : test::simd_targets()) {
      const test::ForcedTarget forced(target);
      const auto& kernels = block_kernels<Space::dimension, typename Space::scalar>();
      SCOPED_TRACE(kernels.target);
      test(kernels);
    }
  }
};

TYPED_TEST_SUITE(BlockKernelsTest, test::Spaces);

template <class Value>
bool same_bits(const Value& a, const Value& b) {
  return std::memcmp(&a, &b, sizeof(Value)) == 0;
}

TEST(SimdTargets, AreTriedFromNoneToTheBestOfThisMachine) {
  const std::vector<std::int64_t> targets = test::all_simd_targets();
  for (const std::int64_t target : targets) {
    const test::ForcedTarget forced(target);
    EXPECT_STREQ((block_kernels<3, float>().target), hwy::TargetName(target));
  }
#ifdef __aarch64__
  EXPECT_EQ(targets, std::vector<std::int64_t>{HWY_NEON});  // which all have
#else
  EXPECT_TRUE(targets.back() == HWY_SCALAR || targets.back() == HWY_EMU128) << hwy::TargetName(targets.back());
#endif
}

TYPED_TEST(BlockKernelsTest, SurveyFindsTheBoundsOfTheCentersOfWhatIsFinite) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (auto& world : test::box_worlds<N, T>(133, 3)) {
    SCOPED_TRACE(world.name);
    Aabb<N, T> expected = Aabb<N, T>::nothing();
    for (const auto& box : world.boxes) {
      if (is_finite(box.min) && is_finite(box.max) && !is_nothing(box)) expected.grow(box.center());
    }
    this->for_every_target([&](const auto& kernels) {
      EXPECT_TRUE(same_bits(kernels.survey(world.boxes.data(), world.boxes.size()), expected));
    });
  }
}

TYPED_TEST(BlockKernelsTest, CellsAreThoseOfCentersAndUnusualBoxesAreToldApart) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  constexpr std::uint16_t unusual = 0xFFFF;
  for (const auto& world : test::box_worlds<N, T>(133, 4)) {
    SCOPED_TRACE(world.name);
    Aabb<N, T> centers = Aabb<N, T>::nothing();
    for (const auto& box : world.boxes) {
      if (is_finite(box.min) && is_finite(box.max) && !is_nothing(box)) centers.grow(box.center());
    }
    // Some centers are outside of a grid over the middle of them.
    const Aabb<N, T> middle{centers.min * T(0.75) + centers.max * T(0.25),
                            centers.min * T(0.25) + centers.max * T(0.75)};
    for (const CellGrid<N, T>& grid : {grid_over(centers, 200), grid_over(middle, 200)}) {
      const T largest = T(1.5);
      std::vector<std::uint16_t> expected;
      for (const auto& box : world.boxes) {
        bool usual = is_finite(box.min) && is_finite(box.max);
        for (Dim i = 0; i < N; ++i) usual = usual && box.min[i] <= box.max[i] && box.max[i] - box.min[i] <= largest;
        expected.push_back(usual ? nearest_cell_of(box.center(), grid) : unusual);
      }
      this->for_every_target([&](const auto& kernels) {
        std::vector<std::uint16_t> cells(world.boxes.size());
        kernels.cells(world.boxes.data(), world.boxes.size(), grid, largest, unusual, cells.data());
        EXPECT_EQ(cells, expected);
      });
    }
  }
}

TYPED_TEST(BlockKernelsTest, CentersAreBoundedAndSortedIntoCellsWhateverTheSizes) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  auto boxes = test::box_worlds<N, T>(133, 5).front().boxes;
  boxes[40] = {Vec<N, T>(std::numeric_limits<T>::lowest()), Vec<N, T>(std::numeric_limits<T>::max())};
  Aabb<N, T> bounds = Aabb<N, T>::nothing();
  for (const auto& box : boxes) bounds.grow(box.center());
  const CellGrid<N, T> grid = grid_over(bounds, 100);
  this->for_every_target([&](const auto& kernels) {
    EXPECT_TRUE(same_bits(kernels.center_bounds(boxes.data(), boxes.size()), bounds));
    std::vector<std::uint16_t> cells(boxes.size());
    kernels.center_cells(boxes.data(), boxes.size(), grid, cells.data());
    for (std::size_t k = 0; k < boxes.size(); ++k) EXPECT_EQ(cells[k], cell_of(boxes[k].center(), grid));
  });
}

TYPED_TEST(BlockKernelsTest, BlocksAreFilledInOrderGrownPaddedAndBounded) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  constexpr std::size_t block_count = 11;  // more than are stored at a time
  for (const auto& world : test::box_worlds<N, T>(block_count * block_size - 11, 6)) {
    SCOPED_TRACE(world.name);
    std::vector<std::uint16_t> order(world.boxes.size());
    for (std::uint16_t k = 0; k < order.size(); ++k) order[k] = static_cast<std::uint16_t>(order.size() - 1 - k);
    this->for_every_target([&](const auto& kernels) {
      for (const T margin : {T(0.25), T(0)}) {
        std::vector<Block<N, T>> blocks(block_count);
        kernels.fill(world.boxes.data(), order.data(), order.size(), margin, blocks.data());
        std::vector<Block<N, T>> above(1);
        kernels.close(blocks.data(), blocks.size(), above.data());
        for (std::size_t k = 0; k < block_count * block_size; ++k) {
          const Block<N, T>& block = blocks[k / block_size];
          for (Dim i = 0; i < N; ++i) {
            if (k < order.size()) {
              EXPECT_TRUE(same_bits(block.min[i][k % block_size], world.boxes[order[k]].min[i] - margin));
              EXPECT_TRUE(same_bits(block.max[i][k % block_size], world.boxes[order[k]].max[i] + margin));
            } else {
              EXPECT_TRUE(std::isnan(block.min[i][k % block_size]) && std::isnan(block.max[i][k % block_size]));
            }
          }
        }
        for (std::size_t lane = 0; lane < block_size; ++lane) {
          Aabb<N, T> bounds = Aabb<N, T>::nothing();
          for (std::size_t k = lane * block_size; k < std::min(order.size(), (lane + 1) * block_size); ++k) {
            bounds.grow(Aabb<N, T>{world.boxes[order[k]].min - margin, world.boxes[order[k]].max + margin});
          }
          for (Dim i = 0; i < N; ++i) {
            if (lane < block_count) {
              EXPECT_EQ(above[0].min[i][lane], bounds.min[i]);
              EXPECT_EQ(above[0].max[i][lane], bounds.max[i]);
            } else {
              EXPECT_TRUE(std::isnan(above[0].min[i][lane]) && std::isnan(above[0].max[i][lane]));
            }
          }
        }
      }
    });
  }
}

TYPED_TEST(BlockKernelsTest, BlocksAreRefilledAsTheirIdsSay) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const std::vector<Aabb<N, T>> boxes = test::box_worlds<N, T>(40, 8).front().boxes;
  std::vector<std::uint32_t> ids(3 * block_size, no_box);
  for (std::uint32_t k = 0; k < block_size; ++k) ids[k] = 39 - 2 * k;
  for (std::uint32_t k = 0; k < 5; ++k) ids[block_size + k] = 2 * k;
  for (std::uint32_t k = 0; k < 15; ++k) ids[2 * block_size + k] = 10 + 2 * k;
  this->for_every_target([&](const auto& kernels) {
    for (const T margin : {T(0), T(0.25)}) {
      std::vector<Block<N, T>> blocks(3);
      EXPECT_TRUE(kernels.refill(boxes.data(), margin, ids.data(), 3, blocks.data()));
      for (std::size_t k = 0; k < ids.size(); ++k) {
        const Block<N, T>& block = blocks[k / block_size];
        for (Dim i = 0; i < N; ++i) {
          const T min = block.min[i][k % block_size];
          const T max = block.max[i][k % block_size];
          if (ids[k] == no_box) {
            EXPECT_TRUE(std::isnan(min) && std::isnan(max)) << k;
          } else {
            EXPECT_EQ(min, boxes[ids[k]].min[i] - margin);
            EXPECT_EQ(max, boxes[ids[k]].max[i] + margin);
          }
        }
      }
    }
  });
}

TYPED_TEST(BlockKernelsTest, ARefillRefusesWhatIsNoBox) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  std::vector<Aabb<N, T>> boxes = test::box_worlds<N, T>(40, 9).front().boxes;
  std::vector<std::uint32_t> ids(2 * block_size, no_box);
  for (std::uint32_t k = 0; k < 20; ++k) ids[k] = k;
  this->for_every_target([&](const auto& kernels) {
    std::vector<Block<N, T>> blocks(2);
    for (const std::size_t spoilt : {0U, 15U, 16U, 19U, 20U}) {  // the last is in no block
      const Aabb<N, T> good = boxes[spoilt];
      boxes[spoilt].max[N - 1] = std::numeric_limits<T>::quiet_NaN();
      EXPECT_EQ(kernels.refill(boxes.data(), T(0), ids.data(), 2, blocks.data()), spoilt == 20) << spoilt;
      boxes[spoilt].max[N - 1] = boxes[spoilt].min[N - 1] - T(0.125);  // a margin does not make it a valid box
      EXPECT_EQ(kernels.refill(boxes.data(), T(1), ids.data(), 2, blocks.data()), spoilt == 20) << spoilt;
      boxes[spoilt] = good;
    }
  });
}

}  // namespace
}  // namespace graze::detail::block_kernels_test
