// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include <graze/broad/box_cover.hpp>
#include <graze/broad/bvh_build.hpp>

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

/// So many centers are sorted sooner than counted, and so many counted finely.
constexpr std::size_t few = 48;
constexpr std::size_t many = 1024;

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

/// Along which axis centers spread most, from where, and how far.
template <class T>
struct BvhSpread {
  Dim axis;
  T from;
  T extent;
};

template <Dim N, class T>
BvhSpread<T> spread_of(const BvhCenters<N, T>& centers) {
  Vec<N, T> low(std::numeric_limits<T>::infinity());
  Vec<N, T> high(-std::numeric_limits<T>::infinity());
  for (std::size_t k = 0; k < centers.count; ++k) {
    const Vec<N, T> at = centers.here[k].at;
    for (Dim i = 0; i < N; ++i) {
      low[i] = at[i] < low[i] ? at[i] : low[i];
      high[i] = at[i] > high[i] ? at[i] : high[i];
    }
  }
  BvhSpread<T> spread{0, low[0], high[0] - low[0]};
  for (Dim i = 1; i < N; ++i) {
    if (high[i] - low[i] > spread.extent) spread = {i, low[i], high[i] - low[i]};
  }
  return spread;
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
      build_entries({level, index, first}, first, first + count, centers);
    } else {
      fill_leaf_node(index, centers);
    }
    Aabb<N, T> around = Aabb<N, T>::nothing();
    for (std::uint32_t lane = 0; lane < count; ++lane) grow_at_once(around, box_in(node.boxes, lane));
    return level > 0 ? around : grown_by(around, margin_);
  }

 private:
  using Center = BvhCenter<N, T>;

  struct Parent {
    std::size_t level;
    std::uint32_t index;
    std::size_t first;
  };

  void fill_leaf_node(std::uint32_t index, const Centers& centers) const {
    BvhNode<N, T>& node = arrays_.nodes[index];
    std::sort(centers.here, centers.here + centers.count,
              [](const Center& a, const Center& b) { return a.slot < b.slot; });
    for (std::uint32_t lane = 0; lane < centers.count; ++lane) {
      const std::uint32_t slot = centers.here[lane].slot;
      put_box(node.boxes, lane, arrays_.boxes[slot]);
      node.entries[lane] = slot;
      arrays_.leaf_nodes[slot] = index;
    }
  }

  /// Builds the nodes from `first` to before `last` on the level below a parent.
  void build_entries(  // NOLINT(misc-no-recursion)
      const Parent& parent, std::size_t first, std::size_t last, const Centers& centers) const {
    if (last - first == 1) {
      const std::uint32_t index = plan_.index(parent.level - 1, first);
      const auto lane = static_cast<std::uint32_t>(first - parent.first);
      BvhNode<N, T>& above = arrays_.nodes[parent.index];
      put_box(above.boxes, lane, build_node(parent.level - 1, first, centers));
      above.entries[lane] = (parent.level == 1 ? BvhLink::leaf(index) : BvhLink::inner(index)).code();
      arrays_.places[index].parent = parent.index;
      return;
    }
    const std::size_t middle = (first + last) / 2;
    const std::size_t count = plan_.first_box(parent.level - 1, middle) - plan_.first_box(parent.level - 1, first);
    const Centers parted = part(centers, count);
    const auto build_side = [&](std::size_t side) {
      if (side == 0) {
        build_entries(parent, first, middle, parted.first(count));
      } else {
        build_entries(parent, middle, last, parted.behind(count));
      }
    };
    if (centers.count > worth_a_task) {
      executor_.parallel_for(2, std::ref(build_side));  // by reference, which allocates nothing
    } else {
      build_side(0);
      build_side(1);
    }
  }

  /// Brings the `count` first ones to the front, or to the front of the room beside.
  static Centers part(const Centers& centers, std::size_t count) {
    const BvhSpread<T> spread = spread_of(centers);
    if (centers.count > many) return part_by_bins<256>(centers, count, spread);
    if (centers.count > few) return part_by_bins<32>(centers, count, spread);
    part_by_order(centers, count, spread.axis);
    return centers;
  }

  /// By counting how many lie in bins of equal width, and then sorting but one of them.
  template <std::size_t bins>
  static Centers part_by_bins(const Centers& centers, std::size_t count, const BvhSpread<T>& spread) {
    const T bins_per_unit = static_cast<T>(bins) / spread.extent;
    if (!std::isfinite(spread.extent) || !std::isfinite(bins_per_unit)) {
      part_by_order(centers, count, spread.axis);
      return centers;
    }
    const auto bin_of = [&](const Center& center) {
      const auto bin = static_cast<std::int32_t>((center.at[spread.axis] - spread.from) * bins_per_unit);
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
    part_by_order(parted.behind(before).first(counts[border]), count - before, spread.axis);
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
