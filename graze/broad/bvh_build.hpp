// SPDX-License-Identifier: MIT
// The nodes of a Bvh, and how they are built from boxes at once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include <graze/broad/executor.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// What hangs in a place of a node: another node, a leaf, or nothing.
class BvhChild {
 public:
  BvhChild() = default;
  static BvhChild node(std::uint32_t index) { return BvhChild(index); }
  static BvhChild leaf(std::uint32_t slot) { return BvhChild(slot | leaf_bit); }

  bool is_none() const { return code_ == none; }
  bool is_leaf() const { return (code_ & leaf_bit) != 0; }   ///< Of a child that is not none.
  std::uint32_t index() const { return code_ & ~leaf_bit; }  ///< Of the node, or the slot of the leaf.

  friend bool operator==(const BvhChild&, const BvhChild&) = default;

 private:
  explicit BvhChild(std::uint32_t code) : code_(code) {}

  static constexpr std::uint32_t leaf_bit = std::uint32_t{1} << 31U;
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t code_ = none;
};

/// Places 2 k and 2 k + 1 are those of node k. In 3D with floats a node is a cache line, and holds all that a query
/// asks before it goes on below.
template <Dim N, class T>
struct alignas(N == 3 && sizeof(T) == 4 ? 64 : alignof(T)) BvhNode {
  std::array<Aabb<N, T>, 2> boxes;  ///< Each contains all that hangs in the place.
  std::array<BvhChild, 2> children;
  std::uint32_t place = 0;  ///< Where the node hangs itself.
  std::uint32_t count = 0;  ///< Of the leaves below.
};

/// How many boxes a Bvh takes in: so that the number of a place fits 32 bits, and that of a leaf 31.
inline constexpr std::uint32_t bvh_most = (std::uint32_t{1} << 31U) - 1;

/// The rule that keeps a Bvh low: of more than 12 leaves no child holds more than 4/5. A tree of n leaves has then no
/// more than log(n) / log(5/4) = 3.11 log2(n) levels of nodes: a tree of up to 12 cannot have more, and a larger one
/// has at most one level more than its larger child. It is the weight balance of Nievergelt and Reingold (1973, "Binary
/// search trees of bounded balance"), held up by building anew what breaks it, as Andersson does (1989, "Improving
/// partial rebuilding by using simple balance criteria").
inline constexpr bool is_out_of_balance(std::uint64_t part, std::uint64_t whole) {
  return whole > 12 && 5 * part > 4 * whole;
}

/// The height of the tallest Bvh: floor(31 log(2) / log(5/4)).
inline constexpr std::size_t bvh_height_limit = 96;

/// The second children of a path down, and the one that comes next: what a walk that goes down first keeps in mind.
inline constexpr std::size_t bvh_path = bvh_height_limit + 1;

/// A leaf before it has its place.
template <Dim N, class T>
struct BvhLeaf {
  Aabb<N, T> box;
  std::uint32_t slot;
};

/// Builds trees into arrays that others own.
template <Dim N, class T>
class BvhBuilder {
 public:
  /// `nodes` by index, of which `indices` may be written; `places` by slot.
  BvhBuilder(BvhNode<N, T>* nodes, std::span<const std::uint32_t> indices, std::uint32_t* places,
             const Executor& executor)
      : nodes_(nodes), indices_(indices), places_(places), executor_(executor) {}

  /// Hangs a tree of these leaves in a place. With n leaves it needs n - 1 nodes, and takes them as a walk meets them
  /// that goes down first. Of more than 12 leaves no child gets more than 2/3, so that a third of them must come or go
  /// before the rule of balance breaks. The boxes are finite. The tree depends on the set of leaves alone, neither on
  /// their order nor on the executor. Changes the order of the leaves. Throws what the executor does.
  void build(std::span<BvhLeaf<N, T>> leaves, std::uint32_t place) { build_from(leaves, place, 0); }

 private:
  void build_from(std::span<BvhLeaf<N, T>> leaves, std::uint32_t place, std::size_t first_index);

  BvhNode<N, T>* nodes_;
  std::span<const std::uint32_t> indices_;
  std::uint32_t* places_;
  const Executor& executor_;
};

extern template class BvhBuilder<2, float>;
extern template class BvhBuilder<3, float>;
extern template class BvhBuilder<2, double>;
extern template class BvhBuilder<3, double>;

}  // namespace graze::detail
