// SPDX-License-Identifier: MIT
// Compiled once per instruction set: Highway includes this file anew for each.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include <graze/broad/meet_kernels.hpp>
#include <graze/broad/simd_choice.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/broad/meet_kernels.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include <graze/broad/simd_lanes-inl.hpp>

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

/// Those of some lanes whose first number is at most the second. A comparison under a mask saves the And.
HWY_INLINE __mmask16 ordered_lanes(__mmask16 lanes, __m512 a, __m512 b) {
  return _mm512_mask_cmp_ps_mask(lanes, a, b, _CMP_LE_OQ);
}
HWY_INLINE __mmask8 ordered_lanes(__mmask8 lanes, __m512d a, __m512d b) {
  return _mm512_mask_cmp_pd_mask(lanes, a, b, _CMP_LE_OQ);
}

/// The lanes of a block that the box touches, one bit each.
template <Dim N, class T>
HWY_INLINE std::uint32_t touched_lanes(const OneBox<N, T>& box, const Block<N, T>& block) {
  const Tag<T> d;
  std::uint32_t touched = 0;
  for (std::uint32_t k = 0; k < vectors_of<T>; ++k) {
    const std::uint32_t at = k * lanes_of<T>;
    auto mask = static_cast<std::conditional_t<sizeof(T) == 4, __mmask16, __mmask8>>(-1);
    const auto all = mask;
    for (Dim i = 0; i < N; ++i) {  // along each axis by itself, for a comparison under a mask waits for it
      const auto below = ordered_lanes(all, hn::Load(d, block.min[i] + at).raw, box.max[i].raw);
      mask &= ordered_lanes(below, box.min[i].raw, hn::Load(d, block.max[i] + at).raw);
    }
    touched |= std::uint32_t{mask} << at;
  }
  return touched;
}

#else

/// The lanes of a block that the box touches, one bit each.
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

/// Writes the pairs of one box with lanes of a block, whose first box is `base`. Where vectors can, it stores as many
/// as a block has.
template <class Two>
HWY_INLINE Two* write_row(std::uint32_t box, std::uint32_t base, std::uint32_t lanes, Two* out) {
#if HWY_TARGET <= HWY_AVX3
  static_assert(sizeof(Two) == sizeof(std::uint64_t) && std::endian::native == std::endian::little);
  const hn::CappedTag<std::uint64_t, block_size / 2> d;
  const auto first = hn::Set(d, box | std::uint64_t{base} << 32U);
  for (std::uint32_t half = 0; half < 2; ++half, lanes >>= block_size / 2) {
    const auto bits = static_cast<std::uint8_t>(lanes);
    const auto lane = hn::ShiftLeft<32>(hn::Iota(d, std::uint64_t{half} * (block_size / 2)));
    // By its intrinsic: for Highway's Compress, GCC copies a table of 2 KiB to the stack each time.
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

/// Boxes, each with the lanes of a block that it touches. Lists of them are gone through without branches that depend
/// on what is found: a wrong guess costs more than the comparisons.
struct Touches {
  static constexpr std::size_t most = std::size_t{block_pairs_at_once} * block_size;
  static constexpr std::size_t slack = block_size;  // whole vectors are stored, of which some lanes count

  std::uint32_t box[most + slack];    // the place of the box: its block and lane
  std::uint32_t block[most + slack];  // the block of the others
  std::uint32_t lanes[most + slack];  // those that it touches
  std::size_t count = 0;

  HWY_INLINE void add(std::uint32_t box_place, std::uint32_t other_block, std::uint32_t touched) {
    box[count] = box_place;
    block[count] = other_block;
    lanes[count] = touched;
    count += touched != 0 ? 1U : 0U;
  }
};

/// Adds the boxes of block a that the mask has, as candidates.
HWY_INLINE void add_rows(std::uint32_t at_a, std::uint32_t at_b, std::uint32_t rows, Touches& list) {
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

/// Lists the boxes of a that can touch boxes of b, for some pairs of blocks: all of a block that meets itself, or whose
/// other's bounds are not known.
template <Dim N, class T>
HWY_INLINE void list_rows(const Block<N, T>* a, const Block<N, T>* above, bool itself, std::span<const BlockPair> pairs,
                          Touches& list) {
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
  Touches candidates;
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

/// Every two boxes of a block.
template <Dim N, class T>
HWY_INLINE void meet_itself(const Block<N, T>& block, std::uint32_t at, Touches& touches) {
  for (std::uint32_t row = 0; row + 1 < block_size; ++row) {
    touches.add(at * block_size + row, at, touched_lanes(OneBox<N, T>(block, row), block) & lanes_after(row));
  }
}

/// Which of two boxes comes first in a pair.
enum class Order { ascending, a_first, b_first };

#if HWY_TARGET <= HWY_AVX3

/// Writes the pairs of one box with some of a block, all at once; stores eight or sixteen.
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

/// Turns touches into pairs, one box after the other.
template <Order order>
HWY_INLINE Pair* write_pairs(Touches& touches, const std::uint32_t* ids_a, const std::uint32_t* ids_b, Pair* out) {
  for (std::size_t k = 0; k < touches.count; ++k) {
    const std::uint32_t* const others = ids_b + std::size_t{touches.block[k]} * block_size;
    out = write_pairs_of<order>(ids_a[touches.box[k]], others, touches.lanes[k], out);
  }
  return out;
}

#else

template <Order order>
HWY_INLINE Pair pair_of(std::uint32_t a, std::uint32_t b) {
  if (order == Order::a_first) return {a, b};
  if (order == Order::b_first) return {b, a};
  // In arithmetic, because compilers make a branch of min and max, and every second guess at it is wrong.
  const std::uint32_t exchange = (a ^ b) & (0U - static_cast<std::uint32_t>(b < a));
  return {a ^ exchange, b ^ exchange};
}

/// Turns touches into pairs, in the order of their boxes: the first lane of each, then the second of those that have
/// one, and so on.
template <Order order>
HWY_INLINE Pair* write_pairs(Touches& touches, const std::uint32_t* ids_a, const std::uint32_t* ids_b, Pair* out) {
  std::uint32_t places[Touches::most + Touches::slack];
  std::uint32_t end = 0;
  for (std::size_t k = 0; k < touches.count; ++k) {
    touches.box[k] = ids_a[touches.box[k]];
    places[k] = end;
    end += static_cast<std::uint32_t>(std::popcount(touches.lanes[k]));
  }
  while (touches.count > 0) {
    const std::size_t count = std::exchange(touches.count, 0);
    for (std::size_t k = 0; k < count; ++k) {
      const std::uint32_t lanes = touches.lanes[k];
      const std::uint32_t block = touches.block[k];
      const std::uint32_t id = touches.box[k];
      const std::uint32_t place = places[k];
      out[place] = pair_of<order>(id, ids_b[block * block_size + static_cast<std::uint32_t>(std::countr_zero(lanes))]);
      places[touches.count] = place + 1;
      touches.add(id, block, lanes & (lanes - 1));
    }
  }
  return out + end;
}

#endif

/// The boxes of one block that touch the bounds of another.
template <Dim N, class T>
HWY_INLINE std::uint32_t rows_near(const BlockLevel<N, T>& of, std::uint32_t at, const BlockLevel<N, T>& other,
                                   std::uint32_t at_other) {
  return touched_lanes(OneBox<N, T>(other.above[at_other / block_size], at_other % block_size), of.blocks[at]);
}

/// What rows touch of the blocks they are listed with.
template <Dim N, class T>
HWY_INLINE void touch_rows(const Block<N, T>* rows, const Block<N, T>* others, const Touches& list, Touches& touches) {
  for (std::size_t k = 0; k < list.count; ++k) {
    const std::uint32_t box = list.box[k];
    const std::uint32_t block = list.block[k];
    touches.add(box, block, touched_lanes(OneBox<N, T>(rows[box / block_size], box % block_size), others[block]));
  }
}

template <Dim N, class T>
// NOLINTNEXTLINE(readability-function-size): arrays, one by one, as the loop needs them
std::size_t meet_pairs(BlockLevel<N, T> a, BlockLevel<N, T> b, bool itself, const BlockPair* pairs, std::size_t count,
                       Pair* out) {
  constexpr int few = 8;  // to look at the other side costs as much as some rows
  Touches rows_of_a;
  Touches rows_of_b;
  Touches touches;
  for (std::size_t k = 0; k < count; ++k) {
    const auto [at_a, at_b] = pairs[k];
    if (itself && at_a == at_b) {
      meet_itself(a.blocks[at_a], at_a, touches);
      continue;
    }
    const std::uint32_t near_b = rows_near(a, at_a, b, at_b);
    // A block of large boxes may have none that does not touch the bounds of a block of small ones.
    if (HWY_UNLIKELY(std::popcount(near_b) > few)) {
      const std::uint32_t near_a = rows_near(b, at_b, a, at_a);
      if (std::popcount(near_a) < std::popcount(near_b)) {
        add_rows(at_b, at_a, near_a, rows_of_b);
        continue;
      }
    }
    add_rows(at_a, at_b, near_b, rows_of_a);
  }
  touch_rows(a.blocks, b.blocks, rows_of_a, touches);
  Touches touches_of_b;
  touch_rows(b.blocks, a.blocks, rows_of_b, touches_of_b);
  Pair* end = nullptr;
  if (itself) {
    end = write_pairs<Order::ascending>(touches, a.ids, b.ids, out);
    end = write_pairs<Order::ascending>(touches_of_b, b.ids, a.ids, end);
  } else {
    end = write_pairs<Order::a_first>(touches, a.ids, b.ids, out);
    end = write_pairs<Order::b_first>(touches_of_b, b.ids, a.ids, end);
  }
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
MeetKernels<N, T> kernels() {
  return {descend_pairs<N, T>, meet_pairs<N, T>, count_rows<N, T>, meet_rows<N, T>};
}

}  // namespace

const AllMeetKernels& all_meet_kernels() {
  static const AllMeetKernels all{kernels<2, float>(), kernels<3, float>(), kernels<2, double>(), kernels<3, double>()};
  return all;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::detail {
namespace {
HWY_EXPORT(all_meet_kernels);
}

template <Dim N, class T>
const MeetKernels<N, T>& meet_kernels() {
  const AllMeetKernels& all = HWY_DYNAMIC_DISPATCH(all_meet_kernels)();
  if constexpr (std::is_same_v<T, float>) {
    if constexpr (N == 2) return all.flat_float;
    if constexpr (N == 3) return all.solid_float;
  } else {
    if constexpr (N == 2) return all.flat_double;
    if constexpr (N == 3) return all.solid_double;
  }
}

template const MeetKernels<2, float>& meet_kernels();
template const MeetKernels<3, float>& meet_kernels();
template const MeetKernels<2, double>& meet_kernels();
template const MeetKernels<3, double>& meet_kernels();

}  // namespace graze::detail
#endif
