// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include <graze/broad/brute_force_pairs.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/pairs/box_set.hpp>
#include <graze/broad/pairs/dense_search.hpp>

namespace graze::detail {
namespace {

std::size_t blocks_of(std::size_t boxes) { return (boxes + block_size - 1) / block_size; }

/// Stores boxes in blocks in their original order, each grown by a margin; NaN if a box is empty.
template <Dim N, class T>
void fill(std::span<const Aabb<N, T>> boxes, T margin, BoxSet set, Buffer<Block<N, T>>& blocks) {
  blocks.require(blocks_of(boxes.size()));
  constexpr T nan = std::numeric_limits<T>::quiet_NaN();
  for (std::size_t k = 0; k < blocks_of(boxes.size()) * block_size; ++k) {
    Block<N, T>& block = blocks[k / block_size];
    const bool is_box = k < boxes.size() && !is_nothing(boxes[k]);
    if (k < boxes.size() && has_nan(boxes[k])) refuse_nan(k, set);
    for (Dim i = 0; i < N; ++i) {
      block.min[i][k % block_size] = is_box ? boxes[k].min[i] - margin : nan;
      block.max[i][k % block_size] = is_box ? boxes[k].max[i] + margin : nan;
    }
  }
}

}  // namespace

template <Dim N, class T>
void DenseSearch<N, T>::take(Boxes boxes_a, const Boxes* boxes_b, T margin) {
  itself_ = boxes_b == nullptr;
  rows_ = boxes_a.size();
  columns_ = itself_ ? rows_ : boxes_b->size();
  fill(boxes_a, margin, itself_ ? BoxSet::only : BoxSet::first, blocks_a_);
  if (!itself_) fill(*boxes_b, margin, BoxSet::second, blocks_b_);
}

template <Dim N, class T>
std::size_t DenseSearch<N, T>::count(Rows rows) const {
  const Buffer<Block<N, T>>& others = itself_ ? blocks_a_ : blocks_b_;
  return overlap_kernels<N, T>().count_rows(blocks_a_.data(), others.data(), blocks_of(columns_), itself_, rows);
}

template <Dim N, class T>
void DenseSearch<N, T>::meet(Rows rows, std::span<Pair> out) const {
  const Buffer<Block<N, T>>& others = itself_ ? blocks_a_ : blocks_b_;
  overlap_kernels<N, T>().meet_rows(blocks_a_.data(), others.data(), blocks_of(columns_), itself_, rows, out);
}

/// Runs all comparisons twice: to count, and to write pairs to their final positions. If there are many pairs, this is
/// faster than writing them twice.
template <Dim N, class T>
std::span<const Pair> DenseSearch<N, T>::find(Boxes boxes_a, const Boxes* boxes_b, const PairOptions& options,
                                              PairSink& room) {
  take(boxes_a, boxes_b, static_cast<T>(options.margin));
  const Executor& executor = executor_of(options);
  constexpr std::size_t comparisons_per_task = std::size_t{1} << 20U;
  constexpr std::size_t most_tasks = 64;
  const std::size_t tasks = std::clamp<std::size_t>(rows_ * columns_ / comparisons_per_task, 1, most_tasks);
  const auto rows_of = [&](std::size_t task) {
    return Rows{static_cast<std::uint32_t>(task * rows_ / tasks),
                static_cast<std::uint32_t>((task + 1) * rows_ / tasks)};
  };
  std::vector<std::size_t> ends(tasks);
  executor.parallel_for(tasks, [&](std::size_t task) { ends[task] = count(rows_of(task)); });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  const std::span<Pair> pairs(room.all(ends.back()), ends.back());
  executor.parallel_for(tasks, [&](std::size_t task) {
    const std::size_t begin = task == 0 ? 0 : ends[task - 1];
    meet(rows_of(task), pairs.subspan(begin, ends[task] - begin));
  });
  return pairs;
}

/// Processes waves of a few rows per task, so that only the pairs of one wave are held.
template <Dim N, class T>
void DenseSearch<N, T>::visit(Boxes boxes_a, const Boxes* boxes_b, const PairOptions& options,
                              const PairVisitor& visitor) {
  take(boxes_a, boxes_b, static_cast<T>(options.margin));
  constexpr std::size_t pairs_per_task = std::size_t{1} << 14U;
  const std::size_t step = std::max<std::size_t>(1, pairs_per_task / (columns_ + 1));
  std::array<std::vector<Pair>, 16> found;  // by task
  for (std::size_t wave = 0; wave < rows_; wave += step * found.size()) {
    executor_of(options).parallel_for(found.size(), [&](std::size_t task) {
      const std::size_t first = std::min(rows_, wave + task * step);
      const Rows rows{static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(std::min(rows_, first + step))};
      found[task].resize(count(rows));
      meet(rows, found[task]);
    });
    for (const std::vector<Pair>& pairs : found) {
      if (!pairs.empty() && !visitor(pairs)) return;
    }
  }
}

template class DenseSearch<2, float>;
template class DenseSearch<3, float>;
template class DenseSearch<2, double>;
template class DenseSearch<3, double>;

}  // namespace graze::detail
