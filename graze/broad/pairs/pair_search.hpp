// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/memory/pool.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/broad/pairs/block_tree.hpp>
#include <graze/broad/pairs/pair_sink.hpp>
#include <graze/broad/pairs/pair_sort.hpp>

namespace graze::detail {

/// The method `tree`: two block trees, or one and itself, are traversed together down to pairs of blocks above the
/// boxes; these are distributed to tasks, each of which finds its pairs.
template <Dim N, class T>
class PairSearch {
 public:
  using Boxes = std::span<const Aabb<N, T>>;

  PairSearch();
  ~PairSearch();

  /// The pairs within one set if `boxes_b` is null, otherwise between two. They are written to `room` or to memory of
  /// this object, where they are valid until the next call.
  std::span<const Pair> find(Boxes boxes_a, const Boxes* boxes_b, const PairOptions& options, PairSink& room);

  /// Passes the same pairs to a visitor, in the order in which they are found, holding only those of a few blocks.
  void visit(Boxes boxes_a, const Boxes* boxes_b, const PairOptions& options, const PairVisitor& visitor);

  std::size_t bytes() const;

 private:
  void build(Boxes boxes_a, const Boxes* boxes_b, T margin, const Executor& executor);
  void descend();
  const Block<N, T>* above_of(std::size_t level) const;
  struct Found;
  template <class Finds>
  void meet(std::span<const BlockPair> parents, Buffer<BlockPair>& list, Finds& found) const;
  std::size_t task_count() const;
  PairForecast forecast() const;
  std::span<const BlockPair> meetings_of(std::size_t task, std::size_t tasks) const;
  void find_lists(std::size_t tasks, const Executor& executor);
  std::span<const Pair> find_sorted(const PairLimits& limits, const Executor& executor, PairSink& room);
  std::span<const Pair> find_in_turns(PairSink& room);
  std::span<const Pair> find_any(const PairLimits& limits, const Executor& executor, PairSink& room);
  std::span<const Pair> find_in_lists(const Executor& executor, PairSink& room);
  std::span<const Pair> find_ahead(std::size_t expected, const Executor& executor, PairSink& room);

  BlockTree<N, T> tree_a_;
  BlockTree<N, T> tree_b_;
  const BlockTree<N, T>* other_ = nullptr;  // the tree that tree_a_ is compared with
  Buffer<BlockPair> meetings_;              // pairs of blocks above the boxes
  Buffer<BlockPair> spare_meetings_;
  std::size_t meeting_count_ = 0;
  std::vector<std::unique_ptr<Found>> found_;  // by task
  Pool<Found> workers_;                        // for finding what is sorted at once
  PairSort sort_;
  std::size_t last_count_ = 0;  // of the last unordered search by several threads, if large
  PairLimits last_limits_{};
};

}  // namespace graze::detail
