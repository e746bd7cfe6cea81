// SPDX-License-Identifier: MIT
// Compiled once per instruction set: Highway includes this file anew for each.
#include <bit>

#include <graze/broad/simd_choice.hpp>
#include <graze/broad/sort_kernels.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/broad/sort_kernels.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include <graze/broad/simd_lanes-inl.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

static_assert(short_row == block_size, "a row is compared like a block");

// NOLINTNEXTLINE(readability-function-size): arrays, one by one, as the loop needs them
void place_pairs(const Pair* pairs, std::size_t count, std::uint32_t row_mask, const std::uint32_t* begins,
                 const std::uint32_t* seconds, Pair* out) {
  const Tag<std::uint32_t> d;
  for (std::size_t k = 0; k < count; ++k) {
    const Pair pair = pairs[k];
    const std::uint32_t row = pair.a & row_mask;
    const std::uint32_t begin = begins[row];
    const std::uint32_t length = begins[row + 1] - begin;
    if (HWY_UNLIKELY(length > short_row)) continue;
    const auto second = hn::Set(d, pair.b);
    std::uint32_t smaller = 0;
    for (std::uint32_t at = 0; at < short_row; at += lanes_of<std::uint32_t>) {
      smaller |= bits_of<std::uint32_t>(hn::Lt(hn::LoadU(d, seconds + begin + at), second)) << at;
    }
    const auto rank = static_cast<std::uint32_t>(std::popcount(smaller & ((1U << length) - 1U)));
    out[begin + rank] = pair;
  }
}

void place_keys(const std::int64_t* keys, std::size_t count, std::uint32_t first, Pair* out) {
  const Tag<std::int64_t> d;
  constexpr std::uint32_t before = very_short_row - 1;
  for (std::size_t k = 0; k < count; ++k) {
    const std::int64_t key = keys[k];
    const auto mine = hn::Set(d, key);
    const std::int64_t* const near = keys + k - before;
    std::uint32_t smaller = 0;
    for (std::uint32_t at = 0; at < 2 * very_short_row; at += lanes_of<std::int64_t>) {
      smaller |= bits_of<std::int64_t>(hn::Lt(hn::LoadU(d, near + at), mine)) << at;
    }
    // All before the row are smaller, all after it greater.
    const std::size_t place = k + static_cast<std::size_t>(std::popcount(smaller)) - before;
    const auto bits = static_cast<std::uint64_t>(key);
    out[place] = {first + static_cast<std::uint32_t>(bits >> 32U), static_cast<std::uint32_t>(bits)};
  }
}

}  // namespace

const SortKernels& all_sort_kernels() {
  static const SortKernels all{lanes_of<std::int64_t> >= 8, place_keys, place_pairs};
  return all;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::detail {
namespace {
HWY_EXPORT(all_sort_kernels);
}

const SortKernels& sort_kernels() { return HWY_DYNAMIC_DISPATCH(all_sort_kernels)(); }

}  // namespace graze::detail
#endif
