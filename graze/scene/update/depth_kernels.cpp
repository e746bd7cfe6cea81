// SPDX-License-Identifier: MIT
// Compiled once for each instruction set: Highway includes this file repeatedly.
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/simd/choice.hpp>
#include <graze/scene/update/box_depth.hpp>
#include <graze/scene/update/depth_kernels.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/scene/update/depth_kernels.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include <graze/broad/simd/lanes-inl.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

/// One bit for each of some pairs: `deep` if its depth is above `certain`; `settled` if it is deep, below -certain, or
/// NaN.
struct DepthBits {
  std::uint32_t deep;
  std::uint32_t settled;
};

HWY_INLINE DepthBits bits_of_depth(float depth, float certain) {
  const std::uint32_t deep = depth > certain ? 1 : 0;
  return {deep, deep | (depth >= -certain ? 0U : 1U)};
}

template <Dim N>
HWY_INLINE DepthBits depth_bits(const Aabb<N, float>* boxes, const Pair& pair, float certain) {
  return bits_of_depth(box_depth(boxes[pair.a], boxes[pair.b]), certain);
}

#if HWY_TARGET == HWY_SCALAR

inline constexpr std::size_t pairs_at_once = 1;

template <Dim N>
HWY_INLINE DepthBits next_depth_bits(const Aabb<N, float>* boxes, const Pair* pairs, float certain) {
  return depth_bits<N>(boxes, *pairs, certain);
}

#else

inline constexpr std::size_t pairs_at_once = 4;

using Four = hn::FixedTag<float, 4>;
using FourLanes = hn::Vec<Four>;

/// A vector whose lane i is the minimum of x and y of the i-th argument.
HWY_INLINE FourLanes least_of_first_two(FourLanes a, FourLanes b, FourLanes c, FourLanes d) {
  const Four tag;
  const auto low = hn::InterleaveLower(tag, a, b);
  const auto high = hn::InterleaveLower(tag, c, d);
  return hn::Min(hn::ConcatLowerLower(tag, high, low), hn::ConcatUpperUpper(tag, high, low));
}

/// The depths of a pair's boxes along each axis. The fourth lane is unspecified.
HWY_INLINE FourLanes along_axes(const Aabb<3, float>* boxes, const Pair& pair) {
  const Four d;
  const Aabb<3, float>& a = boxes[pair.a];
  const Aabb<3, float>& b = boxes[pair.b];
  return hn::Min(hn::Sub(hn::LoadU(d, &a.max.x), hn::LoadU(d, &b.min.x)),
                 hn::Sub(hn::LoadU(d, &b.max.x), hn::LoadU(d, &a.min.x)));
}

HWY_INLINE FourLanes four_depths(const Aabb<3, float>* boxes, const Pair* pairs) {
  const Four d;
  const auto first = along_axes(boxes, pairs[0]);
  const auto second = along_axes(boxes, pairs[1]);
  const auto third = along_axes(boxes, pairs[2]);
  const auto fourth = along_axes(boxes, pairs[3]);
  const auto low_z = hn::InterleaveUpper(d, first, second);
  const auto high_z = hn::InterleaveUpper(d, third, fourth);
  return hn::Min(least_of_first_two(first, second, third, fourth), hn::ConcatLowerLower(d, high_z, low_z));
}

/// The first box's max minus the second's min, x and y, and vice versa.
HWY_INLINE FourLanes both_ways(const Aabb<2, float>* boxes, const Pair& pair) {
  const Four d;
  const auto a = hn::LoadU(d, &boxes[pair.a].min.x);
  const auto b = hn::LoadU(d, &boxes[pair.b].min.x);
  const auto max_and_max = hn::ConcatUpperUpper(d, b, a);
  const auto min_and_min = hn::ConcatLowerLower(d, a, b);
  return hn::Sub(max_and_max, min_and_min);
}

HWY_INLINE FourLanes four_depths(const Aabb<2, float>* boxes, const Pair* pairs) {
  const Four d;
  const auto first = both_ways(boxes, pairs[0]);
  const auto second = both_ways(boxes, pairs[1]);
  const auto third = both_ways(boxes, pairs[2]);
  const auto fourth = both_ways(boxes, pairs[3]);
  const auto low = hn::InterleaveUpper(d, first, second);
  const auto high = hn::InterleaveUpper(d, third, fourth);
  const auto back = hn::Min(hn::ConcatLowerLower(d, high, low), hn::ConcatUpperUpper(d, high, low));
  return hn::Min(least_of_first_two(first, second, third, fourth), back);
}

template <Dim N>
HWY_INLINE DepthBits next_depth_bits(const Aabb<N, float>* boxes, const Pair* pairs, float certain) {
  const Four d;
  const auto depths = four_depths(boxes, pairs);
  const auto mask_bits = [](const auto& mask) HWY_ATTR {
    std::uint64_t bits = 0;
    hn::StoreMaskBits(Four(), mask, reinterpret_cast<std::uint8_t*>(&bits));
    return static_cast<std::uint32_t>(bits) & 15U;
  };
  const std::uint32_t deep = mask_bits(hn::Gt(depths, hn::Set(d, certain)));
  const std::uint32_t not_apart = mask_bits(hn::Ge(depths, hn::Set(d, -certain)));
  return {deep, deep | (not_apart ^ 15U)};
}

#endif

/// Stores bits as bytes, 0 or 1, and lists the positions of unsettled pairs, which are few.
template <std::size_t count>
HWY_INLINE std::size_t note(const DepthBits& bits, std::size_t place, char* touches, std::size_t* open) {
  static_assert(count == 1 || count == 4);
  const std::uint32_t bytes = bits.deep * 0x00204081U & 0x01010101U;
  std::memcpy(touches, &bytes, count);
  std::uint32_t rest = bits.settled ^ ((1U << count) - 1U);
  std::size_t number = 0;
  for (; HWY_UNLIKELY(rest != 0); rest &= rest - 1) {
    open[number++] = place + static_cast<std::size_t>(std::countr_zero(rest));
  }
  return number;
}

template <Dim N>
// NOLINTNEXTLINE(readability-function-size): input and output arrays
std::size_t judge(const Aabb<N, float>* boxes, std::size_t boxes_in_row, const Pair* pairs, std::size_t count,
                  float certain, char* touches, std::size_t* open) {
  const bool asks_ahead = boxes_in_row * sizeof *boxes > bytes_near;
  std::size_t number = 0;
  std::size_t k = 0;
  for (; k + pairs_at_once <= count; k += pairs_at_once) {
    if (asks_ahead && k + pairs_at_once + prefetch_distance <= count) {
      for (std::size_t i = 0; i < pairs_at_once; ++i) prefetch(&boxes[pairs[k + i + prefetch_distance].b]);
    }
    number += note<pairs_at_once>(next_depth_bits<N>(boxes, pairs + k, certain), k, touches + k, open + number);
  }
  for (; k < count; ++k) number += note<1>(depth_bits<N>(boxes, pairs[k], certain), k, touches + k, open + number);
  return number;
}

}  // namespace

const AllDepthKernels& all_depth_kernels() {
  static const AllDepthKernels all{{judge<2>}, {judge<3>}};
  return all;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::detail {
namespace {
HWY_EXPORT(all_depth_kernels);
}

template <Dim N>
const DepthKernels<N>& depth_kernels() {
  const AllDepthKernels& all = HWY_DYNAMIC_DISPATCH(all_depth_kernels)();
  if constexpr (N == 2) {
    return all.flat;
  } else {
    return all.solid;
  }
}

template const DepthKernels<2>& depth_kernels<2>();
template const DepthKernels<3>& depth_kernels<3>();

}  // namespace graze::detail
#endif
