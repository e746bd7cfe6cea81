// SPDX-License-Identifier: MIT
// Compiled once per instruction set: Highway includes this file again for each.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include <graze/broad/pairs/overlap_kernels.hpp>
#include <graze/broad/simd/choice.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/broad/pairs/overlap_kernels.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include <graze/broad/pairs/pair_writer-inl.hpp>
#include <graze/broad/pairs/touched_lanes-inl.hpp>
#include <graze/broad/simd/lanes-inl.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

/// Writes the pairs of one box with lanes of a block, whose first box is `base`. Vector code stores a whole block's
/// worth.
template <class Two>
HWY_INLINE Two* write_row(std::uint32_t box, std::uint32_t base, std::uint32_t lanes, Two* out) {
#if HWY_TARGET <= HWY_AVX3
  static_assert(sizeof(Two) == sizeof(std::uint64_t) && std::endian::native == std::endian::little);
  const hn::CappedTag<std::uint64_t, block_size / 2> d;
  const auto first = hn::Set(d, box | std::uint64_t{base} << 32U);
  for (std::uint32_t half = 0; half < 2; ++half, lanes >>= block_size / 2) {
    const auto bits = static_cast<std::uint8_t>(lanes);
    const auto lane = hn::ShiftLeft<32>(hn::Iota(d, std::uint64_t{half} * (block_size / 2)));
    // Uses the intrinsic: for Highway's Compress, GCC copies a table of 2 KiB to the stack each time.
    _mm512_storeu_si512(out, _mm512_maskz_compress_epi64(bits, hn::Add(first, lane).raw));
    out += std::popcount(bits);
  }
#else
  for (; lanes != 0; lanes &= lanes - 1) {
    *out++ = {box, base + static_cast<std::uint32_t>(std::countr_zero(lanes))};
  }
#endif
  return out;
}

/// Lists the boxes of a that may touch boxes of b, for some pairs of blocks. Lists all boxes of a block paired with
/// itself, or if the other block's bounds are unknown.
template <Dim N, class T>
HWY_INLINE void list_rows(const Block<N, T>* a, const Block<N, T>* above, bool itself, std::span<const BlockPair> pairs,
                          RowList& list) {
  for (const auto [at_a, at_b] : pairs) {
    std::uint32_t rows = 0xFFFFU;
    if (above != nullptr && !(itself && at_a == at_b)) {
      rows = touched_lanes(OneBox<N, T>(above[at_b / block_size], at_b % block_size), a[at_a]);
    }
    add_rows(at_a, at_b, rows, list);
  }
}

template <Dim N, class T>
// NOLINTNEXTLINE(readability-function-size): arrays, one by one, as the loop needs them
std::size_t descend_pairs(const Block<N, T>* a, const Block<N, T>* b, const Block<N, T>* above, bool itself,
                          const BlockPair* pairs, std::size_t count, BlockPair* out) {
  BlockPair* next = out;
  RowList candidates;
  for (std::size_t first = 0; first < count; first += block_pairs_at_once) {
    candidates.count = 0;
    list_rows(a, above, itself, {pairs + first, std::min<std::size_t>(block_pairs_at_once, count - first)}, candidates);
    for (std::size_t k = 0; k < candidates.count; ++k) {
      const std::uint32_t box = candidates.box[k];
      const std::uint32_t block = candidates.block[k];
      const std::uint32_t row = box % block_size;
      const bool same = itself && box / block_size == block;
      const OneBox<N, T> one(a[box / block_size], row);
      const std::uint32_t counted = 0xFFFFU << (same ? row : 0U);
      next = write_row(box, block * block_size, touched_lanes(one, b[block]) & counted, next);
    }
  }
  return static_cast<std::size_t>(next - out);
}

/// The boxes of one block that touch the bounds of another.
template <Dim N, class T>
HWY_INLINE std::uint32_t rows_near(const BlockLevel<N, T>& of, std::uint32_t at, const BlockLevel<N, T>& other,
                                   std::uint32_t at_other) {
  return touched_lanes(OneBox<N, T>(other.above[at_other / block_size], at_other % block_size), of.blocks[at]);
}

/// Writes the pairs of listed boxes with the blocks they are listed with.
template <Dim N, class T, class Writer>
HWY_INLINE void meet_listed(const Block<N, T>* rows, const Block<N, T>* others, const RowList& list, Writer& writer) {
  for (std::size_t k = 0; k < list.count; ++k) {
    const std::uint32_t box = list.box[k];
    const std::uint32_t block = list.block[k];
    writer.add(box, block, touched_lanes(OneBox<N, T>(rows[box / block_size], box % block_size), others[block]));
  }
}

/// Writes the pairs within a block.
template <Dim N, class T, class Writer>
HWY_INLINE void meet_itself(const Block<N, T>& block, std::uint32_t at, Writer& writer) {
  for (std::uint32_t row = 0; row + 1 < block_size; ++row) {
    writer.add(at * block_size + row, at, touched_lanes(OneBox<N, T>(block, row), block) & lanes_after(row));
  }
}

/// Writes the pairs of boxes of some pairs of blocks. If `itself`, b is a, and a block may be paired with itself.
template <bool itself, Dim N, class T>
HWY_INLINE Pair* meet_blocks(const BlockLevel<N, T>& a, const BlockLevel<N, T>& b, std::span<const BlockPair> pairs,
                             Pair* out) {
  constexpr int few = 8;  // testing the other side costs as much as this many rows
  RowList rows_of_a;
  RowList rows_of_b;
  PairWriter<itself ? Order::ascending : Order::a_first> writer(a.ids, b.ids, out);
  for (const auto [at_a, at_b] : pairs) {
    if (itself && at_a == at_b) {
      meet_itself(a.blocks[at_a], at_a, writer);
      continue;
    }
    const std::uint32_t near_b = rows_near(a, at_a, b, at_b);
    // Every box of a block of large boxes may touch the bounds of a block of small ones.
    if (HWY_UNLIKELY(std::popcount(near_b) > few)) {
      const std::uint32_t near_a = rows_near(b, at_b, a, at_a);
      if (std::popcount(near_a) < std::popcount(near_b)) {
        add_rows(at_b, at_a, near_a, rows_of_b);
        continue;
      }
    }
    add_rows(at_a, at_b, near_b, rows_of_a);
  }
  meet_listed(a.blocks, b.blocks, rows_of_a, writer);
  PairWriter<itself ? Order::ascending : Order::b_first> writer_of_b(b.ids, a.ids, writer.finish());
  meet_listed(b.blocks, a.blocks, rows_of_b, writer_of_b);
  return writer_of_b.finish();
}

template <Dim N, class T>
// NOLINTNEXTLINE(readability-function-size): arrays, one by one, as the loop needs them
std::size_t meet_pairs(BlockLevel<N, T> a, BlockLevel<N, T> b, bool itself, const BlockPair* pairs, std::size_t count,
                       Pair* out) {
  const std::span<const BlockPair> all(pairs, count);
  const Pair* const end = itself ? meet_blocks<true>(a, b, all, out) : meet_blocks<false>(a, b, all, out);
  return static_cast<std::size_t>(end - out);
}

/// Calls use(row, block, lanes) for every row of a and block of b that touch.
template <Dim N, class T, class Use>
// NOLINTNEXTLINE(readability-function-size): arrays, one by one, as the loop needs them
HWY_INLINE void for_each_touch(const Block<N, T>* a, const Block<N, T>* b, std::size_t blocks_of_b, bool itself,
                               Rows rows, const Use& use) {
  for (std::uint32_t row = rows.first; row < rows.last; ++row) {
    const OneBox<N, T> one(a[row / block_size], row % block_size);
    std::uint32_t counted = itself ? lanes_after(row % block_size) : 0xFFFFU;
    for (std::uint32_t k = itself ? row / block_size : 0; k < blocks_of_b; ++k) {
      use(row, k, touched_lanes(one, b[k]) & counted);
      counted = 0xFFFFU;
    }
  }
}

template <Dim N, class T>
std::size_t count_rows(const Block<N, T>* a, const Block<N, T>* b, std::size_t blocks_of_b, bool itself, Rows rows) {
  std::size_t count = 0;
  for_each_touch(a, b, blocks_of_b, itself, rows, [&count](std::uint32_t, std::uint32_t, std::uint32_t lanes) {
    count += static_cast<std::size_t>(std::popcount(lanes));
  });
  return count;
}

template <Dim N, class T>
// NOLINTNEXTLINE(readability-function-size): arrays, one by one, as the loop needs them
void meet_rows(const Block<N, T>* a, const Block<N, T>* b, std::size_t blocks_of_b, bool itself, Rows rows,
               std::span<Pair> out) {
  Pair* next = out.data();
  const Pair* const end = next + out.size();
  for_each_touch(a, b, blocks_of_b, itself, rows, [&](std::uint32_t row, std::uint32_t block, std::uint32_t lanes) {
    if (lanes == 0) return;
    if (HWY_LIKELY(end - next >= std::ptrdiff_t{block_size})) {
      next = write_row(row, block * block_size, lanes, next);
    } else {
      Pair last[2 * block_size];
      next = std::copy(last, write_row(row, block * block_size, lanes, last), next);
    }
  });
}

template <Dim N, class T>
OverlapKernels<N, T> kernels() {
  return {descend_pairs<N, T>, meet_pairs<N, T>, count_rows<N, T>, meet_rows<N, T>};
}

}  // namespace

const AllOverlapKernels& all_overlap_kernels() {
  static const AllOverlapKernels all{kernels<2, float>(), kernels<3, float>(), kernels<2, double>(),
                                     kernels<3, double>()};
  return all;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::detail {
namespace {
HWY_EXPORT(all_overlap_kernels);
}

template <Dim N, class T>
const OverlapKernels<N, T>& overlap_kernels() {
  return HWY_DYNAMIC_DISPATCH(all_overlap_kernels)().template of<N, T>();
}

template const OverlapKernels<2, float>& overlap_kernels();
template const OverlapKernels<3, float>& overlap_kernels();
template const OverlapKernels<2, double>& overlap_kernels();
template const OverlapKernels<3, double>& overlap_kernels();

}  // namespace graze::detail
#endif
