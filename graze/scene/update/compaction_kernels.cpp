// SPDX-License-Identifier: MIT
// Compiled once for each instruction set: Highway includes this file repeatedly.
#include <bit>
#include <cstddef>
#include <cstdint>

#include <graze/broad/simd/choice.hpp>
#include <graze/scene/update/compaction_kernels.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/scene/update/compaction_kernels.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include <graze/broad/simd/compress-inl.hpp>
#include <graze/broad/simd/lanes-inl.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

static_assert(room_behind_chosen >= lanes_of<std::uint32_t> && room_behind_chosen >= lanes_of<double>);

/// A bit mask of the marks in a block.
HWY_INLINE std::uint32_t marked(const char* marks) {
  std::uint32_t bits = 0;
  for (std::uint32_t at = 0; at < block_size; at += lanes_of<std::uint8_t>) {
    const Tag<std::uint8_t> d;
    const auto bytes = hn::LoadU(d, reinterpret_cast<const std::uint8_t*>(marks) + at);
    bits |= bits_of<std::uint8_t>(hn::Ne(bytes, hn::Zero(d))) << at;
  }
  return bits;
}

/// Writes the selected numbers of a block, and some beyond; `numbers_at` returns a vector of them. Returns the end.
template <class T, class NumbersAt>
HWY_INLINE T* write_chosen(std::uint32_t chosen, const NumbersAt& numbers_at, T* to) {
  const Tag<T> d;
  for (std::uint32_t at = 0; at < block_size; at += lanes_of<T>) {
    const std::uint32_t some = chosen >> at & ((1U << lanes_of<T>)-1U);
    hn::StoreU(ToFront<Tag<T>>(some)(numbers_at(at)), d, to);
    to += std::popcount(some);
  }
  return to;
}

std::size_t choose(const Pair* pairs, const char* marks, std::size_t count, Pair* chosen, std::uint32_t* places) {
  static_assert(sizeof(Pair) == sizeof(double));  // never used in arithmetic
  const auto* const numbers = reinterpret_cast<const double*>(pairs);
  auto* pair_to = reinterpret_cast<double*>(chosen);
  std::uint32_t* place_to = places;
  const auto first_places =
      hn::Iota(Tag<std::uint32_t>(), 0);  // with any other start GCC generates the numbers one by one
  const std::size_t blocks = count / block_size * block_size;
  for (std::size_t k = 0; k < blocks; k += block_size) {
    const std::uint32_t bits = marked(marks + k);
    const auto pairs_at = [&](std::uint32_t at) { return hn::LoadU(Tag<double>(), numbers + k + at); };
    const auto places_at = [&](std::uint32_t at) {
      return hn::Add(first_places, hn::Set(Tag<std::uint32_t>(), static_cast<std::uint32_t>(k) + at));
    };
    pair_to = write_chosen(bits, pairs_at, pair_to);
    place_to = write_chosen(bits, places_at, place_to);
  }
  auto number = static_cast<std::size_t>(place_to - places);
  for (std::size_t k = blocks; k < count; ++k) {
    chosen[number] = pairs[k];
    places[number] = static_cast<std::uint32_t>(k);
    number += marks[k] != 0 ? 1 : 0;
  }
  return number;
}

}  // namespace

const CompactionKernels& all_compaction_kernels() {
  static const CompactionKernels all{choose};
  return all;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::detail {
namespace {
HWY_EXPORT(all_compaction_kernels);
}

const CompactionKernels& compaction_kernels() { return HWY_DYNAMIC_DISPATCH(all_compaction_kernels)(); }

}  // namespace graze::detail
#endif
