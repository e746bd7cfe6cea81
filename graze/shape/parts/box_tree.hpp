// SPDX-License-Identifier: MIT
// A static tree over boxes of parts or faces, which can be fitted to other boxes.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <graze/math/lanes/sixteen.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/parts/box_block.hpp>
#include <graze/shape/parts/box_visit.hpp>
#include <graze/shape/parts/may_matter.hpp>
#include <graze/shape/parts/pieces.hpp>
#include <graze/shape/parts/spatial_order.hpp>

namespace graze::detail {

/// A tree of sixteen children per node without pointers. Level 0 holds the boxes of the parts, sorted so that
/// neighbours in space are neighbours in the list; each box of the level above is around the next sixteen. The boxes of
/// one node lie side by side in a block. Boxes that are infinite, or so large that sums of them might be, are not in
/// the tree.
///
/// `Leaves` keeps level 0: set(executor, parts, inputs...) puts it into the order of `parts`, box(place) returns one
/// box, block(index, buffer) sixteen of them, perhaps in the buffer; what is beyond the last adds nothing to
/// block.around(). contents(index) is what TestsContents and FindsKeysOfContents get.
template <Dim N, class T, class Leaves>
class BoxTree {
 public:
  /// A tree of boxes, which it does not keep: those of the leaves are in these. The same for every executor.
  template <class Executor, class... Inputs>
  BoxTree(const Executor& executor, std::span<const Aabb<N, T>> boxes, const Inputs&... inputs) {
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      (is_moderate(boxes[i]) ? parts_ : unbounded_).push_back(i);
    }
    put_in_spatial_order<width>(boxes, std::span<std::uint32_t>(parts_), executor);
    set_leaves(executor, inputs...);
    size_when_built_ = size_of_boxes();
  }

  /// The tree of the same parts, in the same order, with other boxes; see is_moderate.
  template <class... Inputs>
  BoxTree refitted(const Inputs&... inputs) const {
    BoxTree result;
    result.parts_ = parts_;
    result.unbounded_ = unbounded_;
    result.size_when_built_ = size_when_built_;
    result.set_leaves(OneByOne(), inputs...);
    return result;
  }

  /// Whether the boxes, relative to the whole, have grown so much since they were sorted that a new tree is faster.
  bool is_outgrown() const {
    constexpr double most_growth = 1.5;
    return !(size_of_boxes() <= most_growth * size_when_built_);
  }

  const Leaves& leaves() const { return leaves_; }

  /// Whether all boxes in the tree are still far from the limits of numbers.
  bool is_moderate() const { return parts_.empty() || is_moderate(around_); }

  /// The box around the boxes in the tree.
  const Aabb<N, T>& around() const { return around_; }

  /// The part at a place of level 0.
  std::uint32_t part_at(std::size_t place) const { return parts_[place]; }

  /// The parts that are not in the tree, in order.
  std::span<const std::uint32_t> unbounded() const { return unbounded_; }

  /// Calls visit(index of a part, its place), or visit(index, place, key) if it takes the key of FindsKeysOfContents,
  /// until it returns false: for each part in the tree whose box, and every box around it, may_matter(box) accepts;
  /// perhaps for a few more, see TestsLanes. The order is InAnyOrder or ByKey, the box with the least key in a node
  /// first. `may_matter` may accept less from call to call.
  template <class MayMatter, class Order, class Visit>
  void visit(const MayMatter& may_matter, Order /*order*/, const Visit& visit) const {
    if (parts_.empty() || !may_matter(around_)) return;
    BoxVisit<BoxTree, MayMatter, Order>(*this, may_matter).run(root(), visit);
  }

  /// Calls visit(part of this tree, part of the other) until it returns false: for each pair whose boxes, and every two
  /// boxes around them, overlap where `place` and `place_other` put the boxes. Returns whether all were visited.
  template <class PlaceBoxes, class PlaceOthers, class Visit>
  bool visit_pairs(const BoxTree& other, const PlaceBoxes& place, const PlaceOthers& place_others,
                   const Visit& visit) const {
    if (!visit_unbounded_pairs<false>(other, visit)) return false;
    if (parts_.empty() || other.parts_.empty()) return true;
    return visit_pairs_below<false>(root(), other, other.root(), place, place_others, visit);
  }

  /// Calls visit(place of a part in this tree, place in the other) for each pair in the trees whose boxes, and every
  /// two boxes around them, may be near: may_be_near.lanes(block, box, squared) tells which boxes of a block, and
  /// writes squared distances, up to which may_be_near.admits(squared) is asked again. Of boxes, the near ones come
  /// first. may_be_near.lanes(contents, contents), if it exists, tells which parts of two blocks may be near.
  template <class PlaceBoxes, class PlaceOthers, class MayBeNear, class Visit>
  void visit_nearest_pairs(const BoxTree& other, const PlaceBoxes& place, const PlaceOthers& place_others,
                           const MayBeNear& may_be_near, const Visit& visit) const {
    if (parts_.empty() || other.parts_.empty()) return;
    visit_nearest_pairs_below(root(), other, other.root(), place, place_others, may_be_near, visit);
  }

  /// Calls visit(part of this tree, part of the other) until it returns false, for the pairs that are not in the trees:
  /// one of them has no finite box. Returns whether all were visited.
  template <class Visit>
  bool visit_unbounded_pairs(const BoxTree& other, const Visit& visit) const {
    return visit_unbounded_pairs<false>(other, visit);
  }

  /// As visit_pairs, for pairs of two different parts of this tree, each once and in any order.
  template <class PlaceBoxes, class Visit>
  bool visit_own_pairs(const PlaceBoxes& place, const Visit& visit) const {
    if (!visit_unbounded_pairs<true>(*this, visit)) return false;
    return parts_.empty() || visit_pairs_below<true>(root(), *this, root(), place, place, visit);
  }

 private:
  BoxTree() = default;

  static constexpr std::uint32_t width = row_length;
  using Place = PlaceInTree;
  template <class Tree, class MayMatter, class Order>
  friend class BoxVisit;

  Place root() const { return {0, static_cast<std::uint32_t>(height_)}; }

  /// The boxes of a node's children, perhaps in the buffer.
  const BoxBlock<N, T>& block_of(const Place& node, BoxBlock<N, T>& buffer) const {
    if (node.level == 1) return leaves_.block(node.index, buffer);
    return blocks_[first_block_of_level_[node.level - 1] + node.index];
  }
  std::size_t count_of_children(const Place& node) const {
    return std::min<std::size_t>(width, size_of_level_[node.level - 1] - std::size_t{node.index} * width);
  }
  Aabb<N, T> box_at(const Place& place) const {
    if (place.level == height_) return around_;
    if (place.level == 0) return leaves_.box(place.index);
    return blocks_[first_block_of_level_[place.level] + place.index / width].box(place.index % width);
  }

  static bool is_moderate(const Aabb<N, T>& box) {
    constexpr T most = std::numeric_limits<T>::max() / 16;
    return is_finite(box.min) && is_finite(box.max) && max_abs(box.min) < most && max_abs(box.max) < most;
  }

  static double size_of(const Aabb<N, T>& box) {
    return sum_abs(wide<N, T>(box.max) * 0.5 - wide<N, T>(box.min) * 0.5);
  }
  /// The mean size of the boxes around sixteen others, relative to the whole: how much a query that meets a place
  /// visits.
  double size_of_boxes() const {
    const double all = size_of(around_);
    double sum = 0;
    double count = 0;
    for (std::uint32_t level = 1; level < height_; ++level) {
      for (std::uint32_t i = 0; i < size_of_level_[level]; ++i) sum += size_of(box_at({i, level}));
      count += static_cast<double>(size_of_level_[level]);
    }
    return count > 0 && all > 0 ? sum / all / count : 0;
  }

  template <bool is_self, class Visit>
  bool visit_unbounded_pairs(const BoxTree& other, const Visit& visit) const {
    for (std::size_t i = 0; i < unbounded_.size(); ++i) {
      for (std::size_t j = is_self ? i + 1 : 0; j < other.unbounded_.size(); ++j) {
        if (!visit(unbounded_[i], other.unbounded_[j])) return false;
      }
      for (const std::uint32_t part : other.parts_) {
        if (!visit(unbounded_[i], part)) return false;
      }
    }
    if (is_self) return true;
    for (const std::uint32_t unbounded : other.unbounded_) {
      for (const std::uint32_t part : parts_) {
        if (!visit(part, unbounded)) return false;
      }
    }
    return true;
  }

  /// Descends in the tree that is higher at its place, or in both, so that boxes of about one size meet.
  template <bool is_self, class PlaceBoxes, class PlaceOthers, class Visit>
  // NOLINTNEXTLINE(readability-function-size): a node, what places boxes, for each tree
  bool visit_pairs_below(const Place& node, const BoxTree& other, const Place& other_node, const PlaceBoxes& place,
                         const PlaceOthers& place_others, const Visit& visit) const {
    if (node.level == 0 && other_node.level == 0) return visit(parts_[node.index], other.parts_[other_node.index]);
    if (node.level < other_node.level) {
      const Aabb<N, T> box = place(box_at(node));
      return for_each_lane(other.overlapping_children(other_node, box, place_others), [&](std::uint32_t lane) {
        return visit_pairs_below<is_self>(node, other, child_of(other_node, lane), place, place_others, visit);
      });
    }
    if (node.level > other_node.level) {
      const Aabb<N, T> box = place_others(other.box_at(other_node));
      return for_each_lane(overlapping_children(node, box, place), [&](std::uint32_t lane) {
        return visit_pairs_below<is_self>(child_of(node, lane), other, other_node, place, place_others, visit);
      });
    }
    const bool is_same = is_self && node == other_node;
    BoxBlock<N, T> moved;
    BoxBlock<N, T> moved_other;
    BoxBlock<N, T> buffer;
    BoxBlock<N, T> other_buffer;
    const BoxBlock<N, T>& block = place(block_of(node, buffer), moved);
    const BoxBlock<N, T>& other_block = place_others(other.block_of(other_node, other_buffer), moved_other);
    const LaneMask of_other = first_lanes(other.count_of_children(other_node));
    for (std::uint32_t i = 0; i < count_of_children(node); ++i) {
      LaneMask lanes = lanes_that_overlap(other_block, block.box(i)) & of_other;
      if (is_same) lanes &= ~first_lanes(node.level == 1 ? i + 1 : i);
      const bool goes_on = for_each_lane(lanes, [&](std::uint32_t lane) {
        return visit_pairs_below<is_self>(child_of(node, i), other, child_of(other_node, lane), place, place_others,
                                          visit);
      });
      if (!goes_on) return false;
    }
    return true;
  }

  template <class PlaceBoxes>
  LaneMask overlapping_children(const Place& node, const Aabb<N, T>& box, const PlaceBoxes& place) const {
    BoxBlock<N, T> buffer;
    BoxBlock<N, T> moved;
    return lanes_that_overlap(place(block_of(node, buffer), moved), box) & first_lanes(count_of_children(node));
  }

  /// The boxes of a node's children at its place.
  template <class PlaceBoxes>
  struct PlacedChildren {
    PlacedChildren(const BoxTree& tree, const Place& node, const PlaceBoxes& place)
        : count(tree.count_of_children(node)), boxes(place(tree.block_of(node, buffer), moved)) {}

    std::size_t count;
    BoxBlock<N, T> buffer;
    BoxBlock<N, T> moved;
    const BoxBlock<N, T>& boxes;
  };

  /// Of the parts in two nodes of level 1, those that may be near to one of the others.
  template <class MayBeNear>
  PairOfLanes lanes_near(const Place& node, const BoxTree& other, const Place& other_node,
                         const MayBeNear& may_be_near) const {
    if constexpr (requires { may_be_near.lanes(leaves_.contents(0), leaves_.contents(0)); }) {
      return may_be_near.lanes(leaves_.contents(node.index), other.leaves_.contents(other_node.index));
    } else {
      return {};
    }
  }

  /// Calls visit(lane) for those of some children that may be near a box, in the order of their distances; before each,
  /// asks again whether it may.
  template <class PlaceBoxes, class MayBeNear, class Visit>
  static void visit_near_children(const PlacedChildren<PlaceBoxes>& children, LaneMask of_these, const Aabb<N, T>& box,
                                  const MayBeNear& may_be_near, const Visit& visit) {
    alignas(64) Row<T> squared;
    std::array<std::uint32_t, width> order;
    std::ptrdiff_t count = 0;
    for_each_lane(may_be_near.lanes(children.boxes, box, squared) & of_these, [&](std::uint32_t lane) {
      order[static_cast<std::size_t>(count++)] = lane;
      return true;
    });
    std::sort(order.begin(), order.begin() + count,
              [&squared](std::uint32_t a, std::uint32_t b) { return squared[a] < squared[b]; });
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      const std::uint32_t lane = order[static_cast<std::size_t>(i)];
      if (may_be_near.admits(squared[lane])) visit(lane);
    }
  }

  template <class PlaceBoxes, class PlaceOthers, class MayBeNear, class Visit>
  // NOLINTNEXTLINE(readability-function-size): as above
  void visit_nearest_pairs_below(const Place& node, const BoxTree& other, const Place& other_node,
                                 const PlaceBoxes& place, const PlaceOthers& place_others, const MayBeNear& may_be_near,
                                 const Visit& visit) const {
    if (node.level == 1 && other_node.level == 1) {
      const PairOfLanes parts = lanes_near(node, other, other_node, may_be_near);
      if (parts.first == 0) return;
      const PlacedChildren<PlaceBoxes> children(*this, node, place);
      const PlacedChildren<PlaceOthers> others(other, other_node, place_others);
      visit_near_children(
          others, parts.second & first_lanes(others.count), place(box_at(node)), may_be_near,
          [&](std::uint32_t other_lane) {
            Row<T> squared;
            const LaneMask near = may_be_near.lanes(children.boxes, others.boxes.box(other_lane), squared);
            for_each_lane(near & parts.first & first_lanes(children.count), [&](std::uint32_t lane) {
              visit(std::size_t{child_of(node, lane).index}, std::size_t{child_of(other_node, other_lane).index});
              return true;
            });
          });
    } else if (node.level >= other_node.level) {
      const PlacedChildren<PlaceBoxes> children(*this, node, place);
      visit_near_children(children, first_lanes(children.count), place_others(other.box_at(other_node)), may_be_near,
                          [&](std::uint32_t lane) {
                            visit_nearest_pairs_below(child_of(node, lane), other, other_node, place, place_others,
                                                      may_be_near, visit);
                          });
    } else {
      const PlacedChildren<PlaceOthers> others(other, other_node, place_others);
      visit_near_children(others, first_lanes(others.count), place(box_at(node)), may_be_near, [&](std::uint32_t lane) {
        visit_nearest_pairs_below(node, other, child_of(other_node, lane), place, place_others, may_be_near, visit);
      });
    }
  }

  static Place child_of(const Place& node, std::uint32_t lane) { return {node.index * width + lane, node.level - 1}; }

  template <class Executor, class... Inputs>
  void set_leaves(const Executor& executor, const Inputs&... inputs) {
    leaves_.set(executor, std::span<const std::uint32_t>(parts_), inputs...);
    set_levels();
  }

  /// From the leaves up to the node that holds all.
  void set_levels() {
    blocks_.clear();
    height_ = 0;
    around_ = Aabb<N, T>::nothing();
    if (parts_.empty()) return;
    add_level(parts_.size());
    BoxBlock<N, T> buffer;
    while (size_of_level_[height_ - 1] > width) {
      const std::size_t below = size_of_level_[height_ - 1];
      const auto level = static_cast<std::uint32_t>(height_);
      add_level((below + width - 1) / width);
      blocks_.resize(first_block_of_level_[level] + (size_of_level_[level] + width - 1) / width,
                     BoxBlock<N, T>::nothing());
      for (std::uint32_t i = 0; i < size_of_level_[level]; ++i) {
        blocks_[first_block_of_level_[level] + i / width].set(i % width, block_of({i, level}, buffer).around());
      }
    }
    around_ = block_of(root(), buffer).around();
  }

  void add_level(std::size_t count) {
    first_block_of_level_[height_] = blocks_.size();
    size_of_level_[height_] = count;
    ++height_;
  }

  Leaves leaves_;
  Aabb<N, T> around_ = Aabb<N, T>::nothing();
  std::vector<std::uint32_t> parts_;      ///< In the order of level 0.
  std::vector<std::uint32_t> unbounded_;  ///< Parts without a finite box.
  std::vector<BoxBlock<N, T>> blocks_;    ///< Those of level 1, then level 2, and so on.
  std::array<std::size_t, most_levels_of_tree> first_block_of_level_{};
  std::array<std::size_t, most_levels_of_tree> size_of_level_{};  ///< The number of its boxes.
  std::size_t height_ = 0;                                        ///< The number of levels of boxes.
  double size_when_built_ = 0;
};

}  // namespace graze::detail
