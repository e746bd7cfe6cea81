// SPDX-License-Identifier: MIT
// Small sets of boxes on a coarse lattice, where everything touches everything, shrunk to the fewest when they fail.
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/brute_force_pairs.hpp>
#include <graze/broad/pairs.hpp>

#include "thread_executor.hpp"

namespace graze::pair_laws_test {
namespace {

/// min_x, extent_x, min_y, ...: extents may be negative, which is an empty box.
template <Dim N, class T>
std::vector<Aabb<N, T>> boxes_of(const std::vector<std::vector<int>>& numbers) {
  std::vector<Aabb<N, T>> boxes;
  for (const auto& row : numbers) {
    Aabb<N, T> box;
    for (Dim i = 0; i < N; ++i) {
      box.min[i] = static_cast<T>(row[static_cast<std::size_t>(2 * i)]);
      box.max[i] = box.min[i] + static_cast<T>(row[static_cast<std::size_t>(2 * i + 1)]);
    }
    boxes.push_back(box);
  }
  return boxes;
}

template <Dim N>
rc::Gen<std::vector<std::vector<int>>> lattice_boxes(int side) {
  const auto number = rc::gen::weightedOneOf<int>(
      {{8, rc::gen::inRange(0, side)}, {1, rc::gen::inRange(-1, 3)}, {1, rc::gen::inRange(0, 1000)}});
  return rc::gen::scale(
      12.0, rc::gen::container<std::vector<std::vector<int>>>(rc::gen::container<std::vector<int>>(2 * N, number)));
}

template <Dim N, class T>
void expect_lawful(int side) {
  const auto boxes = boxes_of<N, T>(*lattice_boxes<N>(side));
  const std::span<const Aabb<N, T>> all = boxes;
  const PairOptions by_tree{.method = PairMethod::tree};
  const std::vector<Pair> expected = brute_force_pairs(all);
  RC_ASSERT(overlapping_pairs(boxes, by_tree) == expected);
  const test::ThreadExecutor three(3);
  std::vector<Pair> as_found =
      overlapping_pairs(boxes, {.executor = &three, .order = PairOrder::any, .method = PairMethod::tree});
  std::sort(as_found.begin(), as_found.end());
  RC_ASSERT(as_found == expected);
  const std::size_t cut = all.size() / 3;
  RC_ASSERT(overlapping_pairs(all.first(cut), all.subspan(cut), by_tree) ==
            brute_force_pairs(all.first(cut), all.subspan(cut)));
}

RC_GTEST_PROP(PairLaws, InThePlaneInFloat, ()) { expect_lawful<2, float>(*rc::gen::inRange(2, 60)); }
RC_GTEST_PROP(PairLaws, InThePlaneInDouble, ()) { expect_lawful<2, double>(*rc::gen::inRange(2, 60)); }
RC_GTEST_PROP(PairLaws, InSpaceInFloat, ()) { expect_lawful<3, float>(*rc::gen::inRange(2, 20)); }
RC_GTEST_PROP(PairLaws, InSpaceInDouble, ()) { expect_lawful<3, double>(*rc::gen::inRange(2, 20)); }

}  // namespace
}  // namespace graze::pair_laws_test
