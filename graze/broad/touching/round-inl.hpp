// SPDX-License-Identifier: MIT
// Verdicts on many pairs of spheres and capsules, and of spheres and AABBs. Included once per instruction set, so it
// has no ordinary include guard.
#if defined(GRAZE_BROAD_TOUCHING_ROUND_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_TOUCHING_ROUND_INL_HPP
#undef GRAZE_BROAD_TOUCHING_ROUND_INL_HPP
#else
#define GRAZE_BROAD_TOUCHING_ROUND_INL_HPP
#endif

#include <limits>
#include <type_traits>

#include <hwy/highway.h>

#include <graze/broad/touching/lanes-inl.hpp>
#include <graze/math/tolerance.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

/// The certain part of the verdict on each lane's pair.
template <class T>
struct LaneVerdict {
  hn::Mask<Tag<T>> apart;
  hn::Mask<Tag<T>> overlapping;
};

/// As filter_of_squares in query/relation/sphere_filter.hpp.
template <class T>
HWY_INLINE LaneVerdict<T> verdict_of_squares(Lanes<T> distance, Lanes<T> reach) {
  const auto slack =
      hn::MulAdd(all(tolerance::squares<T>), hn::Add(distance, reach), all(std::numeric_limits<T>::min()));
  const auto gap = hn::Sub(distance, reach);
  return {hn::Gt(gap, slack), hn::Lt(gap, hn::Neg(slack))};
}

template <Dim N, class T>
HWY_INLINE LaneVerdict<T> verdict_of(const LaneSphere<N, T>& a, const LaneSphere<N, T>& b) {
  const auto between = difference(b.center, a.center);
  const auto reach = hn::Add(a.radius, b.radius);
  return verdict_of_squares<T>(inner(between, between), hn::Mul(reach, reach));
}

template <Dim N, class T>
HWY_INLINE LaneVerdict<T> verdict_of(const LaneSphere<N, T>& sphere, const LaneAabb<N, T>& box) {
  LaneVec<N, T> outside;  // twice the distance; |x| + x instead of a maximum preserves NaN
  for (Dim i = 0; i < N; ++i) {
    const auto below = hn::Sub(box.min.at[i], sphere.center.at[i]);
    const auto above = hn::Sub(sphere.center.at[i], box.max.at[i]);
    outside.at[i] = hn::Add(hn::Add(hn::Abs(below), below), hn::Add(hn::Abs(above), above));
  }
  const auto reach = hn::Add(sphere.radius, sphere.radius);
  return verdict_of_squares<T>(inner(outside, outside), hn::Mul(reach, reach));
}

/// Between these sizes, products of three numbers neither overflow nor lose significant digits to underflow.
template <class T>
inline constexpr T least_size = std::is_same_v<T, float> ? T(0x1p-30) : T(0x1p-300);
template <class T>
inline constexpr T largest_size = std::is_same_v<T, float> ? T(0x1p30) : T(0x1p300);

/// Clamps x to [0, 1], also NaN.
template <class T>
HWY_INLINE Lanes<T> clamped_share(Lanes<T> x) {
  return hn::Min(hn::Max(x, hn::Zero(Tag<T>())), all(T(1)));
}

/// The approximate vector from a's nearest point to b's: the lines' nearest points, clamped one after the other
/// (Ericson, Real-Time Collision Detection, 2005, 5.1.9). If a quotient is NaN, any parameter will do.
template <Dim N, class T>
HWY_INLINE LaneVec<N, T> way_between(const LaneVec<N, T>& u, const LaneVec<N, T>& v, const LaneVec<N, T>& w) {
  const auto zero = hn::Zero(Tag<T>());
  const auto share_of = [zero](auto numerator, auto denominator) {
    return clamped_share<T>(hn::IfThenElse(hn::Gt(denominator, zero), hn::Div(numerator, denominator), zero));
  };
  const auto uu = inner(u, u);
  const auto vv = inner(v, v);
  const auto uv = inner(u, v);
  const auto uw = inner(u, w);
  const auto vw = inner(v, w);
  auto s = share_of(hn::Sub(hn::Mul(uw, vv), hn::Mul(vw, uv)), hn::Sub(hn::Mul(uu, vv), hn::Mul(uv, uv)));
  const auto t = share_of(hn::Sub(hn::Mul(uv, s), vw), vv);
  s = share_of(hn::MulAdd(uv, t, uw), uu);
  LaneVec<N, T> way;
  for (Dim i = 0; i < N; ++i) way.at[i] = hn::Sub(hn::MulAdd(v.at[i], t, w.at[i]), hn::Mul(u.at[i], s));
  return way;
}

/// The verdict on two cores inflated by `reach` in total, from one point of each. They overlap if the distance `length`
/// between the points is clearly less than `reach`. They are apart if the gap between the cores along the vector
/// between the points is clearly more; `gap` is that gap times `length`. Any two points give a correct verdict.
template <class T>
HWY_INLINE LaneVerdict<T> proved_verdict(Lanes<T> gap, Lanes<T> length, Lanes<T> reach, Lanes<T> size) {
  const auto usable = hn::And(hn::Gt(size, all(least_size<T>)), hn::Lt(size, all(largest_size<T>)));
  const auto slack = hn::Mul(all(tolerance::segment_lanes<T>), size);
  // A direction shorter than the slack is mostly rounding.
  const auto apart = hn::And(hn::Gt(length, slack), hn::Gt(gap, hn::Mul(hn::Add(reach, slack), length)));
  return {hn::And(usable, apart), hn::And(usable, hn::Lt(length, hn::Sub(reach, slack)))};
}

template <Dim N, class T>
HWY_INLINE LaneVerdict<T> verdict_of(const LaneCapsule<N, T>& a, const LaneCapsule<N, T>& b) {
  const auto zero = hn::Zero(Tag<T>());
  const auto between = difference(b.start, a.start);
  const auto reach = hn::Add(a.radius, b.radius);
  const auto size = hn::Add(hn::Add(sum_abs(a.along), sum_abs(b.along)), hn::Add(sum_abs(between), reach));
  const auto way = way_between(a.along, b.along, between);
  const auto end_of_a = hn::Max(inner(a.along, way), zero);
  const auto begin_of_b = hn::Add(inner(between, way), hn::Min(inner(b.along, way), zero));
  return proved_verdict<T>(hn::Sub(begin_of_b, end_of_a), hn::Sqrt(inner(way, way)), reach, size);
}

template <Dim N, class T>
HWY_INLINE LaneVerdict<T> verdict_of(const LaneSphere<N, T>& sphere, const LaneCapsule<N, T>& capsule) {
  return verdict_of(LaneCapsule<N, T>(sphere), capsule);
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
