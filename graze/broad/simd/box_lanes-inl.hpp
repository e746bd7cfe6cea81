// SPDX-License-Identifier: MIT
// Loads consecutive boxes into one vector per coordinate. Included once per instruction set, so it has no ordinary
// include guard.
#if defined(GRAZE_BROAD_SIMD_BOX_LANES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_SIMD_BOX_LANES_INL_HPP
#undef GRAZE_BROAD_SIMD_BOX_LANES_INL_HPP
#else
#define GRAZE_BROAD_SIMD_BOX_LANES_INL_HPP
#endif

#include <cstdint>
#include <type_traits>

#include <hwy/highway.h>

#include <graze/broad/simd/lanes-inl.hpp>
#include <graze/shape/aabb.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

/// One coordinate of consecutive boxes in each vector.
template <Dim N, class T>
struct BoxLanes {
  Lanes<T> min[N];
  Lanes<T> max[N];
};

/// For half as many boxes as lanes: ends[i] holds min and max along axis i alternately.
template <class T>
HWY_INLINE void load_ends(const T* box, Lanes<T> (&ends)[2]) {
  hn::LoadInterleaved2(Tag<T>(), box, ends[0], ends[1]);
}
template <class T>
HWY_INLINE void load_ends(const T* box, Lanes<T> (&ends)[3]) {
  hn::LoadInterleaved3(Tag<T>(), box, ends[0], ends[1], ends[2]);
}

/// Loads one box per lane, starting at `boxes`. Loads and shuffles: a gather takes several times as long on most
/// machines.
template <Dim N, class T>
HWY_INLINE BoxLanes<N, T> load_boxes(const Aabb<N, T>* boxes) {
  static_assert(sizeof(Aabb<N, T>) == std::size_t{2} * N * sizeof(T));
  const Tag<T> d;
  BoxLanes<N, T> result;
  const T* const first = &boxes->min[0];
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_WASM
  using Index = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
  const hn::RebindToSigned<Tag<T>> di;
  const auto box = hn::Mul(hn::Iota(di, Index{0}), hn::Set(di, Index{2 * N}));
  for (Dim i = 0; i < N; ++i) {
    result.min[i] = hn::GatherIndex(d, first + i, box);
    result.max[i] = hn::GatherIndex(d, first + N + i, box);
  }
#else
  Lanes<T> low[N];
  Lanes<T> high[N];
  load_ends(first, low);
  load_ends(first + N * lanes_of<T>, high);
  for (Dim i = 0; i < N; ++i) {
    result.min[i] = hn::ConcatEven(d, high[i], low[i]);
    result.max[i] = hn::ConcatOdd(d, high[i], low[i]);
  }
#endif
  return result;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
