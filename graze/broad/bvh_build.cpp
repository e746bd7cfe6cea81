// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include <graze/broad/box_cover.hpp>
#include <graze/broad/bvh_build.hpp>
#include <graze/broad/bvh_kernels.hpp>
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

/// More centers than this are counted sooner than sorted, and more than that counted finely.
constexpr std::size_t worth_bins = 24;
constexpr std::size_t worth_fine_bins = 1024;

/// The center of a box, and whose it is: all that parting moves about.
template <Dim N, class T>
struct BvhCenter {
  Vec<N, T> at;
  std::uint32_t slot;
};

/// Centers, and as much room beside them.
template <Dim N, class T>
struct BvhCenters {
  BvhCenter<N, T>* here;
  BvhCenter<N, T>* beside;
  std::size_t count;

  BvhCenters first(std::size_t some) const { return {here, beside, some}; }
  BvhCenters behind(std::size_t some) const { return {here + some, beside + some, count - some}; }
};

template <Dim N, class T>
Aabb<N, T> bounds_of_centers(const BvhCenters<N, T>& centers) {
  Aabb<N, T> bounds = Aabb<N, T>::nothing();
  for (std::size_t k = 0; k < centers.count; ++k) grow_at_once(bounds, {centers.here[k].at, centers.here[k].at});
  return bounds;
}

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
      build_entries({level, index, first}, {first, first + count, bounds_of_centers(centers)}, centers);
    } else {
      fill_leaf_node(index, centers);
    }
    const Aabb<N, T> around = bvh_kernels<N, T>().around(node.boxes);
    return level > 0 ? around : grown_by(around, margin_);
  }

 private:
  using Center = BvhCenter<N, T>;

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

  /// By slot: each comes behind all whose slots are lower.
  void fill_leaf_node(std::uint32_t index, const Centers& centers) const {
    BvhNode<N, T>& node = arrays_.nodes[index];
    std::array<std::int32_t, block_size> slots;  // NOLINT(*-member-init): filled before it is read
    slots.fill(std::numeric_limits<std::int32_t>::max());
    for (std::size_t k = 0; k < centers.count; ++k) {
      prefetch(&arrays_.boxes[centers.here[k].slot]);
      slots[k] = static_cast<std::int32_t>(centers.here[k].slot);
    }
    for (std::size_t k = 0; k < centers.count; ++k) {
      std::int32_t lane = 0;
      for (const std::int32_t other : slots) lane += other < slots[k] ? 1 : 0;
      const std::uint32_t slot = centers.here[k].slot;
      put_box(node.boxes, static_cast<std::uint32_t>(lane), arrays_.boxes[slot]);
      node.entries[lane] = slot;
      arrays_.leaf_nodes[slot] = index;
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
    const std::size_t middle = (entries.first + entries.last) / 2;
    const std::size_t count =
        plan_.first_box(parent.level - 1, middle) - plan_.first_box(parent.level - 1, entries.first);
    const Dim axis = longest_axis(entries.bounds);
    const Centers parted = part(centers, count, axis, entries.bounds);
    std::array<Entries, 2> sides = {Entries{entries.first, middle, entries.bounds},
                                    Entries{middle, entries.last, entries.bounds}};
    sides[0].bounds.max[axis] = sides[1].bounds.min[axis] = parted.here[count].at[axis];
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

  /// Brings the `count` first ones along an axis to the front, or to the front of the room beside, and the one that
  /// follows behind them.
  static Centers part(const Centers& centers, std::size_t count, Dim axis, const Aabb<N, T>& bounds) {
    if (centers.count > worth_fine_bins) return part_by_bins<256>(centers, count, axis, bounds);
    if (centers.count > worth_bins) return part_by_bins<32>(centers, count, axis, bounds);
    part_by_order(centers, count, axis);
    return centers;
  }

  /// By counting how many lie in bins of equal width, and then sorting but one of them.
  template <std::size_t bins>
  static Centers part_by_bins(const Centers& centers, std::size_t count, Dim axis, const Aabb<N, T>& bounds) {
    const T from = bounds.min[axis];
    const T extent = bounds.max[axis] - from;
    const T bins_per_unit = static_cast<T>(bins) / extent;
    if (!std::isfinite(extent) || !std::isfinite(bins_per_unit)) {
      part_by_order(centers, count, axis);
      return centers;
    }
    const auto bin_of = [&](const Center& center) {
      const auto bin = static_cast<std::int32_t>((center.at[axis] - from) * bins_per_unit);
      return std::min(bin, static_cast<std::int32_t>(bins) - 1);
    };
    std::array<std::uint32_t, bins> counts{};
    for (std::size_t k = 0; k < centers.count; ++k) ++counts[static_cast<std::size_t>(bin_of(centers.here[k]))];
    std::size_t border = 0;
    std::size_t before = 0;
    while (before + counts[border] <= count) before += counts[border++];
    std::array<std::size_t, 3> next = {0, before, before + counts[border]};  // below the border's bin, in it, above
    const auto border_bin = static_cast<std::int32_t>(border);
    for (std::size_t k = 0; k < centers.count; ++k) {
      const std::int32_t bin = bin_of(centers.here[k]);
      const std::size_t side = static_cast<std::size_t>(bin >= border_bin) + static_cast<std::size_t>(bin > border_bin);
      centers.beside[next[side]++] = centers.here[k];
    }
    const Centers parted{centers.beside, centers.here, centers.count};
    part_by_order(parted.behind(before).first(counts[border]), count - before, axis);
    return parted;
  }

  /// Equal ones come by slot.
  static void part_by_order(const Centers& centers, std::size_t count, Dim axis) {
    std::nth_element(centers.here, centers.here + count, centers.here + centers.count,
                     [axis](const Center& a, const Center& b) {
                       return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis] : a.slot < b.slot;
                     });
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
  std::vector<BvhCenter<N, T>> centers(2 * slots.size());
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const Aabb<N, T>& box = arrays.boxes[slots[k]];
    for (Dim i = 0; i < N; ++i) centers[k].at[i] = box.min[i] * T(0.5) + box.max[i] * T(0.5);
    centers[k].slot = slots[k];
  }
  const std::size_t top = plan.height() - 1;
  BvhBuilder<N, T>(margin, plan, arrays, executor)
      .build_node(top, 0, {centers.data(), centers.data() + slots.size(), slots.size()});
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
