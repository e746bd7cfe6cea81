// SPDX-License-Identifier: MIT
// visit_parts(compound, may_matter, order, visit): the parts that may decide a query, by the compound's tree if it has
// one. Both ways give the same answers, bit for bit, if the query keeps two rules: a box is refused only if no part in
// it can change the answer, and of two parts that are equally good, the first in the compound wins, not the first
// visited.
#pragma once

#include <cstddef>
#include <cstdint>

#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::detail {

/// Which of the parts visited so far decides: the one with the least value, of several the first in the compound.
class FirstPart {
 public:
  /// Whether a part decides, which is then remembered.
  bool is_replaced_by(double value, std::size_t index) {
    const bool is_better = is_none_ || value < value_ || (value == value_ && index < index_);
    if (!is_better) return false;
    is_none_ = false;
    value_ = value;
    index_ = index;
    return true;
  }

  bool is_none() const { return is_none_; }
  std::size_t index() const { return index_; }

 private:
  bool is_none_ = true;
  double value_ = 0;
  std::size_t index_ = 0;
};

/// For `visit_parts`: whether a part may touch what has a box, grown as by touching_bounds.
template <Dim N, class T>
struct MayTouch {
  bool operator()(const Aabb<N, T>& grown) const { return boxes_overlap(grown, box); }
  bool operator()(const Part<N, T>& part) const { return may_part_touch(part, box); }

  Aabb<N, T> box;
};

/// A `may_matter` may have another form for the boxes inside one, may_matter.inside(box), that takes less time. Out of
/// line, so that small compounds are as fast as without trees.
template <Dim N, class T, class MayMatter, class Order, class Visit>
[[gnu::noinline]] void visit_parts_by_tree(const PartTree<N, T>& tree, const Compound<N, T>& compound,
                                           const MayMatter& may_matter, const Order& order, const Visit& visit) {
  for (const std::uint32_t index : tree.unbounded()) {
    const Part<N, T>& part = compound.parts[index];
    if (may_matter(part) && !visit(part, std::size_t{index})) return;
  }
  const auto visit_at = [&](std::uint32_t index) { return visit(compound.parts[index], std::size_t{index}); };
  if constexpr (requires { may_matter.inside(tree.around()); }) {
    tree.visit(may_matter.inside(tree.around()), order, visit_at);
  } else {
    tree.visit(may_matter, order, visit_at);
  }
}

/// Calls visit(part, index) until it returns false, for the parts that may matter: without a tree, those of which
/// may_matter(part) is true, in order; with a tree, those of which may_matter(box) is true for the part's box, grown as
/// by touching_bounds, and for the boxes around that, in the order of `PartTree::visit`.
template <Dim N, class T, class MayMatter, class Order, class Visit>
[[gnu::always_inline]] inline void visit_parts(const Compound<N, T>& compound, const MayMatter& may_matter,
                                               const Order& order, const Visit& visit) {
  if (const PartTree<N, T>* const tree = tree_of(compound.parts)) {
    return visit_parts_by_tree(*tree, compound, may_matter, order, visit);
  }
  for (std::size_t i = 0; i < compound.parts.size(); ++i) {
    const Part<N, T>& part = compound.parts[i];
    if (may_matter(part) && !visit(part, i)) return;
  }
}

/// The same, in any order.
template <Dim N, class T, class MayMatter, class Visit>
[[gnu::always_inline]] inline void visit_parts(const Compound<N, T>& compound, const MayMatter& may_matter,
                                               const Visit& visit) {
  visit_parts(compound, may_matter, InAnyOrder(), visit);
}

}  // namespace graze::detail
