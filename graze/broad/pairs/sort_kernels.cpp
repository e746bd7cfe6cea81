// SPDX-License-Identifier: MIT
// Compiled once per instruction set: Highway includes this file again for each.
#include <algorithm>
#include <bit>
#include <cstddef>
#include <iterator>

#include <graze/broad/pairs/sort_kernels.hpp>
#include <graze/broad/simd/choice.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/broad/pairs/sort_kernels.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include <graze/broad/simd/lanes-inl.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

static_assert(short_row == block_size, "a row is compared like a block");

template <class Code>
// NOLINTNEXTLINE(readability-function-size): arrays, one by one, as the loop needs them
void place_codes(const Code* codes, std::size_t count, const CodeBucket& bucket, const std::uint32_t* begins,
                 const std::uint32_t* seconds, Pair* out) {
  const Tag<std::uint32_t> d;
  const PairCode code = bucket.code;
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint32_t row = code.row_of(codes[k]);
    const std::uint32_t begin = begins[row];
    const std::uint32_t length = begins[row + 1] - begin;
    if (HWY_UNLIKELY(length > short_row)) continue;
    const Pair pair{bucket.first + row, code.second_of(codes[k])};
    const auto second = hn::Set(d, pair.b);
    std::uint32_t smaller = 0;
    for (std::uint32_t at = 0; at < short_row; at += lanes_of<std::uint32_t>) {
      smaller |= bits_of<std::uint32_t>(hn::Lt(hn::LoadU(d, seconds + begin + at), second)) << at;
    }
    const auto rank = static_cast<std::uint32_t>(std::popcount(smaller & ((1U << length) - 1U)));
    out[begin + rank] = pair;
  }
}

template <class Code>
void place_keys(const Code* codes, std::size_t count, const CodeBucket& bucket, Pair* out) {
  const Tag<Code> d;
  const PairCode form = bucket.code;
  constexpr std::uint32_t before = very_short_row - 1;
  for (std::size_t k = 0; k < count; ++k) {
    const Code code = codes[k];
    const auto mine = hn::Set(d, code);
    const Code* const near = codes + k - before;
    std::uint32_t smaller = 0;
    for (std::uint32_t at = 0; at < 2 * very_short_row; at += lanes_of<Code>) {
      smaller |= bits_of<Code>(hn::Lt(hn::LoadU(d, near + at), mine)) << at;
    }
    // All numbers before the row are smaller, all after it greater.
    const std::size_t place = k + static_cast<std::size_t>(std::popcount(smaller)) - before;
    out[place] = {bucket.first + form.row_of(code), form.second_of(code)};
  }
}

template <class Code>
constexpr CodeKernels<Code> code_kernels{lanes_of<Code> >= 8, place_keys<Code>, place_codes<Code>};

#if HWY_TARGET <= HWY_AVX3

constexpr std::uint32_t row_lanes = 16;
using Row = hn::CappedTag<std::uint32_t, row_lanes>;

/// One step of a sorting network: the partner of each lane, and which lanes take the greater number.
struct Step {
  alignas(64) std::uint32_t partner[row_lanes];
  __mmask16 upper;
};

constexpr Step step_by(std::uint32_t difference) {
  Step step{};
  for (std::uint32_t lane = 0; lane < row_lanes; ++lane) {
    step.partner[lane] = lane ^ difference;
    if (step.partner[lane] < lane) step.upper |= static_cast<__mmask16>(1U << lane);
  }
  return step;
}

/// The steps of the bitonic sorter (Batcher 1968, "Sorting networks and their applications") for sixteen numbers, with
/// ascending runs only: each merge begins by comparing a run with the reversed next one. The last four steps sort a
/// bitonic sequence.
constexpr Step steps[] = {step_by(1), step_by(3), step_by(1), step_by(7), step_by(2), step_by(1), step_by(15),
                          step_by(4), step_by(2), step_by(1), step_by(8), step_by(4), step_by(2), step_by(1)};
constexpr std::uint32_t steps_to_sort = 10;

HWY_INLINE __m512i take(const Step& step, __m512i row) {
  const __m512i other = _mm512_permutexvar_epi32(hn::Load(Row(), step.partner).raw, row);
  return _mm512_mask_max_epu32(_mm512_min_epu32(row, other), step.upper, row, other);
}

HWY_INLINE __m512i turned_around(__m512i row) {
  static constexpr Step ends = step_by(row_lanes - 1);
  return _mm512_permutexvar_epi32(hn::Load(Row(), ends.partner).raw, row);
}

/// Some numbers, ascending; unused lanes hold the maximum.
HWY_INLINE __m512i sorted_lanes(const std::uint32_t* numbers, std::uint32_t filled) {
  __m512i row = _mm512_mask_loadu_epi32(_mm512_set1_epi32(-1), static_cast<__mmask16>(filled), numbers);
  for (std::uint32_t k = 0; k < steps_to_sort; ++k) row = take(steps[k], row);
  return row;
}

HWY_INLINE __m512i merged_lanes(__m512i row) {
  for (std::uint32_t k = steps_to_sort; k < std::size(steps); ++k) row = take(steps[k], row);
  return row;
}

/// Writes the pairs of one first index with up to sixteen second ones, of which the first `count` are valid. Stores all
/// sixteen if they fit before `end`.
HWY_INLINE void write_row(std::uint32_t first, __m512i seconds, std::uint32_t filled, Pair* out, const Pair* end) {
  alignas(64) static constexpr std::uint32_t in_turns[] = {0,  16, 1,  17, 2,  18, 3,  19, 4,  20, 5,
                                                           21, 6,  22, 7,  23, 8,  24, 9,  25, 10, 26,
                                                           11, 27, 12, 28, 13, 29, 14, 30, 15, 31};
  const __m512i firsts = _mm512_set1_epi32(static_cast<int>(first));
  const __m512i low = _mm512_permutex2var_epi32(firsts, hn::Load(Row(), in_turns).raw, seconds);
  const __m512i high = _mm512_permutex2var_epi32(firsts, hn::Load(Row(), in_turns + row_lanes).raw, seconds);
  constexpr std::uint32_t half = row_lanes / 2;
  if (HWY_LIKELY(end - out >= std::ptrdiff_t{row_lanes})) {
    _mm512_storeu_si512(out, low);
    _mm512_storeu_si512(out + half, high);
  } else {
    _mm512_mask_storeu_epi64(out, static_cast<__mmask8>(filled), low);
    _mm512_mask_storeu_epi64(out + half, static_cast<__mmask8>(filled >> half), high);
  }
}

// NOLINTNEXTLINE(readability-function-size): arrays, one by one, as the loop needs them
void place_rows(const std::uint32_t* begins, std::uint32_t rows, std::uint32_t first, const std::uint32_t* seconds,
                Pair* out) {
  const Pair* const end = out + begins[rows];
  for (std::uint32_t row = 0; row < rows; ++row) {
    const std::uint32_t begin = begins[row];
    const std::uint32_t length = begins[row + 1] - begin;
    if (HWY_UNLIKELY(length > placed_row)) continue;
    const auto filled = static_cast<std::uint32_t>((std::uint64_t{1} << length) - 1);
    __m512i lower = sorted_lanes(seconds + begin, filled);
    if (HWY_UNLIKELY(length > row_lanes)) {
      const __m512i turned = turned_around(sorted_lanes(seconds + begin + row_lanes, filled >> row_lanes));
      const __m512i upper = merged_lanes(_mm512_max_epu32(lower, turned));
      lower = merged_lanes(_mm512_min_epu32(lower, turned));
      write_row(first + row, lower, filled, out + begin, end);
      write_row(first + row, upper, filled >> row_lanes, out + begin + row_lanes, end);
    } else {
      write_row(first + row, lower, filled, out + begin, end);
    }
  }
}

constexpr bool rows_pay = true;

#else

// NOLINTNEXTLINE(readability-function-size): as above
void place_rows(const std::uint32_t* begins, std::uint32_t rows, std::uint32_t first, const std::uint32_t* seconds,
                Pair* out) {
  for (std::uint32_t row = 0; row < rows; ++row) {
    const std::uint32_t* const end = seconds + begins[row + 1];
    if (begins[row + 1] - begins[row] > placed_row) continue;
    for (const std::uint32_t* one = seconds + begins[row]; one != end; ++one) {
      const auto rank = std::count_if(seconds + begins[row], end, [one](std::uint32_t other) { return other < *one; });
      out[begins[row] + static_cast<std::uint32_t>(rank)] = {first + row, *one};
    }
  }
}

constexpr bool rows_pay = false;

#endif

}  // namespace

const SortKernels& all_sort_kernels() {
  static const SortKernels all{code_kernels<std::int32_t>, code_kernels<std::int64_t>, rows_pay, place_rows};
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
