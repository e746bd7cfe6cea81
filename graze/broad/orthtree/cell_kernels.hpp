// SPDX-License-Identifier: MIT
// Inner loops of an Orthtree, compiled for each instruction set and chosen at run time. All give the same answers in
// the same order, because every lane is calculated alike.
#pragma once

#include <cstddef>
#include <cstdint>

#include <graze/broad/orthtree/code.hpp>
#include <graze/broad/orthtree/entry_pool.hpp>
#include <graze/broad/orthtree/group.hpp>
#include <graze/broad/simd/space_kernels.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// The state of a walk to all boxes that share a point with a region. It can be interrupted when enough was found.
/// Groups of cells wait on a stack, blocks of entries in a queue. Members are uninitialised, because the arrays are
/// large; start() initialises them.
template <Dim N, class T>
struct CellMetWalk {
  static constexpr std::size_t depth_limit = 32;
  static constexpr std::size_t most_found = 240;
  static constexpr std::size_t most_blocks = 96;  // no more groups are opened from here on
  static constexpr std::size_t slack = 16;        // for storing a whole vector
  Aabb<N, T> region;
  std::uint32_t next;  // the group to visit first; 0 if there is none
  bool has_way;        // whether `next` is below the root, so that `way` gives the path to the region's center
  CellWay<N> way;
  std::size_t open_count;
  std::size_t block_count;
  std::size_t found_count;
  std::size_t groups_seen;  // statistics
  std::size_t blocks_seen;
  std::uint32_t open[1 + (depth_limit + 1) * cells_per_group<N> + slack];  // group numbers; the first is 0
  std::uint32_t blocks[most_blocks + cells_per_group<N> + slack];
  std::uint32_t found[most_found + entries_per_block + slack];  // slots

  /// Starts with nothing to visit.
  void start(const Aabb<N, T>& asked) {
    region = asked;
    next = open[0] = 0;
    has_way = false;
    open_count = block_count = found_count = groups_seen = blocks_seen = 0;
  }

  /// Adds the boxes of a cell, or those below it. Only for one or two cells, at the start.
  void add_entries(const EntryList& list) {
    if (list.count > 0) blocks[block_count++] = list.head;
  }
  void add_group(std::uint32_t group) {
    if (next != 0) open[++open_count] = next;
    next = group;
  }

  /// Descends to the center of the region first. Call it after the group below the root was added, with none after it.
  void follow(const CellWay<N>& from_root) {
    has_way = true;
    way = from_root;
  }

  bool is_over() const { return next == 0 && block_count == 0; }
};

template <Dim N, class T>
struct CellKernels {
  /// The name of the instruction set.
  const char* target;

  /// Continues a walk until it is finished or there is no space for the boxes of another block.
  void (*find_overlapping)(const CellGroup<N, T>* groups, const EntryPage<N, T>* pages, CellMetWalk<N, T>& walk);

  /// The codes of the centers of boxes, as by code_of, with the boxes' indices.
  void (*code)(const Aabb<N, T>* boxes, std::size_t count, const CodeScale<N, T>& scale, CodedBox* coded);

  /// The bounds of all boxes if all are finite and not empty; otherwise an empty box.
  Aabb<N, T> (*bounds)(const Aabb<N, T>* boxes, std::size_t count);
};

/// The kernels of one instruction set.
using AllCellKernels = SpaceKernels<CellKernels>;

/// The instruction sets that kernels are compiled for, in Highway's bits.
std::int64_t cell_kernel_targets();

/// The kernels for this machine. Instantiated for 2D and 3D, float and double.
template <Dim N, class T>
GRAZE_EXPORT const CellKernels<N, T>& cell_kernels();

}  // namespace graze::detail
