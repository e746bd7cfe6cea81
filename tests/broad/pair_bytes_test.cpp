// SPDX-License-Identifier: MIT
// The memory that finding all pairs takes in addition to the boxes and the list.
#include <cstddef>
#include <functional>
#include <span>

#include <gtest/gtest.h>

#include <graze/broad/pairs.hpp>
#include <graze/broad/scene_generators.hpp>

#include "soak.hpp"
#include "thread_executor.hpp"

namespace graze::pair_bytes_test {
namespace {

constexpr PairOrder both_orders[] = {PairOrder::sorted, PairOrder::any};

/// Bytes per box of a finder after a call.
template <Dim N, class T>
double bytes_per_box(std::span<const Aabb<N, T>> boxes, const Executor& executor, PairOrder order) {
  PairFinder<N, T> finder;
  finder.find(boxes, {.executor = &executor, .order = order});
  return static_cast<double>(finder.bytes()) / static_cast<double>(boxes.size());
}

/// A million, or fewer if tests are to be short.
std::size_t many_boxes() { return test::soak_operations() < 20'000 ? 200'000 : 1'000'000; }

/// With fewer boxes, the memory that does not depend on their number has a larger share.
template <class T>
void expect_at_most(double most, World world, const Executor& executor) {
  const MovingBoxes<3, T> boxes(world, many_boxes(), 1);
  if (boxes.boxes().size() < 1'000'000) most *= 1.5;
  for (const PairOrder order : both_orders) {
    EXPECT_LE((bytes_per_box<3, T>(boxes.boxes(), executor, order)), most)
        << name_of(world) << (order == PairOrder::any ? ", any order" : "");
  }
}

TEST(PairBytes, AreAtMost80ForEachOfAMillionBoxes) {
  for (const World world : {World::brownian, World::heavy, World::line, World::cluster, World::giants}) {
    expect_at_most<float>(80, world, serial_executor());
    expect_at_most<double>(80, world, serial_executor());
  }
}

/// With thirteen pairs per box: they are stored in the output until they are sorted.
TEST(PairBytes, AreAtMost80OfALatticeToo) {
  expect_at_most<float>(80, World::lattice, serial_executor());
  expect_at_most<double>(80, World::lattice, serial_executor());
  expect_at_most<float>(80, World::lattice, test::ThreadExecutor(2));
}

TEST(PairBytes, AreNotManyMoreWithManyThreads) {
  const test::ThreadExecutor sixteen(16);
  expect_at_most<float>(80, World::brownian, sixteen);
}

/// As if the second of two threads were late: runs half of the tasks in order, then the others.
class LateExecutor final : public Executor {
 public:
  void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task) const override {
    for (std::size_t i = 0; i < count / 2; ++i) task(i);
    for (std::size_t i = count; i > count / 2; --i) task(i - 1);
  }
  std::size_t concurrency() const override { return 2; }
};

/// The pairs exist twice then: in the lists of the tasks, and in one list.
TEST(PairBytes, AreNotManyMoreWhereASecondThreadComesLate) {
  expect_at_most<float>(75, World::cluster, LateExecutor());
}

TEST(PairBytes, StayFromFrameToFrame) {
  MovingBoxes<3, float> boxes(World::brownian, 50'000, 1);
  for (const PairOrder order : both_orders) {
    PairFinder<3, float> finder;
    const PairOptions options{.executor = &serial_executor(), .order = order};
    for (int frame = 0; frame < 3; ++frame) finder.find(boxes.boxes(), options);  // two buffers are swapped
    const std::size_t bytes = finder.bytes();
    for (int frame = 0; frame < 3; ++frame) finder.find(boxes.boxes(), options);
    EXPECT_EQ(finder.bytes(), bytes);
  }
}

/// Unsorted and on one thread, pairs stay where they were found.
TEST(PairBytes, AreWithoutThePairsThemselves) {
  const MovingBoxes<3, float> boxes(World::point, 3'000, 1);
  constexpr std::size_t pairs = 4'498'500;
  for (const PairMethod method : {PairMethod::tree, PairMethod::dense, PairMethod::brute_force}) {
    PairFinder<3, float> finder;
    const PairOptions options{.executor = &serial_executor(), .order = PairOrder::any, .method = method};
    EXPECT_EQ(finder.find(boxes.boxes(), options).size(), pairs);
    EXPECT_LE(finder.bytes(), pairs * sizeof(Pair) * 3 / 4) << name_of(method) << ": half of the list may be unused";
    const std::size_t bytes = finder.bytes();
    finder.visit(
        boxes.boxes(), [](std::span<const Pair>) { return false; }, options);
    EXPECT_GE(finder.bytes(), bytes + pairs * sizeof(Pair)) << "its list is unused memory now";
  }
}

}  // namespace
}  // namespace graze::pair_bytes_test
