// SPDX-License-Identifier: MIT
// The vector types of kernels. Included once per instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_SIMD_LANES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_SIMD_LANES_INL_HPP
#undef GRAZE_BROAD_SIMD_LANES_INL_HPP
#else
#define GRAZE_BROAD_SIMD_LANES_INL_HPP
#endif

#include <algorithm>
#include <cstdint>

#include <hwy/highway.h>

#include <graze/broad/simd/block.hpp>
#include <graze/broad/simd/wasm_doubles-inl.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A vector with as many lanes as the machine has, but at most those of a block.
template <class T>
using Tag = hn::CappedTag<T, block_size>;

template <class T>
using Lanes = hn::Vec<Tag<T>>;

template <class T>
constexpr std::uint32_t lanes_of = static_cast<std::uint32_t>(hn::MaxLanes(Tag<T>()));

/// The number of vectors in a block.
template <class T>
constexpr std::uint32_t vectors_of = block_size / lanes_of<T>;

/// Placed after the parameters of a lambda: always inlines it, whatever its length.
#undef GRAZE_INLINE_LAMBDA
#ifdef __GNUC__
#define GRAZE_INLINE_LAMBDA __attribute__((always_inline))
#else
#define GRAZE_INLINE_LAMBDA
#endif

/// Calls use(0), use(1), ... with constants. Arrays stay in registers only if indices are constants early in
/// compilation, which those of nested loops are not.
template <std::size_t count, class Use>
HWY_INLINE void unrolled(const Use& use) {
  [&use]<std::size_t... i>(std::index_sequence<i...>) GRAZE_INLINE_LAMBDA {
    (use(std::integral_constant<std::size_t, i>()), ...);
  }
  (std::make_index_sequence<count>());
}

/// One bit per lane.
template <class T, class Mask>
HWY_INLINE std::uint32_t bits_of(const Mask& mask) {
  std::uint64_t bits = 0;
  hn::StoreMaskBits(Tag<T>(), mask, reinterpret_cast<std::uint8_t*>(&bits));
  return static_cast<std::uint32_t>(bits) & ((1U << lanes_of<T>)-1U);
}

/// For numbers that are not NaN, which Highway's emulation would test for.
template <class T>
HWY_INLINE Lanes<T> lesser(const Lanes<T>& a, const Lanes<T>& b) {
#if HWY_TARGET == HWY_SCALAR
  return Lanes<T>(std::min(a.raw, b.raw));
#else
  return hn::Min(a, b);
#endif
}

template <class T>
HWY_INLINE Lanes<T> greater(const Lanes<T>& a, const Lanes<T>& b) {
#if HWY_TARGET == HWY_SCALAR
  return Lanes<T>(std::max(a.raw, b.raw));
#else
  return hn::Max(a, b);
#endif
}

/// Which lanes of a block contain a box.
template <class T>
HWY_INLINE auto is_full(const Lanes<T>& coordinate) {
  return hn::Eq(coordinate, coordinate);
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
