// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <span>

#include <graze/broad/bvh/build.hpp>
#include <graze/broad/bvh/bvh_kernels.hpp>
#include <graze/broad/bvh/part.hpp>
#include <graze/broad/index/box_cover.hpp>
#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/memory/prefetch.hpp>

namespace graze::detail {

BvhPlan::BvhPlan(std::size_t boxes) : sizes_(1, boxes), firsts_(1, 0) {
  do {
    sizes_.push_back((sizes_.back() + block_size - 1) / block_size);
    firsts_.push_back(firsts_.back() + sizes_.back());
  } while (sizes_.back() > 1);
}

namespace {

/// Subtrees with at least this many boxes are built by parallel tasks.
constexpr std::size_t worth_a_task = 4096;

/// A node of this level holds a few thousand boxes at most. All its centers are partitioned before the first leaf node
/// is filled, so that the boxes of the next nodes are known, and prefetched, while one is built.
constexpr std::size_t level_of_groups = 2;

/// How many leaf nodes ahead memory is prefetched for writing.
constexpr std::size_t nodes_ahead = 2;

template <Dim N, class T>
Dim longest_axis(const Aabb<N, T>& box) {
  Dim longest = 0;
  for (Dim i = 1; i < N; ++i) {
    if (box.max[i] - box.min[i] > box.max[longest] - box.min[longest]) longest = i;
  }
  return longest;
}

template <Dim N, class T>
class BvhBuilder {
 public:
  using Centers = BvhCenters<N, T>;

  BvhBuilder(double margin, const BvhPlan& plan, const BvhArrays<N, T>& arrays, const Executor& executor)
      : margin_(margin), plan_(plan), arrays_(arrays), executor_(executor) {}

  /// Builds a node of a level from its boxes, and returns its bounds.
  Aabb<N, T> build_node(  // NOLINT(misc-no-recursion): no deeper than the tree
      std::size_t level, std::size_t number, const Centers& centers, std::span<const std::uint32_t> next = {}) const {
    const std::uint32_t index = plan_.index(level, number);
    BvhNode<N, T>& node = arrays_.nodes[index];
    const std::size_t first = plan_.first_entry(level, number);
    const std::size_t count = plan_.first_entry(level, number + 1) - first;
    arrays_.places[index].count = static_cast<std::uint32_t>(count);
    clear_lanes(node, static_cast<std::uint32_t>(count));
    if (level == 0) {
      fill_leaf_node(index, centers);
      return grown_by(bvh_kernels<N, T>().around(node.boxes), margin_);
    }
    Centers groups[block_size];
    Parent parent{level, index, first, next, groups};
    build_entries(parent, {first, first + count, build_kernels<N, T>().bounds(centers.here, centers.count)}, centers);
    if (level == level_of_groups) build_groups(parent, count);
    return bvh_kernels<N, T>().around(node.boxes);
  }

 private:
  struct Parent {
    std::size_t level;
    std::uint32_t index;
    std::size_t first;
    std::span<const std::uint32_t> next;  ///< Slots of the next sibling's boxes that are not prefetched yet.
    Centers* groups;                      ///< Centers of its entries, which are built once all are known.
  };

  /// A range of a parent's entries, and a box that contains the centers of their boxes.
  struct Entries {
    std::size_t first;
    std::size_t last;
    Aabb<N, T> bounds;
  };

  static std::span<const std::uint32_t> slots_of(const Centers& centers) { return {centers.here.slots, centers.count}; }

  /// Entries are in the order of slots, since partitioning is stable.
  void fill_leaf_node(std::uint32_t index, const Centers& centers) const {
    BvhNode<N, T>& node = arrays_.nodes[index];
    if (index + nodes_ahead < plan_.nodes()) prefetch_whole_to_write(arrays_.nodes + index + nodes_ahead);
    for (std::uint32_t lane = 0; lane < centers.count; ++lane) {
      const std::uint32_t slot = centers.here.slots[lane];
      put_box(node.boxes, lane, arrays_.boxes[slot]);
      node.entries[lane] = slot;
      node.generations[lane] = arrays_.generations.empty() ? arrays_.generation : arrays_.generations[slot];
    }
  }

  void ask_for(std::span<const std::uint32_t> slots) const {
    for (const std::uint32_t slot : slots) prefetch(&arrays_.boxes[slot]);
    if (arrays_.generations.empty()) return;
    for (const std::uint32_t slot : slots) prefetch(&arrays_.generations[slot]);
  }

  /// Prefetches up to a node's worth of boxes, the first that are not prefetched yet. Does not write if there are none:
  /// above the level of groups there never are, and there several threads share a parent.
  void ask_for_some(std::span<const std::uint32_t>& slots) const {
    if (slots.empty()) return;
    const std::size_t some = std::min<std::size_t>(block_size, slots.size());
    ask_for(slots.first(some));
    slots = slots.subspan(some);
  }

  /// Builds a node and enters it in its parent.
  void build_entry(  // NOLINT(misc-no-recursion)
      Parent& parent, std::size_t entry, const Centers& centers, std::span<const std::uint32_t> next) const {
    const std::uint32_t index = plan_.index(parent.level - 1, entry);
    const auto lane = static_cast<std::uint32_t>(entry - parent.first);
    BvhNode<N, T>& above = arrays_.nodes[parent.index];
    put_box(above.boxes, lane, build_node(parent.level - 1, entry, centers, next));
    above.entries[lane] = (parent.level == 1 ? BvhLink::leaf(index) : BvhLink::inner(index)).code();
    arrays_.places[index].parent = parent.index;
  }

  /// Builds the postponed entries of a parent, prefetching for the next entry while one is built.
  void build_groups(Parent& parent, std::size_t count) const {  // NOLINT(misc-no-recursion)
    ask_for(slots_of(parent.groups[0]));
    for (std::size_t k = 0; k < count; ++k) {
      const std::span<const std::uint32_t> next =
          k + 1 < count ? slots_of(parent.groups[k + 1]) : std::span<const std::uint32_t>{};
      build_entry(parent, parent.first + k, parent.groups[k], next);
    }
  }

  /// Builds the nodes of a range of a parent's entries.
  void build_entries(  // NOLINT(misc-no-recursion)
      Parent& parent, const Entries& entries, const Centers& centers) const {
    if (entries.last - entries.first == 1) {
      if (parent.level == level_of_groups) {
        parent.groups[entries.first - parent.first] = centers;
      } else {
        ask_for_some(parent.next);
        build_entry(parent, entries.first, centers, {});
      }
      return;
    }
    const std::size_t middle = (entries.first + entries.last) / 2;
    const std::size_t count =
        plan_.first_box(parent.level - 1, middle) - plan_.first_box(parent.level - 1, entries.first);
    const Dim axis = longest_axis(entries.bounds);
    const bool are_leaves = parent.level == 1 && entries.last - entries.first == 2;
    const T border = part_centers(centers, count, axis, are_leaves ? BvhWanted::slots : BvhWanted::all);
    const Centers parted{centers.beside, centers.here, centers.count};
    std::array<Entries, 2> sides = {Entries{entries.first, middle, entries.bounds},
                                    Entries{middle, entries.last, entries.bounds}};
    sides[0].bounds.max[axis] = sides[1].bounds.min[axis] = border;
    const auto build_side = [&](std::size_t side) {
      build_entries(parent, sides[side], side == 0 ? parted.first(count) : parted.behind(count));
    };
    if (centers.count > worth_a_task) {
      executor_.parallel_for(2, std::ref(build_side));  // by reference, which does not allocate
    } else {
      build_side(0);
      build_side(1);
    }
  }

  double margin_;
  const BvhPlan& plan_;
  BvhArrays<N, T> arrays_;
  const Executor& executor_;
};

/// Fast if the slots are already ascending, or descending as they are after all boxes were erased.
void sort_slots(std::span<std::uint32_t> slots) {
  if (std::is_sorted(slots.rbegin(), slots.rend())) {
    std::reverse(slots.begin(), slots.end());
  } else if (!std::is_sorted(slots.begin(), slots.end())) {
    std::sort(slots.begin(), slots.end());
  }
}

}  // namespace

template <Dim N, class T>
void build_bvh(std::span<const std::uint32_t> slots, double margin, const BvhPlan& plan, const BvhArrays<N, T>& arrays,
               const Executor& executor) {
  const std::size_t count = slots.size();
  BlankVector<T> coordinates(std::size_t{2} * N * count);
  BlankVector<std::uint32_t> numbers(2 * count);
  BvhCenters<N, T> centers;
  for (Dim i = 0; i < N; ++i) {
    centers.here.at[i] = coordinates.data() + static_cast<std::size_t>(i) * 2 * count;
    centers.beside.at[i] = centers.here.at[i] + count;
  }
  centers.here.slots = numbers.data();
  centers.beside.slots = numbers.data() + count;
  centers.count = count;
  const std::span<std::uint32_t> sorted(centers.here.slots, count);
  std::copy(slots.begin(), slots.end(), sorted.begin());
  if (are_in_a_row(slots)) {
    build_kernels<N, T>().centers(arrays.boxes + slots[0], count, centers.here);
  } else {
    sort_slots(sorted);
    for (std::size_t first = 0; first < count;) {
      std::size_t last = first + 1;
      while (last < count && sorted[last] == sorted[last - 1] + 1) ++last;
      build_kernels<N, T>().centers(arrays.boxes + sorted[first], last - first, centers.here.behind(first));
      first = last;
    }
  }
  const std::size_t top = plan.height() - 1;
  BvhBuilder<N, T>(margin, plan, arrays, executor).build_node(top, 0, centers);
  arrays.places[plan.index(top, 0)].parent = no_box;
}

template void build_bvh(std::span<const std::uint32_t>, double, const BvhPlan&, const BvhArrays<2, float>&,
                        const Executor&);
template void build_bvh(std::span<const std::uint32_t>, double, const BvhPlan&, const BvhArrays<3, float>&,
                        const Executor&);
template void build_bvh(std::span<const std::uint32_t>, double, const BvhPlan&, const BvhArrays<2, double>&,
                        const Executor&);
template void build_bvh(std::span<const std::uint32_t>, double, const BvhPlan&, const BvhArrays<3, double>&,
                        const Executor&);

}  // namespace graze::detail
