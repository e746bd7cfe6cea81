// SPDX-License-Identifier: MIT
// Verdicts on many pairs of boxes, and of spheres and oriented boxes. Included once per instruction set, so it has no
// ordinary include guard.
#if defined(GRAZE_BROAD_TOUCHING_BOXES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_TOUCHING_BOXES_INL_HPP
#undef GRAZE_BROAD_TOUCHING_BOXES_INL_HPP
#else
#define GRAZE_BROAD_TOUCHING_BOXES_INL_HPP
#endif

#include <limits>

#include <hwy/highway.h>

#include <graze/broad/touching/lanes-inl.hpp>
#include <graze/broad/touching/round-inl.hpp>
#include <graze/math/tolerance.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

/// The comparisons are exact. Boxes that share only a face, and NaN, remain undecided.
template <Dim N, class T>
HWY_INLINE LaneVerdict<T> verdict_of(const LaneAabb<N, T>& a, const LaneAabb<N, T>& b) {
  auto gap = hn::Or(hn::Lt(a.max.at[0], b.min.at[0]), hn::Lt(b.max.at[0], a.min.at[0]));
  auto within = hn::And(hn::Gt(a.max.at[0], b.min.at[0]), hn::Gt(b.max.at[0], a.min.at[0]));
  auto numbers = hn::And(hn::Le(a.min.at[0], a.max.at[0]), hn::Le(b.min.at[0], b.max.at[0]));
  for (Dim i = 1; i < N; ++i) {
    gap = hn::Or(gap, hn::Or(hn::Lt(a.max.at[i], b.min.at[i]), hn::Lt(b.max.at[i], a.min.at[i])));
    within = hn::And(within, hn::And(hn::Gt(a.max.at[i], b.min.at[i]), hn::Gt(b.max.at[i], a.min.at[i])));
    numbers = hn::And(numbers, hn::And(hn::Le(a.min.at[i], a.max.at[i]), hn::Le(b.min.at[i], b.max.at[i])));
  }
  return {hn::And(gap, numbers), hn::And(within, numbers)};
}

/// The orthonormality error of axes: the largest |axis i . axis j - (i == j)|.
template <Dim N, class T>
HWY_INLINE Lanes<T> orthonormality_error_of(const LaneObb<N, T>& box) {
  auto orthonormality_error = hn::Zero(Tag<T>());
  for (Dim i = 0; i < N; ++i) {
    orthonormality_error = hn::Max(orthonormality_error, hn::Abs(hn::Sub(inner(box.axes[i], box.axes[i]), all(T(1)))));
    for (Dim j = i + 1; j < N; ++j)
      orthonormality_error = hn::Max(orthonormality_error, hn::Abs(inner(box.axes[i], box.axes[j])));
  }
  return orthonormality_error;
}
template <Dim N, class T>
HWY_INLINE Lanes<T> orthonormality_error_of(const LaneAabb<N, T>&) {
  return hn::Zero(Tag<T>());
}

/// A second box in the frame of the first, as in query/relation/box_filter.hpp.
template <Dim N, class T>
struct LaneView {
  LaneVec<N, T> half;
  LaneVec<N, T> other_half;
  LaneVec<N, T> between;        ///< From center to center.
  LaneVec<N, T> directions[N];  ///< The second box's axes.
  LaneVec<N, T> shadow[N];      ///< Their absolute values.

  HWY_INLINE LaneView(const LaneObb<N, T>& a, const LaneObb<N, T>& b) : half(a.half), other_half(b.half) {
    const auto way = difference(b.center, a.center);
    unrolled<N>([&](auto i) GRAZE_INLINE_LAMBDA {
      between.at[i] = inner(a.axes[i], way);
      unrolled<N>([&](auto j) GRAZE_INLINE_LAMBDA { directions[j].at[i] = inner(a.axes[i], b.axes[j]); });
    });
    set_shadow();
  }

  HWY_INLINE LaneView(const LaneAabb<N, T>& a, const LaneObb<N, T>& b) : other_half(b.half) {
    for (Dim i = 0; i < N; ++i) {
      half.at[i] = hn::Mul(all(T(0.5)), hn::Sub(a.max.at[i], a.min.at[i]));
      between.at[i] = hn::Sub(hn::Sub(b.center.at[i], a.min.at[i]), half.at[i]);
      directions[i] = b.axes[i];
    }
    set_shadow();
  }

 private:
  HWY_INLINE void set_shadow() {
    unrolled<N>([&](auto j) GRAZE_INLINE_LAMBDA {
      unrolled<N>([&](auto i) GRAZE_INLINE_LAMBDA { shadow[j].at[i] = hn::Abs(directions[j].at[i]); });
    });
  }
};

/// The largest gap along the axes of both boxes and, in 3D, along the cross products of their edges, and the sum of all
/// lengths involved.
template <class T>
struct LaneGaps {
  Lanes<T> on_axes;
  Lanes<T> across;
  Lanes<T> size;
};

/// The gap along the cross product of the first box's axis i and the second's axis j.
template <class T>
HWY_INLINE Lanes<T> gap_across(const LaneView<3, T>& view, Dim i, Dim j) {
  const Dim i1 = (i + 1) % 3;
  const Dim i2 = (i + 2) % 3;
  const Dim j1 = (j + 1) % 3;
  const Dim j2 = (j + 2) % 3;
  const auto along = hn::NegMulAdd(view.between.at[i1], view.directions[j].at[i2],
                                   hn::Mul(view.between.at[i2], view.directions[j].at[i1]));
  auto gap = hn::NegMulAdd(view.half.at[i1], view.shadow[j].at[i2], hn::Abs(along));
  gap = hn::NegMulAdd(view.half.at[i2], view.shadow[j].at[i1], gap);
  gap = hn::NegMulAdd(view.other_half.at[j1], view.shadow[j2].at[i], gap);
  return hn::NegMulAdd(view.other_half.at[j2], view.shadow[j1].at[i], gap);
}

template <Dim N, class T>
HWY_INLINE LaneGaps<T> gaps_of(const LaneView<N, T>& view) {
  LaneGaps<T> gaps;
  gaps.on_axes = gaps.across = all(-std::numeric_limits<T>::infinity());
  gaps.size = hn::Zero(Tag<T>());
  for (Dim i = 0; i < N; ++i) {
    auto reach = view.half.at[i];
    for (Dim j = 0; j < N; ++j) reach = hn::MulAdd(view.other_half.at[j], view.shadow[j].at[i], reach);
    const auto along = hn::Abs(view.between.at[i]);
    gaps.on_axes = hn::Max(gaps.on_axes, hn::Sub(along, reach));
    gaps.size = hn::Add(gaps.size, hn::Add(along, reach));
  }
  for (Dim j = 0; j < N; ++j) {
    auto gap = hn::Sub(hn::Abs(inner(view.between, view.directions[j])), view.other_half.at[j]);
    for (Dim i = 0; i < N; ++i) gap = hn::NegMulAdd(view.half.at[i], view.shadow[j].at[i], gap);
    gaps.on_axes = hn::Max(gaps.on_axes, gap);
  }
  if constexpr (N == 3) {
    for (Dim i = 0; i < 3; ++i) {
      for (Dim j = 0; j < 3; ++j) gaps.across = hn::Max(gaps.across, gap_across(view, i, j));
    }
  }
  return gaps;
}

/// Whether only cross products of nearly parallel edges leave the verdict open.
template <class T>
HWY_INLINE hn::Mask<Tag<T>> only_parallel_edges_are_open(const LaneView<3, T>& view, Lanes<T> band, Lanes<T> parallel) {
  auto settled = hn::Lt(hn::Zero(Tag<T>()), band);
  for (Dim i = 0; i < 3; ++i) {
    for (Dim j = 0; j < 3; ++j) {
      const auto off = hn::Add(view.shadow[j].at[(i + 1) % 3], view.shadow[j].at[(i + 2) % 3]);
      const auto deep = hn::Lt(gap_across(view, i, j), hn::Neg(band));
      settled = hn::And(settled, hn::Or(hn::Lt(off, parallel), deep));
    }
  }
  return settled;
}

/// Whether no product of these lengths is affected by underflow. False if one is NaN.
template <class T>
HWY_INLINE hn::Mask<Tag<T>> are_usable(const LaneGaps<T>& gaps) {
  constexpr T least_product = T(0x1p20) * std::numeric_limits<T>::min();
  return hn::Gt(hn::Mul(gaps.size, hn::Min(gaps.size, all(T(1)))), all(least_product));
}

/// Gaps beyond this prove the verdict for boxes whose axes are orthonormal up to `skew`.
template <class T>
HWY_INLINE Lanes<T> band_of(const LaneGaps<T>& gaps, Lanes<T> orthonormality_error) {
  return hn::Mul(hn::Mul(all(static_cast<T>(tolerance::box_filter)), orthonormality_error), gaps.size);
}

/// What is certain from all axes together; filter_of_boxes in query/relation/box_filter.hpp gives the reason.
template <class T>
HWY_INLINE LaneVerdict<T> verdict_of_gaps(const LaneGaps<T>& gaps, Lanes<T> band) {
  const auto usable = are_usable(gaps);
  const auto widest = hn::Max(gaps.on_axes, gaps.across);
  return {hn::And(usable, hn::Gt(widest, band)), hn::And(usable, hn::Lt(widest, hn::Neg(band)))};
}

/// The same, and what is certain apart from nearly parallel edges.
template <Dim N, class T>
HWY_INLINE LaneVerdict<T> verdict_within(const LaneView<N, T>& view, const LaneGaps<T>& gaps,
                                         Lanes<T> orthonormality_error) {
  const auto band = band_of(gaps, orthonormality_error);
  LaneVerdict<T> verdict = verdict_of_gaps(gaps, band);
  if constexpr (N == 3) {
    const auto is_deep = hn::And(are_usable(gaps), hn::Lt(gaps.on_axes, hn::Mul(all(T(-8)), band)));
    const auto deep = hn::And(is_deep, hn::Not(hn::Or(verdict.apart, verdict.overlapping)));
    if (!hn::AllFalse(Tag<T>(), deep)) {
      const auto parallel = hn::Mul(all(static_cast<T>(2 * tolerance::box_filter)), orthonormality_error);
      verdict.overlapping =
          hn::Or(verdict.overlapping, hn::And(deep, only_parallel_edges_are_open(view, band, parallel)));
    }
  }
  return verdict;
}

/// Tries the greatest skew of any valid box first; if a lane remains open, the actual skew of these boxes.
template <Dim N, class T, class First>
HWY_INLINE LaneVerdict<T> verdict_of_boxes(const First& a, const LaneObb<N, T>& b) {
  const LaneView<N, T> view(a, b);
  const LaneGaps<T> gaps = gaps_of(view);
  LaneVerdict<T> verdict = verdict_within(view, gaps, all(static_cast<T>(tolerance::orthonormal)));
  if (hn::AllTrue(Tag<T>(), hn::Or(verdict.apart, verdict.overlapping))) return verdict;
  const auto measured = hn::Add(hn::Max(orthonormality_error_of(a), orthonormality_error_of(b)),
                                all(tolerance::measured_orthonormality_error<T>));
  return verdict_within(view, gaps, hn::Min(measured, all(static_cast<T>(tolerance::orthonormal))));
}

/// Branch-free, so it assumes the greatest skew of any valid box. This leaves two or three percent of the lanes open,
/// at least one in every third vector: retrying those at once would mispredict as much as it saves.
template <Dim N, class T>
HWY_INLINE LaneVerdict<T> quick_verdict_of(const LaneObb<N, T>& a, const LaneObb<N, T>& b) {
  const LaneGaps<T> gaps = gaps_of(LaneView<N, T>(a, b));
  return verdict_of_gaps(gaps, band_of(gaps, all(static_cast<T>(tolerance::orthonormal))));
}

template <Dim N, class T>
HWY_INLINE LaneVerdict<T> verdict_of(const LaneObb<N, T>& a, const LaneObb<N, T>& b) {
  return verdict_of_boxes(a, b);
}
template <Dim N, class T>
HWY_INLINE LaneVerdict<T> verdict_of(const LaneAabb<N, T>& a, const LaneObb<N, T>& b) {
  return verdict_of_boxes(a, b);
}

/// The vector from the center, clamped to the box along each axis, as filter_of_sphere in
/// query/relation/box_filter.hpp.
template <Dim N, class T>
HWY_INLINE LaneVerdict<T> verdict_of(const LaneSphere<N, T>& sphere, const LaneObb<N, T>& box) {
  const Tag<T> d;
  LaneVec<N, T> rest = difference(sphere.center, box.center);
  LaneVec<N, T> along;
  auto size = sphere.radius;
  auto outside = all(-std::numeric_limits<T>::infinity());
  for (Dim i = 0; i < N; ++i) {
    along.at[i] = inner(box.axes[i], rest);
    size = hn::Add(size, hn::Add(hn::Abs(rest.at[i]), box.half.at[i]));
    outside = hn::Max(outside, hn::Sub(hn::Abs(along.at[i]), box.half.at[i]));
  }
  for (Dim i = 0; i < N; ++i) {
    const auto place = hn::Min(hn::Max(along.at[i], hn::Neg(box.half.at[i])), box.half.at[i]);
    for (Dim k = 0; k < N; ++k) rest.at[k] = hn::NegMulAdd(place, box.axes[i].at[k], rest.at[k]);
  }
  const auto distance = hn::Sqrt(inner(rest, rest));
  const auto usable = hn::And(hn::Gt(size, all(least_size<T>)), hn::Lt(size, all(largest_size<T>)));
  const auto verdict_within = [&](auto orthonormality_error) -> LaneVerdict<T> {
    const auto slack = hn::Mul(hn::Mul(all(static_cast<T>(tolerance::box_filter)), orthonormality_error), size);
    const auto apart = hn::Gt(distance, hn::Add(sphere.radius, slack));
    const auto near = hn::Lt(distance, hn::Sub(sphere.radius, slack));
    return {hn::And(usable, apart), hn::And(usable, hn::Or(near, hn::Lt(outside, hn::Neg(slack))))};
  };
  const LaneVerdict<T> verdict = verdict_within(all(static_cast<T>(tolerance::orthonormal)));
  if (hn::AllTrue(d, hn::Or(verdict.apart, verdict.overlapping))) return verdict;
  return verdict_within(hn::Add(orthonormality_error_of(box), all(tolerance::measured_orthonormality_error<T>)));
}

// ---- A capsule against a box

/// The capsule's axis relative to the box's center, in world axes and in the box's axes.
template <Dim N, class T>
struct LaneAxis {
  LaneVec<N, T> start;
  LaneVec<N, T> local_start;
  LaneVec<N, T> local_along;

  HWY_INLINE LaneAxis(const LaneObb<N, T>& box, const LaneCapsule<N, T>& capsule)
      : start(difference(capsule.start, box.center)) {
    for (Dim i = 0; i < N; ++i) {
      local_start.at[i] = inner(box.axes[i], start);
      local_along.at[i] = inner(box.axes[i], capsule.along);
    }
  }
};

/// Half the derivative of the squared distance from the box along the capsule's axis, at a parameter of the axis.
template <Dim N, class T>
HWY_INLINE Lanes<T> slope_at(const LaneAxis<N, T>& axis, const LaneVec<N, T>& half, Lanes<T> share) {
  auto slope = hn::Zero(Tag<T>());
  for (Dim i = 0; i < N; ++i) {
    const auto place = hn::MulAdd(axis.local_along.at[i], share, axis.local_start.at[i]);
    const auto inside = hn::Min(hn::Max(place, hn::Neg(half.at[i])), half.at[i]);
    slope = hn::MulAdd(axis.local_along.at[i], hn::Sub(place, inside), slope);
  }
  return slope;
}

/// The approximate parameter of the axis's point nearest to the box. The derivative is increasing, and linear between
/// the points where the axis crosses a face's plane; these bracket its zero.
template <Dim N, class T>
HWY_INLINE Lanes<T> nearest_share(const LaneAxis<N, T>& axis, const LaneVec<N, T>& half) {
  const auto zero = hn::Zero(Tag<T>());
  auto low = zero;
  auto high = all(T(1));
  for (Dim i = 0; i < N; ++i) {
    const auto inverse = hn::Div(all(T(1)), axis.local_along.at[i]);
    for (const auto& face : {half.at[i], hn::Neg(half.at[i])}) {
      const auto share = clamped_share<T>(hn::Mul(hn::Sub(face, axis.local_start.at[i]), inverse));
      const auto rises = hn::Gt(slope_at(axis, half, share), zero);
      high = hn::IfThenElse(rises, hn::Min(high, share), high);
      low = hn::IfThenElse(rises, low, hn::Max(low, share));
    }
  }
  const auto slope_low = slope_at(axis, half, low);
  const auto rise = hn::Sub(slope_at(axis, half, high), slope_low);
  const auto part = clamped_share<T>(hn::IfThenElse(hn::Gt(rise, zero), hn::Div(hn::Neg(slope_low), rise), zero));
  return hn::MulAdd(hn::Sub(high, low), part, low);
}

/// As for two capsules: two points prove overlap, a direction proves separation. Both refer to the set that the box
/// represents, whose axes are orthonormal only up to rounding.
template <Dim N, class T>
HWY_INLINE LaneVerdict<T> verdict_of(const LaneObb<N, T>& box, const LaneCapsule<N, T>& capsule) {
  const LaneAxis<N, T> axis(box, capsule);
  const auto share = nearest_share(axis, box.half);
  LaneVec<N, T> way;  // from the point of the box to that of the axis
  auto size = hn::Add(hn::Add(sum_abs(axis.start), sum_abs(capsule.along)), capsule.radius);
  for (Dim k = 0; k < N; ++k) way.at[k] = hn::MulAdd(capsule.along.at[k], share, axis.start.at[k]);
  for (Dim i = 0; i < N; ++i) {
    const auto place = hn::MulAdd(axis.local_along.at[i], share, axis.local_start.at[i]);
    const auto inside = hn::Min(hn::Max(place, hn::Neg(box.half.at[i])), box.half.at[i]);
    for (Dim k = 0; k < N; ++k) way.at[k] = hn::NegMulAdd(inside, box.axes[i].at[k], way.at[k]);
    size = hn::Add(size, box.half.at[i]);
  }
  const auto length = hn::Sqrt(inner(way, way));
  auto gap = hn::Add(inner(axis.start, way), hn::Min(inner(capsule.along, way), hn::Zero(Tag<T>())));
  for (Dim i = 0; i < N; ++i) gap = hn::NegMulAdd(box.half.at[i], hn::Abs(inner(box.axes[i], way)), gap);
  return proved_verdict<T>(gap, length, capsule.radius, size);
}

template <Dim N, class T>
HWY_INLINE LaneVerdict<T> verdict_of(const LaneAabb<N, T>& box, const LaneCapsule<N, T>& capsule) {
  // Relative to the box's center, in world axes.
  LaneCapsule<N, T> seen = capsule;
  const LaneObb<N, T> around_origin(box);
  for (Dim i = 0; i < N; ++i) {
    seen.start.at[i] = hn::Sub(hn::Sub(capsule.start.at[i], box.min.at[i]), around_origin.half.at[i]);
  }
  return verdict_of(around_origin, seen);
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
