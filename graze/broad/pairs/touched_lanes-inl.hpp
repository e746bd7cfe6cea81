// SPDX-License-Identifier: MIT
// Which boxes of a block one box touches. Included once per instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_PAIRS_TOUCHED_LANES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_PAIRS_TOUCHED_LANES_INL_HPP
#undef GRAZE_BROAD_PAIRS_TOUCHED_LANES_INL_HPP
#else
#define GRAZE_BROAD_PAIRS_TOUCHED_LANES_INL_HPP
#endif

#include <cstdint>

#include <hwy/highway.h>

#include <graze/broad/simd/block.hpp>
#include <graze/broad/simd/lanes-inl.hpp>
#include <graze/math/vec.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

/// A box that every lane is compared with.
template <Dim N, class T>
struct OneBox {
  Lanes<T> min[N];
  Lanes<T> max[N];

  HWY_INLINE OneBox(const Block<N, T>& block, std::uint32_t lane) {
    for (Dim i = 0; i < N; ++i) {
      min[i] = hn::Set(Tag<T>(), block.min[i][lane]);
      max[i] = hn::Set(Tag<T>(), block.max[i][lane]);
    }
  }
};

#if HWY_TARGET <= HWY_AVX3

/// The lanes among `lanes` with a <= b. A masked comparison saves an And.
HWY_INLINE __mmask16 ordered_lanes(__mmask16 lanes, __m512 a, __m512 b) {
  return _mm512_mask_cmp_ps_mask(lanes, a, b, _CMP_LE_OQ);
}
HWY_INLINE __mmask8 ordered_lanes(__mmask8 lanes, __m512d a, __m512d b) {
  return _mm512_mask_cmp_pd_mask(lanes, a, b, _CMP_LE_OQ);
}

HWY_INLINE __mmask16 both(__mmask16 a, __mmask16 b) { return _kand_mask16(a, b); }
HWY_INLINE __mmask8 both(__mmask8 a, __mmask8 b) { return _kand_mask8(a, b); }

/// The lanes of a block that the box touches, as a bit mask. The result for each axis stays in a mask register.
template <Dim N, class T>
HWY_INLINE std::uint32_t touched_lanes(const OneBox<N, T>& box, const Block<N, T>& block) {
  const Tag<T> d;
  std::uint32_t touched = 0;
  for (std::uint32_t k = 0; k < vectors_of<T>; ++k) {
    const std::uint32_t at = k * lanes_of<T>;
    const auto along = [&](Dim i) {  // independent per axis, because a masked comparison waits for its mask
      const auto below = hn::Le(hn::Load(d, block.min[i] + at), box.max[i]).raw;
      return ordered_lanes(below, box.min[i].raw, hn::Load(d, block.max[i] + at).raw);
    };
    auto mask = along(0);
    for (Dim i = 1; i < N; ++i) mask = both(mask, along(i));
    touched |= std::uint32_t{mask} << at;
  }
  return touched;
}

#else

/// The lanes of a block that the box touches, as a bit mask.
template <Dim N, class T>
HWY_INLINE std::uint32_t touched_lanes(const OneBox<N, T>& box, const Block<N, T>& block) {
  const Tag<T> d;
  std::uint32_t touched = 0;
  for (std::uint32_t k = 0; k < vectors_of<T>; ++k) {
    const std::uint32_t at = k * lanes_of<T>;
    auto mask =
        hn::And(hn::Le(hn::Load(d, block.min[0] + at), box.max[0]), hn::Ge(hn::Load(d, block.max[0] + at), box.min[0]));
    for (Dim i = 1; i < N; ++i) {
      mask = hn::And(mask, hn::And(hn::Le(hn::Load(d, block.min[i] + at), box.max[i]),
                                   hn::Ge(hn::Load(d, block.max[i] + at), box.min[i])));
    }
    touched |= bits_of<T>(mask) << at;
  }
  return touched;
}

#endif

/// The lanes after `lane`.
HWY_INLINE std::uint32_t lanes_after(std::uint32_t lane) { return 0xFFFEU << lane & 0xFFFFU; }

}  // namespace
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
