// SPDX-License-Identifier: MIT
// Inner loops of building a block tree, compiled for each instruction set and chosen at run time. All give the same
// answers, because every lane is calculated alike.
#pragma once

#include <cstddef>
#include <cstdint>

#include <graze/broad/pairs/cell_grid.hpp>
#include <graze/broad/simd/block.hpp>
#include <graze/broad/simd/space_kernels.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

template <Dim N, class T>
struct BlockKernels {
  /// The name of the instruction set.
  const char* target;

  /// The bounds of the centers of the boxes that are finite and not empty.
  Aabb<N, T> (*survey)(const Aabb<N, T>* boxes, std::size_t count);

  /// The cell of every box's center, or the nearest cell to it. Boxes that are larger than `largest` on some axis,
  /// infinite or empty, or have a NaN, get `unusual`.
  void (*cells)(const Aabb<N, T>* boxes, std::size_t count, const CellGrid<N, T>& grid, T largest,
                std::uint16_t unusual, std::uint16_t* cell);

  /// The bounds of the centers of finite boxes.
  Aabb<N, T> (*center_bounds)(const Aabb<N, T>* boxes, std::size_t count);

  /// The cell of every center, or the nearest cell to it, for finite boxes of any size.
  void (*center_cells)(const Aabb<N, T>* boxes, std::size_t count, const CellGrid<N, T>& grid, std::uint16_t* cell);

  /// Fills blocks with the boxes at order[0], order[1], ..., each grown by `margin`, and pads the last block with NaN.
  void (*fill)(const Aabb<N, T>* boxes, const std::uint16_t* order, std::size_t count, T margin, Block<N, T>* blocks);

  /// Refills `count` blocks with the boxes that `ids` names, each grown by `margin`. Returns false if one has a NaN or
  /// is empty.
  bool (*refill)(const Aabb<N, T>* boxes, T margin, const std::uint32_t* ids, std::size_t count, Block<N, T>* blocks);

  /// Stores the bounds of each block in its lane of the level above; unused lanes become NaN.
  void (*close)(const Block<N, T>* blocks, std::size_t count, Block<N, T>* above);
};

/// The kernels of one instruction set.
using AllBlockKernels = SpaceKernels<BlockKernels>;

/// The instruction sets that kernels are compiled for, in Highway's bits.
std::int64_t block_kernel_targets();

/// The kernels for this machine. Instantiated for 2D and 3D, float and double.
template <Dim N, class T>
const BlockKernels<N, T>& block_kernels();

}  // namespace graze::detail
