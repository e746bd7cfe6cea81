// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/broad/pairs/overlap_kernels.hpp>
#include <graze/broad/pairs/pair_sink.hpp>
#include <graze/broad/simd/block.hpp>

namespace graze::detail {

/// The method `dense`: every box against every other, a block at a time. Quadratic, but without other costs: there is
/// no tree to build, and pairs are found in ascending order. The fastest method for hundreds of boxes, and for any
/// number if most of them overlap.
template <Dim N, class T>
class DenseSearch {
 public:
  using Boxes = std::span<const Aabb<N, T>>;

  /// The pairs within one set if `boxes_b` is null, otherwise between two; ascending, written to `room`. Throws
  /// std::invalid_argument, naming the index of the first box that has a NaN.
  std::span<const Pair> find(Boxes boxes_a, const Boxes* boxes_b, const PairOptions& options, PairSink& room);

  /// Passes the same pairs to a visitor, holding only those of a few rows.
  void visit(Boxes boxes_a, const Boxes* boxes_b, const PairOptions& options, const PairVisitor& visitor);

  /// The memory held, in bytes.
  std::size_t bytes() const { return blocks_a_.bytes() + blocks_b_.bytes(); }

 private:
  void take(Boxes boxes_a, const Boxes* boxes_b, T margin);
  std::size_t count(Rows rows) const;
  void meet(Rows rows, std::span<Pair> out) const;

  std::size_t rows_ = 0;     // boxes of the first set
  std::size_t columns_ = 0;  // of the second
  bool itself_ = true;
  Buffer<Block<N, T>> blocks_a_;
  Buffer<Block<N, T>> blocks_b_;
};

}  // namespace graze::detail
