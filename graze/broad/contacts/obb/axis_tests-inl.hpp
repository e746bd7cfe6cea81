// SPDX-License-Identifier: MIT
// Tests the axes of many pairs of oriented boxes: finds the axis of least depth of each, and whether the boxes overlap.
// Included once per instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_CONTACTS_OBB_AXIS_TESTS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_OBB_AXIS_TESTS_INL_HPP
#undef GRAZE_BROAD_CONTACTS_OBB_AXIS_TESTS_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_OBB_AXIS_TESTS_INL_HPP
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include <hwy/highway.h>

#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/broad/contacts/manifold_points-inl.hpp>
#include <graze/broad/contacts/obb/axes-inl.hpp>
#include <graze/broad/contacts/obb/choice-inl.hpp>
#include <graze/broad/contacts/obb/obb_kernels.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact/boxes.hpp>
#include <graze/shape/fields/shape_order.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

template <class T>
const T* numbers_of(const Obb<3, T>& box) {
  return reinterpret_cast<const T*>(&box);
}

/// Bits of the pairs of a group whose second box is the first in the contact order.
template <class T>
HWY_NOINLINE std::uint32_t turned_of_ties(const T* const* first, const T* const* second, std::uint32_t ties) {
  std::uint32_t turned = 0;
  for (; ties != 0; ties &= ties - 1) {
    const auto lane = static_cast<std::uint32_t>(std::countr_zero(ties));
    const auto box = [lane](const T* const* rows) { return reinterpret_cast<const Obb<3, T>*>(rows[lane]); };
    turned |= std::uint32_t{!is_in_order(*box(first), *box(second))} << lane;
  }
  return turned;
}

/// The same by their centers, as compare of shape/fields/shape_order.hpp; by all numbers if these are level.
template <class T>
HWY_INLINE std::uint32_t turned_of(const Doubles* of_first, const Doubles* of_second, const T* const* first,
                                   const T* const* second) {
  const auto along = [&](std::size_t k) {
    return hn::Mul(both(order_direction[k]), hn::Sub(of_second[k], of_first[k]));
  };
  const Doubles ahead = sum(along(0), along(1), along(2));
  std::uint32_t turned = bits_of<double>(hn::Lt(ahead, both(0)));
  const std::uint32_t ties = bits_of<double>(hn::Eq(ahead, both(0)));
  if (HWY_UNLIKELY(ties != 0)) turned |= turned_of_ties(first, second, ties);
  return turned;
}

/// Swaps lanes of two vectors.
template <class D, class V>
HWY_INLINE void exchange_where(hn::Mask<D> mask, V& a, V& b) {
  const V first = hn::IfThenElse(mask, b, a);
  b = hn::IfThenElse(mask, a, b);
  a = first;
}

/// The boxes of pairs in their contact order.
template <class T>
struct BoxesInOrder {
  const T* const* a;
  const T* const* b;
  std::uint32_t turned;

  HWY_INLINE const T* first(std::size_t lane) const { return is_turned(lane) ? b[lane] : a[lane]; }
  HWY_INLINE const T* second(std::size_t lane) const { return is_turned(lane) ? a[lane] : b[lane]; }
  bool is_turned(std::size_t lane) const { return (turned >> lane & 1U) != 0; }
};

/// The bits of pairs that are swapped.
HWY_INLINE std::uint32_t turned_at_all(FirstBox first) { return first == FirstBox::in_order ? ~std::uint32_t{} : 0; }

/// As many pairs as a vector has floats, in their contact order, relative to the first boxes' centers.
template <class T>
class PairsToLookAt;

template <>
class PairsToLookAt<float> {
 public:
  HWY_INLINE PairsToLookAt(const float* const* first, const float* const* second, FirstBox which) {
    load_struct<float>(first, first_);
    load_struct<float>(second, second_);
    turned_ = 0;
    for (std::size_t group = 0; group < 2; ++group) {
      Doubles centers[2][3];
      for (std::size_t k = 0; k < 3; ++k) {
        centers[0][k] = widened(first_[k], group);
        centers[1][k] = widened(second_[k], group);
      }
      const std::size_t lane = group * pairs_at_once;
      turned_ |= turned_of(centers[0], centers[1], first + lane, second + lane) << lane;
    }
    turned_ &= turned_at_all(which);
    const auto mask = mask_of(Tag<float>(), turned_);
    for (std::size_t k = 0; k < 15; ++k) exchange_where<Tag<float>>(mask, first_[k], second_[k]);
  }

  /// One bit for each pair whose second box is the first in the contact order.
  std::uint32_t turned() const { return turned_; }

  HWY_INLINE AxesLook look() const {
    LaneObb<3, float> a(first_);
    LaneObb<3, float> b(second_);
    b.center = difference(b.center, a.center);
    for (Dim i = 0; i < 3; ++i) a.center.at[i] = hn::Zero(Tag<float>());
    return AxesLook(a, b);
  }

  /// Axes are rounded to float, so hardly any repeats another.
  HWY_INLINE AxesLook::Bits distinct(AxesLook::Bits axes) const { return axes; }

 private:
  HWY_INLINE static Doubles widened(Lanes<float> v, std::size_t group) {
    return hn::PromoteTo(Tag<double>(), group == 0 ? hn::LowerHalf(FloatTag(), v) : hn::UpperHalf(FloatTag(), v));
  }

  Lanes<float> first_[15];
  Lanes<float> second_[15];
  std::uint32_t turned_;
};

template <>
class PairsToLookAt<double> {
 public:
  HWY_INLINE PairsToLookAt(const double* const* first, const double* const* second, FirstBox which)
      : first_(first), second_(second) {
    Halves of_group[2];
    unrolled<2>([&](auto group) GRAZE_INLINE_LAMBDA { load(first, second, group, of_group[group]); });
    unrolled<12>([&](auto k) GRAZE_INLINE_LAMBDA {
      a_[3 + k] = together(of_group[0].first[k], of_group[1].first[k]);
      b_[3 + k] = together(of_group[0].second[k], of_group[1].second[k]);
    });
    turned_ = (of_group[0].turned | of_group[1].turned << pairs_at_once) & turned_at_all(which);
    const auto turned = mask_of(Tag<float>(), turned_);
    unrolled<3>([&](auto k) GRAZE_INLINE_LAMBDA {
      const Lanes<float> way = together(of_group[0].way[k], of_group[1].way[k]);
      a_[k] = hn::Zero(Tag<float>());
      b_[k] = hn::IfThenElse(turned, hn::Neg(way), way);
    });
    unrolled<12>([&](auto k) GRAZE_INLINE_LAMBDA { exchange_where<Tag<float>>(turned, a_[3 + k], b_[3 + k]); });
  }

  /// One bit for each pair whose second box is the first in the contact order.
  std::uint32_t turned() const { return turned_; }

  HWY_INLINE AxesLook look() const { return AxesLook(LaneObb<3, float>(a_), LaneObb<3, float>(b_)); }

  /// Removes repeated axes.
  HWY_NOINLINE AxesLook::Bits distinct(AxesLook::Bits axes) const {
    Bits repeated[2];
    const BoxesInOrder<double> boxes{first_, second_, turned_};
    for (std::size_t group = 0; group < 2; ++group) {
      const double* a[pairs_at_once];
      const double* b[pairs_at_once];
      for (std::size_t lane = 0; lane < pairs_at_once; ++lane) {
        a[lane] = boxes.first(group * pairs_at_once + lane);
        b[lane] = boxes.second(group * pairs_at_once + lane);
      }
      repeated[group] = repeated_axes(load_boxes(a).axes, load_boxes(b).axes);
    }
    const AxesLook::Bits left = hn::AndNot(joined(repeated[0], repeated[1]), axes);
    return hn::IfThenElse(hn::Eq(left, hn::Zero(AxesLook::BitsTag())), axes, left);
  }

 private:
  /// A group in float: the boxes without their centers, and the vector from the first center to the second.
  struct Halves {
    hn::Vec<FloatTag> first[12];
    hn::Vec<FloatTag> second[12];
    hn::Vec<FloatTag> way[3];
    std::uint32_t turned;
  };

  HWY_INLINE static void load(const double* const* first, const double* const* second, std::size_t group, Halves& to) {
    Doubles of_first[15];
    Doubles of_second[15];
    const std::size_t lane = group * pairs_at_once;
    load_numbers_of_boxes(first + lane, of_first);
    load_numbers_of_boxes(second + lane, of_second);
    to.turned = turned_of(of_first, of_second, first + lane, second + lane);
    unrolled<3>([&](auto k) GRAZE_INLINE_LAMBDA { to.way[k] = narrowed(hn::Sub(of_second[k], of_first[k])); });
    unrolled<12>([&](auto k) GRAZE_INLINE_LAMBDA {
      to.first[k] = narrowed(of_first[3 + k]);
      to.second[k] = narrowed(of_second[3 + k]);
    });
  }

  HWY_INLINE static Lanes<float> together(hn::Vec<FloatTag> low, hn::Vec<FloatTag> high) {
    return hn::Combine(Tag<float>(), high, low);
  }

  const double* const* first_;
  const double* const* second_;
  Lanes<float> a_[15];
  Lanes<float> b_[15];
  std::uint32_t turned_;
};

/// Tests many pairs, and sets aside those with several candidates for the axis of least depth.
template <class T>
class LooksAtObbs {
 public:
  LooksAtObbs(std::span<const TwoObbs<T>> pairs, FirstBox first, ObbAxisTest* looks)
      : pairs_(pairs), first_(first), looks_(looks) {
    for (std::size_t from = 0; from < pairs.size(); from += at_once) look(from);
    while (ties_.count > 0) choose();
  }

 private:
  static constexpr std::size_t at_once = lanes_of<float>;
  /// With at least this many ambiguous pairs, repeated axes are removed; fewer are set aside as they are.
  static constexpr int many_ties = at_once / 4;
  using LookTag = AxesLook::BitsTag;
  using LookBits = AxesLook::Bits;
  using HalfBitsTag = hn::Rebind<std::uint32_t, Tag<double>>;
  using HalfBits = hn::Vec<HalfBitsTag>;

  void look(std::size_t from) {
    const std::size_t count = std::min(at_once, pairs_.size() - from);
    std::array<const T*, at_once> first;
    std::array<const T*, at_once> second;
    for (std::size_t lane = 0; lane < at_once; ++lane) {
      const TwoObbs<T>& boxes = pairs_[lane < count ? from + lane : from];
      first[lane] = numbers_of(*boxes.a);
      second[lane] = numbers_of(*boxes.b);
    }
    const PairsToLookAt<T> boxes(first.data(), second.data(), first_);
    const LookBits bits = boxes.look().bits();
    LookBits axes = hn::And(bits, all_bits(AxesLook::axes));
    if (std::popcount(bits_of<float>(hn::RebindMask(Tag<float>(), are_several(axes)))) >= many_ties) {
      axes = boxes.distinct(axes);
    }
    const LookBits along_faces =
        hn::GatherIndex(LookTag(), axes_along_faces.data(),
                        hn::BitCast(hn::RebindToSigned<LookTag>(), hn::ShiftRight<AxesLook::first_right_angle>(bits)));
    const auto several = are_several(axes);
    put(from, count, look_of(bits, axes, along_faces, boxes.turned()));
    std::uint32_t tied = bits_of<float>(hn::RebindMask(Tag<float>(), several)) & ((1U << count) - 1);
    if (tied != 0) put_aside(from, tied, {first.data(), second.data(), boxes.turned()}, axes, along_faces);
    while (ties_.count >= pairs_at_once) choose();
  }

  HWY_INLINE static LookBits all_bits(std::uint32_t value) { return hn::Set(LookTag(), value); }

  HWY_INLINE static hn::Mask<LookTag> are_several(LookBits axes) {
    return hn::Ne(hn::And(axes, hn::Sub(axes, all_bits(1))), hn::Zero(LookTag()));
  }

  HWY_INLINE static LookBits look_of(LookBits bits, LookBits axes, LookBits along_faces, std::uint32_t turned) {
    const LookBits place = place_of(axes);
    const LookBits verdict = hn::And(bits, all_bits(AxesLook::overlapping | AxesLook::apart));
    const LookBits along = hn::ShiftLeft<24>(hn::And(hn::Shr(along_faces, place), all_bits(1)));
    const LookBits turns = hn::IfThenElseZero(mask_of(LookTag(), turned), all_bits(ObbAxisTest::turned));
    return hn::Or(hn::Or(place, verdict), hn::Or(along, turns));
  }

  /// The index of the lowest bit, or no_axis if there is none: the exponent of the bit as a float.
  HWY_INLINE static LookBits place_of(LookBits axes) {
    const LookBits with_last = hn::Or(axes, all_bits(1U << ObbAxisTest::no_axis));
    const LookBits lowest = hn::And(with_last, hn::Sub(hn::Zero(LookTag()), with_last));
    const auto number = hn::ConvertTo(Tag<float>(), hn::BitCast(hn::RebindToSigned<LookTag>(), lowest));
    return hn::Sub(hn::ShiftRight<23>(hn::BitCast(LookTag(), number)), all_bits(127));
  }

  HWY_INLINE void put(std::size_t from, std::size_t count, LookBits looks) {
    static_assert(sizeof(ObbAxisTest) == sizeof(std::uint32_t));
    if (HWY_LIKELY(count == at_once)) {
      hn::StoreU(looks, LookTag(), &looks_[from].bits);
    } else {
      alignas(64) std::array<std::uint32_t, at_once> bits;
      hn::Store(looks, LookTag(), bits.data());
      for (std::size_t lane = 0; lane < count; ++lane) looks_[from + lane].bits = bits[lane];
    }
  }

  HWY_INLINE void put_aside(std::size_t from, std::uint32_t tied, const BoxesInOrder<T>& boxes, LookBits axes,
                            LookBits along_faces) {
    alignas(64) std::array<std::uint32_t, at_once> axes_of;
    alignas(64) std::array<std::uint32_t, at_once> along_faces_of;
    hn::Store(axes, LookTag(), axes_of.data());
    hn::Store(along_faces, LookTag(), along_faces_of.data());
    for (; tied != 0; tied &= tied - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(tied));
      ties_.first[ties_.count] = boxes.first(lane);
      ties_.second[ties_.count] = boxes.second(lane);
      ties_.pairs[ties_.count] = static_cast<std::uint32_t>(from + lane);
      ties_.axes[ties_.count] = axes_of[lane];
      ties_.along_faces[ties_.count] = along_faces_of[lane];
      ++ties_.count;
    }
  }

  /// Decides among the axes of the last pairs set aside.
  HWY_NOINLINE void choose() {
    const std::size_t count = std::min(pairs_at_once, ties_.count);
    const std::size_t from = ties_.count - count;
    ties_.fill_group(from);
    ties_.count = from;
    BoxPair boxes;
    load_boxes(&ties_.first[from], boxes.box[0]);
    load_boxes(&ties_.second[from], boxes.box[1]);
    see_from_first(boxes);
    const Bits axes = hn::PromoteTo(BitsTag(), hn::LoadU(HalfBitsTag(), &ties_.axes[from]));
    const Bits distinct = hn::AndNot(repeated_axes(boxes.box[0].axes, boxes.box[1].axes), axes);
    const SearchLanes found(boxes, hn::IfThenElse(hn::Eq(distinct, hn::Zero(BitsTag())), axes, distinct));
    const Doubles place = hn::IfThenElse(found.is_open(), both(ObbAxisTest::no_axis), found.place());
    alignas(64) std::array<std::uint32_t, pairs_at_once> chosen;
    hn::Store(axis_bits_of(place, hn::LoadU(HalfBitsTag(), &ties_.along_faces[from])), HalfBitsTag(), chosen.data());
    for (std::size_t lane = 0; lane < count; ++lane) {
      std::uint32_t& bits = looks_[ties_.pairs[from + lane]].bits;
      bits = (bits & ~(ObbAxisTest::axis_bits | ObbAxisTest::along_face)) | chosen[lane];
    }
  }

  HWY_INLINE static HalfBits axis_bits_of(Doubles place, HalfBits along_faces) {
    const HalfBitsTag d;
    const HalfBits axis = hn::BitCast(d, hn::DemoteTo(hn::RebindToSigned<HalfBitsTag>(), place));
    const HalfBits along = hn::And(hn::Shr(along_faces, axis), hn::Set(d, 1));
    return hn::Or(axis, hn::ShiftLeft<24>(along));
  }

  /// Pairs with several candidates for the axis of least depth, their boxes in their contact order.
  struct Ties {
    static constexpr std::size_t room = at_once + pairs_at_once;

    /// Repeats the pair at `from` to fill an incomplete group.
    HWY_INLINE void fill_group(std::size_t from) {
      for (std::size_t i = count; i < from + pairs_at_once; ++i) {
        first[i] = first[from];
        second[i] = second[from];
        axes[i] = axes[from];
        along_faces[i] = along_faces[from];
      }
    }

    std::array<const T*, room> first;
    std::array<const T*, room> second;
    std::array<std::uint32_t, room> pairs;
    std::array<BoxesAxes, room> axes;
    std::array<BoxesAxes, room> along_faces;
    std::size_t count = 0;
  };

  std::span<const TwoObbs<T>> pairs_;
  FirstBox first_;
  ObbAxisTest* looks_;
  Ties ties_;
};

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
