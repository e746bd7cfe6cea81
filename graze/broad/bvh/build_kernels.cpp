// SPDX-License-Identifier: MIT
// Compiled once per instruction set: Highway includes this file again for each.
#include <algorithm>
#include <bit>
#include <limits>
#include <type_traits>
#include <utility>

#include <graze/broad/bvh/build_kernels.hpp>
#include <graze/broad/index/box_cover.hpp>
#include <graze/broad/simd/choice.hpp>
#include <graze/math/rounding.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/broad/bvh/build_kernels.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include <graze/broad/simd/box_lanes-inl.hpp>
#include <graze/broad/simd/compress-inl.hpp>
#include <graze/broad/simd/lanes-inl.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

template <class T>
using LaneMask = hn::Mask<Tag<T>>;

template <class T>
HWY_INLINE std::size_t count_of(const LaneMask<T>& mask) {
  return hn::CountTrue(Tag<T>(), mask);
}

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
  if (count < lanes_of<T>) {
    for (Dim i = 0; i < N; ++i) {
      const auto [low, high] = std::minmax_element(centers.at[i], centers.at[i] + count);
      bounds.min[i] = *low;
      bounds.max[i] = *high;
    }
    return bounds;
  }
  Lanes<T> low[N];
  Lanes<T> high[N];
  for (Dim i = 0; i < N; ++i) low[i] = high[i] = hn::LoadU(d, centers.at[i] + count - lanes_of<T>);
  for (std::size_t k = 0; k + lanes_of<T> <= count; k += lanes_of<T>) {
    for (Dim i = 0; i < N; ++i) {
      const auto at = hn::LoadU(d, centers.at[i] + k);
      low[i] = lesser<T>(low[i], at);
      high[i] = greater<T>(high[i], at);
    }
  }
  for (Dim i = 0; i < N; ++i) {
    bounds.min[i] = hn::GetLane(hn::MinOfLanes(d, low[i]));
    bounds.max[i] = hn::GetLane(hn::MaxOfLanes(d, high[i]));
  }
  return bounds;
}

// ---- Selection

/// Up to this count, each number is compared with all.
constexpr std::size_t few = 32;

/// From this count on, a larger sample pays. Its numbers are compared with each other.
template <class T>
constexpr std::size_t worth_a_sample = lanes_of<T> == 1 ? 4096 : 512;

/// The number of rounds before std::nth_element takes over.
constexpr int most_rounds = 24;

/// Up to `most` numbers, padded with numbers greater than all.
template <class T, std::size_t most>
struct Numbers {
  static constexpr std::size_t vectors = most / lanes_of<T>;

  alignas(64) T all[most];
  alignas(64) T less[most];  // for each, how many are less
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

  /// The number of a rank: the greatest with at most `rank` smaller ones.
  HWY_INLINE Selected<T> of_rank(std::size_t rank) const {
    const Tag<T> d;
    const auto most_less = hn::Set(d, static_cast<T>(rank));
    const auto least = hn::Set(d, std::numeric_limits<T>::lowest());
    auto value = least;
    auto below = hn::Zero(d);
    for (std::size_t k = 0; k < most; k += lanes_of<T>) {
      const auto lanes = hn::Load(d, less + k);
      const auto is_candidate = hn::Le(lanes, most_less);
      value = greater<T>(value, hn::IfThenElse(is_candidate, hn::Load(d, all + k), least));
      below = greater<T>(below, hn::IfThenElseZero(is_candidate, lanes));
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

/// The sample's numbers `off` places before and after the expected place of the rank.
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
  if (count < worth_a_sample<T>) return bracket_from_sample<16>(numbers, count, rank, is_narrow ? 0 : 3);
  return bracket_from_sample<64>(numbers, count, rank, is_narrow ? 0 : 6);
}

/// The count of numbers below a bracket, and of those in it, which are copied to `to`; `to` may be the input.
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
    const auto is_below = hn::Lt(lanes, low);
    const auto is_up_to = hn::Le(lanes, high);
    hn::StoreU(ToFront<Tag<T>>(bits_of<T>(hn::AndNot(is_below, is_up_to)))(lanes), d, to + result.within);
    const std::size_t below = count_of<T>(is_below);
    result.below += below;
    result.within += count_of<T>(is_up_to) - below;
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
  std::size_t less = 0;  // of those already excluded
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

// ---- Partitioning

/// The number of centers in each part so far, and the end of each part.
struct Ends {
  std::size_t low;
  std::size_t high;
};

/// Centers below a border along an axis go to the low part.
template <class T>
struct Cut {
  Dim axis;
  T value;
};

/// A vector of slots with as many lanes as one of T.
template <class T>
using SlotTag = hn::Rebind<std::uint32_t, Tag<T>>;

/// Whether whole vectors are partitioned; short ones are not worth it.
template <class T>
constexpr bool parts_vectors = lanes_of<T> >= 4;

/// Partitions centers one by one. Copies the first `copied` coordinates.
template <Dim copied, Dim N, class T>
HWY_INLINE void part_some(const CenterLists<N, T>& from, std::size_t some, Cut<T> cut, const CenterLists<N, T>& to,
                          Ends& ends) {
  const T* const along = from.at[cut.axis];
  for (std::size_t k = 0; k < some; ++k) {
    const std::size_t is_low = along[k] < cut.value ? 1 : 0;
    // compilers would turn this into a branch
    const std::size_t place = ends.high ^ ((ends.high ^ ends.low) & (0 - is_low));
    for (Dim i = 0; i < copied; ++i) to.at[i][place] = from.at[i][k];
    to.slots[place] = from.slots[k];
    ends.low += is_low;
    ends.high += 1 - is_low;
  }
}

/// Partitions a whole vector; both ends need space for a full vector.
template <Dim copied, Dim N, class T>
HWY_INLINE void part_vector(const CenterLists<N, T>& from, Cut<T> cut, const CenterLists<N, T>& to, Ends& ends) {
  constexpr std::uint32_t all = (1U << lanes_of<T>)-1U;
  const Tag<T> d;
  const SlotTag<T> ds;
  const auto is_low = hn::Lt(hn::LoadU(d, from.at[cut.axis]), hn::Set(d, cut.value));
  const std::uint32_t bits = bits_of<T>(is_low);
  const ToFront<Tag<T>> low_first(bits);
  const ToFront<Tag<T>> high_first(bits ^ all);
  for (Dim i = 0; i < copied; ++i) {
    const auto lanes = hn::LoadU(d, from.at[i]);
    hn::StoreU(low_first(lanes), d, to.at[i] + ends.low);
    hn::StoreU(high_first(lanes), d, to.at[i] + ends.high);
  }
  const auto slots = hn::LoadU(ds, from.slots);
  hn::StoreU(ToFront<SlotTag<T>>(bits)(slots), ds, to.slots + ends.low);
  hn::StoreU(ToFront<SlotTag<T>>(bits ^ all)(slots), ds, to.slots + ends.high);
  const std::size_t lower = count_of<T>(is_low);
  ends.low += lower;
  ends.high += lanes_of<T> - lower;
}

template <Dim copied, Dim N, class T>
void part(const CenterLists<N, T>& centers, std::size_t count, Dim axis, const Selected<T>& border,
          const CenterLists<N, T>& parts) {
  const CenterLists<N, T> from = centers;  // keeps the pointers in registers across stores
  const CenterLists<N, T> to = parts;
  const Cut<T> cut{axis, border.value};
  Ends ends{0, border.less};
  if constexpr (parts_vectors<T>) {
    for (std::size_t k = 0; k < count; k += lanes_of<T>) {
      if (HWY_LIKELY(ends.low + lanes_of<T> <= border.less && ends.high + lanes_of<T> <= count)) {
        part_vector<copied>(from.behind(k), cut, to, ends);
      } else {
        part_some<copied>(from.behind(k), std::min<std::size_t>(lanes_of<T>, count - k), cut, to, ends);
      }
    }
  } else {
    part_some<copied>(from, count, cut, to, ends);
  }
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
BuildKernels<N, T> kernels() {
  return {hwy::TargetName(HWY_TARGET),
          count_finite<N, T>,
          centers_of<N, T>,
          bounds_of_centers<N, T>,
          select<T>,
          part<N, N, T>,
          part<0, N, T>};
}

}  // namespace

const AllBuildKernels& all_build_kernels() {
  static const AllBuildKernels all{kernels<2, float>(), kernels<3, float>(), kernels<2, double>(),
                                   kernels<3, double>()};
  return all;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::detail {
namespace {
HWY_EXPORT(all_build_kernels);
}

std::int64_t center_kernel_targets() { return HWY_TARGETS; }

template <Dim N, class T>
const BuildKernels<N, T>& build_kernels() {
  return HWY_DYNAMIC_DISPATCH(all_build_kernels)().template of<N, T>();
}

template const BuildKernels<2, float>& build_kernels();
template const BuildKernels<3, float>& build_kernels();
template const BuildKernels<2, double>& build_kernels();
template const BuildKernels<3, double>& build_kernels();

}  // namespace graze::detail
#endif
