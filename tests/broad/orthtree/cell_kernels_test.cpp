// SPDX-License-Identifier: MIT
// Compares the walk to the boxes in a box, with every instruction set of this machine and without, with a plain loop;
// and tests that it visits few others.
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/orthtree/cell_kernels.hpp>
#include <graze/broad/orthtree/code.hpp>
#include <graze/broad/orthtree/tree.hpp>
#include <graze/broad/orthtree/walk.hpp>
#include <graze/shape/shape.hpp>

#include "broad/box_worlds.hpp"
#include "broad/simd_targets.hpp"
#include "spaces.hpp"

namespace graze::detail::cell_kernels_test {
namespace {

std::vector<std::uint32_t> first_slots(std::size_t count) {
  std::vector<std::uint32_t> slots(count);
  std::iota(slots.begin(), slots.end(), 0U);
  return slots;
}

/// All that is visited, or only the first part.
template <Dim N, class T>
std::vector<std::uint32_t> visited(const CellTree<N, T>& tree, const Aabb<N, T>& region, std::size_t most = 1U << 20U) {
  std::vector<std::uint32_t> slots;
  visit_groups_in_box(tree, region, [&](std::uint32_t slot) {
    slots.push_back(slot);
    return slots.size() < most;
  });
  return slots;
}

template <class Space>
class CellKernelsTest : public testing::Test {
 protected:
  static constexpr Dim N = Space::dimension;
  using T = typename Space::scalar;
  using Box = Aabb<N, T>;
  using Tree = CellTree<N, T>;

  /// Calls test() for each instruction set.
  template <class Test>
  void for_every_target(const Test& test) {
    const auto compiled = static_cast<std::uint64_t>(hwy::SupportedTargets() & cell_kernel_targets());
    ASSERT_EQ(test::all_simd_targets().size(), static_cast<std::size_t>(std::popcount(compiled)));
    for (const std::int64_t target : test::simd_targets()) {
      const test::ForcedTarget forced(target);
      EXPECT_STREQ((cell_kernels<N, T>().target), hwy::TargetName(target));
      SCOPED_TRACE(hwy::TargetName(target));
      test();
    }
  }

  /// A region finds the right boxes, in the same order with every instruction set.
  void expect_found(const Tree& tree, const std::vector<Box>& boxes, const std::vector<Box>& regions) {
    std::vector<std::vector<std::uint32_t>> found;
    for (const Box& region : regions) found.push_back(visited(tree, region));
    for (std::size_t k = 0; k < regions.size(); ++k) {
      std::vector<std::uint32_t> expected;
      for (std::uint32_t slot = 0; slot < boxes.size(); ++slot) {
        if (boxes_overlap(regions[k], boxes[slot])) expected.push_back(slot);
      }
      std::vector<std::uint32_t> sorted = found[k];
      std::sort(sorted.begin(), sorted.end());
      EXPECT_EQ(sorted, expected);
    }
    for_every_target([&] {
      for (std::size_t k = 0; k < regions.size(); ++k) EXPECT_EQ(visited(tree, regions[k]), found[k]);
    });
  }

  static Tree filled(const std::vector<Box>& boxes, const OrthtreeOptions& options = {}) {
    Tree tree(options);
    tree.fill(boxes, first_slots(boxes.size()));
    return tree;
  }
};

TYPED_TEST_SUITE(CellKernelsTest, test::Spaces);

TYPED_TEST(CellKernelsTest, FindsTheBoxesThatShareAPoint) {
  using Shape = typename TestFixture::Box;
  for (const auto& world : test::box_worlds<TestFixture::N, typename TestFixture::T>(600, 11)) {
    SCOPED_TRACE(world.name);
    std::vector<Shape> boxes;
    for (const Shape& box : world.boxes) {
      if (is_valid(box)) boxes.push_back(box);
    }
    std::vector<Shape> regions(boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(boxes.size() / 8));
    regions.push_back(Shape::everything());
    this->expect_found(TestFixture::filled(boxes), boxes, regions);
    this->expect_found(TestFixture::filled(boxes, {1, 32}), boxes, regions);
    this->expect_found(TestFixture::filled(boxes, {600, 0}), boxes, regions);
  }
}

/// Positions in blocks and cells are reused, and the previous content is never met.
TYPED_TEST(CellKernelsTest, FindsThemAfterChangesToo) {
  using Shape = typename TestFixture::Box;
  using Number = typename TestFixture::T;
  constexpr Dim dimension = TestFixture::N;
  std::mt19937 random(20261124);
  const auto number = [&random](std::uint32_t below) { return static_cast<Number>(random() % below); };
  const auto some_box = [&] {
    Shape box;
    for (Dim i = 0; i < dimension; ++i) {
      box.min[i] = number(200);
      box.max[i] = box.min[i] + number(random() % 16 == 0 ? 60 : 4);
    }
    if (random() % 64 == 0) box.max[0] = std::numeric_limits<Number>::infinity();
    return box;
  };
  std::vector<Shape> boxes(900);
  for (Shape& box : boxes) box = some_box();
  auto tree = TestFixture::filled(boxes, {4, 16});
  for (int round = 0; round < 3; ++round) {
    std::vector<Shape> regions{Shape::everything()};
    for (std::uint32_t slot = 0; slot < boxes.size(); ++slot) {
      if (random() % 2 == 0) continue;
      tree.erase(slot);
      boxes[slot] = some_box();
      if (random() % 2 == 0) {
        tree.insert(slot, boxes[slot]);
      } else {
        boxes[slot] = no_entry<dimension, Number>();  // shares a point with no region
      }
      regions.push_back(some_box());
    }
    this->expect_found(tree, boxes, regions);
    for (std::uint32_t slot = 0; slot < boxes.size(); ++slot) {
      const bool is_gone = !(boxes[slot].min[0] == boxes[slot].min[0]);
      boxes[slot] = some_box();
      if (is_gone) {
        tree.insert(slot, boxes[slot]);
      } else {
        tree.update(slot, boxes[slot]);
      }
    }
    this->expect_found(tree, boxes, regions);
  }
}

/// One chain of a thousand blocks, many times the capacity of a walk; and a thousand cells of one box each.
TYPED_TEST(CellKernelsTest, GoesOnWhereItWasInterruptedAndStopsWhereItIsTold) {
  using Shape = typename TestFixture::Box;
  using Number = typename TestFixture::T;
  using Point = Vec<TestFixture::N, Number>;
  const Shape same{Point(Number(1)), Point(Number(2))};
  std::vector<Shape> boxes(8'000, same);
  for (std::uint32_t k = 0; k < 2'000; ++k) {
    const Point corner(static_cast<Number>(3 + k));
    boxes.push_back({corner, corner});
  }
  const auto tree = TestFixture::filled(boxes, {1, 32});
  this->expect_found(tree, boxes, {same, Shape::everything(), {Point(Number(2)), Point(Number(1'000))}});
  const std::vector<std::uint32_t> all = visited(tree, Shape::everything());
  for (const std::size_t most : {1U, 2U, 240U, 241U, 248U, 255U, 256U, 9'999U, 10'000U}) {
    EXPECT_EQ(visited(tree, Shape::everything(), most),
              std::vector<std::uint32_t>(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(most)));
  }
}

TYPED_TEST(CellKernelsTest, FindsNothingWhereThereIsNothing) {
  using Shape = typename TestFixture::Box;
  using Number = typename TestFixture::T;
  using Point = Vec<TestFixture::N, Number>;
  const Number nan = std::numeric_limits<Number>::quiet_NaN();
  typename TestFixture::Tree tree({});
  this->expect_found(tree, {}, {Shape::everything()});
  std::vector<Shape> boxes(100, Shape{Point(Number(1)), Point(Number(2))});
  this->expect_found(TestFixture::filled(boxes), boxes,
                     {{Point(nan), Point(nan)}, {Point(nan), Point(Number(5))}, {Point(Number(3)), Point(Number(4))}});
}

/// With counts that leave lanes unused, and boxes whose centers are outside, infinite or NaN.
TYPED_TEST(CellKernelsTest, CodesAreThoseOfTheCenters) {
  using Number = typename TestFixture::T;
  constexpr Dim dimension = TestFixture::N;
  CellPosition<dimension> root;
  root.half = 40;
  const CodeScale<dimension, Number> scale(root);
  for (const auto& world : test::box_worlds<dimension, Number>(119, 12)) {
    SCOPED_TRACE(world.name);
    this->for_every_target([&] {
      for (const std::size_t count : {std::size_t{0}, std::size_t{5}, std::size_t{16}, world.boxes.size()}) {
        std::vector<CodedBox> coded(count);
        cell_kernels<dimension, Number>().code(world.boxes.data(), count, scale, coded.data());
        for (std::size_t k = 0; k < count; ++k) {
          const auto& box = world.boxes[k];
          EXPECT_EQ(coded[k].index, k);
          EXPECT_EQ(coded[k].code, code_of(box.min * Number(0.5) + box.max * Number(0.5), scale));
        }
      }
    });
  }
}

TYPED_TEST(CellKernelsTest, BoundsAreThoseOfAllUnlessOneIsNotFinite) {
  using Shape = typename TestFixture::Box;
  using Number = typename TestFixture::T;
  constexpr Dim dimension = TestFixture::N;
  using Point = Vec<dimension, Number>;
  std::vector<Shape> boxes;
  for (const auto& world : test::box_worlds<dimension, Number>(50, 13)) {
    for (const Shape& box : world.boxes) {
      if (is_valid(box)) boxes.push_back(box);
    }
  }
  const Number nan = std::numeric_limits<Number>::quiet_NaN();
  const Number infinity = std::numeric_limits<Number>::infinity();
  Shape unbounded = boxes[0];
  unbounded.max[dimension - 1] = infinity;
  Shape unknown = boxes[0];
  unknown.min[0] = nan;
  const std::vector<Shape> faulty{unbounded, unknown, {Point(nan), Point(nan)}, {Point(Number(2)), Point(Number(1))}};
  this->for_every_target([&] {
    const auto bounds = cell_kernels<dimension, Number>().bounds;
    EXPECT_TRUE(is_nothing(bounds(boxes.data(), 0)));
    for (const std::size_t count : {std::size_t{1}, std::size_t{21}, boxes.size()}) {
      Shape expected = Shape::nothing();
      for (std::size_t k = 0; k < count; ++k) expected.grow(boxes[k]);
      EXPECT_EQ(bounds(boxes.data(), count), expected);
      for (const std::size_t place : {std::size_t{0}, count / 2, count - 1}) {
        for (const Shape& fault : faulty) {
          std::vector<Shape> some(boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(count));
          some[place] = fault;
          EXPECT_TRUE(is_nothing(bounds(some.data(), count)));
        }
      }
    }
  });
}

/// A lattice of a hundred by a hundred.
TEST(CellKernels, LookAtLittleBesideWhatTheyFind) {
  std::vector<Aabb<2, float>> boxes;
  for (std::uint32_t k = 0; k < 10'000; ++k) {
    const Vec<2> low(static_cast<float>(k % 100), static_cast<float>(k / 100));
    boxes.push_back({low, low + 0.5F});
  }
  CellTree<2, float> tree({});
  tree.fill(boxes, first_slots(boxes.size()));
  // Descending to the center first, to an empty area, or group by group only changes the order.
  const auto way_to = [&tree](float x, float y) {
    return CellWay<2>::to_middle(Aabb<2, float>{{x, y}, {x, y}}, tree.code_scale());
  };
  for (const std::optional<CellWay<2>>& way : {std::optional(way_to(42, 42)), std::optional(way_to(90, 7)), {}}) {
    CellMetWalk<2, float> walk;
    walk.start({{40, 40}, {44, 44}});
    walk.add_group(tree.cell(CellTree<2, float>::root).first_child / 4);
    if (way) walk.follow(*way);
    cell_kernels<2, float>().find_overlapping(tree.groups(), tree.pool().pages(), walk);
    EXPECT_TRUE(walk.is_over());
    EXPECT_EQ(walk.found_count, 25U);
    EXPECT_LT(walk.groups_seen, 20U);
    EXPECT_LT(walk.blocks_seen, 25U);
  }
}

}  // namespace
}  // namespace graze::detail::cell_kernels_test
