// SPDX-License-Identifier: MIT
// Splits where lines have the least to do: a side costs its surface times the number of its leaves (MacDonald and Booth
// 1990, "Heuristics for ray tracing using space subdivision"), tried between bins of equal width along the axis on
// which the centers spread most (Wald 2007, "On fast construction of SAH-based bounding volume hierarchies"), and
// between all leaves when they are few.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <utility>

#include <graze/broad/box_cover.hpp>
#include <graze/broad/bvh_build.hpp>

namespace graze::detail {
namespace {

constexpr std::size_t bins = 16;
constexpr std::size_t few = 16;

/// The sides of larger trees may be built by different threads.
constexpr std::size_t worth_a_task = 4096;

template <Dim N, class T>
T center_on(const Aabb<N, T>& box, Dim axis) {
  return box.min[axis] * T(0.5) + box.max[axis] * T(0.5);
}

/// Along which axis the centers spread most, from where, and how far.
template <class T>
struct Spread {
  Dim axis;
  T from;
  T extent;
};

template <Dim N, class T>
Spread<T> spread_of(std::span<const BvhLeaf<N, T>> leaves) {
  Vec<N, T> low(std::numeric_limits<T>::infinity());
  Vec<N, T> high(-std::numeric_limits<T>::infinity());
  for (const BvhLeaf<N, T>& leaf : leaves) {
    for (Dim i = 0; i < N; ++i) {
      const T center = center_on(leaf.box, i);
      low[i] = center < low[i] ? center : low[i];
      high[i] = center > high[i] ? center : high[i];
    }
  }
  Spread<T> spread{0, low[0], high[0] - low[0]};
  for (Dim i = 1; i < N; ++i) {
    if (high[i] - low[i] > spread.extent) spread = {i, low[i], high[i] - low[i]};
  }
  return spread;
}

/// How many leaves the first side may get.
struct Range {
  std::size_t least;
  std::size_t most;
};

Range allowed(std::size_t count) {
  if (count <= 12) return {1, count - 1};
  return {(count + 2) / 3, count - (count + 2) / 3};
}

/// By their centers along an axis, equal ones by slot.
template <Dim N, class T>
struct Before {
  Dim axis;

  bool operator()(const BvhLeaf<N, T>& a, const BvhLeaf<N, T>& b) const {
    const T center_a = center_on(a.box, axis);
    const T center_b = center_on(b.box, axis);
    return center_a != center_b ? center_a < center_b : a.slot < b.slot;
  }
};

/// Sorts a few leaves and returns how many come first.
template <Dim N, class T>
std::size_t split_few(std::span<BvhLeaf<N, T>> leaves, Dim axis) {
  const std::size_t count = leaves.size();
  std::sort(leaves.begin(), leaves.end(), Before<N, T>{axis});
  std::array<double, few> cost_behind;  // NOLINT(*-member-init): written before it is read
  Aabb<N, T> box = Aabb<N, T>::nothing();
  for (std::size_t k = count; k-- > 1;) {
    grow_at_once(box, leaves[k].box);
    cost_behind[k] = surface_of(box) * static_cast<double>(count - k);
  }
  const Range range = allowed(count);
  std::size_t best = count / 2;
  double best_cost = std::numeric_limits<double>::infinity();
  box = Aabb<N, T>::nothing();
  for (std::size_t k = 1; k <= range.most; ++k) {
    grow_at_once(box, leaves[k - 1].box);
    const double cost = surface_of(box) * static_cast<double>(k) + cost_behind[k];
    if (k < range.least || !(cost < best_cost)) continue;
    best = k;
    best_cost = cost;
  }
  return best;
}

/// Halves the leaves.
template <Dim N, class T>
std::size_t split_in_the_middle(std::span<BvhLeaf<N, T>> leaves, Dim axis) {
  const std::size_t half = leaves.size() / 2;
  std::nth_element(leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(half), leaves.end(),
                   Before<N, T>{axis});
  return half;
}

/// The leaves whose centers lie in a bin.
template <Dim N, class T>
struct Bin {
  Aabb<N, T> box = Aabb<N, T>::nothing();
  std::size_t count = 0;
};

/// The border between bins with the lowest cost; none where each leaves too few on one side.
template <Dim N, class T>
std::size_t best_border(const std::array<Bin<N, T>, bins>& all, const Range& range) {
  std::array<double, bins> cost_behind;  // NOLINT(*-member-init): written before it is read
  Bin<N, T> side;
  for (std::size_t k = bins; k-- > 1;) {
    grow_at_once(side.box, all[k].box);
    side.count += all[k].count;
    cost_behind[k] = surface_of(side.box) * static_cast<double>(side.count);
  }
  side = {};
  std::size_t best = 0;
  double best_cost = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < bins; ++k) {
    grow_at_once(side.box, all[k - 1].box);
    side.count += all[k - 1].count;
    if (side.count < range.least || side.count > range.most) continue;
    const double cost = surface_of(side.box) * static_cast<double>(side.count) + cost_behind[k];
    if (!(cost < best_cost)) continue;
    best = k;
    best_cost = cost;
  }
  return best;
}

/// Parts many leaves and returns how many come first.
template <Dim N, class T>
std::size_t split_many(std::span<BvhLeaf<N, T>> leaves, const Spread<T>& spread) {
  const T bins_per_unit = static_cast<T>(bins) / spread.extent;
  if (!std::isfinite(spread.extent) || !std::isfinite(bins_per_unit)) return split_in_the_middle(leaves, spread.axis);
  const auto bin_of = [&](const BvhLeaf<N, T>& leaf) {
    const auto bin = static_cast<std::size_t>((center_on(leaf.box, spread.axis) - spread.from) * bins_per_unit);
    return std::min(bin, bins - 1);
  };
  std::array<Bin<N, T>, bins> all;
  for (const BvhLeaf<N, T>& leaf : leaves) {
    Bin<N, T>& bin = all[bin_of(leaf)];
    grow_at_once(bin.box, leaf.box);
    ++bin.count;
  }
  const std::size_t border = best_border(all, allowed(leaves.size()));
  if (border == 0) return split_in_the_middle(leaves, spread.axis);
  const auto first_behind =
      std::partition(leaves.begin(), leaves.end(), [&](const BvhLeaf<N, T>& leaf) { return bin_of(leaf) < border; });
  return static_cast<std::size_t>(first_behind - leaves.begin());
}

template <Dim N, class T>
std::size_t split(std::span<BvhLeaf<N, T>> leaves) {
  if (leaves.size() == 2) {
    if (leaves[1].slot < leaves[0].slot) std::swap(leaves[0], leaves[1]);
    return 1;
  }
  const Spread<T> spread = spread_of<N, T>(leaves);
  return leaves.size() <= few ? split_few(leaves, spread.axis) : split_many(leaves, spread);
}

}  // namespace

/// Of two or more leaves; a node with k leaves below is followed by those k - 2 that are below its first place and its
/// second: so each side knows its nodes before the other is built. No deeper than the tree.
template <Dim N, class T>
void BvhBuilder<N, T>::build_from(  // NOLINT(misc-no-recursion)
    std::span<BvhLeaf<N, T>> leaves, std::uint32_t place, std::size_t first_index) {
  BvhNode<N, T>& parent = nodes_[place / 2];
  if (leaves.size() == 1) {
    parent.children[place % 2] = BvhChild::leaf(leaves[0].slot);
    parent.boxes[place % 2] = leaves[0].box;
    places_[leaves[0].slot] = place;
    return;
  }
  const std::uint32_t index = indices_[first_index];
  BvhNode<N, T>& node = nodes_[index];
  node.place = place;
  node.count = static_cast<std::uint32_t>(leaves.size());
  const std::size_t middle = split(leaves);
  const auto build_side = [&](std::size_t side) {
    if (side == 0) {
      build_from(leaves.first(middle), 2 * index, first_index + 1);
    } else {
      build_from(leaves.subspan(middle), 2 * index + 1, first_index + middle);
    }
  };
  if (leaves.size() > worth_a_task) {
    executor_.parallel_for(2, std::ref(build_side));  // by reference, which allocates nothing
  } else {
    build_side(0);
    build_side(1);
  }
  parent.children[place % 2] = BvhChild::node(index);
  parent.boxes[place % 2] = box_around(node.boxes[0], node.boxes[1]);
}

template class BvhBuilder<2, float>;
template class BvhBuilder<3, float>;
template class BvhBuilder<2, double>;
template class BvhBuilder<3, double>;

}  // namespace graze::detail
