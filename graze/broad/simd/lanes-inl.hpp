// SPDX-License-Identifier: MIT
// Vectors as kernels use them. Included once for each instruction set, hence no ordinary guard.
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

/// As many lanes as the machine has, at most a block's.
template <class T>
using Tag = hn::CappedTag<T, block_size>;

template <class T>
using Lanes = hn::Vec<Tag<T>>;

template <class T>
constexpr std::uint32_t lanes_of = static_cast<std::uint32_t>(hn::MaxLanes(Tag<T>()));

/// How many vectors make a block.
template <class T>
constexpr std::uint32_t vectors_of = block_size / lanes_of<T>;

/// After the parameters of a lambda: it becomes part of its caller, however long both are.
#undef GRAZE_INLINE_LAMBDA
#define GRAZE_INLINE_LAMBDA __attribute__((always_inline))

/// use(0), use(1) ... of as many constants. What is in an array stays in registers if its places are constants before
/// anything else is done; those of a loop in a loop are not.
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

/// Of numbers that are not NaN, which Highway asks about where there are no vectors.
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

/// Which lanes of a block have a box.
template <class T>
HWY_INLINE auto is_full(const Lanes<T>& coordinate) {
  return hn::Eq(coordinate, coordinate);
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
