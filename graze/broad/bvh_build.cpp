// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <functional>
#include <limits>

#include <graze/broad/box_cover.hpp>
#include <graze/broad/buffer.hpp>
#include <graze/broad/bvh_build.hpp>
#include <graze/broad/bvh_kernels.hpp>
#include <graze/broad/bvh_part.hpp>
#include <graze/broad/prefetch.hpp>

namespace graze::detail {

BvhPlan::BvhPlan(std::size_t boxes) : sizes_(1, boxes), firsts_(1, 0) {
  do {
    sizes_.push_back((sizes_.back() + block_size - 1) / block_size);
    firsts_.push_back(firsts_.back() + sizes_.back());
  } while (sizes_.back() > 1);
}

namespace {

/// Parts of larger trees may be built by different threads.
constexpr std::size_t worth_a_task = 4096;

/// Before so many centers are parted down to leaf nodes, what these will hold is asked for.
constexpr std::size_t worth_asking_ahead = 256;

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

  /// Builds a node of a level from the boxes that are its own, and returns its bounds.
  Aabb<N, T> build_node(  // NOLINT(misc-no-recursion): no deeper than the tree
      std::size_t level, std::size_t number, const Centers& centers) const {
    const std::uint32_t index = plan_.index(level, number);
    BvhNode<N, T>& node = arrays_.nodes[index];
    const std::size_t first = plan_.first_entry(level, number);
    const std::size_t count = plan_.first_entry(level, number + 1) - first;
    arrays_.places[index].count = static_cast<std::uint32_t>(count);
    clear_lanes(node, static_cast<std::uint32_t>(count));
    if (level > 0) {
      build_entries({level, index, first},
                    {first, first + count, center_kernels<N, T>().bounds(centers.here, centers.count)}, centers);
    } else {
      fill_leaf_node(index, centers);
    }
    const Aabb<N, T> around = bvh_kernels<N, T>().around(node.boxes);
    return level > 0 ? around : grown_by(around, margin_);
  }

 private:
  struct Parent {
    std::size_t level;
    std::uint32_t index;
    std::size_t first;
  };

  /// Entries of a parent, by number, and a box that holds their boxes' centers.
  struct Entries {
    std::size_t first;
    std::size_t last;
    Aabb<N, T> bounds;
  };

  /// In the order of slots, since parting keeps it.
  void fill_leaf_node(std::uint32_t index, const Centers& centers) const {
    BvhNode<N, T>& node = arrays_.nodes[index];
    for (std::uint32_t lane = 0; lane < centers.count; ++lane) {
      const std::uint32_t slot = centers.here.slots[lane];
      put_box(node.boxes, lane, arrays_.boxes[slot]);
      node.entries[lane] = slot;
      arrays_.leaf_nodes[slot] = index;
    }
  }

  void ask_ahead(const Centers& centers) const {
    for (std::size_t k = 0; k < centers.count; ++k) {
      const std::uint32_t slot = centers.here.slots[k];
      prefetch(&arrays_.boxes[slot]);
      prefetch(&arrays_.leaf_nodes[slot]);
    }
  }

  /// Builds the nodes that are entries of a parent.
  void build_entries(  // NOLINT(misc-no-recursion)
      const Parent& parent, const Entries& entries, const Centers& centers) const {
    if (entries.last - entries.first == 1) {
      const std::uint32_t index = plan_.index(parent.level - 1, entries.first);
      const auto lane = static_cast<std::uint32_t>(entries.first - parent.first);
      BvhNode<N, T>& above = arrays_.nodes[parent.index];
      put_box(above.boxes, lane, build_node(parent.level - 1, entries.first, centers));
      above.entries[lane] = (parent.level == 1 ? BvhLink::leaf(index) : BvhLink::inner(index)).code();
      arrays_.places[index].parent = parent.index;
      return;
    }
    if (centers.count <= worth_asking_ahead && centers.count > worth_asking_ahead / 2) ask_ahead(centers);
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
      executor_.parallel_for(2, std::ref(build_side));  // by reference, which allocates nothing
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
  std::copy(slots.begin(), slots.end(), centers.here.slots);
  std::uint32_t* const last_slot = centers.here.slots + count;
  if (std::is_sorted(slots.rbegin(), slots.rend())) {  // as they come where all boxes before were erased
    std::reverse(centers.here.slots, last_slot);
  } else if (!std::is_sorted(slots.begin(), slots.end())) {
    std::sort(centers.here.slots, last_slot);
  }
  for (std::size_t first = 0; first < count;) {
    const std::uint32_t* const sorted = centers.here.slots;
    std::size_t last = first + 1;
    while (last < count && sorted[last] == sorted[last - 1] + 1) ++last;
    center_kernels<N, T>().centers(arrays.boxes + sorted[first], last - first, centers.here.behind(first));
    first = last;
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
