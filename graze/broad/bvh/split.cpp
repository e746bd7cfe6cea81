// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include <graze/broad/bvh/split.hpp>
#include <graze/broad/index/box_cover.hpp>

namespace graze::detail {
namespace {

template <Dim N, class T>
double sum_of_extents(const Aabb<N, T>& box) {
  double sum = 0;
  for (Dim i = 0; i < N; ++i) sum += static_cast<double>(box.max[i]) - static_cast<double>(box.min[i]);
  return sum;
}

/// Orders entries by twice their center, which does not overflow for the largest numbers of T; ties by entry.
template <Dim N, class T>
void sort_along(BvhEntries<N, T>& entries, Dim axis) {
  const auto center = [axis](const BvhEntry<N, T>& entry) {
    return static_cast<double>(entry.box.min[axis]) * 0.5 + static_cast<double>(entry.box.max[axis]) * 0.5;
  };
  std::sort(entries.all.begin(), entries.all.begin() + entries.count, [&](const auto& a, const auto& b) {
    const double center_a = center(a);
    const double center_b = center(b);
    return center_a != center_b ? center_a < center_b : a.entry < b.entry;
  });
}

/// Where to cut a sequence of entries, and the cost of the cut.
struct BvhCut {
  std::uint32_t first;
  double cost;
};

template <Dim N, class T>
BvhCut best_cut(const BvhEntries<N, T>& entries) {
  const std::uint32_t count = entries.count;
  const std::uint32_t least = std::max(bvh_least, count - block_size);
  std::array<double, std::size_t{2} * block_size> cost_behind;  // NOLINT(*-member-init): written before it is read
  Aabb<N, T> box = Aabb<N, T>::nothing();
  for (std::uint32_t k = count; k-- > least;) {
    grow_at_once(box, entries.all[k].box);
    cost_behind[k] = sum_of_extents(box) * (count - k);
  }
  BvhCut best{count / 2, std::numeric_limits<double>::infinity()};
  box = Aabb<N, T>::nothing();
  for (std::uint32_t k = 1; k <= count - least; ++k) {
    grow_at_once(box, entries.all[k - 1].box);
    if (k < least) continue;
    const double cost = sum_of_extents(box) * k + cost_behind[k];
    if (cost < best.cost) best = {k, cost};
  }
  return best;
}

}  // namespace

template <Dim N, class T>
std::uint32_t split_entries(BvhEntries<N, T>& entries) {
  Dim axis = 0;
  BvhCut best{entries.count / 2, std::numeric_limits<double>::infinity()};
  for (Dim i = 0; i < N; ++i) {
    sort_along(entries, i);
    const BvhCut cut = best_cut(entries);
    if (!(cut.cost < best.cost)) continue;
    best = cut;
    axis = i;
  }
  if (axis != N - 1) sort_along(entries, axis);
  return best.first;
}

template std::uint32_t split_entries(BvhEntries<2, float>&);
template std::uint32_t split_entries(BvhEntries<3, float>&);
template std::uint32_t split_entries(BvhEntries<2, double>&);
template std::uint32_t split_entries(BvhEntries<3, double>&);

}  // namespace graze::detail
