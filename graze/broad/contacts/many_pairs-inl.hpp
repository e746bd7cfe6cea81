// SPDX-License-Identifier: MIT
// The numbers of many pairs, one pair per lane: bit-identical to those for one pair in query/fast_contact/one_pair.hpp,
// with features as numbers. Included once per instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_CONTACTS_MANY_PAIRS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_MANY_PAIRS_INL_HPP
#undef GRAZE_BROAD_CONTACTS_MANY_PAIRS_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_MANY_PAIRS_INL_HPP
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <hwy/highway.h>

#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/query/fast_contact/one_pair.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

using Real = Doubles;
using Mask = DoublesMask;
using Point2d = LaneVec<2, double>;
using FeatureName = Doubles;  ///< The feature's index in `touched_features`.

// ---- Numbers and masks. Highway has the operations on two vectors.

HWY_INLINE Real all(double value) { return hn::Set(Tag<double>(), value); }
/// With a compile-time constant.
HWY_INLINE Mask all(bool value) {
#if HWY_TARGET <= HWY_AVX3
  return mask_of(Tag<double>(), value ? (1U << pairs_at_once) - 1 : 0);
#else
  const hn::RebindToUnsigned<Tag<double> > bits;
  return hn::MaskFromVec(hn::BitCast(Tag<double>(), hn::Set(bits, value ? ~std::uint64_t{0} : 0)));
#endif
}

HWY_INLINE Real operator+(Real a, double b) { return a + all(b); }
HWY_INLINE Real operator-(Real a, double b) { return a - all(b); }
HWY_INLINE Real operator*(double a, Real b) { return all(a) * b; }
HWY_INLINE Real operator*(Real a, double b) { return a * all(b); }
HWY_INLINE Real operator/(double a, Real b) { return all(a) / b; }
HWY_INLINE Real operator-(Real v) { return hn::Neg(v); }
HWY_INLINE Mask operator==(Real a, double b) { return a == all(b); }
HWY_INLINE Mask operator<(Real a, double b) { return a < all(b); }
HWY_INLINE Mask operator>(Real a, double b) { return a > all(b); }
HWY_INLINE Mask operator<=(Real a, double b) { return a <= all(b); }
HWY_INLINE Mask operator>=(Real a, double b) { return a >= all(b); }
/// A negated mask, for which `&&` has an instruction.
struct NotMask {
  Mask mask;
  HWY_INLINE operator Mask() const { return hn::Not(mask); }
};
HWY_INLINE NotMask operator!(Mask mask) { return {mask}; }
HWY_INLINE Mask operator&&(Mask a, Mask b) { return hn::And(a, b); }
HWY_INLINE Mask operator&&(Mask a, NotMask b) { return hn::AndNot(b.mask, a); }
HWY_INLINE Mask operator&&(NotMask a, Mask b) { return hn::AndNot(a.mask, b); }
HWY_INLINE Mask operator&&(NotMask a, NotMask b) { return hn::Not(hn::Or(a.mask, b.mask)); }
HWY_INLINE Mask operator||(Mask a, Mask b) { return hn::Or(a, b); }
HWY_INLINE Mask both_of(Mask a, Mask b) { return hn::And(a, b); }
HWY_INLINE Mask either_of(Mask a, Mask b) { return hn::Or(a, b); }
HWY_INLINE Mask are_same(Mask a, Mask b) { return hn::Not(hn::Xor(a, b)); }

HWY_INLINE bool any(Mask mask) { return !hn::AllFalse(Tag<double>(), mask); }
HWY_INLINE bool any_likely(Mask /*of_most*/) { return true; }

HWY_INLINE Real fabs(Real v) { return hn::Abs(v); }
HWY_INLINE Real sqrt(Real v) { return hn::Sqrt(v); }
HWY_INLINE Real side_of(Real v) { return hn::CopySign(all(1.0), v); }
HWY_INLINE Real copysign(Real magnitude, Real sign) { return hn::CopySign(magnitude, sign); }

HWY_INLINE Real select(Mask mask, Real yes, Real no) { return hn::IfThenElse(mask, yes, no); }
HWY_INLINE Mask select(Mask mask, Mask yes, Mask no) { return hn::Or(hn::And(mask, yes), hn::AndNot(mask, no)); }
HWY_INLINE Point select(Mask mask, const Point& yes, const Point& no) {
  return {{select(mask, yes[0], no[0]), select(mask, yes[1], no[1]), select(mask, yes[2], no[2])}};
}
HWY_INLINE Point2d select(Mask mask, const Point2d& yes, const Point2d& no) {
  return {{select(mask, yes[0], no[0]), select(mask, yes[1], no[1])}};
}
HWY_INLINE Point2d one_of(Mask mask, const Point2d& yes, const Point2d& no) { return select(mask, yes, no); }
HWY_INLINE Real or_zero(Mask mask, Real number) { return hn::IfThenElseZero(mask, number); }
template <class V>
HWY_INLINE void take(Mask mask, const V& value, V& to) {
  to = select(mask, value, to);
}

// ---- Points

template <class P>
HWY_INLINE P zero() {
  if constexpr (std::is_same_v<P, Point>) return {{all(0.0), all(0.0), all(0.0)}};
  if constexpr (std::is_same_v<P, Point2d>) return {{all(0.0), all(0.0)}};
}
HWY_INLINE Point operator-(const Point& v) { return {{-v[0], -v[1], -v[2]}}; }
HWY_INLINE Point operator/(const Point& v, Real divisor) { return {{v[0] / divisor, v[1] / divisor, v[2] / divisor}}; }
HWY_INLINE Point abs(const Point& v) { return {{fabs(v[0]), fabs(v[1]), fabs(v[2])}}; }
HWY_INLINE Real sum_abs(const Point& v) { return fabs(v[0]) + fabs(v[1]) + fabs(v[2]); }
HWY_INLINE Real max_abs(const Point& v) { return hn::Max(hn::Max(fabs(v[0]), fabs(v[1])), fabs(v[2])); }

HWY_INLINE Point2d operator+(const Point2d& a, const Point2d& b) { return {{a[0] + b[0], a[1] + b[1]}}; }
HWY_INLINE Point2d operator-(const Point2d& a, const Point2d& b) { return {{a[0] - b[0], a[1] - b[1]}}; }
HWY_INLINE Point2d operator-(const Point2d& v) { return {{-v[0], -v[1]}}; }
HWY_INLINE Point2d operator*(const Point2d& v, Real factor) { return {{v[0] * factor, v[1] * factor}}; }
HWY_INLINE Real dot(const Point2d& a, const Point2d& b) { return a[0] * b[0] + a[1] * b[1]; }
HWY_INLINE Real sum_abs(const Point2d& v) { return fabs(v[0]) + fabs(v[1]); }
HWY_INLINE Point2d perpendicular(const Point2d& v) { return {{-v[1], v[0]}}; }

// ---- Axes

using Axis = Real;

HWY_INLINE Axis axis_number(Dim i) { return all(static_cast<double>(i)); }
HWY_INLINE Mask is_axis(Axis axis, Dim i) { return axis == axis_number(i); }

template <class V>
HWY_INLINE V one_of_three(Axis axis, const V& first, const V& second, const V& third) {
  return select(is_axis(axis, 2), third, select(is_axis(axis, 1), second, first));
}
HWY_INLINE Real turned(const Point& v, Axis axis, Dim turns = 0) {
  return one_of_three(axis, v[turns], v[(turns + 1) % 3], v[(turns + 2) % 3]);
}
HWY_INLINE Point turned(const Point (&of_axes)[3], Axis axis, Dim turns = 0) {
  return one_of_three(axis, of_axes[turns], of_axes[(turns + 1) % 3], of_axes[(turns + 2) % 3]);
}
HWY_INLINE Point across_others(const Point (&axes)[3], Axis axis) {
  return one_of_three(axis, cross(axes[1], axes[2]), cross(axes[2], axes[0]), cross(axes[0], axes[1]));
}
HWY_INLINE Point placed(Axis axis, Real on_axis, Real on_next, Real on_last) {
  return {{one_of_three(axis, on_axis, on_last, on_next), one_of_three(axis, on_next, on_axis, on_last),
           one_of_three(axis, on_last, on_next, on_axis)}};
}
HWY_INLINE Point unit_point(Axis axis) { return placed(axis, all(1.0), all(0.0), all(0.0)); }

// ---- Features

/// The features that a point may be on: for round shapes those of one_pair.hpp, and for a sphere the first; then, with
/// three bits for the axes along which it is at the box's end and three for the side, those of feature_of_box; then the
/// corners of a 2D box, and its sides.
inline constexpr double first_vertex = 0;
inline constexpr double second_vertex = 1;
inline constexpr double first_edge = 2;
inline constexpr std::size_t first_of_box = 3;
inline constexpr std::size_t first_of_2d = first_of_box + 64;
using TouchedFeatures = std::array<Feature, first_of_2d + 8>;
inline const TouchedFeatures& touched_features() {
  static const auto features = [] {
    TouchedFeatures known{{{FeatureKind::vertex, 0}, {FeatureKind::vertex, 1}, {FeatureKind::edge, 0}}};
    for (std::size_t bits = 0; bits < 64; ++bits) {
      const auto side = [bits](std::size_t i) { return (bits >> (3 + i) & 1U) != 0 ? 1.0 : -1.0; };
      const bool is_beyond[3] = {(bits & 1U) != 0, (bits & 2U) != 0, (bits & 4U) != 0};
      known[first_of_box + bits] =
          one_pair::feature_of(one_pair::feature_of_box({side(0), side(1), side(2)}, is_beyond));
    }
    for (std::uint32_t number = 0; number < 4; ++number) {
      known[first_of_2d + number] = {FeatureKind::vertex, number};
      known[first_of_2d + 4 + number] = {FeatureKind::edge, number};
    }
    return known;
  }();
  return features;
}

HWY_INLINE FeatureName feature_of_box(const Point& place, const Mask (&is_beyond)[3]) {
  Real name = all(double{first_of_box});
  for (Dim i = 0; i < 3; ++i) {
    name = name + or_zero(place[i] > 0.0, all(double(8 << i))) + or_zero(is_beyond[i], all(double(1 << i)));
  }
  return name;
}
/// The bits for being at an axis's end.
HWY_INLINE Real end_bits(Axis axis, Mask is_far) {
  const Real bit = one_of_three(axis, all(1.0), all(2.0), all(4.0));
  return bit + or_zero(is_far, 8 * bit);
}
HWY_INLINE FeatureName feature_of_face(Axis axis, Mask is_far) {
  return all(double{first_of_box}) + end_bits(axis, is_far);
}
HWY_INLINE FeatureName feature_of_side(Axis axis, Mask is_far, Mask is_along_last, Mask is_at_far_end) {
  const Axis next = one_of_three(axis, all(1.0), all(2.0), all(0.0));
  const Axis last = one_of_three(axis, all(2.0), all(0.0), all(1.0));
  return feature_of_face(axis, is_far) + end_bits(select(is_along_last, last, next), is_at_far_end);
}

HWY_INLINE FeatureName corner_feature_2d(const Point2d& sides) {
  return all(double{first_of_2d}) + (or_zero(sides[0] > 0.0, all(1.0)) + or_zero(sides[1] > 0.0, all(2.0)));
}
HWY_INLINE FeatureName side_feature_2d(Mask across_second, Real at) {
  return all(double{first_of_2d + 4}) + (or_zero(across_second, all(2.0)) + or_zero(at > 0.0, all(1.0)));
}

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
