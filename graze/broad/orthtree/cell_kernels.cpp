// SPDX-License-Identifier: MIT
// Compiled once per instruction set: Highway includes this file again for each.
#include <algorithm>
#include <bit>
#include <numeric>
#include <type_traits>

#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/orthtree/cell_kernels.hpp>
#include <graze/broad/simd/choice.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/broad/orthtree/cell_kernels.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include <graze/broad/orthtree/codes-inl.hpp>
#include <graze/broad/simd/compress-inl.hpp>
#include <graze/broad/simd/lanes-inl.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

/// From a bit string with N bits for each of several boxes: one bit per box, set if all N bits of the box are set.
template <Dim N>
HWY_INLINE std::uint32_t boxes_of(std::uint64_t numbers) {
  constexpr std::uint64_t firsts = N == 2 ? 0x1111'1111U : 0x0410'4104'1041U;  // the lowest bit of each box
  numbers &= numbers >> static_cast<unsigned>(N);
  numbers &= N == 2 ? numbers >> 1U : numbers >> 1U & numbers >> 2U;
#if HWY_TARGET <= HWY_AVX3 && HWY_ARCH_X86_64
  return static_cast<std::uint32_t>(_pext_u64(numbers, firsts));  // fast on all processors with AVX-512
#else
  numbers &= firsts;
  if constexpr (N == 2) {
    numbers = (numbers | numbers >> 3U) & 0x0303'0303U;
    numbers = (numbers | numbers >> 6U) & 0x000F'000FU;
    return static_cast<std::uint32_t>((numbers | numbers >> 12U) & 0xFFU);
  } else {
    numbers = (numbers | numbers >> 5U) & 0x0030'0300'3003U;
    numbers = (numbers | numbers >> 10U) & 0x0000'0F00'000FU;
    return static_cast<std::uint32_t>((numbers | numbers >> 20U) & 0xFFU);
  }
#endif
}

/// A region in the form in which consecutive boxes are compared with it in memory order: each min with the region's
/// max, each negated max with the region's negated min. NaN exceeds every limit.
template <Dim N, class T>
class RowLimits {
 public:
  HWY_INLINE explicit RowLimits(const Aabb<N, T>& region) {
    alignas(64) T limits[period];
    alignas(64) T signs[period];
    for (std::uint32_t k = 0; k < period; ++k) {
      const auto at = static_cast<Dim>(k % numbers);
      const bool is_min = at < N;
      limits[k] = is_min ? region.max[at % N] : -region.min[at % N];
      signs[k] = is_min ? T(0) : -T(0);
    }
    for (std::uint32_t k = 0; k < vectors; ++k) {
      limits_[k] = hn::Load(D(), limits + k * lanes);
      signs_[k] = hn::Load(D(), signs + k * lanes);
    }
  }

  /// Which of the boxes share a point with the region, as a bit mask.
  template <std::size_t count>
  HWY_INLINE std::uint32_t met(const Aabb<N, T> (&boxes)[count]) const {
    static_assert(sizeof(boxes) == count * numbers * sizeof(T) && count * numbers % lanes == 0);
    const T* const first = &boxes[0].min[0];
    std::uint64_t bits = 0;
    for (std::uint32_t k = 0; k < count * numbers / lanes; ++k) {
      const auto signless = hn::Xor(hn::Load(D(), first + std::size_t{k} * lanes), signs_[k % vectors]);
      bits |= std::uint64_t{bits_of<T>(hn::Le(signless, limits_[k % vectors]))} << k * lanes;
    }
    return boxes_of<N>(bits);
  }

 private:
  using D = Tag<T>;
  static constexpr std::uint32_t lanes = lanes_of<T>;
  static constexpr std::uint32_t numbers = 2 * static_cast<std::uint32_t>(N);
  static constexpr std::uint32_t period = std::lcm(numbers, lanes);
  static constexpr std::uint32_t vectors = period / lanes;

  Lanes<T> limits_[vectors];
  Lanes<T> signs_[vectors];
};

template <class D, class Mask>
HWY_INLINE std::uint32_t bits_in([[maybe_unused]] D d, const Mask& mask) {
#if HWY_TARGET <= HWY_AVX3
  return mask.raw;  // one bit per lane, zeros beyond
#else
  std::uint64_t bits = 0;
  hn::StoreMaskBits(d, mask, reinterpret_cast<std::uint8_t*>(&bits));
  return static_cast<std::uint32_t>(bits) & ((1U << hn::MaxLanes(D())) - 1U);
#endif
}

/// Vectors with one lane for each of `count` cells or entries, or as many lanes as the machine has.
template <std::size_t count>
using Numbers = hn::CappedTag<std::uint32_t, count>;

template <std::size_t count>
HWY_INLINE std::uint32_t other_than(std::uint32_t none, const std::uint32_t (&values)[count]) {
  const Numbers<count> d;
  constexpr std::uint32_t lanes = hn::MaxLanes(Numbers<count>());
  std::uint32_t others = 0;
  for (std::uint32_t lane = 0; lane < count; lane += lanes) {
    others |= bits_in(d, hn::Ne(hn::Load(d, values + lane), hn::Set(d, none))) << lane;
  }
  return others;
}

/// Writes the values whose bits are set contiguously, followed by up to a vector of unspecified numbers.
template <std::size_t count>
HWY_INLINE std::size_t write_those(std::uint32_t chosen, const std::uint32_t (&values)[count], std::uint32_t* to) {
  const Numbers<count> d;
  constexpr std::uint32_t lanes = hn::MaxLanes(Numbers<count>());
  std::size_t written = 0;
  for (std::uint32_t lane = 0; lane < count; lane += lanes) {
    const std::uint32_t bits = lanes == count ? chosen : chosen >> lane & ((1U << lanes) - 1U);
    hn::StoreU(ToFront<Numbers<count>>(bits)(hn::Load(d, values + lane)), d, to + written);
    written += static_cast<std::size_t>(std::popcount(bits));
  }
  return written;
}

/// Which cells of a group a region meets, as a bit mask.
template <Dim N, class T>
class GroupLimits {
 public:
  HWY_INLINE explicit GroupLimits(const Aabb<N, T>& region) {
    for (Dim i = 0; i < N; ++i) {
      low_[i] = hn::Set(D(), region.min[i]);
      high_[i] = hn::Set(D(), region.max[i]);
    }
  }

  HWY_INLINE std::uint32_t met(const CellGroup<N, T>& group) const {
    constexpr std::uint32_t lanes = hn::MaxLanes(D());
    std::uint32_t bits = 0;
    for (std::uint32_t lane = 0; lane < cells_per_group<N>; lane += lanes) {
      auto meets = hn::And(hn::Le(hn::Load(D(), group.min[0] + lane), high_[0]),
                           hn::Ge(hn::Load(D(), group.max[0] + lane), low_[0]));
      for (Dim i = 1; i < N; ++i) {
        meets = hn::And(meets, hn::And(hn::Le(hn::Load(D(), group.min[i] + lane), high_[i]),
                                       hn::Ge(hn::Load(D(), group.max[i] + lane), low_[i])));
      }
      bits |= bits_in(D(), meets) << lane;
    }
    return bits;
  }

 private:
  using D = hn::CappedTag<T, cells_per_group<N>>;

  hn::Vec<D> low_[N];
  hn::Vec<D> high_[N];
};

/// Prefetches a block and the one before it, which is usually the next of its list: the blocks of a leaf that was
/// filled in bulk are consecutive, in reverse order of the list.
template <Dim N, class T>
HWY_INLINE void prefetch_list(const EntryPage<N, T>* pages, std::uint32_t head) {
  prefetch_whole(pages + head);
  prefetch_whole(pages + (head - (head > 0 ? 1 : 0)));
}

/// Visits groups until none is left or there is no space for more blocks. The first child met is visited next,
/// directly, without waiting for the stack that holds the others. Whatever will be visited is prefetched as soon as it
/// is known, including blocks, because the way down to the last cells is bound by memory latency.
template <Dim N, class T>
HWY_INLINE void look_at_groups(const CellGroup<N, T>* groups, const EntryPage<N, T>* pages,
                               const GroupLimits<N, T>& limits, CellMetWalk<N, T>& walk) {
  std::uint32_t* const stack = walk.open + 1;
  std::uint32_t next = walk.next;
  std::size_t open = walk.open_count;
  std::size_t blocks = walk.block_count;
  std::size_t seen = 0;
  for (; next != 0 && blocks <= CellMetWalk<N, T>::most_blocks; ++seen) {
    const CellGroup<N, T>& group = groups[next];
    const std::uint32_t met = limits.met(group);
    const std::uint32_t opened = met & other_than(0, group.below);
    const std::uint32_t waits = walk.open[open];  // 0 if there is none
    const std::uint32_t first = group.below[std::countr_zero(opened | 1U << (cells_per_group<N> - 1U))];
    next = opened != 0 ? first : waits;
    open -= opened == 0 && open > 0 ? 1 : 0;
    const std::size_t waiting = write_those(opened & (opened - 1), group.below, stack + open);
    prefetch_whole(groups + stack[open]);
    open += waiting;
    const std::size_t added = write_those(met & other_than(no_index, group.heads), group.heads, walk.blocks + blocks);
    for (std::size_t k = 0; k < added; ++k) prefetch_list(pages, walk.blocks[blocks + k]);
    blocks += added;
  }
  walk.groups_seen += seen;
  walk.next = next;
  walk.open_count = open;
  walk.block_count = blocks;
}

/// Descends to the cell around the region's center, as far as cells are met on the way. The path is known from the code
/// of the center, so no group waits for the result of the one above it.
template <Dim N, class T>
HWY_INLINE void look_along_way(const CellGroup<N, T>* groups, const EntryPage<N, T>* pages,
                               const GroupLimits<N, T>& limits, CellMetWalk<N, T>& walk) {
  std::uint32_t* const stack = walk.open + 1;
  std::uint32_t next = walk.next;
  std::size_t open = walk.open_count;
  std::size_t blocks = walk.block_count;
  CellWay<N> way = walk.way;
  std::size_t seen = 0;
  while (next != 0) {
    const CellGroup<N, T>& group = groups[next];
    const std::uint32_t child = way.next();
    ++seen;
    next = group.below[child];
    const std::uint32_t met = limits.met(group);
    const std::uint32_t aside = met & other_than(0, group.below) & ~(1U << child);
    const std::size_t waiting = write_those(aside, group.below, stack + open);
    prefetch_whole(groups + stack[open]);
    open += waiting;
    blocks += write_those(met & other_than(no_index, group.heads), group.heads, walk.blocks + blocks);
    if ((met >> child & 1U) == 0) {  // a branch, because a select would wait for the result
      next = 0;
      break;
    }
    if (blocks > CellMetWalk<N, T>::most_blocks) break;
  }
  for (std::size_t k = 0; k < blocks; ++k) prefetch_list(pages, walk.blocks[k]);
  if (next == 0 && open > 0) next = stack[--open];
  walk.groups_seen += seen;
  walk.next = next;
  walk.open_count = open;
  walk.block_count = blocks;
}

/// Visits the queue of blocks, appending the blocks linked from them. When the queue is about to reach its capacity, it
/// moves to the front; it never grows longer than it was.
template <Dim N, class T>
HWY_INLINE void look_at_blocks(const EntryPage<N, T>* pages, const RowLimits<N, T>& limits, CellMetWalk<N, T>& walk) {
  using Walk = CellMetWalk<N, T>;
  std::uint32_t* const blocks = walk.blocks;
  std::size_t end = walk.block_count;
  std::size_t found = walk.found_count;
  std::size_t next = 0;
  std::size_t seen = 0;
  for (; next < end && found <= Walk::most_found; ++seen) {
    const EntryPage<N, T>& page = pages[blocks[next++]];
    if (end == std::size(walk.blocks)) {
      std::copy(blocks + next, blocks + end, blocks);
      end -= next;
      next = 0;
    }
    blocks[end] = page.next;
    const std::uint32_t goes_on = page.next == no_index ? 0 : 1;
    end += goes_on;
    prefetch_whole(pages + ((std::max(page.next, 1U) - 1U) & (0U - goes_on)));  // the block after the next
    found += write_those(limits.met(page.boxes), page.slots, walk.found + found);
  }
  std::copy(blocks + next, blocks + end, blocks);
  walk.blocks_seen += seen;
  walk.block_count = end - next;
  walk.found_count = found;
}

template <Dim N, class T>
void find_overlapping(const CellGroup<N, T>* groups, const EntryPage<N, T>* pages, CellMetWalk<N, T>& walk) {
  const GroupLimits<N, T> group_limits(walk.region);
  const RowLimits<N, T> limits(walk.region);
  if (walk.has_way) look_along_way(groups, pages, group_limits, walk);
  walk.has_way = false;
  do {
    look_at_groups(groups, pages, group_limits, walk);
    look_at_blocks(pages, limits, walk);
  } while (!walk.is_over() && walk.found_count <= CellMetWalk<N, T>::most_found);
}

template <Dim N, class T>
CellKernels<N, T> kernels() {
  return {hwy::TargetName(HWY_TARGET), find_overlapping<N, T>, code_boxes<N, T>, bounds_of_finite<N, T>};
}

}  // namespace

const AllCellKernels& all_cell_kernels() {
  static const AllCellKernels all{kernels<2, float>(), kernels<3, float>(), kernels<2, double>(), kernels<3, double>()};
  return all;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::detail {
namespace {
HWY_EXPORT(all_cell_kernels);
}

std::int64_t cell_kernel_targets() { return HWY_TARGETS; }

template <Dim N, class T>
const CellKernels<N, T>& cell_kernels() {
  return HWY_DYNAMIC_DISPATCH(all_cell_kernels)().template of<N, T>();
}

template const CellKernels<2, float>& cell_kernels();
template const CellKernels<3, float>& cell_kernels();
template const CellKernels<2, double>& cell_kernels();
template const CellKernels<3, double>& cell_kernels();

}  // namespace graze::detail
#endif
