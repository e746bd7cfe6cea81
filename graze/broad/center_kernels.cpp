// SPDX-License-Identifier: MIT
// Compiled once per instruction set: Highway includes this file anew for each.
#include <algorithm>
#include <bit>
#include <limits>
#include <type_traits>
#include <utility>

#include <graze/broad/box_cover.hpp>
#include <graze/broad/center_kernels.hpp>
#include <graze/broad/simd_choice.hpp>
#include <graze/math/rounding.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/broad/center_kernels.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include <graze/broad/box_lanes-inl.hpp>
#include <graze/broad/simd_lanes-inl.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

template <class T>
using LaneMask = hn::Mask<Tag<T>>;

template <class T>
HWY_INLINE std::size_t count_of(const LaneMask<T>& mask) {
  return static_cast<std::size_t>(std::popcount(bits_of<T>(mask)));
}

#if HWY_TARGET <= HWY_AVX3

/// The lanes of a mask one after another. By intrinsics where Highway looks up a table, which GCC copies to the stack
/// each time; for the same reason older instruction sets move numbers one by one.
template <class T>
HWY_INLINE Lanes<T> compressed(const Lanes<T>& lanes, const LaneMask<T>& mask) {
  if constexpr (sizeof(T) == 8) return Lanes<T>{_mm512_maskz_compress_pd(mask.raw, lanes.raw)};
  if constexpr (sizeof(T) == 4) return hn::Compress(lanes, mask);
}

/// As many slots as there are lanes of T.
template <class T>
using SlotTag = hn::Rebind<std::uint32_t, Tag<T>>;

template <class T>
HWY_INLINE hn::Mask<SlotTag<T>> slot_mask(const LaneMask<T>& mask) {
  if constexpr (sizeof(T) == 4) return hn::RebindMask(SlotTag<T>(), mask);
  const std::uint64_t bits = bits_of<T>(mask);
  return hn::LoadMaskBits(SlotTag<T>(), reinterpret_cast<const std::uint8_t*>(&bits));
}

#endif

template <Dim N, class T>
void centers_of(const Aabb<N, T>* boxes, std::size_t count, const CenterLists<N, T>& to) {
  const Tag<T> d;
  const auto half = hn::Set(d, T(0.5));
  std::size_t k = 0;
  for (; k + lanes_of<T> <= count; k += lanes_of<T>) {
    const BoxLanes<N, T> box = load_boxes(boxes + k);
    for (Dim i = 0; i < N; ++i) {
      hn::StoreU(hn::Add(hn::Mul(box.min[i], half), hn::Mul(box.max[i], half)), d, to.at[i] + k);
    }
  }
  for (; k < count; ++k) {
    for (Dim i = 0; i < N; ++i) to.at[i][k] = boxes[k].min[i] * T(0.5) + boxes[k].max[i] * T(0.5);
  }
}

template <Dim N, class T>
Aabb<N, T> bounds_of_centers(const CenterLists<N, T>& centers, std::size_t count) {
  const Tag<T> d;
  Aabb<N, T> bounds;
  for (Dim i = 0; i < N; ++i) {
    const T* const at = centers.at[i];
    bounds.min[i] = bounds.max[i] = at[0];
    if (count >= lanes_of<T>) {
      auto low = hn::LoadU(d, at);
      auto high = low;
      for (std::size_t k = lanes_of<T>; k + lanes_of<T> <= count; k += lanes_of<T>) {
        low = hn::Min(low, hn::LoadU(d, at + k));
        high = hn::Max(high, hn::LoadU(d, at + k));
      }
      low = hn::Min(low, hn::LoadU(d, at + count - lanes_of<T>));
      high = hn::Max(high, hn::LoadU(d, at + count - lanes_of<T>));
      bounds.min[i] = hn::GetLane(hn::MinOfLanes(d, low));
      bounds.max[i] = hn::GetLane(hn::MaxOfLanes(d, high));
      continue;
    }
    for (std::size_t k = 1; k < count; ++k) {
      bounds.min[i] = std::min(bounds.min[i], at[k]);
      bounds.max[i] = std::max(bounds.max[i], at[k]);
    }
  }
  return bounds;
}

// ---- Selection

/// So many numbers are each compared with all.
constexpr std::size_t few = 32;

/// How often one looks between others before an ordinary selection takes over.
constexpr int most_rounds = 24;

/// Up to `most` numbers, and behind them such as are greater than all.
template <class T, std::size_t most>
struct Numbers {
  static constexpr std::size_t vectors = most / lanes_of<T>;

  alignas(64) T all[most];
  alignas(64) T less[most];  // how many are less than each
  std::size_t count;

  HWY_INLINE void count_less() {
    const Tag<T> d;
    const auto one = hn::Set(d, T(1));
    Lanes<T> sums[vectors];
    Lanes<T> lanes[vectors];
    for (std::size_t k = 0; k < vectors; ++k) {
      sums[k] = hn::Zero(d);
      lanes[k] = hn::Load(d, all + k * lanes_of<T>);
    }
    for (std::size_t j = 0; j < count; ++j) {
      const auto other = hn::Set(d, all[j]);
      for (std::size_t k = 0; k < vectors; ++k) {
        sums[k] = hn::Add(sums[k], hn::IfThenElseZero(hn::Lt(other, lanes[k]), one));
      }
    }
    for (std::size_t k = 0; k < vectors; ++k) hn::Store(sums[k], d, less + k * lanes_of<T>);
  }

  /// The one of a rank: the greatest of those that fewer or as many are less than.
  HWY_INLINE Selected<T> of_rank(std::size_t rank) const {
    const Tag<T> d;
    const auto most_less = hn::Set(d, static_cast<T>(rank));
    auto value = hn::Set(d, std::numeric_limits<T>::lowest());
    auto below = hn::Zero(d);
    for (std::size_t k = 0; k < most; k += lanes_of<T>) {
      const auto lanes = hn::Load(d, less + k);
      const auto is_candidate = hn::Le(lanes, most_less);
      value = hn::IfThenElse(is_candidate, hn::Max(value, hn::Load(d, all + k)), value);
      below = hn::IfThenElse(is_candidate, hn::Max(below, lanes), below);
    }
    return {hn::GetLane(hn::MaxOfLanes(d, value)), static_cast<std::size_t>(hn::GetLane(hn::MaxOfLanes(d, below)))};
  }
};

template <class T>
Selected<T> select_of_few(const T* numbers, std::size_t count, std::size_t rank) {
  Numbers<T, few> all;
  std::fill(std::copy(numbers, numbers + count, all.all), all.all + few, std::numeric_limits<T>::infinity());
  all.count = count;
  all.count_less();
  return all.of_rank(rank);
}

template <class T>
struct Bracket {
  T low;
  T high;
};

/// Those of a sample that are so many places before and behind where a rank would be in it.
template <std::size_t sampled, class T>
HWY_INLINE Bracket<T> bracket_from_sample(const T* numbers, std::size_t count, std::size_t rank, std::size_t off) {
  Numbers<T, sampled> sample;
  const std::size_t step = count / sampled;
  for (std::size_t k = 0; k < sampled; ++k) sample.all[k] = numbers[k * step + step / 2];
  sample.count = sampled;
  sample.count_less();
  const std::size_t place = rank * sampled / count;
  return {sample.of_rank(place > off ? place - off : 0).value,
          sample.of_rank(std::min(place + off, sampled - 1)).value};
}

template <class T>
Bracket<T> bracket_of(const T* numbers, std::size_t count, std::size_t rank, bool is_narrow) {
  if (count < 512) return bracket_from_sample<16>(numbers, count, rank, is_narrow ? 0 : 3);
  return bracket_from_sample<64>(numbers, count, rank, is_narrow ? 0 : 6);
}

/// How many numbers are below a bracket, and in it; these are in `to`, which may be where they were.
struct Between {
  std::size_t below;
  std::size_t within;
};

template <class T>
Between take_between(const T* numbers, std::size_t count, const Bracket<T>& bracket, T* to) {
  const Tag<T> d;
  const auto low = hn::Set(d, bracket.low);
  const auto high = hn::Set(d, bracket.high);
  Between result{0, 0};
  std::size_t k = 0;
  for (; k + lanes_of<T> <= count; k += lanes_of<T>) {
    const auto lanes = hn::LoadU(d, numbers + k);
    const auto is_within = hn::And(hn::Ge(lanes, low), hn::Le(lanes, high));
    result.below += count_of<T>(hn::Lt(lanes, low));
#if HWY_TARGET <= HWY_AVX3
    hn::StoreU(compressed<T>(lanes, is_within), d, to + result.within);
    result.within += count_of<T>(is_within);
#else
    for (std::uint32_t bits = bits_of<T>(is_within); bits != 0; bits &= bits - 1) {
      to[result.within++] = numbers[k + static_cast<std::uint32_t>(std::countr_zero(bits))];
    }
#endif
  }
  for (; k < count; ++k) {
    result.below += numbers[k] < bracket.low ? 1U : 0U;
    if (numbers[k] >= bracket.low && numbers[k] <= bracket.high) to[result.within++] = numbers[k];
  }
  return result;
}

template <class T>
Selected<T> select_by_order(const T* numbers, std::size_t count, std::size_t rank, T* room) {
  std::copy(numbers, numbers + count, room);
  std::nth_element(room, room + rank, room + count);
  const T value = room[rank];
  const auto less = std::count_if(room, room + rank, [value](T other) { return other < value; });
  return {value, static_cast<std::size_t>(less)};
}

template <class T>
Selected<T> select(const T* numbers, std::size_t count, std::size_t rank, T* room, T* more_room) {
  constexpr T most = std::numeric_limits<T>::max();
  std::size_t less = 0;  // of those that are left behind
  bool is_narrow = false;
  for (int round = 0; count > few; ++round) {
    if (round == most_rounds) {
      const Selected<T> found = select_by_order(numbers, count, rank, room);
      return {found.value, found.less + less};
    }
    const Bracket<T> bracket = bracket_of(numbers, count, rank, is_narrow);
    Between between = take_between(numbers, count, bracket, room);
    const std::size_t up_to = between.below + between.within;
    if (rank < between.below) {
      between = take_between(numbers, count, {-most, next_down(bracket.low)}, room);
    } else if (rank >= up_to) {
      between = take_between(numbers, count, {next_up(bracket.high), most}, room);
    } else if (bracket.low == bracket.high) {
      return {bracket.low, less + between.below};
    }
    less += between.below;
    rank -= between.below;
    is_narrow = between.within > std::max(few, count / 2);
    count = between.within;
    numbers = room;
    std::swap(room, more_room);
  }
  const Selected<T> found = select_of_few(numbers, count, rank);
  return {found.value, found.less + less};
}

// ---- Parting

/// How many are in both parts so far, each with where it ends.
struct Ends {
  std::size_t low;
  std::size_t high;
};

#if HWY_TARGET <= HWY_AVX3

/// Parts a vector of centers, or the last ones, and writes no more than they are. Copies the first `copied`
/// coordinates.
template <Dim copied, Dim N, class T>
// NOLINTNEXTLINE(readability-function-size): as the loop needs it
HWY_INLINE void part_some(const CenterLists<N, T>& from, std::size_t some, Dim axis, T border,
                          const CenterLists<N, T>& to, Ends& ends) {
  const Tag<T> d;
  const SlotTag<T> ds;
  const auto are_there = hn::FirstN(d, some);
  const auto is_low = hn::And(are_there, hn::Lt(hn::MaskedLoad(are_there, d, from.at[axis]), hn::Set(d, border)));
  const auto is_high = hn::AndNot(is_low, are_there);
  const std::size_t lower = count_of<T>(is_low);
  const auto first_low = hn::FirstN(d, lower);
  const auto first_high = hn::FirstN(d, some - lower);
  for (Dim i = 0; i < copied; ++i) {
    const auto lanes = hn::MaskedLoad(are_there, d, from.at[i]);
    hn::BlendedStore(compressed<T>(lanes, is_low), first_low, d, to.at[i] + ends.low);
    hn::BlendedStore(compressed<T>(lanes, is_high), first_high, d, to.at[i] + ends.high);
  }
  const auto slots = hn::MaskedLoad(hn::FirstN(ds, some), ds, from.slots);
  hn::BlendedStore(hn::Compress(slots, slot_mask<T>(is_low)), hn::FirstN(ds, lower), ds, to.slots + ends.low);
  hn::BlendedStore(hn::Compress(slots, slot_mask<T>(is_high)), hn::FirstN(ds, some - lower), ds, to.slots + ends.high);
  ends.low += lower;
  ends.high += some - lower;
}

/// The same for a whole vector where as much may be written behind both ends.
template <Dim copied, Dim N, class T>
HWY_INLINE void part_vector(const CenterLists<N, T>& from, Dim axis, T border, const CenterLists<N, T>& to,
                            Ends& ends) {
  const Tag<T> d;
  const SlotTag<T> ds;
  const auto is_low = hn::Lt(hn::LoadU(d, from.at[axis]), hn::Set(d, border));
  const auto is_high = hn::Not(is_low);
  for (Dim i = 0; i < copied; ++i) {
    const auto lanes = hn::LoadU(d, from.at[i]);
    hn::StoreU(compressed<T>(lanes, is_low), d, to.at[i] + ends.low);
    hn::StoreU(compressed<T>(lanes, is_high), d, to.at[i] + ends.high);
  }
  const auto slots = hn::LoadU(ds, from.slots);
  hn::StoreU(hn::Compress(slots, slot_mask<T>(is_low)), ds, to.slots + ends.low);
  hn::StoreU(hn::Compress(slots, slot_mask<T>(is_high)), ds, to.slots + ends.high);
  const std::size_t lower = count_of<T>(is_low);
  ends.low += lower;
  ends.high += lanes_of<T> - lower;
}

#endif

template <Dim copied, Dim N, class T>
void part(const CenterLists<N, T>& centers, std::size_t count, Dim axis, const Selected<T>& border,
          const CenterLists<N, T>& parts) {
  const CenterLists<N, T> from = centers;  // its pointers in registers, whatever is written
  const CenterLists<N, T> to = parts;
  Ends ends{0, border.less};
#if HWY_TARGET <= HWY_AVX3
  for (std::size_t k = 0; k < count; k += lanes_of<T>) {
    if (HWY_LIKELY(ends.low + lanes_of<T> <= border.less && ends.high + lanes_of<T> <= count)) {
      part_vector<copied>(from.behind(k), axis, border.value, to, ends);
    } else {
      part_some<copied>(from.behind(k), std::min<std::size_t>(lanes_of<T>, count - k), axis, border.value, to, ends);
    }
  }
#else
  const T* const along = from.at[axis];
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t is_low = along[k] < border.value ? 1 : 0;
    const std::size_t place = ends.high ^ ((ends.high ^ ends.low) & (0 - is_low));  // compilers would make a branch
    for (Dim i = 0; i < copied; ++i) to.at[i][place] = from.at[i][k];
    to.slots[place] = from.slots[k];
    ends.low += is_low;
    ends.high += 1 - is_low;
  }
#endif
}

template <Dim N, class T>
std::size_t count_finite(const Aabb<N, T>* boxes, std::size_t count) {
  const Tag<T> d;
  const auto most = hn::Set(d, std::numeric_limits<T>::max());
  const auto least = hn::Neg(most);
  std::size_t k = 0;
  for (; k + lanes_of<T> <= count; k += lanes_of<T>) {
    const BoxLanes<N, T> box = load_boxes(boxes + k);
    auto is_finite = hn::FirstN(d, lanes_of<T>);
    for (Dim i = 0; i < N; ++i) {
      is_finite = hn::And(is_finite, hn::And(hn::Le(box.min[i], box.max[i]),
                                             hn::And(hn::Ge(box.min[i], least), hn::Le(box.max[i], most))));
    }
    if (HWY_UNLIKELY(!hn::AllTrue(d, is_finite))) break;
  }
  while (k < count && is_finite_box(boxes[k])) ++k;
  return k;
}

template <Dim N, class T>
CenterKernels<N, T> kernels() {
  return {hwy::TargetName(HWY_TARGET),
          count_finite<N, T>,
          centers_of<N, T>,
          bounds_of_centers<N, T>,
          select<T>,
          part<N, N, T>,
          part<0, N, T>};
}

}  // namespace

const AllCenterKernels& all_center_kernels() {
  static const AllCenterKernels all{kernels<2, float>(), kernels<3, float>(), kernels<2, double>(),
                                    kernels<3, double>()};
  return all;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::detail {
namespace {
HWY_EXPORT(all_center_kernels);
}

std::int64_t center_kernel_targets() { return HWY_TARGETS; }

template <Dim N, class T>
const CenterKernels<N, T>& center_kernels() {
  const AllCenterKernels& all = HWY_DYNAMIC_DISPATCH(all_center_kernels)();
  if constexpr (std::is_same_v<T, float>) {
    if constexpr (N == 2) return all.flat_float;
    if constexpr (N == 3) return all.solid_float;
  } else {
    if constexpr (N == 2) return all.flat_double;
    if constexpr (N == 3) return all.solid_double;
  }
}

template const CenterKernels<2, float>& center_kernels();
template const CenterKernels<3, float>& center_kernels();
template const CenterKernels<2, double>& center_kernels();
template const CenterKernels<3, double>& center_kernels();

}  // namespace graze::detail
#endif
