// SPDX-License-Identifier: MIT
// What a Bvh is made of.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <graze/broad/simd/block.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// The name of a node where it hangs: its number, and whether it is a leaf node, so that a walk knows before it looks.
class BvhLink {
 public:
  BvhLink() = default;
  static BvhLink inner(std::uint32_t index) { return BvhLink(2 * index); }
  static BvhLink leaf(std::uint32_t index) { return BvhLink(2 * index + 1); }
  static BvhLink of_code(std::uint32_t code) { return BvhLink(code); }

  bool is_none() const { return code_ == no_box; }
  bool is_leaf() const { return (code_ & 1U) != 0; }  ///< Of a link that is not none.
  std::uint32_t index() const { return code_ >> 1U; }
  std::uint32_t code() const { return code_; }

  friend bool operator==(const BvhLink&, const BvhLink&) = default;

 private:
  explicit BvhLink(std::uint32_t code) : code_(code) {}

  std::uint32_t code_ = no_box;
};

/// Who a box of a tree is: its slot, and the generation with which it came there, so that who finds the box knows its
/// key without a look elsewhere.
struct BvhName {
  std::uint32_t slot;
  std::uint32_t generation;

  friend bool operator==(const BvhName&, const BvhName&) = default;
};

/// Up to sixteen entries side by side: the first lanes, with the codes of links where the node is an inner one, slots
/// and their generations where it is a leaf node. Lanes behind them are NaN.
template <Dim N, class T>
struct BvhNode {
  Block<N, T> boxes;
  alignas(64) std::uint32_t entries[block_size];
  std::uint32_t generations[block_size];  // of no meaning in an inner node

  BvhName name(std::uint32_t lane) const { return {entries[lane], generations[lane]}; }
};

/// How many entries a node has at least, but for the root, which may have fewer: so many, and as many again and one
/// more, are what a full node is split into (Bayer and McCreight 1972, "Organization and maintenance of large ordered
/// indexes").
inline constexpr std::uint32_t bvh_least = 6;

/// How many boxes a Bvh takes in: so that the code of a link fits 32 bits.
inline constexpr std::uint32_t bvh_most = (std::uint32_t{1} << 31U) - 1;

/// The height of the tallest Bvh, whose root has two entries and all others six: 2 * 6^11 < 2^31 < 2 * 6^12.
inline constexpr std::size_t bvh_height_limit = 12;

/// What a walk that goes down first keeps in mind at most: of each level on its path fifteen others, and sixteen new.
/// Room for a whole vector more.
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

/// A box and a margin around it, as far as there are finite numbers.
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

/// What a lane without an entry has for a box.
template <Dim N, class T>
Aabb<N, T> no_box_in() {
  constexpr T nan = std::numeric_limits<T>::quiet_NaN();
  return {Vec<N, T>(nan), Vec<N, T>(nan)};
}

/// Leaves a lane without an entry.
template <Dim N, class T>
void clear_lane(BvhNode<N, T>& node, std::uint32_t lane) {
  put_box(node.boxes, lane, no_box_in<N, T>());
  node.entries[lane] = no_box;
  node.generations[lane] = 0;
}

/// All lanes from the first on.
template <Dim N, class T>
void clear_lanes(BvhNode<N, T>& node, std::uint32_t first) {
  for (std::uint32_t lane = first; lane < block_size; ++lane) clear_lane(node, lane);
}

}  // namespace graze::detail
