// SPDX-License-Identifier: MIT
// Compiled once per instruction set: Highway includes this file again for each.
#include <algorithm>
#include <bit>
#include <limits>
#include <type_traits>

#include <graze/broad/bvh/bvh_kernels.hpp>
#include <graze/broad/simd/choice.hpp>
#include <graze/broad/spatial_index.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/broad/bvh/bvh_kernels.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include <graze/broad/bvh/near-inl.hpp>
#include <graze/broad/bvh/ray-inl.hpp>
#include <graze/broad/simd/compress-inl.hpp>
#include <graze/broad/simd/lanes-inl.hpp>

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

/// Writes the entries whose bits are set contiguously, followed by up to sixteen unspecified numbers.
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
void find_overlapping(const BvhNode<N, T>* nodes, BvhMetWalk<N, T>& walk) {
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
std::uint32_t entered(const Block<N, T>& block, const BvhSlabs<N, T>& slabs, T* soonest) {
  return boxes_entered(block, slabs, std::numeric_limits<T>::infinity(), soonest);
}

template <Dim N, class T>
std::size_t find_first(const BvhNode<N, T>* nodes, BvhLink root, BvhFirstWalk<N, T>& walk) {
  return walk_to_first(nodes, root, walk);
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

/// The index of the least of sixteen numbers, among the lanes in the mask `candidates`.
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
  // Sums that overflow become the largest number: Highway's emulation finds no minimum among infinities.
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
          find_overlapping<N, T>,
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
  return HWY_DYNAMIC_DISPATCH(all_bvh_kernels)().template of<N, T>();
}

template const BvhKernels<2, float>& bvh_kernels();
template const BvhKernels<3, float>& bvh_kernels();
template const BvhKernels<2, double>& bvh_kernels();
template const BvhKernels<3, double>& bvh_kernels();

}  // namespace graze::detail
#endif
