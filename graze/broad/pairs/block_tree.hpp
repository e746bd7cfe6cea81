// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/pairs/block_spread.hpp>
#include <graze/broad/pairs/box_set.hpp>
#include <graze/broad/pairs/spatial_order.hpp>
#include <graze/broad/simd/block.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// Boxes sorted so that spatial neighbours share a block of sixteen, these blocks again in blocks of sixteen, and so on
/// up to a single one. It is built for each set of boxes, or refitted to boxes that have moved, in memory that is kept.
template <Dim N, class T>
class BlockTree {
 public:
  BlockTree();
  ~BlockTree();

  /// Builds the tree of all non-empty boxes, each grown by `margin`. Throws std::invalid_argument, naming the index of
  /// the first box that has a NaN, and its set.
  void build(std::span<const Aabb<N, T>> boxes, T margin, const Executor& executor, BoxSet set = BoxSet::only);

  /// Updates to as many boxes in the same order without sorting: fast, and good while they have moved little. Returns
  /// false, with unusable content, if that is not possible: boxes were added or removed, have moved so far that sorting
  /// pays, have a NaN or are empty.
  bool refit(std::span<const Aabb<N, T>> boxes, T margin, const Executor& executor);

  /// Adds levels of a single block on top up to a height of `wanted`.
  void raise(std::size_t wanted);

  /// The number of levels: at least two, or none if all boxes are empty.
  std::size_t height() const { return level_first_.size() - 1; }

  /// The blocks of a level: level 0 holds the boxes, level k + 1 the bounds of the blocks of level k.
  const Block<N, T>* level(std::size_t k) const { return blocks_.data() + level_first_[k]; }
  std::size_t level_size(std::size_t k) const { return level_first_[k + 1] - level_first_[k]; }

  /// The boxes of level 0, as indices into the sequence that the tree was built from.
  const std::uint32_t* ids() const { return ids_.data(); }

  /// Memory that is used only while the tree is built.
  auto idle_memory() { return order_.idle_memory(); }

  /// The memory held, in bytes.
  std::size_t bytes() const;

 private:
  class Scratch;
  class ScratchPool;

  void lay_out();
  void fill_run(std::span<const Aabb<N, T>> boxes, T margin, const SpatialRun& run, std::size_t first_block,
                Scratch& scratch);
  void close(std::size_t level, const Executor& executor);
  void remember_spread();
  bool has_drifted(std::span<const Aabb<N, T>> boxes, T margin) const;

  SpatialOrder<N, T> order_;
  Buffer<Block<N, T>> blocks_;  // level after level
  std::vector<std::size_t> level_first_ = {0};
  Buffer<std::uint32_t> ids_;
  std::unique_ptr<ScratchPool> scratches_;

  // The quality of the order when it was created, and its loss since then.
  std::size_t box_count_ = 0;  // of the last build, if all of its boxes are in the tree
  std::size_t built_height_ = 0;
  bool knows_spread_ = false;
  BlockSpread<N, T> spread_;
  std::uint64_t spread_when_built_ = 0;
  std::uint64_t sample_when_built_ = 0;
  std::uint64_t lost_ = 0;
};

}  // namespace graze::detail
