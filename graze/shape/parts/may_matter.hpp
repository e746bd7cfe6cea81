// SPDX-License-Identifier: MIT
// What decides for a BoxTree which boxes a query visits, one by one or sixteen at once, and in which order.
#pragma once

#include <graze/math/lanes/sixteen.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/parts/box_block.hpp>

namespace graze::detail {

/// For `BoxTree::visit`: boxes in any order.
struct InAnyOrder {};

/// For `BoxTree::visit`: boxes by may_matter.key(box), the least first; NaN for a box that does not matter. If
/// may_matter accepts less by now, may_matter.admits(key) tells whether a box still matters.
struct ByKey {};

/// What decides about a block at once: may_matter.lanes(block) returns the lanes that may matter. It may accept a few
/// more boxes than may_matter(box).
template <class MayMatter, Dim N, class T>
concept TestsLanes = requires(const MayMatter& may_matter, const BoxBlock<N, T>& block) {
  may_matter.lanes(block);
};

/// The same with keys, which may be a little less than may_matter.key(box).
template <class MayMatter, Dim N, class T>
concept FindsKeysOfLanes = requires(const MayMatter& may_matter, const BoxBlock<N, T>& block, Row<T>& keys) {
  may_matter.lanes(block, keys);
};

/// What decides about sixteen parts themselves, which the tree keeps in its leaves, without their boxes.
template <class MayMatter, class Contents>
concept TestsContents = requires(const MayMatter& may_matter, const Contents& contents) {
  may_matter.lanes(contents);
};

/// The same with keys.
template <class MayMatter, class Contents, class T>
concept FindsKeysOfContents = requires(const MayMatter& may_matter, const Contents& contents, Row<T>& keys) {
  may_matter.lanes(contents, keys);
};

/// Lanes of two blocks.
struct PairOfLanes {
  LaneMask first = first_lanes(row_length);
  LaneMask second = first_lanes(row_length);
};

}  // namespace graze::detail
