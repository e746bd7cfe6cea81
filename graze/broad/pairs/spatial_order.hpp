// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/pairs/box_set.hpp>
#include <graze/broad/pairs/cell_grid.hpp>
#include <graze/broad/simd/block.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// A range of the order with boxes near each other.
struct SpatialRun {
  std::size_t first = 0;
  std::size_t count = 0;  // at most longest_run
  bool finite = true;
};

/// The maximum length of a run: a cluster of this many boxes is gathered once and sorted in the cache. Also limited to
/// a third of all boxes, so that several threads have work.
inline constexpr std::size_t longest_run = (std::size_t{1} << 16U) - block_size;

/// A coarse spatial order of boxes, divided into runs of one or two thousand that are near each other. It is a counting
/// sort by the cells of a grid over all centers; an overfull cell is a longer run or divided again, so that clustered
/// scenes cost little more than uniform ones. Boxes much larger than most would spread out the runs of small ones; they
/// have runs of their own, by powers of four of their size, with infinite boxes last. Empty boxes are omitted.
template <Dim N, class T>
class SpatialOrder {
 public:
  /// Sorts boxes, in memory that is kept. Throws std::invalid_argument, naming the index of the first box that has a
  /// NaN, and its set.
  void sort(std::span<const Aabb<N, T>> boxes, const Executor& executor, BoxSet set = BoxSet::only);

  std::span<const SpatialRun> runs() const { return runs_; }

  /// Indices of boxes, run by run.
  const std::uint32_t* order() const { return order_.data(); }

  /// Memory that is free until the next sort, for callers that no longer need the order; writing to it destroys the
  /// order.
  std::array<std::span<std::byte>, 3> idle_memory() {
    return {std::as_writable_bytes(std::span(order_.data(), order_.capacity())),
            std::as_writable_bytes(std::span(cells_.data(), cells_.capacity())),
            std::as_writable_bytes(std::span(spare_.data(), spare_.capacity()))};
  }

  /// The memory held, including temporary memory of the last sort, in bytes.
  std::size_t bytes() const;

 private:
  struct Buckets;

  void survey(std::span<const Aabb<N, T>> boxes);
  T usual_size(std::span<const Aabb<N, T>> boxes) const;
  std::size_t find_cells(std::span<const Aabb<N, T>> boxes, const Buckets& buckets, const Executor& executor);
  void scatter(std::span<const Aabb<N, T>> boxes, const Buckets& buckets, const Executor& executor);
  void divide_clusters(std::span<const Aabb<N, T>> boxes, const Buckets& buckets, const Executor& executor);

  std::size_t run_limit() const;
  void cut_runs(const Buckets& buckets);
  void add_runs(std::size_t first, std::size_t count, bool finite);

  Aabb<N, T> centers_;
  std::vector<SpatialRun> runs_;
  std::size_t box_count_ = 0;
  Buffer<std::uint16_t> cells_;
  Buffer<std::uint32_t> order_;
  Buffer<std::uint32_t> spare_;
  std::vector<std::uint32_t> counts_;  // of every cell in every chunk, then where its next box goes
  std::vector<std::size_t> ends_;      // of every cell in the order
  std::size_t passing_bytes_ = 0;
};

}  // namespace graze::detail
