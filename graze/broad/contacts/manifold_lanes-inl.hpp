// SPDX-License-Identifier: MIT
// Vectors in double and oriented boxes, one pair per lane, bit-identical to PairedVec in math/lanes/lanes.hpp: products
// are rounded before they are added. Included once per instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_CONTACTS_MANIFOLD_LANES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_MANIFOLD_LANES_INL_HPP
#undef GRAZE_BROAD_CONTACTS_MANIFOLD_LANES_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_MANIFOLD_LANES_INL_HPP
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <hwy/highway.h>

#include <graze/broad/touching/lanes-inl.hpp>
#include <graze/math/vec.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

using Doubles = Lanes<double>;
using DoublesMask = hn::Mask<Tag<double>>;
using Point = LaneVec<3, double>;

constexpr std::size_t pairs_at_once = lanes_of<double>;

/// A number of each pair, to be read one by one.
template <class T>
struct alignas(64) Row {
  T of[pairs_at_once];
};

/// Bits of each pair, as wide as its numbers: there are few mask registers, and spilling them is slow.
using BitsTag = hn::RebindToUnsigned<Tag<double>>;
using Bits = hn::Vec<BitsTag>;

/// A single bit in all lanes, for T as wide as a lane: loaded, which is faster than generating it.
template <class T>
struct alignas(64) BitsInLanes {
  static constexpr std::size_t count = 16;
  T of[count][hn::MaxLanes(Tag<double>()) * sizeof(double) / sizeof(T)];

  constexpr BitsInLanes() : of{} {
    for (std::size_t place = 0; place < count; ++place) {
      for (T& lane : of[place]) lane = T{1} << place;
    }
  }
};

template <class T>
inline constexpr BitsInLanes<T> bits_in_lanes;

/// A bit mask, one bit per lane.
template <class D>
HWY_INLINE hn::Mask<D> mask_of(D d, std::uint32_t bits) {
  const std::uint64_t wide = bits;
  return hn::LoadMaskBits(d, reinterpret_cast<const std::uint8_t*>(&wide));
}

HWY_INLINE Bits bit_at(std::size_t place) { return hn::Load(BitsTag(), bits_in_lanes<std::uint64_t>.of[place]); }
HWY_INLINE DoublesMask has_bit(Bits bits, std::size_t place) {
  return hn::RebindMask(Tag<double>(), hn::TestBit(bits, bit_at(place)));
}
HWY_INLINE Bits bit_where(DoublesMask mask, std::size_t place) {
  return hn::IfThenElseZero(hn::RebindMask(BitsTag(), mask), bit_at(place));
}
/// The lowest bit of each pair.
HWY_INLINE Bits first_of(Bits bits) { return hn::And(bits, hn::Sub(hn::Zero(BitsTag()), bits)); }

HWY_INLINE Doubles both(double value) { return hn::Set(Tag<double>(), value); }
/// For non-negative integers.
HWY_INLINE Bits whole(Doubles v) { return hn::BitCast(BitsTag(), hn::ConvertTo(hn::RebindToSigned<Tag<double>>(), v)); }
HWY_INLINE DoublesMask no_lane() { return hn::Lt(both(0), both(0)); }

/// As std::max and std::min, also for zeros of either sign.
HWY_INLINE Doubles max_of(Doubles a, Doubles b) { return hn::IfThenElse(hn::Lt(a, b), b, a); }
HWY_INLINE Doubles min_of(Doubles a, Doubles b) { return hn::IfThenElse(hn::Lt(b, a), b, a); }
HWY_INLINE Doubles sign_of(Doubles v) { return hn::CopySign(both(1), hn::Add(v, both(0))); }

HWY_INLINE Point operator+(const Point& a, const Point& b) {
  return {{hn::Add(a.at[0], b.at[0]), hn::Add(a.at[1], b.at[1]), hn::Add(a.at[2], b.at[2])}};
}
HWY_INLINE Point operator-(const Point& a, const Point& b) { return difference(a, b); }
HWY_INLINE Point operator*(const Point& a, Doubles factor) {
  return {{hn::Mul(a.at[0], factor), hn::Mul(a.at[1], factor), hn::Mul(a.at[2], factor)}};
}

HWY_INLINE Doubles sum(Doubles x, Doubles y, Doubles z) { return hn::Add(hn::Add(x, y), z); }

HWY_INLINE Doubles dot(const Point& a, const Point& b) {
  return sum(hn::Mul(a.at[0], b.at[0]), hn::Mul(a.at[1], b.at[1]), hn::Mul(a.at[2], b.at[2]));
}

HWY_INLINE Point cross(const Point& a, const Point& b) {
  const auto minor = [&](Dim i, Dim j) { return hn::Sub(hn::Mul(a.at[i], b.at[j]), hn::Mul(b.at[i], a.at[j])); };
  return {{minor(1, 2), minor(2, 0), minor(0, 1)}};
}

HWY_INLINE Point one_of(const DoublesMask& mask, const Point& yes, const Point& no) {
  return {{hn::IfThenElse(mask, yes.at[0], no.at[0]), hn::IfThenElse(mask, yes.at[1], no.at[1]),
           hn::IfThenElse(mask, yes.at[2], no.at[2])}};
}

/// Boxes like PairedBox of query/fast_contact/obb/faces.hpp.
struct BoxLanes {
  Point center;
  Point axes[3];
  Point half_edges[3];
  Doubles half[3];
};

HWY_INLINE BoxLanes one_of(const DoublesMask& mask, const BoxLanes& yes, const BoxLanes& no) {
  BoxLanes result;
  result.center = one_of(mask, yes.center, no.center);
  for (Dim i = 0; i < 3; ++i) {
    result.axes[i] = one_of(mask, yes.axes[i], no.axes[i]);
    result.half_edges[i] = one_of(mask, yes.half_edges[i], no.half_edges[i]);
    result.half[i] = hn::IfThenElse(mask, yes.half[i], no.half[i]);
  }
  return result;
}

HWY_INLINE Doubles size_of(const BoxLanes& box) {
  const auto along = [&box](Dim k) {
    return hn::Add(
        hn::Add(hn::Add(hn::Abs(box.center.at[k]), hn::Abs(box.half_edges[0].at[k])), hn::Abs(box.half_edges[1].at[k])),
        hn::Abs(box.half_edges[2].at[k]));
  };
  return sum(along(0), along(1), along(2));
}

/// Rotates the axes so that the one with this number, 0, 1 or 2, is the first.
/// Written in place: a returned struct would be copied, by an instruction for long rows.
HWY_INLINE void turn_to(const BoxLanes& box, Doubles first, BoxLanes& result) {
  const DoublesMask is_second = hn::Eq(first, both(1));
  const DoublesMask is_third = hn::Eq(first, both(2));
  result.center = box.center;
  unrolled<3>([&](auto i) GRAZE_INLINE_LAMBDA {
    constexpr Dim next = (i + 1) % 3;
    constexpr Dim last = (i + 2) % 3;
    const auto chosen = [&](const Point& at_first, const Point& at_next, const Point& at_last) GRAZE_INLINE_LAMBDA {
      return one_of(is_third, at_last, one_of(is_second, at_next, at_first));
    };
    result.axes[i] = chosen(box.axes[i], box.axes[next], box.axes[last]);
    result.half_edges[i] = chosen(box.half_edges[i], box.half_edges[next], box.half_edges[last]);
    result.half[i] = hn::IfThenElse(is_third, box.half[last], hn::IfThenElse(is_second, box.half[next], box.half[i]));
  });
}

HWY_INLINE BoxLanes turned_to(const BoxLanes& box, Doubles first) {
  BoxLanes result;
  turn_to(box, first, result);
  return result;
}

/// Transposes eight rows of eight into out[k], with few shuffles: load_struct uses blocks of two numbers.
#if HWY_TARGET <= HWY_AVX3
HWY_INLINE void transpose_eight(const __m512d (&rows)[8], Doubles* out) {
  __m512d pairs[8];  // of rows i and i + 1: numbers 0, 2, 4, 6 and 1, 3, 5, 7
  unrolled<4>([&](auto two) GRAZE_INLINE_LAMBDA {
    pairs[2 * two] = _mm512_unpacklo_pd(rows[2 * two], rows[2 * two + 1]);
    pairs[2 * two + 1] = _mm512_unpackhi_pd(rows[2 * two], rows[2 * two + 1]);
  });
  unrolled<2>([&](auto odd) GRAZE_INLINE_LAMBDA {
    const __m512d low_of_four = _mm512_shuffle_f64x2(pairs[odd], pairs[odd + 2], 0x88);
    const __m512d high_of_four = _mm512_shuffle_f64x2(pairs[odd], pairs[odd + 2], 0xdd);
    const __m512d low_of_last = _mm512_shuffle_f64x2(pairs[odd + 4], pairs[odd + 6], 0x88);
    const __m512d high_of_last = _mm512_shuffle_f64x2(pairs[odd + 4], pairs[odd + 6], 0xdd);
    out[odd] = Doubles{_mm512_shuffle_f64x2(low_of_four, low_of_last, 0x88)};
    out[odd + 2] = Doubles{_mm512_shuffle_f64x2(high_of_four, high_of_last, 0x88)};
    out[odd + 4] = Doubles{_mm512_shuffle_f64x2(low_of_four, low_of_last, 0xdd)};
    out[odd + 6] = Doubles{_mm512_shuffle_f64x2(high_of_four, high_of_last, 0xdd)};
  });
}

HWY_INLINE __m512d eight_numbers(const double* from) { return _mm512_loadu_pd(from); }
HWY_INLINE __m512d eight_numbers(const float* from) { return _mm512_cvtps_pd(_mm256_loadu_ps(from)); }

/// The numbers of the boxes in all lanes, in double. The last eight begin with the eighth.
template <class T>
HWY_INLINE void load_numbers_of_boxes(const T* const* rows, Doubles (&numbers)[15]) {
  unrolled<2>([&](auto part) GRAZE_INLINE_LAMBDA {
    constexpr std::size_t first = 7 * part;
    __m512d from[8];
    unrolled<8>([&](auto lane) GRAZE_INLINE_LAMBDA { from[lane] = eight_numbers(rows[lane] + first); });
    transpose_eight(from, numbers + first);
  });
}
#else
template <class T>
HWY_INLINE void load_numbers_of_boxes(const T* const* rows, Doubles (&numbers)[15]) {
  if constexpr (std::is_same_v<T, double>) {
    load_struct<double>(rows, numbers);
  } else {
    const Tag<double> d;
    const hn::Rebind<float, Tag<double>> narrow;
    alignas(64) double wide[pairs_at_once][16];
    const double* wide_rows[pairs_at_once];
    for (std::size_t lane = 0; lane < pairs_at_once; ++lane) {
      wide_rows[lane] = wide[lane];
      for (std::size_t k = 0; k < 15; k += pairs_at_once) {
        const std::size_t first = std::min<std::size_t>(k, 15 - pairs_at_once);
        hn::StoreU(hn::PromoteTo(d, hn::LoadU(narrow, rows[lane] + first)), d, wide[lane] + first);
      }
    }
    load_struct<double>(wide_rows, numbers);
  }
}
#endif

HWY_INLINE void set_box(const Doubles (&numbers)[15], BoxLanes& box) {
  unrolled<3>([&](auto i) GRAZE_INLINE_LAMBDA {
    box.center.at[i] = numbers[i];
    box.half[i] = numbers[3 + i];
    unrolled<3>([&](auto k) GRAZE_INLINE_LAMBDA { box.axes[i].at[k] = numbers[6 + 3 * i + k]; });
    box.half_edges[i] = box.axes[i] * box.half[i];
  });
}

template <class T>
HWY_INLINE void load_boxes(const T* const* rows, BoxLanes& boxes) {
  Doubles numbers[15];
  load_numbers_of_boxes(rows, numbers);
  set_box(numbers, boxes);
}

template <class T>
HWY_INLINE BoxLanes load_boxes(const T* const* rows) {
  BoxLanes boxes;
  load_boxes(rows, boxes);
  return boxes;
}

/// Two boxes of each pair.
struct BoxPair {
  BoxLanes box[2];
};

/// Puts the boxes in their contact order, relative to the first one's center. Returns that center.
HWY_INLINE Point see_from_first(BoxPair& pair) {
  const Point origin = pair.box[0].center;
  pair.box[1].center = pair.box[1].center - origin;
  pair.box[0].center = {{both(0), both(0), both(0)}};
  return origin;
}

/// The gap along the normal of a box's first face, or along the cross product of the first edges of both, as in
/// MeetingObbs.
struct AxisLanes {
  Point normal;
  Doubles gap;
};

HWY_INLINE AxisLanes axis_of_face(const BoxLanes& own, Dim axis, const BoxLanes& other, const Point& way) {
  const Point adjoint = cross(own.axes[(axis + 1) % 3], own.axes[(axis + 2) % 3]);
  const Point across = adjoint * hn::Div(both(1), hn::Sqrt(dot(adjoint, adjoint)));
  const auto reach_of = [&across](const Point& half_edge) { return hn::Abs(dot(across, half_edge)); };
  const Doubles reach = hn::Add(
      hn::Add(hn::Add(reach_of(own.half_edges[axis]), reach_of(other.half_edges[0])), reach_of(other.half_edges[1])),
      reach_of(other.half_edges[2]));
  const Doubles ahead = dot(across, way);
  return {across * sign_of(ahead), hn::Sub(hn::Abs(ahead), reach)};
}

/// As AxisAcrossEdges, for boxes relative to the first one's center.
struct EdgesLanes {
  Point across;
  Doubles squared;
  Doubles ahead;
  Doubles heights[2][2];

  HWY_INLINE EdgesLanes(const BoxLanes& a, Dim i, const BoxLanes& b, Dim j)
      : EdgesLanes(a, i, b, j, cross(a.axes[i], b.axes[j])) {}

  /// With a given cross product.
  HWY_INLINE EdgesLanes(const BoxLanes& a, Dim i, const BoxLanes& b, Dim j, const Point& product)
      : across(product), squared(dot(across, across)), ahead(dot(across, b.center)) {
    heights[0][0] = dot(across, a.half_edges[(i + 1) % 3]);
    heights[0][1] = dot(across, a.half_edges[(i + 2) % 3]);
    heights[1][0] = dot(across, b.half_edges[(j + 1) % 3]);
    heights[1][1] = dot(across, b.half_edges[(j + 2) % 3]);
  }

  /// As in MeetingObbs.
  HWY_INLINE AxisLanes axis() const {
    const Doubles inverse = hn::Div(both(1), hn::Sqrt(squared));
    return {across * hn::Mul(sign_of(ahead), inverse), hn::Mul(gap(), inverse)};
  }

  /// Multiplied by the length.
  HWY_INLINE Doubles gap() const {
    const Doubles reach_a = hn::Add(hn::Abs(heights[0][0]), hn::Abs(heights[0][1]));
    const Doubles reach_b = hn::Add(hn::Abs(heights[1][0]), hn::Abs(heights[1][1]));
    return hn::Sub(hn::Abs(ahead), hn::Add(reach_a, reach_b));
  }
};

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
