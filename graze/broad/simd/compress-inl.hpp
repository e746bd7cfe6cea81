// SPDX-License-Identifier: MIT
// Moves selected lanes together. Included once per instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_SIMD_COMPRESS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_SIMD_COMPRESS_INL_HPP
#undef GRAZE_BROAD_SIMD_COMPRESS_INL_HPP
#else
#define GRAZE_BROAD_SIMD_COMPRESS_INL_HPP
#endif

#include <array>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include <graze/broad/simd/lanes-inl.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

// For Highway's Compress, GCC 12 copies a lookup table to the stack each time if there is no instruction.

/// The selected lanes, then the others, both in order.
template <std::size_t lanes>
constexpr std::array<std::size_t, lanes> chosen_first(std::size_t bits) {
  std::array<std::size_t, lanes> order{};
  std::size_t count = 0;
  for (const std::size_t wanted : {1U, 0U}) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if ((bits >> lane & 1U) == wanted) order[count++] = lane;
    }
  }
  return order;
}

/// A table of byte shuffles for each selection of lanes, for vectors of at most sixteen bytes.
template <std::size_t lanes, std::size_t bytes>
constexpr auto make_byte_orders() {
  std::array<std::array<std::uint8_t, 16>, std::size_t{1} << lanes> orders{};
  for (std::size_t bits = 0; bits < orders.size(); ++bits) {
    const auto order = chosen_first<lanes>(bits);
    for (std::size_t k = 0; k < lanes * bytes; ++k) {
      orders[bits][k] = static_cast<std::uint8_t>(order[k / bytes] * bytes + k % bytes);
    }
  }
  return orders;
}

template <std::size_t lanes, std::size_t bytes>
alignas(16) inline constexpr auto byte_orders = make_byte_orders<lanes, bytes>();

/// A table of shuffles for each selection of eight lanes: four bits per index, the first lowest.
template <std::size_t lanes>
constexpr auto make_word_orders() {
  constexpr std::size_t words = 8 / lanes;
  std::array<std::uint32_t, std::size_t{1} << lanes> orders{};
  for (std::size_t bits = 0; bits < orders.size(); ++bits) {
    const auto order = chosen_first<lanes>(bits);
    for (std::size_t k = 0; k < 8; ++k) {
      orders[bits] |= static_cast<std::uint32_t>(order[k / words] * words + k % words) << 4 * k;
    }
  }
  return orders;
}

template <std::size_t lanes>
inline constexpr auto word_orders = make_word_orders<lanes>();

#if HWY_TARGET <= HWY_AVX3

/// Moves the lanes whose bits are set to the front, in order. The lanes behind them are unspecified.
template <class D>
class ToFront {
 public:
  HWY_INLINE explicit ToFront(std::uint32_t chosen) : mask_{static_cast<decltype(hn::Mask<D>::raw)>(chosen)} {}

  HWY_INLINE hn::Vec<D> operator()(hn::Vec<D> lanes) const {
    if constexpr (sizeof(hn::TFromD<D>) == 8) {
      return hn::Vec<D>{_mm512_maskz_compress_pd(mask_.raw, lanes.raw)};
    } else {
      return hn::Compress(lanes, mask_);
    }
  }

 private:
  hn::Mask<D> mask_;
};

#elif HWY_TARGET == HWY_SCALAR

template <class D>
class ToFront {
 public:
  HWY_INLINE explicit ToFront(std::uint32_t /*chosen*/) {}
  HWY_INLINE hn::Vec<D> operator()(hn::Vec<D> lane) const { return lane; }
};

#else

template <class D>
class ToFront {
 public:
  HWY_INLINE explicit ToFront(std::uint32_t chosen) {
    if constexpr (width == 32) {
      alignas(32) static constexpr std::uint32_t shifts[] = {0, 4, 8, 12, 16, 20, 24, 28};
      const auto digits = hn::Shr(hn::Set(Words(), word_orders<count>[chosen]), hn::Load(Words(), shifts));
      order_ = hn::BitCast(Bytes(), hn::And(digits, hn::Set(Words(), 7U)));
    } else if constexpr (count > 1) {
      order_ = hn::Load(Bytes(), byte_orders<count, sizeof(hn::TFromD<D>)>[chosen].data());
    }
  }

  HWY_INLINE hn::Vec<D> operator()(hn::Vec<D> lanes) const {
    if constexpr (width == 32) {
      const auto order = hn::IndicesFromVec(Words(), hn::BitCast(Words(), order_));
      return hn::BitCast(D(), hn::TableLookupLanes(hn::BitCast(Words(), lanes), order));
    } else if constexpr (count > 1) {
      return hn::BitCast(D(), hn::TableLookupBytes(hn::BitCast(Bytes(), lanes), order_));
    } else {
      return lanes;
    }
  }

 private:
  static constexpr std::size_t count = hn::MaxLanes(D());
  static constexpr std::size_t width = count * sizeof(hn::TFromD<D>);
  using Words = hn::Repartition<std::uint32_t, D>;
  using Bytes = hn::Repartition<std::uint8_t, D>;

  hn::Vec<Bytes> order_;
};

#endif

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
