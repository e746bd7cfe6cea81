// SPDX-License-Identifier: MIT
// The codes and the bounds of many boxes. Included once per instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_ORTHTREE_CODES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_ORTHTREE_CODES_INL_HPP
#undef GRAZE_BROAD_ORTHTREE_CODES_INL_HPP
#else
#define GRAZE_BROAD_ORTHTREE_CODES_INL_HPP
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <hwy/highway.h>

#include <graze/broad/index/box_cover.hpp>
#include <graze/broad/orthtree/code.hpp>
#include <graze/broad/simd/box_lanes-inl.hpp>
#include <graze/broad/simd/lanes-inl.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

/// spread_bits for every lane.
template <Dim N, class D>
HWY_INLINE hn::Vec<D> spread_lanes(D d, hn::Vec<D> bits) {
  if constexpr (N == 2) {
    bits = hn::And(hn::Or(bits, hn::ShiftLeft<8>(bits)), hn::Set(d, 0x00FF'00FFU));
    bits = hn::And(hn::Or(bits, hn::ShiftLeft<4>(bits)), hn::Set(d, 0x0F0F'0F0FU));
    bits = hn::And(hn::Or(bits, hn::ShiftLeft<2>(bits)), hn::Set(d, 0x3333'3333U));
    return hn::And(hn::Or(bits, hn::ShiftLeft<1>(bits)), hn::Set(d, 0x5555'5555U));
  } else {
    bits = hn::And(hn::Or(bits, hn::ShiftLeft<16>(bits)), hn::Set(d, 0x0300'00FFU));
    bits = hn::And(hn::Or(bits, hn::ShiftLeft<8>(bits)), hn::Set(d, 0x0300'F00FU));
    bits = hn::And(hn::Or(bits, hn::ShiftLeft<4>(bits)), hn::Set(d, 0x030C'30C3U));
    return hn::And(hn::Or(bits, hn::ShiftLeft<2>(bits)), hn::Set(d, 0x0924'9249U));
  }
}

/// The codes of the centers of one vector of boxes, starting at an index.
template <Dim N>
HWY_INLINE void code_lanes(const Aabb<N, float>* boxes, std::uint32_t index, const CodeScale<N, float>& scale,
                           CodedBox* coded) {
  const Tag<float> d;
  const hn::RebindToSigned<Tag<float>> signed_tag;
  const hn::RebindToUnsigned<Tag<float>> numbers;
  const BoxLanes<N, float> lanes = load_boxes(boxes);
  const auto half = hn::Set(d, 0.5F);
  auto code = hn::Zero(numbers);
  for (Dim i = 0; i < N; ++i) {
    const auto center = hn::Add(hn::Mul(lanes.min[i], half), hn::Mul(lanes.max[i], half));
    const auto along = hn::Add(hn::Mul(hn::Sub(center, hn::Set(d, scale.center[i])), hn::Set(d, scale.cells_per_unit)),
                               hn::Set(d, scale.middle));
    const auto positive = hn::IfThenElse(hn::Gt(along, hn::Zero(d)), along, hn::Zero(d));
    const auto last = hn::Set(d, scale.last);
    const auto within = hn::IfThenElse(hn::Lt(positive, last), positive, last);
    const auto cell = hn::BitCast(numbers, hn::ConvertTo(signed_tag, within));
    code = hn::Or(code, i == 0   ? spread_lanes<N>(numbers, cell)
                        : i == 1 ? hn::ShiftLeft<1>(spread_lanes<N>(numbers, cell))
                                 : hn::ShiftLeft<2>(spread_lanes<N>(numbers, cell)));
  }
  static_assert(sizeof(CodedBox) == 2 * sizeof(std::uint32_t));
  hn::StoreInterleaved2(hn::Iota(numbers, index), code, numbers, &coded->index);
}

template <Dim N, class T>
void code_boxes(const Aabb<N, T>* boxes, std::size_t count, const CodeScale<N, T>& scale, CodedBox* coded) {
  std::size_t at = 0;
  if constexpr (std::is_same_v<T, float>) {
    for (; at + lanes_of<T> <= count; at += lanes_of<T>) {
      code_lanes(boxes + at, static_cast<std::uint32_t>(at), scale, coded + at);
    }
  }
  for (; at < count; ++at) {
    coded[at] = {static_cast<std::uint32_t>(at), code_of(boxes[at].min * T(0.5) + boxes[at].max * T(0.5), scale)};
  }
}

template <Dim N, class T>
Aabb<N, T> bounds_of_finite(const Aabb<N, T>* boxes, std::size_t count) {
  const Tag<T> d;
  constexpr T infinity = std::numeric_limits<T>::infinity();
  Lanes<T> low[N];
  Lanes<T> high[N];
  for (Dim i = 0; i < N; ++i) {
    low[i] = hn::Set(d, infinity);
    high[i] = hn::Set(d, -infinity);
  }
  auto is_sound = hn::Eq(low[0], low[0]);
  std::size_t at = 0;
  for (; at + lanes_of<T> <= count; at += lanes_of<T>) {
    const BoxLanes<N, T> lanes = load_boxes(boxes + at);
    for (Dim i = 0; i < N; ++i) {
      is_sound = hn::And(is_sound, hn::Le(lanes.min[i], lanes.max[i]));
      low[i] = lesser<T>(lanes.min[i], low[i]);
      high[i] = greater<T>(lanes.max[i], high[i]);
    }
  }
  Aabb<N, T> bounds;
  bool is_finite = bits_of<T>(is_sound) == (1U << lanes_of<T>)-1U;
  for (Dim i = 0; i < N; ++i) {
    bounds.min[i] = hn::GetLane(hn::MinOfLanes(d, low[i]));
    bounds.max[i] = hn::GetLane(hn::MaxOfLanes(d, high[i]));
  }
  for (; at < count; ++at) {
    is_finite = is_finite && is_finite_box(boxes[at]);
    grow_at_once(bounds, boxes[at]);
  }
  return is_finite && is_finite_box(bounds) ? bounds : Aabb<N, T>::nothing();
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
