// SPDX-License-Identifier: MIT
// Compares the kernels of every instruction set of this machine, and the scalar ones, with plain loops.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/bvh/bvh_kernels.hpp>
#include <graze/broad/bvh/query.hpp>
#include <graze/broad/bvh/tree.hpp>
#include <graze/broad/index/box_cover.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/shape/shape.hpp>

#include "broad/box_worlds.hpp"
#include "broad/simd_targets.hpp"
#include "spaces.hpp"

namespace graze::detail::bvh_kernels_test {
namespace {

template <class Space>
class BvhKernelsTest : public testing::Test {
 protected:
  using Node = BvhNode<Space::dimension, typename Space::scalar>;
  using Box = Aabb<Space::dimension, typename Space::scalar>;

  BvhKernelsTest() {
    for (const auto& world : test::box_worlds<Space::dimension, typename Space::scalar>(600, 11)) {
      std::size_t next = 0;
      for (std::uint32_t count = 1; count <= block_size; ++count) {
        Node node;
        clear_lanes(node, 0);
        for (std::uint32_t lane = 0; lane < count; ++next) {
          const Box& box = world.boxes[next % world.boxes.size()];
          if (!is_valid(box)) continue;
          put_box(node.boxes, lane, box);
          node.entries[lane++] = static_cast<std::uint32_t>(next);
        }
        nodes_.push_back(node);
        counts_.push_back(count);
        probes_.push_back(world.boxes[(next + 300) % world.boxes.size()]);
      }
    }
  }

  /// Calls test(kernels, node, count, nearby box) for each instruction set and node.
  template <class Test>
  void for_every_node(const Test& test) {
    ASSERT_EQ(test::all_simd_targets().size(), kernel_targets());
    for (const std::int64_t target : test::simd_targets()) {
      const test::ForcedTarget forced(target);
      const auto& kernels = bvh_kernels<Space::dimension, typename Space::scalar>();
      EXPECT_STREQ(kernels.target, hwy::TargetName(target));
      SCOPED_TRACE(kernels.target);
      for (std::size_t k = 0; k < nodes_.size(); ++k) test(kernels, nodes_[k], counts_[k], probes_[k]);
    }
  }

  /// The number of this machine's instruction sets that the kernels are compiled for.
  static std::size_t kernel_targets() {
    return static_cast<std::size_t>(
        std::popcount(static_cast<std::uint64_t>(hwy::SupportedTargets() & bvh_kernel_targets())));
  }

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> counts_;
  std::vector<Box> probes_;
};

TYPED_TEST_SUITE(BvhKernelsTest, test::Spaces);

TYPED_TEST(BvhKernelsTest, MetAreTheBoxesThatShareAPoint) {
  std::size_t all = 0;
  this->for_every_node([&](const auto& kernels, const auto& node, std::uint32_t count, const auto& box) {
    std::uint32_t expected = 0;
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      expected |= static_cast<std::uint32_t>(boxes_overlap(box, box_in(node.boxes, lane))) << lane;
    }
    EXPECT_EQ(kernels.met(node.boxes, box), expected);
    EXPECT_EQ(kernels.met(node.boxes, TestFixture::Box::everything()), (std::uint64_t{1} << count) - 1);
    all += static_cast<std::size_t>(std::popcount(expected));
  });
  EXPECT_GT(all, 50 * test::simd_targets().size());
}

TYPED_TEST(BvhKernelsTest, AroundIsTheBoxAroundAll) {
  this->for_every_node([&](const auto& kernels, const auto& node, std::uint32_t count, const auto&) {
    auto expected = TestFixture::Box::nothing();
    for (std::uint32_t lane = 0; lane < count; ++lane) grow_at_once(expected, box_in(node.boxes, lane));
    EXPECT_EQ(kernels.around(node.boxes), expected);
  });
}

template <Dim N, class T>
T sum_of_growth(const Aabb<N, T>& bounds, const Aabb<N, T>& box) {
  T growth = 0;
  for (Dim i = 0; i < N; ++i) {
    growth += std::max(bounds.min[i] - box.min[i], T(0)) + std::max(box.max[i] - bounds.max[i], T(0));
  }
  return growth;
}

template <Dim N, class T>
T sum_of_extents(const Aabb<N, T>& box) {
  T sum = 0;
  for (Dim i = 0; i < N; ++i) sum += box.max[i] - box.min[i];
  return sum;
}

template <Dim N, class T>
std::uint32_t expected_least_grown(const BvhNode<N, T>& node, std::uint32_t count, const Aabb<N, T>& box) {
  std::uint32_t best = 0;
  for (std::uint32_t lane = 1; lane < count; ++lane) {
    const T growth = sum_of_growth(box_in(node.boxes, lane), box);
    const T least = sum_of_growth(box_in(node.boxes, best), box);
    const T extents = sum_of_extents(box_in(node.boxes, lane));
    if (growth < least || (growth == least && extents < sum_of_extents(box_in(node.boxes, best)))) best = lane;
  }
  return best;
}

TYPED_TEST(BvhKernelsTest, LeastGrownIsTheFirstOfTheSmallestThatGrowLeast) {
  this->for_every_node([&](const auto& kernels, const auto& node, std::uint32_t count, const auto& box) {
    if (is_valid(box)) {
      EXPECT_EQ(kernels.least_grown(node.boxes, box), expected_least_grown(node, count, box));
    }
    const auto present = box_in(node.boxes, count - 1);
    EXPECT_EQ(kernels.least_grown(node.boxes, present), expected_least_grown(node, count, present));
  });
}

/// There is an answer even if the growth overflows.
TYPED_TEST(BvhKernelsTest, LeastGrownIsABoxEvenAmongTheLargest) {
  using T = typename TypeParam::scalar;
  constexpr Dim N = TypeParam::dimension;
  constexpr T most = std::numeric_limits<T>::max();
  BvhNode<N, T> node;
  clear_lanes(node, 0);
  for (std::uint32_t lane = 0; lane < 3; ++lane) put_box(node.boxes, lane, {Vec<N, T>(most / 2), Vec<N, T>(most)});
  const Aabb<N, T> far{Vec<N, T>(-most), Vec<N, T>(-most)};
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    EXPECT_EQ((bvh_kernels<N, T>().least_grown(node.boxes, far)), 0U);
  }
}

/// All boxes that entry_of enters, no later, and few others.
TYPED_TEST(BvhKernelsTest, EnteredAreTheBoxesThatARayMayEnter) {
  using T = typename TypeParam::scalar;
  constexpr Dim N = TypeParam::dimension;
  std::size_t all = 0;
  this->for_every_node([&](const auto& kernels, const auto& node, std::uint32_t count, const auto& box) {
    if (!is_valid(box)) return;
    const auto towards = box_in(node.boxes, count / 2);
    Ray<N, T> ray{box.min, towards.max - box.min};
    if (count % 3 == 0) ray.direction[0] = T(0);
    if (!is_valid(ray)) return;
    const double size = std::max(finite_size(kernels.around(node.boxes)), finite_size(box));
    T soonest[block_size];
    const BvhSlabs<N, T> slabs = slabs_of(ray, size);
    const std::uint32_t entered = kernels.entered(node.boxes, slabs, soonest);
    const bool is_usual = std::count(std::begin(slabs.kinds), std::end(slabs.kinds), BvhSlab::any) == 0;
    EXPECT_LT(entered, std::uint64_t{1} << count);
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      const auto there = box_in(node.boxes, lane);
      const std::optional<double> t = entry_of(ray, there);
      const bool may_enter = (entered >> lane & 1U) != 0;
      EXPECT_TRUE(may_enter || !t);
      const double slack = 1e-3 * (1e-3 * size + static_cast<double>(sum_of_extents(there)));
      if (may_enter && is_usual) {
        EXPECT_TRUE(entry_of(ray, grown_by(there, slack)).has_value());
      }
      if (!t) continue;
      EXPECT_LE(static_cast<double>(soonest[lane]), *t);
      if (is_usual) {
        EXPECT_GE(static_cast<double>(soonest[lane]), *t * (1 - 1e-5) - 1e-30);
      }
      ++all;
    }
  });
  EXPECT_GT(all, 50 * test::simd_targets().size());
}

/// The first of all boxes on a ray, ties to the lowest slot, bit for bit: forwards and backwards, along axes, from
/// inside and from afar, for every instruction set.
TYPED_TEST(BvhKernelsTest, TheFirstBoxOnARayIsThatOfBoxByBox) {
  using T = typename TypeParam::scalar;
  constexpr Dim N = TypeParam::dimension;
  std::size_t hits = 0;
  for (const auto& world : test::box_worlds<N, T>(300, 5)) {
    SCOPED_TRACE(world.name);
    BvhTree<N, T> tree(0);
    for (std::uint32_t k = 0; k < world.boxes.size(); ++k) tree.insert(k, world.boxes[k], 7 * k);
    std::vector<Ray<N, T>> rays;
    for (std::size_t k = 0; k < world.boxes.size(); k += 3) {
      const Aabb<N, T>& to = world.boxes[world.boxes.size() - 1 - k];
      Ray<N, T> ray{world.boxes[k].min, to.max - world.boxes[k].min};
      if (k % 4 == 0) ray.direction[static_cast<Dim>(k % N)] = k % 8 == 0 ? T(0) : -T(0);
      if (k % 5 == 0) ray.origin -= ray.direction;
      if (is_valid(ray)) rays.push_back(ray);
    }
    for (const Ray<N, T>& ray : rays) {
      std::optional<BvhHit> first;
      for (std::uint32_t k = 0; k < world.boxes.size(); ++k) {
        const std::optional<double> t = entry_of(ray, world.boxes[k]);
        if (t && (!first || *t < first->t)) first = {*t, {k, 7 * k}};
      }
      for (const std::int64_t target : test::simd_targets()) {
        const test::ForcedTarget forced(target);
        ASSERT_EQ(first_along(tree, ray), first) << bvh_kernels<N, T>().target;
      }
      hits += first ? 1 : 0;
    }
  }
  EXPECT_GT(hits, 100U);
}

/// Walks of a tree find the same boxes in the same order with every instruction set.
TYPED_TEST(BvhKernelsTest, WalksDoNotDependOnTheInstructionSet) {
  using T = typename TypeParam::scalar;
  constexpr Dim N = TypeParam::dimension;
  for (const auto& world : test::box_worlds<N, T>(700, 13)) {
    SCOPED_TRACE(world.name);
    std::vector<std::vector<std::uint32_t>> found;
    std::vector<std::vector<double>> ranks;
    for (const std::int64_t target : test::simd_targets()) {
      const test::ForcedTarget forced(target);
      BvhTree<N, T> tree(0);
      for (std::uint32_t k = 0; k < world.boxes.size(); ++k) tree.insert(k, world.boxes[k], 7 * k);
      std::vector<std::uint32_t>& slots = found.emplace_back();
      std::vector<double>& numbers = ranks.emplace_back();
      for (std::uint32_t k = 0; k < world.boxes.size(); k += 50) {
        const Aabb<N, T>& box = world.boxes[k];
        visit_met(tree, RegionProbe<Aabb<N, T>>(box), [&slots](const BvhName& name) {
          EXPECT_EQ(name.generation, 7 * name.slot);
          slots.push_back(name.slot);
          return true;
        });
        if (!is_valid(box)) continue;
        for (const std::size_t wanted : {1U, 8U, 20U}) {
          NearestKeys nearest(wanted);
          find_near(tree, box.min, nearest);
          for (const Neighbour& neighbour : nearest.sorted()) {
            EXPECT_EQ(neighbour.key.generation, 7 * neighbour.key.index);
            slots.push_back(neighbour.key.index);
            numbers.push_back(neighbour.distance_squared);
          }
        }
        Ray<N, T> ray{box.min, Vec<N, T>(T(1))};
        ray.direction[0] = T(2);
        const std::optional<BvhHit> first = first_along(tree, ray);
        ASSERT_TRUE(first.has_value());
        EXPECT_EQ(first->name.generation, 7 * first->name.slot);
        slots.push_back(first->name.slot);
        numbers.push_back(first->t);
      }
    }
    for (std::size_t k = 1; k < found.size(); ++k) {
      EXPECT_EQ(found[k], found[0]);
      EXPECT_EQ(ranks[k], ranks[0]);
    }
  }
}

}  // namespace
}  // namespace graze::detail::bvh_kernels_test
