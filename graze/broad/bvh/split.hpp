// SPDX-License-Identifier: MIT
// How the entries of an overfull node of a Bvh are distributed to two nodes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <graze/broad/bvh/node.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// An entry outside of a node.
template <Dim N, class T>
struct BvhEntry {
  Aabb<N, T> box;
  std::uint32_t entry;
  std::uint32_t generation = 0;
};

template <Dim N, class T>
BvhEntry<N, T> entry_in(const BvhNode<N, T>& node, std::uint32_t lane) {
  return {box_in(node.boxes, lane), node.entries[lane], node.generations[lane]};
}

template <Dim N, class T>
void put_entry(BvhNode<N, T>& node, std::uint32_t lane, const BvhEntry<N, T>& entry) {
  put_box(node.boxes, lane, entry.box);
  node.entries[lane] = entry.entry;
  node.generations[lane] = entry.generation;
}

/// The entries of two nodes, or of one node and one more entry.
template <Dim N, class T>
struct BvhEntries {
  std::array<BvhEntry<N, T>, std::size_t{2} * block_size> all;
  std::uint32_t count = 0;

  void add(const BvhEntry<N, T>& entry) { all[count++] = entry; }
  void add(const BvhNode<N, T>& node, std::uint32_t entries) {
    for (std::uint32_t lane = 0; lane < entries; ++lane) add(entry_in(node, lane));
  }
};

/// Sorts more than sixteen entries and returns how many go to the first node. Among all cuts of the entries sorted
/// along an axis that leave bvh_least to sixteen on either side, it minimises the sum of the extents of both bounds,
/// weighted by the number of entries (after Beckmann, Kriegel, Schneider and Seeger 1990, "The R*-tree"). Depends only
/// on the set of entries.
template <Dim N, class T>
std::uint32_t split_entries(BvhEntries<N, T>& entries);

}  // namespace graze::detail
