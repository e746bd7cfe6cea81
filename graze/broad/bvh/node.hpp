// SPDX-License-Identifier: MIT
// The nodes and links of a Bvh.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <graze/broad/simd/block.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// A link to a node: its number, and whether it is a leaf node, so that a walk knows before reading the node.
class BvhLink {
 public:
  BvhLink() = default;
  static BvhLink inner(std::uint32_t index) { return BvhLink(2 * index); }
  static BvhLink leaf(std::uint32_t index) { return BvhLink(2 * index + 1); }
  static BvhLink of_code(std::uint32_t code) { return BvhLink(code); }

  bool is_none() const { return code_ == no_box; }
  bool is_leaf() const { return (code_ & 1U) != 0; }  ///< Only for a link to a node.
  std::uint32_t index() const { return code_ >> 1U; }
  std::uint32_t code() const { return code_; }

  friend bool operator==(const BvhLink&, const BvhLink&) = default;

 private:
  explicit BvhLink(std::uint32_t code) : code_(code) {}

  std::uint32_t code_ = no_box;
};

/// Identifies a box of a tree: its slot and the generation at insertion, so that a search has the key without another
/// lookup.
struct BvhName {
  std::uint32_t slot;
  std::uint32_t generation;

  friend bool operator==(const BvhName&, const BvhName&) = default;
};

/// Up to sixteen entries in the first lanes: codes of links in an inner node; slots and generations in a leaf node. The
/// boxes of unused lanes are NaN.
template <Dim N, class T>
struct BvhNode {
  Block<N, T> boxes;
  alignas(64) std::uint32_t entries[block_size];
  std::uint32_t generations[block_size];  // unused in an inner node

  BvhName name(std::uint32_t lane) const { return {entries[lane], generations[lane]}; }
};

/// The minimum number of entries of a node other than the root. A full node and one more entry are split into nodes
/// with at least this many (Bayer and McCreight 1972, "Organization and maintenance of large ordered indexes").
inline constexpr std::uint32_t bvh_least = 6;

/// The maximum number of boxes in a Bvh; with it, the code of a link fits 32 bits.
inline constexpr std::uint32_t bvh_most = (std::uint32_t{1} << 31U) - 1;

/// The height of the tallest Bvh, whose root has two entries and all other nodes six: 2 * 6^11 < 2^31 < 2 * 6^12.
inline constexpr std::size_t bvh_height_limit = 12;

/// The maximum stack of a depth-first walk: fifteen siblings for each level on its path and sixteen new nodes, plus a
/// whole vector for stores.
inline constexpr std::size_t bvh_path = (bvh_height_limit + 2) * block_size;

template <Dim N, class T>
Aabb<N, T> box_in(const Block<N, T>& block, std::uint32_t lane) {
  Aabb<N, T> box;
  for (Dim i = 0; i < N; ++i) {
    box.min[i] = block.min[i][lane];
    box.max[i] = block.max[i][lane];
  }
  return box;
}

template <Dim N, class T>
void put_box(Block<N, T>& block, std::uint32_t lane, const Aabb<N, T>& box) {
  for (Dim i = 0; i < N; ++i) {
    block.min[i][lane] = box.min[i];
    block.max[i][lane] = box.max[i];
  }
}

/// A box grown by a margin, clamped to finite numbers.
template <Dim N, class T>
Aabb<N, T> grown_by(const Aabb<N, T>& box, double margin) {
  constexpr auto most = static_cast<double>(std::numeric_limits<T>::max());
  if (margin == 0) return box;
  Aabb<N, T> grown;
  for (Dim i = 0; i < N; ++i) {
    grown.min[i] = static_cast<T>(std::max(static_cast<double>(box.min[i]) - margin, -most));
    grown.max[i] = static_cast<T>(std::min(static_cast<double>(box.max[i]) + margin, most));
  }
  return grown;
}

/// The box of a lane without an entry.
template <Dim N, class T>
Aabb<N, T> no_box_in() {
  constexpr T nan = std::numeric_limits<T>::quiet_NaN();
  return {Vec<N, T>(nan), Vec<N, T>(nan)};
}

/// Clears a lane.
template <Dim N, class T>
void clear_lane(BvhNode<N, T>& node, std::uint32_t lane) {
  put_box(node.boxes, lane, no_box_in<N, T>());
  node.entries[lane] = no_box;
  node.generations[lane] = 0;
}

/// Clears all lanes from `first` on.
template <Dim N, class T>
void clear_lanes(BvhNode<N, T>& node, std::uint32_t first) {
  for (std::uint32_t lane = first; lane < block_size; ++lane) clear_lane(node, lane);
}

}  // namespace graze::detail
