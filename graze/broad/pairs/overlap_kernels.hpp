// SPDX-License-Identifier: MIT
// Inner loops of finding the overlaps between two block trees, compiled for each instruction set as in
// block_kernels.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <graze/broad/pair.hpp>
#include <graze/broad/simd/block.hpp>
#include <graze/broad/simd/space_kernels.hpp>
#include <graze/math/vec.hpp>

namespace graze::detail {

/// The boxes in [first, last).
struct Rows {
  std::uint32_t first;
  std::uint32_t last;
};

/// Blocks of boxes, their ids, and the bounds of the blocks.
template <Dim N, class T>
struct BlockLevel {
  const Block<N, T>* blocks;
  const std::uint32_t* ids;
  const Block<N, T>* above;
};

template <Dim N, class T>
struct OverlapKernels {
  /// The pairs of child blocks to compare, for `count` pairs of blocks whose lanes are bounds of blocks. `a` and `b`
  /// hold these blocks; `above` the bounds of those of b, or is null. `out` needs space for 256 per pair. Returns their
  /// number.
  std::size_t (*descend)(const Block<N, T>* a, const Block<N, T>* b, const Block<N, T>* above, bool itself,
                         const BlockPair* pairs, std::size_t count, BlockPair* out);

  /// The overlapping boxes of `count` pairs of blocks of boxes. `out` needs space for 256 per pair. Returns their
  /// number. `itself`: both are the same tree, and pairs have a < b.
  std::size_t (*meet)(BlockLevel<N, T> a, BlockLevel<N, T> b, bool itself, const BlockPair* pairs, std::size_t count,
                      Pair* out);

  /// The number of overlaps of the rows of a with boxes of b; if `itself`, with later boxes only. Boxes are in their
  /// original order.
  std::size_t (*count_rows)(const Block<N, T>* a, const Block<N, T>* b, std::size_t blocks_of_b, bool itself,
                            Rows rows);

  /// Writes these pairs, ascending, to `out`, which has space for exactly as many.
  void (*meet_rows)(const Block<N, T>* a, const Block<N, T>* b, std::size_t blocks_of_b, bool itself, Rows rows,
                    std::span<Pair> out);
};

/// The kernels of one instruction set.
using AllOverlapKernels = SpaceKernels<OverlapKernels>;

/// The kernels for this machine. Instantiated for 2D and 3D, float and double.
template <Dim N, class T>
const OverlapKernels<N, T>& overlap_kernels();

}  // namespace graze::detail
