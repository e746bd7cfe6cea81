// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>

#include <rapidcheck.h>

#include <graze/broad/index/box_cover.hpp>
#include <graze/broad/orthtree/tree.hpp>

namespace graze::test {

/// Every box is in one cell, inside its bounds and those of all ancestors, and the cell grown to twice its size
/// contains it.
template <Dim N, class T>
void expect_sound(const detail::CellTree<N, T>& tree, const std::map<std::uint32_t, Aabb<N, T>>& expected) {
  using Tree = detail::CellTree<N, T>;
  std::map<std::uint32_t, Aabb<N, T>> found;
  const auto visit = [&](std::uint32_t index, const auto& self) -> void {
    const detail::Cell<N, T>& cell = tree.cell(index);
    tree.pool().for_each(cell.entries, [&](const detail::Entry<N, T>& entry) {
      RC_ASSERT(found.emplace(entry.slot, entry.box).second);
      RC_ASSERT(tree.box(entry.slot) == entry.box);
      if (index == Tree::outside) return;
      RC_ASSERT(detail::covers(cell.bounds, entry.box));
      RC_ASSERT(detail::fits(tree.place(index), entry.box));
    });
    if (cell.first_child == detail::no_index) return;
    RC_ASSERT(tree.depth(index) < tree.options().max_depth);
    for (std::uint32_t k = 0; k < Tree::children; ++k) {
      const std::uint32_t child = cell.first_child + k;
      RC_ASSERT(tree.place(child).parent == index);
      RC_ASSERT(tree.place(child).half == tree.place(index).half / 2);
      RC_ASSERT(tree.depth(child) == tree.depth(index) + 1);
      RC_ASSERT(is_nothing(tree.cell(child).bounds) || detail::covers(cell.bounds, tree.cell(child).bounds));
      self(child, self);
    }
  };
  visit(Tree::outside, visit);
  if (tree.has_root()) visit(Tree::root, visit);
  RC_ASSERT(found == expected);
}

}  // namespace graze::test
