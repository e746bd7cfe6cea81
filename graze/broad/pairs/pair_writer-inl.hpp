// SPDX-License-Identifier: MIT
// Writes the pairs of boxes that touch. Included once per instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_PAIRS_PAIR_WRITER_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_PAIRS_PAIR_WRITER_INL_HPP
#undef GRAZE_BROAD_PAIRS_PAIR_WRITER_INL_HPP
#else
#define GRAZE_BROAD_PAIRS_PAIR_WRITER_INL_HPP
#endif

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <hwy/highway.h>

#include <graze/broad/pair.hpp>
#include <graze/broad/simd/block.hpp>
#include <graze/broad/simd/lanes-inl.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

/// Boxes, each with a block to compare it with. Such lists are processed without data-dependent branches, because
/// mispredictions would cost more than the comparisons.
struct RowList {
  static constexpr std::size_t most = std::size_t{block_pairs_at_once} * block_size;
  static constexpr std::size_t slack = block_size;  // whole vectors are stored, of which some lanes are valid

  std::uint32_t box[most + slack];    // the box's position: its block and lane
  std::uint32_t block[most + slack];  // the other block
  std::size_t count = 0;
};

/// Adds the boxes of block a in the mask as candidates.
HWY_INLINE void add_rows(std::uint32_t at_a, std::uint32_t at_b, std::uint32_t rows, RowList& list) {
#if HWY_TARGET <= HWY_AVX3
  const hn::CappedTag<std::uint32_t, block_size> d;
  const auto bits = static_cast<std::uint16_t>(rows);
  const auto mask = hn::LoadMaskBits(d, reinterpret_cast<const std::uint8_t*>(&bits));
  const auto box = hn::Add(hn::Iota(d, 0U), hn::Set(d, at_a * block_size));
  hn::StoreU(hn::Compress(box, mask), d, list.box + list.count);
  hn::StoreU(hn::Set(d, at_b), d, list.block + list.count);
  list.count += static_cast<std::size_t>(std::popcount(rows));
#else
  for (; rows != 0; rows &= rows - 1, ++list.count) {
    list.box[list.count] = at_a * block_size + static_cast<std::uint32_t>(std::countr_zero(rows));
    list.block[list.count] = at_b;
  }
#endif
}

/// Which of two boxes comes first in a pair.
enum class Order { ascending, a_first, b_first };

#if HWY_TARGET <= HWY_AVX3

/// Writes the pairs of one box with some lanes of a block at once; stores eight or sixteen.
template <Order order>
HWY_INLINE Pair* write_pairs_of(std::uint32_t id, const std::uint32_t* others, std::uint32_t lanes, Pair* out) {
  const hn::CappedTag<std::uint32_t, block_size> d;
  const auto one = hn::Set(d, id);
  const hn::Vec<decltype(d)> other{
      _mm512_maskz_compress_epi32(static_cast<std::uint16_t>(lanes), hn::LoadU(d, others).raw)};
  const auto first = order == Order::ascending ? hn::Min(one, other) : order == Order::a_first ? one : other;
  const auto second = order == Order::ascending ? hn::Max(one, other) : order == Order::a_first ? other : one;
  alignas(64) static constexpr std::uint32_t in_turns[] = {0,  16, 1,  17, 2,  18, 3,  19, 4,  20, 5,
                                                           21, 6,  22, 7,  23, 8,  24, 9,  25, 10, 26,
                                                           11, 27, 12, 28, 13, 29, 14, 30, 15, 31};
  const int count = std::popcount(lanes);
  _mm512_storeu_si512(out, _mm512_permutex2var_epi32(first.raw, hn::Load(d, in_turns).raw, second.raw));
  if (HWY_UNLIKELY(count > 8)) {
    _mm512_storeu_si512(out + 8, _mm512_permutex2var_epi32(first.raw, hn::Load(d, in_turns + 16).raw, second.raw));
  }
  return out + count;
}

/// Writes the pairs of boxes with lanes of blocks immediately, box by box: listing them first takes longer, even if
/// most boxes touch nothing.
template <Order order>
class PairWriter {
 public:
  PairWriter(const std::uint32_t* ids_a, const std::uint32_t* ids_b, Pair* out)
      : ids_a_(ids_a), ids_b_(ids_b), out_(out) {}

  /// Adds the lanes of a block that a box touches; there may be none.
  HWY_INLINE void add(std::uint32_t box, std::uint32_t block, std::uint32_t lanes) {
    out_ = write_pairs_of<order>(ids_a_[box], ids_b_ + std::size_t{block} * block_size, lanes, out_);
  }

  /// The end of the written pairs.
  HWY_INLINE Pair* finish() { return out_; }

 private:
  const std::uint32_t* ids_a_;
  const std::uint32_t* ids_b_;
  Pair* out_;
};

#else

template <Order order>
HWY_INLINE Pair pair_of(std::uint32_t a, std::uint32_t b) {
  if (order == Order::a_first) return {a, b};
  if (order == Order::b_first) return {b, a};
  // Arithmetic instead of min and max, which compilers turn into a branch that is mispredicted half of the time.
  const std::uint32_t exchange = (a ^ b) & (0U - static_cast<std::uint32_t>(b < a));
  return {a ^ exchange, b ^ exchange};
}

/// Writes the pairs of boxes with lanes of blocks at the end: the first lane of each box, then the second of those that
/// have one, and so on.
template <Order order>
class PairWriter {
 public:
  PairWriter(const std::uint32_t* ids_a, const std::uint32_t* ids_b, Pair* out)
      : ids_a_(ids_a), ids_b_(ids_b), out_(out) {}

  /// Adds the lanes of a block that a box touches; there may be none.
  HWY_INLINE void add(std::uint32_t box, std::uint32_t block, std::uint32_t lanes) {
    touches_.box[touches_.count] = ids_a_[box];
    touches_.block[touches_.count] = block;
    lanes_[touches_.count] = lanes;
    touches_.count += lanes != 0 ? 1U : 0U;
  }

  /// The end of the written pairs.
  HWY_INLINE Pair* finish() {
    std::uint32_t end = 0;
    for (std::size_t k = 0; k < touches_.count; ++k) {
      places_[k] = end;
      end += static_cast<std::uint32_t>(std::popcount(lanes_[k]));
    }
    while (touches_.count > 0) write_first_lanes();
    return out_ + end;
  }

 private:
  /// Keeps the boxes that have more.
  HWY_INLINE void write_first_lanes() {
    const std::size_t count = std::exchange(touches_.count, 0);
    for (std::size_t k = 0; k < count; ++k) {
      const std::uint32_t id = touches_.box[k];
      const std::uint32_t block = touches_.block[k];
      const std::uint32_t lanes = lanes_[k];
      const std::uint32_t place = places_[k];
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
      out_[place] = pair_of<order>(id, ids_b_[std::size_t{block} * block_size + lane]);
      const std::size_t left = touches_.count;
      touches_.box[left] = id;
      touches_.block[left] = block;
      lanes_[left] = lanes & (lanes - 1);
      places_[left] = place + 1;
      touches_.count += lanes_[left] != 0 ? 1U : 0U;
    }
  }

  const std::uint32_t* ids_a_;
  const std::uint32_t* ids_b_;
  Pair* out_;
  RowList touches_;  // boxes by their ids
  std::uint32_t lanes_[RowList::most + RowList::slack];
  std::uint32_t places_[RowList::most + RowList::slack];  // index of the next pair of each, among all
};

#endif

}  // namespace
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
