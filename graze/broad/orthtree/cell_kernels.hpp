// SPDX-License-Identifier: MIT
// The inner loops of an Orthtree, once for every set of vector instructions that the compiler knows. Which one runs is
// chosen at run time, and makes no difference to any answer, nor to its order: nothing here rounds differently from
// lane to lane.
#pragma once

#include <cstddef>
#include <cstdint>

#include <graze/broad/orthtree/code.hpp>
#include <graze/broad/orthtree/entry_pool.hpp>
#include <graze/broad/orthtree/group.hpp>
#include <graze/broad/simd/space_kernels.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// A walk to all boxes that share a point with a region, which can be interrupted when much was found. Groups of cells
/// wait on a stack, blocks of entries in a row. Without initial values, so that room for many costs nothing: start()
/// gives them.
template <Dim N, class T>
struct CellMetWalk {
  static constexpr std::size_t depth_limit = 32;
  static constexpr std::size_t most_found = 240;
  static constexpr std::size_t most_blocks = 96;  // when no more groups are opened
  static constexpr std::size_t slack = 16;        // for a vector that is written whole
  Aabb<N, T> region;
  std::uint32_t next;  // the group that is looked at first; 0 when there is none
  bool has_way;        // whether that one is below the root, from where the way to the region's middle is known
  CellWay<N> way;
  std::size_t open_count;
  std::size_t block_count;
  std::size_t found_count;
  std::size_t groups_seen;  // so far, for whoever wants to know
  std::size_t blocks_seen;
  std::uint32_t open[1 + (depth_limit + 1) * cells_per_group<N> + slack];  // groups, by number, the first 0
  std::uint32_t blocks[most_blocks + cells_per_group<N> + slack];
  std::uint32_t found[most_found + entries_per_block + slack];  // slots

  /// Begins anew, with nothing to look at.
  void start(const Aabb<N, T>& asked) {
    region = asked;
    next = open[0] = 0;
    has_way = false;
    open_count = block_count = found_count = groups_seen = blocks_seen = 0;
  }

  /// Adds the boxes of a cell, those below it, or both to what is looked at. For a cell or two, at the beginning.
  void add_entries(const EntryList& list) {
    if (list.count > 0) blocks[block_count++] = list.head;
  }
  void add_group(std::uint32_t group) {
    if (next != 0) open[++open_count] = next;
    next = group;
  }

  /// Goes down to where the middle of the region is first, and then aside. Once the group below the root has been
  /// added, and none after it.
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

  /// Goes on with a walk until it is over or there is no room for what another block may hold.
  void (*find_met)(const CellGroup<N, T>* groups, const EntryPage<N, T>* pages, CellMetWalk<N, T>& walk);

  /// The codes of the centers of boxes, which code_of gives, and their places in the row.
  void (*code)(const Aabb<N, T>* boxes, std::size_t count, const CodeScale<N, T>& scale, CodedBox* coded);

  /// The box around all, if all are finite and contain something; nothing otherwise.
  Aabb<N, T> (*bounds)(const Aabb<N, T>* boxes, std::size_t count);
};

/// The kernels of one instruction set.
using AllCellKernels = SpaceKernels<CellKernels>;

/// The instruction sets that kernels are compiled for, in Highway's bits.
std::int64_t cell_kernel_targets();

/// The kernels for this machine. Instantiated for 2D and 3D, float and double.
template <Dim N, class T>
const CellKernels<N, T>& cell_kernels();

}  // namespace graze::detail
