// SPDX-License-Identifier: MIT
// What a finder of pairs does when memory runs out.
#include <algorithm>
#include <cstddef>
#include <new>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/brute_force_pairs.hpp>
#include <graze/broad/pairs.hpp>

#include "box_worlds.hpp"
#include "heap_watch.hpp"

namespace graze::pair_memory_test {
namespace {

/// Whether a call succeeds if memory runs out after this many requests.
bool has_enough(std::size_t grants, const auto& call) {
  test::heap_watch.grants_left = grants;
  bool enough = true;
  try {
    call();
  } catch (const std::bad_alloc&) {
    enough = false;
  }
  test::heap_watch.grants_left = test::HeapWatch::no_end;
  return enough;
}

/// Wherever it fails: data from a failed call must not lead to wrong answers.
TEST(PairMemory, ThatRanOutLeavesNothingToFindWrongPairsWith) {
  const std::vector<Aabb<3, float>> all = test::box_worlds<3, float>(900, 46).front().boxes;
  const std::span<const Aabb<3, float>> boxes = all;
  const std::span<const Aabb<3, float>> some = boxes.first(300);
  const std::span<const Aabb<3, float>> others = boxes.subspan(300);
  const std::vector<Pair> of_one = brute_force_pairs(boxes);
  const std::vector<Pair> of_two = brute_force_pairs(some, others);
  for (const PairOrder order : {PairOrder::sorted, PairOrder::any}) {
    const PairOptions options{.executor = &serial_executor(), .order = order, .method = PairMethod::tree};
    const auto expect = [&](std::span<const Pair> pairs, const std::vector<Pair>& expected, std::size_t grants) {
      std::vector<Pair> found(pairs.begin(), pairs.end());
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, expected) << grants << " grants";
    };
    std::size_t grants = 0;
    for (bool enough = false; !enough; ++grants) {
      PairFinder<3, float> one;
      PairFinder<3, float> two;
      PairFinder<3, float> moved;
      moved.find(boxes, options);
      enough = has_enough(grants, [&] { one.find(boxes, options); });
      enough = has_enough(grants, [&] { two.find(some, others, options); }) && enough;
      enough = has_enough(grants, [&] { moved.find(boxes, options); }) && enough;
      expect(one.find(boxes, options), of_one, grants);
      expect(two.find(some, others, options), of_two, grants);
      expect(moved.find(boxes, options), of_one, grants);
    }
    EXPECT_GT(grants, 10U);
  }
}

}  // namespace
}  // namespace graze::pair_memory_test
