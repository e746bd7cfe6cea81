// SPDX-License-Identifier: MIT
// The tree over the parts of a compound.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/math/lanes/sixteen.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/parts/box_block.hpp>
#include <graze/shape/parts/box_tree.hpp>
#include <graze/shape/parts/pieces.hpp>

namespace graze::detail {

/// The boxes of parts, as the lowest level of a tree.
template <Dim N, class T>
class BoxLeaves {
 public:
  template <class Executor>
  void set(const Executor& /*executor*/, std::span<const std::uint32_t> parts, std::span<const Aabb<N, T>> boxes) {
    blocks_.assign((parts.size() + row_length - 1) / row_length, BoxBlock<N, T>::nothing());
    for (std::size_t i = 0; i < parts.size(); ++i) blocks_[i / row_length].set(i % row_length, boxes[parts[i]]);
  }

  Aabb<N, T> box(std::size_t place) const { return blocks_[place / row_length].box(place % row_length); }
  const BoxBlock<N, T>& block(std::size_t index, const BoxBlock<N, T>& /*buffer*/) const { return blocks_[index]; }
  const BoxBlock<N, T>& contents(std::size_t index) const { return blocks_[index]; }

 private:
  std::vector<BoxBlock<N, T>> blocks_;
};

/// A BoxTree of the boxes of a compound's parts, large enough that a part which its box does not let a query reach
/// cannot matter to that query.
template <Dim N, class T>
class PartTree : public BoxTree<N, T, BoxLeaves<N, T>> {
 public:
  /// `whole` is the box around the whole compound; has_usual_lengths: whether none of its lengths needs scaling.
  PartTree(std::span<const Aabb<N, T>> boxes, const Aabb<N, T>& whole, bool has_usual_lengths)
      : BoxTree<N, T, BoxLeaves<N, T>>(OneByOne(), boxes, boxes),
        bounds_(whole),
        has_usual_lengths_(has_usual_lengths) {}

  /// The box around all parts.
  const Aabb<N, T>& bounds() const { return bounds_; }
  /// Whether no length of a part needs scaling; see query/scaling/range.hpp.
  bool has_usual_lengths() const { return has_usual_lengths_; }

 private:
  Aabb<N, T> bounds_;
  bool has_usual_lengths_;
};

}  // namespace graze::detail
