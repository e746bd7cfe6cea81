// SPDX-License-Identifier: MIT
// Walks a Bvh to the first box that a ray enters. Included once per instruction set, so it has no ordinary include
// guard.
#if defined(GRAZE_BROAD_BVH_RAY_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_BVH_RAY_INL_HPP
#undef GRAZE_BROAD_BVH_RAY_INL_HPP
#else
#define GRAZE_BROAD_BVH_RAY_INL_HPP
#endif

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <type_traits>

#include <hwy/highway.h>

#include <graze/broad/bvh/bvh_kernels.hpp>
#include <graze/broad/bvh/node.hpp>
#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/simd/lanes-inl.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

/// Which lanes a ray may enter before a limit, as a bit mask, given the t at which it enters and leaves their slabs.
/// Writes a lower bound of t for each.
template <class T, class Mask>
HWY_INLINE std::uint32_t lanes_entered(Lanes<T> enter, const Lanes<T>& leave, const Mask& may_be, T limit, T* soonest) {
  const Tag<T> d;
  const auto smallest = hn::Set(d, std::numeric_limits<T>::min());
  enter = hn::Min(enter, hn::Set(d, std::numeric_limits<T>::max()));
  const auto latest = hn::Add(hn::Mul(leave, hn::Set(d, T(1) + tolerance::ray_lanes<T>)), smallest);
  const auto earliest = hn::Sub(hn::Mul(enter, hn::Set(d, T(1) - tolerance::ray_lanes<T>)), smallest);
  hn::StoreU(earliest, d, soonest);
  return bits_of<T>(hn::And(may_be, hn::And(hn::Le(enter, latest), hn::Le(earliest, hn::Set(d, limit)))));
}

/// Which boxes of a block a ray may enter before a limit, as a bit mask, for slabs of any kind, and a lower bound of t
/// for each.
template <Dim N, class T>
HWY_INLINE std::uint32_t boxes_entered(const Block<N, T>& block, const BvhSlabs<N, T>& slabs, T limit, T* soonest) {
  const Tag<T> d;
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
    entered |= lanes_entered<T>(enter, leave, meets, limit, soonest + lane) << lane;
  }
  return entered;
}

/// A ray for which no special case applies.
template <Dim N, class T>
class AnyRay {
 public:
  AnyRay(const Ray<N, T>& ray, const BvhSlabs<N, T>& slabs) : ray_(ray), slabs_(slabs) {}

  HWY_INLINE std::uint32_t entered(const Block<N, T>& block, T limit, T* soonest) const {
    return boxes_entered(block, slabs_, limit, soonest);
  }

  /// The t at which the ray enters a box of a block; infinity if it misses.
  HWY_INLINE double entry(const Block<N, T>& block, std::uint32_t lane) const {
    return entry_of(ray_, box_in(block, lane)).value_or(std::numeric_limits<double>::infinity());
  }

 private:
  const Ray<N, T>& ray_;
  const BvhSlabs<N, T>& slabs_;
};

/// A ray that crosses the slabs of all boxes, as most do. The near sides are selected once, so no branch depends on the
/// direction, which is different for every ray.
template <Dim N, class T>
class CrossingRay {
 public:
  CrossingRay(const Ray<N, T>& ray, const BvhSlabs<N, T>& slabs) : slabs_(slabs) {
    for (Dim i = 0; i < N; ++i) {
      origin_[i] = static_cast<double>(ray.origin[i]);
      direction_[i] = static_cast<double>(ray.direction[i]);
      const bool is_backwards = direction_[i] < 0;
      const std::size_t row = static_cast<std::size_t>(i) * sizeof(Row);
      near_[i] = (is_backwards ? offsetof(Box, max) : offsetof(Box, min)) + row;
      far_[i] = (is_backwards ? offsetof(Box, min) : offsetof(Box, max)) + row;
    }
  }

  HWY_INLINE std::uint32_t entered(const Block<N, T>& block, T limit, T* soonest) const {
    const Tag<T> d;
    std::uint32_t entered = 0;
    for (std::uint32_t lane = 0; lane < block_size; lane += lanes_of<T>) {
      auto enter = hn::Zero(d);
      auto leave = hn::Set(d, std::numeric_limits<T>::infinity());
      for (Dim i = 0; i < N; ++i) {
        const auto origin = hn::Set(d, slabs_.origin[i]);
        const auto inverse = hn::Set(d, slabs_.inverse[i]);
        enter = hn::Max(enter, hn::Mul(hn::Sub(hn::Load(d, row(block, near_[i]) + lane), origin), inverse));
        leave = hn::Min(leave, hn::Mul(hn::Sub(hn::Load(d, row(block, far_[i]) + lane), origin), inverse));
      }
      const auto is_any = is_full<T>(hn::Load(d, block.min[0] + lane));
      entered |= lanes_entered<T>(enter, leave, is_any, limit, soonest + lane) << lane;
    }
    return entered;
  }

  /// As in AnyRay, by the operations of entry_of().
  HWY_INLINE double entry(const Block<N, T>& block, std::uint32_t lane) const {
    double enter = 0;
    double leave = std::numeric_limits<double>::infinity();
    for (Dim i = 0; i < N; ++i) {
      enter = std::max(enter, (static_cast<double>(row(block, near_[i])[lane]) - origin_[i]) / direction_[i]);
      leave = std::min(leave, (static_cast<double>(row(block, far_[i])[lane]) - origin_[i]) / direction_[i]);
    }
    return enter <= leave * (1 + tolerance::ray_slabs) ? enter : std::numeric_limits<double>::infinity();
  }

 private:
  using Box = Block<N, T>;
  using Row = T[block_size];
  static_assert(std::is_standard_layout_v<Box>);

  /// A row of coordinates at an offset in a block.
  static HWY_INLINE const T* row(const Box& block, std::size_t offset) {
    return reinterpret_cast<const T*>(reinterpret_cast<const std::byte*>(&block) + offset);
  }

  BvhSlabs<N, T> slabs_;
  double origin_[N];
  double direction_[N];
  std::size_t near_[N];
  std::size_t far_[N];
};

/// For each candidate, how many others have a smaller t, or the same t in a lower lane. Branch-free, because the order
/// is unpredictable.
template <class T>
HWY_INLINE std::size_t later_than(const T* soonest, std::uint32_t candidates, std::uint32_t one) {
  const Tag<T> d;
  const auto own = hn::Set(d, soonest[one]);
  std::uint32_t later = 0;
  std::uint32_t not_sooner = 0;
  for (std::uint32_t lane = 0; lane < block_size; lane += lanes_of<T>) {
    const auto others = hn::Load(d, soonest + lane);
    later |= bits_of<T>(hn::Gt(others, own)) << lane;
    not_sooner |= bits_of<T>(hn::Ge(others, own)) << lane;
  }
  const std::uint32_t lower = (1U << one) - 1U;
  return static_cast<std::size_t>(std::popcount(candidates & (later | (not_sooner & lower))));
}

/// Whether all coordinates are within the limit for `crossed` slabs.
template <Dim N, class T>
HWY_INLINE bool are_usual(const Block<N, T>& block) {
  const Tag<T> d;
  const auto most = hn::Set(d, most_for_slabs<T>);
  std::uint32_t beyond = 0;
  for (std::uint32_t lane = 0; lane < block_size; lane += lanes_of<T>) {
    auto is_beyond = hn::Gt(hn::Zero(d), hn::Zero(d));
    for (Dim i = 0; i < N; ++i) {  // both are numbers, or the lane is empty
      is_beyond = hn::Or(is_beyond, hn::Ge(hn::Abs(hn::Load(d, block.min[i] + lane)), most));
      is_beyond = hn::Or(is_beyond, hn::Ge(hn::Abs(hn::Load(d, block.max[i] + lane)), most));
    }
    beyond |= bits_of<T>(is_beyond);
  }
  return beyond == 0;
}

/// How many of the children that a ray enters are prefetched: the next to visit and the one after it.
constexpr std::size_t asked_ahead = 2;

/// Visits the nearest child first; skips open nodes beyond the first hit so far. HeldRay is AnyRay or CrossingRay.
template <Dim N, class T, class HeldRay>
HWY_INLINE std::size_t walk_down(const BvhNode<N, T>* nodes, BvhLink root, const HeldRay& ray,
                                 BvhFirstWalk<N, T>& walk) {
  alignas(64) T soonest[block_size];
  // The stack: the t at which the ray enters each open node, and the link's code. Two arrays, because one load of two
  // values that were just stored separately would stall.
  T open_from[bvh_path];
  std::uint32_t open[bvh_path];
  open_from[0] = 0;
  open[0] = root.code();
  std::size_t count = 1;
  std::size_t looks = 0;
  T limit = next_up(static_cast<T>(walk.t));
  while (count > 0) {
    --count;
    if (static_cast<double>(open_from[count]) > walk.t) continue;
    const BvhLink link = BvhLink::of_code(open[count]);
    const BvhNode<N, T>& node = nodes[link.index()];
    ++looks;
    const std::uint32_t entered = ray.entered(node.boxes, limit, soonest);
    if (link.is_leaf()) {
      for (std::uint32_t rest = entered; rest != 0; rest &= rest - 1) {
        const auto lane = static_cast<std::uint32_t>(std::countr_zero(rest));
        if (static_cast<double>(soonest[lane]) > walk.t) continue;
        const double t = ray.entry(node.boxes, lane);
        if (std::isinf(t) || !(t < walk.t || (t == walk.t && node.entries[lane] < walk.name.slot))) continue;
        walk.t = t;
        walk.name = node.name(lane);
      }
      limit = next_up(static_cast<T>(walk.t));
      continue;
    }
    for (std::uint32_t rest = entered; rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(rest));
      const std::size_t place = count + later_than(soonest, entered, lane);
      open_from[place] = soonest[lane];
      open[place] = node.entries[lane];
    }
    const std::size_t first = count;
    count += static_cast<std::size_t>(std::popcount(entered));
    for (std::size_t k = std::max(first + asked_ahead, count) - asked_ahead; k < count; ++k) {
      prefetch_whole(nodes + BvhLink::of_code(open[k]).index());
    }
  }
  return looks;
}

template <Dim N, class T>
HWY_INLINE std::size_t walk_to_first(const BvhNode<N, T>* nodes, BvhLink root, BvhFirstWalk<N, T>& walk) {
  auto& kinds = walk.slabs.kinds;
  if (!are_usual(nodes[root.index()].boxes)) {
    std::replace(std::begin(kinds), std::end(kinds), BvhSlab::crossed, BvhSlab::any);
  }
  if (std::all_of(std::begin(kinds), std::end(kinds), [](BvhSlab kind) { return kind == BvhSlab::crossed; })) {
    return walk_down(nodes, root, CrossingRay<N, T>(walk.ray, walk.slabs), walk);
  }
  return walk_down(nodes, root, AnyRay<N, T>(walk.ray, walk.slabs), walk);
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
