// SPDX-License-Identifier: MIT
// Compiled once per instruction set: Highway includes this file anew for each.
#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <type_traits>

#include <graze/broad/bvh_kernels.hpp>
#include <graze/broad/prefetch.hpp>
#include <graze/broad/simd_choice.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/broad/bvh_kernels.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include <graze/broad/bvh_near-inl.hpp>
#include <graze/broad/simd_compress-inl.hpp>
#include <graze/broad/simd_lanes-inl.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

template <Dim N, class T>
HWY_INLINE std::uint32_t boxes_met(const Block<N, T>& block, const Lanes<T>* low, const Lanes<T>* high) {
  const Tag<T> d;
  std::uint32_t met = 0;
  for (std::uint32_t lane = 0; lane < block_size; lane += lanes_of<T>) {
    auto meets =
        hn::And(hn::Le(hn::Load(d, block.min[0] + lane), high[0]), hn::Ge(hn::Load(d, block.max[0] + lane), low[0]));
    for (Dim i = 1; i < N; ++i) {
      meets = hn::And(meets, hn::And(hn::Le(hn::Load(d, block.min[i] + lane), high[i]),
                                     hn::Ge(hn::Load(d, block.max[i] + lane), low[i])));
    }
    met |= bits_of<T>(meets) << lane;
  }
  return met;
}

/// Writes the entries whose bits are set one after another, and up to sixteen numbers of no meaning behind them.
HWY_INLINE std::size_t write_chosen(const std::uint32_t* entries, std::uint32_t chosen, std::uint32_t* to) {
  using D = Tag<std::uint32_t>;
  std::size_t count = 0;
  for (std::uint32_t lane = 0; lane < block_size; lane += lanes_of<std::uint32_t>) {
    const std::uint32_t bits = (chosen >> lane) & ((1U << lanes_of<std::uint32_t>)-1U);
    hn::StoreU(ToFront<D>(bits)(hn::Load(D(), entries + lane)), D(), to + count);
    count += static_cast<std::size_t>(std::popcount(bits));
  }
  return count;
}

template <Dim N, class T>
void find_met(const BvhNode<N, T>* nodes, BvhMetWalk<N, T>& walk) {
  const Tag<T> d;
  Lanes<T> low[N];
  Lanes<T> high[N];
  for (Dim i = 0; i < N; ++i) {
    low[i] = hn::Set(d, walk.region.min[i]);
    high[i] = hn::Set(d, walk.region.max[i]);
  }
  std::size_t open = walk.open_count;
  std::size_t found = walk.found_count;
  while (open > 0 && found <= BvhMetWalk<N, T>::most_found) {
    const BvhLink link = BvhLink::of_code(walk.open[--open]);
    const BvhNode<N, T>& node = nodes[link.index()];
    const std::uint32_t met = boxes_met(node.boxes, low, high);
    if (link.is_leaf()) {
      write_chosen(node.generations, met, walk.generations + found);
      found += write_chosen(node.entries, met, walk.found + found);
    } else {
      open += write_chosen(node.entries, met, walk.open + open);
    }
  }
  walk.open_count = open;
  walk.found_count = found;
}

template <Dim N, class T>
std::uint32_t met(const Block<N, T>& block, const Aabb<N, T>& box) {
  const Tag<T> d;
  Lanes<T> low[N];
  Lanes<T> high[N];
  for (Dim i = 0; i < N; ++i) {
    low[i] = hn::Set(d, box.min[i]);
    high[i] = hn::Set(d, box.max[i]);
  }
  return boxes_met(block, low, high);
}

template <Dim N, class T>
HWY_INLINE std::uint32_t boxes_entered(const Block<N, T>& block, const BvhSlabs<N, T>& slabs, T limit, T* soonest) {
  const Tag<T> d;
  const auto smallest = hn::Set(d, std::numeric_limits<T>::min());
  std::uint32_t entered = 0;
  for (std::uint32_t lane = 0; lane < block_size; lane += lanes_of<T>) {
    auto enter = hn::Zero(d);
    auto leave = hn::Set(d, std::numeric_limits<T>::infinity());
    auto meets = is_full<T>(hn::Load(d, block.min[0] + lane));
    for (Dim i = 0; i < N; ++i) {
      const auto min = hn::Load(d, block.min[i] + lane);
      const auto max = hn::Load(d, block.max[i] + lane);
      const auto origin = hn::Set(d, slabs.origin[i]);
      if (slabs.kinds[i] == BvhSlab::any) continue;
      if (slabs.kinds[i] == BvhSlab::parallel) {
        meets = hn::And(meets, hn::And(hn::Le(min, origin), hn::Le(origin, max)));
        continue;
      }
      const bool is_backwards = slabs.inverse[i] < 0;
      const auto near = is_backwards ? max : min;
      const auto far = is_backwards ? min : max;
      const auto inverse = hn::Set(d, slabs.inverse[i]);
      enter = hn::Max(enter, hn::Mul(hn::Sub(near, origin), inverse));
      leave = hn::Min(leave, hn::Mul(hn::Sub(far, origin), inverse));
    }
    enter = hn::Min(enter, hn::Set(d, std::numeric_limits<T>::max()));
    const auto latest = hn::Add(hn::Mul(leave, hn::Set(d, T(1) + tolerance::ray_lanes<T>)), smallest);
    const auto earliest = hn::Sub(hn::Mul(enter, hn::Set(d, T(1) - tolerance::ray_lanes<T>)), smallest);
    meets = hn::And(meets, hn::And(hn::Le(enter, latest), hn::Le(earliest, hn::Set(d, limit))));
    hn::StoreU(earliest, d, soonest + lane);
    entered |= bits_of<T>(meets) << lane;
  }
  return entered;
}

template <Dim N, class T>
std::uint32_t entered(const Block<N, T>& block, const BvhSlabs<N, T>& slabs, T* soonest) {
  return boxes_entered(block, slabs, std::numeric_limits<T>::infinity(), soonest);
}

/// What a walk along a ray has still to look at.
template <class T>
struct Waiting {
  T soonest;
  std::uint32_t code;
};

template <Dim N, class T>
HWY_INLINE void look_at_hits(const BvhNode<N, T>& node, std::uint32_t entered, const T* soonest,
                             BvhFirstWalk<N, T>& walk) {
  for (; entered != 0; entered &= entered - 1) {
    const auto lane = static_cast<std::uint32_t>(std::countr_zero(entered));
    if (static_cast<double>(soonest[lane]) > walk.t) continue;
    const std::uint32_t slot = node.entries[lane];
    const std::optional<double> t = entry_of(walk.ray, box_in(node.boxes, lane));
    if (!t || !(*t < walk.t || (*t == walk.t && slot < walk.name.slot))) continue;
    walk.t = *t;
    walk.name = node.name(lane);
  }
}

/// So many children of a node that a ray enters are asked for, those that are looked at next: the second one while the
/// first is looked at.
constexpr std::size_t asked_ahead = 2;

/// Whether all coordinates are less than what is allowed for `crossed` slabs.
template <Dim N, class T>
HWY_INLINE bool are_usual(const Block<N, T>& block) {
  const Tag<T> d;
  const auto most = hn::Set(d, most_for_slabs<T>);
  std::uint32_t beyond = 0;
  for (std::uint32_t lane = 0; lane < block_size; lane += lanes_of<T>) {
    auto is_beyond = hn::Gt(hn::Zero(d), hn::Zero(d));
    for (Dim i = 0; i < N; ++i) {  // both are numbers, or there is no box in the lane
      is_beyond = hn::Or(is_beyond, hn::Ge(hn::Abs(hn::Load(d, block.min[i] + lane)), most));
      is_beyond = hn::Or(is_beyond, hn::Ge(hn::Abs(hn::Load(d, block.max[i] + lane)), most));
    }
    beyond |= bits_of<T>(is_beyond);
  }
  return beyond == 0;
}

/// The nearest child first; what waits is passed by when a box was found before it.
template <Dim N, class T>
std::size_t find_first(const BvhNode<N, T>* nodes, BvhLink root, BvhFirstWalk<N, T>& walk) {
  alignas(64) T soonest[block_size];
  Waiting<T> open[bvh_path];
  open[0] = {T(0), root.code()};
  std::size_t count = 1;
  std::size_t looks = 0;
  T limit = next_up(static_cast<T>(walk.t));
  if (!are_usual(nodes[root.index()].boxes)) {
    std::replace(std::begin(walk.slabs.kinds), std::end(walk.slabs.kinds), BvhSlab::crossed, BvhSlab::any);
  }
  while (count > 0) {
    const Waiting<T> next = open[--count];
    if (static_cast<double>(next.soonest) > walk.t) continue;
    const BvhLink link = BvhLink::of_code(next.code);
    const BvhNode<N, T>& node = nodes[link.index()];
    ++looks;
    std::uint32_t entered = boxes_entered(node.boxes, walk.slabs, limit, soonest);
    if (link.is_leaf()) {
      look_at_hits(node, entered, soonest, walk);
      limit = next_up(static_cast<T>(walk.t));
      continue;
    }
    const std::size_t first = count;
    for (; entered != 0; entered &= entered - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(entered));
      const Waiting<T> child{soonest[lane], node.entries[lane]};
      std::size_t place = count++;
      for (; place > first && open[place - 1].soonest < child.soonest; --place) open[place] = open[place - 1];
      open[place] = child;
    }
    for (std::size_t k = std::max(first + asked_ahead, count) - asked_ahead; k < count; ++k) {
      prefetch_whole(nodes + BvhLink::of_code(open[k].code).index());
    }
  }
  return looks;
}

template <Dim N, class T>
Aabb<N, T> around(const Block<N, T>& block) {
  const Tag<T> d;
  const auto infinity = hn::Set(d, std::numeric_limits<T>::infinity());
  Aabb<N, T> box;
  for (Dim i = 0; i < N; ++i) {
    auto low = infinity;
    auto high = hn::Neg(infinity);
    for (std::uint32_t lane = 0; lane < block_size; lane += lanes_of<T>) {
      const auto min = hn::Load(d, block.min[i] + lane);
      const auto max = hn::Load(d, block.max[i] + lane);
      low = lesser<T>(low, hn::IfThenElse(is_full<T>(min), min, infinity));
      high = greater<T>(high, hn::IfThenElse(is_full<T>(max), max, hn::Neg(infinity)));
    }
    box.min[i] = hn::GetLane(hn::MinOfLanes(d, low));
    box.max[i] = hn::GetLane(hn::MaxOfLanes(d, high));
  }
  return box;
}

/// Where the least of sixteen numbers is, among those of the candidates: a bit each.
template <class T>
HWY_INLINE std::uint32_t least_of(const Lanes<T>* numbers, std::uint32_t candidates) {
  const Tag<T> d;
  auto least = numbers[0];
  for (std::uint32_t k = 1; k < vectors_of<T>; ++k) least = hn::Min(least, numbers[k]);
  least = hn::MinOfLanes(d, least);
  std::uint32_t bits = 0;
  for (std::uint32_t k = 0; k < vectors_of<T>; ++k) bits |= bits_of<T>(hn::Eq(numbers[k], least)) << k * lanes_of<T>;
  return bits & candidates;
}

template <Dim N, class T>
std::uint32_t least_grown(const Block<N, T>& block, const Aabb<N, T>& box) {
  const Tag<T> d;
  // Sums without a number are as large as a number can be: Highway's emulation finds no least one among infinities.
  const auto most = hn::Set(d, std::numeric_limits<T>::max());
  Lanes<T> growth[vectors_of<T>];
  Lanes<T> size[vectors_of<T>];
  std::uint32_t full = 0;
  for (std::uint32_t k = 0; k < vectors_of<T>; ++k) {
    growth[k] = hn::Zero(d);
    size[k] = hn::Zero(d);
    const std::uint32_t lane = k * lanes_of<T>;
    for (Dim i = 0; i < N; ++i) {
      const auto min = hn::Load(d, block.min[i] + lane);
      const auto max = hn::Load(d, block.max[i] + lane);
      const auto below = hn::Max(hn::Sub(min, hn::Set(d, box.min[i])), hn::Zero(d));
      const auto above = hn::Max(hn::Sub(hn::Set(d, box.max[i]), max), hn::Zero(d));
      growth[k] = hn::Add(growth[k], hn::Add(below, above));
      size[k] = hn::Add(size[k], hn::Sub(max, min));
    }
    const auto is_there = is_full<T>(hn::Load(d, block.min[0] + lane));
    full |= bits_of<T>(is_there) << lane;
    growth[k] = hn::IfThenElse(is_there, hn::Min(growth[k], most), most);
    size[k] = hn::IfThenElse(is_there, hn::Min(size[k], most), most);
  }
  const std::uint32_t least = least_of<T>(growth, full);
  if (std::has_single_bit(least)) return static_cast<std::uint32_t>(std::countr_zero(least));
  for (std::uint32_t k = 0; k < vectors_of<T>; ++k) {
    const std::uint64_t bits = (least >> k * lanes_of<T>)&((1U << lanes_of<T>)-1U);
    const auto is_least = hn::LoadMaskBits(d, reinterpret_cast<const std::uint8_t*>(&bits));
    size[k] = hn::IfThenElse(is_least, size[k], most);
  }
  return static_cast<std::uint32_t>(std::countr_zero(least_of<T>(size, least)));
}

template <Dim N, class T>
BvhKernels<N, T> kernels() {
  return {hwy::TargetName(HWY_TARGET),
          find_met<N, T>,
          met<N, T>,
          find_first<N, T>,
          entered<N, T>,
          find_near<N, T>,
          around<N, T>,
          least_grown<N, T>};
}

}  // namespace

const AllBvhKernels& all_bvh_kernels() {
  static const AllBvhKernels all{kernels<2, float>(), kernels<3, float>(), kernels<2, double>(), kernels<3, double>()};
  return all;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::detail {
namespace {
HWY_EXPORT(all_bvh_kernels);
}

std::int64_t bvh_kernel_targets() { return HWY_TARGETS; }

template <Dim N, class T>
const BvhKernels<N, T>& bvh_kernels() {
  const AllBvhKernels& all = HWY_DYNAMIC_DISPATCH(all_bvh_kernels)();
  if constexpr (std::is_same_v<T, float>) {
    if constexpr (N == 2) return all.flat_float;
    if constexpr (N == 3) return all.solid_float;
  } else {
    if constexpr (N == 2) return all.flat_double;
    if constexpr (N == 3) return all.solid_double;
  }
}

template const BvhKernels<2, float>& bvh_kernels();
template const BvhKernels<3, float>& bvh_kernels();
template const BvhKernels<2, double>& bvh_kernels();
template const BvhKernels<3, double>& bvh_kernels();

}  // namespace graze::detail
#endif
