// SPDX-License-Identifier: MIT
// Capsules and boxes in the plane, a lane for each pair, as query/fast_contact/cores_2d.hpp has them, to the bit.
// Included once for each instruction set, hence no ordinary guard.
#if defined(GRAZE_BROAD_CONTACTS_2D_CORES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_2D_CORES_INL_HPP
#undef GRAZE_BROAD_CONTACTS_2D_CORES_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_2D_CORES_INL_HPP
#endif

#include <cstddef>

#include <hwy/highway.h>

#include <graze/broad/contacts/fast_contact-inl.hpp>
#include <graze/broad/contacts/manifold_lanes-inl.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

HWY_INLINE Point2d one_of(const DoublesMask& mask, const Point2d& yes, const Point2d& no) {
  return {{hn::IfThenElse(mask, yes.at[0], no.at[0]), hn::IfThenElse(mask, yes.at[1], no.at[1])}};
}
/// As std::copysign(1.0, v).
HWY_INLINE Doubles side_of(Doubles v) { return hn::CopySign(both(1), v); }

/// As Core2d.
template <std::size_t axes>
struct CoreLanes2d {
  Point2d center;
  Point2d half_edge[2];
  Point2d along[2];
  Doubles half_length[2];
  Point2d normal[2];
  Doubles radius;

  /// A constructor would be called by those of structs that hold one, which are compiled for any machine.
  HWY_INLINE void clear() {
    const Point2d zero{{both(0), both(0)}};
    center = zero;
    radius = both(0);
    for (std::size_t i = 0; i < 2; ++i) {
      half_edge[i] = along[i] = normal[i] = zero;
      half_length[i] = both(0);
    }
  }

  HWY_INLINE Doubles size() const {
    Doubles sum = hn::Add(sum_abs(center), radius);
    for (std::size_t i = 0; i < axes; ++i) sum = hn::Add(sum, sum_abs(half_edge[i]));
    return sum;
  }

  HWY_INLINE Doubles shortest() const { return axes == 1 ? half_length[0] : min_of(half_length[0], half_length[1]); }

  HWY_INLINE Point2d corner(const Point2d& sides) const {
    return center + half_edge[0] * sides.at[0] + half_edge[1] * sides.at[1];
  }

  HWY_INLINE Point2d sides_of(const Point2d& place) const {
    const Point2d off = place - center;
    return {{side_of(dot(off, half_edge[0])), side_of(dot(off, half_edge[1]))}};
  }

  HWY_INLINE void set_edge(std::size_t i, const Point2d& half) {
    half_edge[i] = half;
    half_length[i] = hn::Sqrt(dot(half, half));
    along[i] = half * hn::Div(both(1), half_length[i]);
  }
};

// ---- Of shapes in memory, as core_2d(shape, origin): `origin` where they are seen from

HWY_INLINE CoreLanes2d<1> core_2d_of(const CapsuleNumbers<Point2d>& capsule, const Point2d& origin) {
  const Point2d start = capsule.start - origin;
  const Point2d end = capsule.end - origin;
  CoreLanes2d<1> core;
  core.clear();
  core.center = (start + end) * both(0.5);
  core.set_edge(0, (end - start) * both(0.5));
  core.normal[1] = perpendicular(core.along[0]);
  core.radius = capsule.radius;
  return core;
}

/// An oriented box' center, half extents and axes.
struct ObbLanes2d {
  Point2d center;
  Doubles half[2];
  Point2d axes[2];

  template <class T>
  HWY_INLINE explicit ObbLanes2d(const T* const* rows) {
    Doubles numbers[8];
    load_wide(rows, numbers);
    center = {{numbers[0], numbers[1]}};
    for (std::size_t i = 0; i < 2; ++i) {
      half[i] = numbers[2 + i];
      axes[i] = {{numbers[4 + 2 * i], numbers[5 + 2 * i]}};
    }
  }
};

HWY_INLINE CoreLanes2d<2> core_2d_of(const ObbLanes2d& box, const Point2d& origin) {
  CoreLanes2d<2> core;
  core.clear();
  core.center = box.center - origin;
  for (std::size_t i = 0; i < 2; ++i) core.set_edge(i, box.axes[i] * box.half[i]);
  const Doubles turn =
      side_of(hn::Sub(hn::Mul(box.axes[0].at[0], box.axes[1].at[1]), hn::Mul(box.axes[0].at[1], box.axes[1].at[0])));
  core.normal[0] = perpendicular(core.along[1]) * hn::Neg(turn);
  core.normal[1] = perpendicular(core.along[0]) * turn;
  return core;
}

/// The ends of a box along the axes.
struct AabbLanes2d {
  Point2d min;
  Point2d max;

  template <class T>
  HWY_INLINE explicit AabbLanes2d(const T* const* rows) {
    Doubles numbers[4];
    load_wide(rows, numbers);
    min = {{numbers[0], numbers[1]}};
    max = {{numbers[2], numbers[3]}};
  }
};

HWY_INLINE CoreLanes2d<2> core_2d_of(const AabbLanes2d& box, const Point2d& origin) {
  const Point2d low = box.min - origin;
  const Point2d high = box.max - origin;
  const Point2d half = (high - low) * both(0.5);
  CoreLanes2d<2> core;
  core.clear();
  core.center = (low + high) * both(0.5);
  for (std::size_t i = 0; i < 2; ++i) {
    core.half_edge[i].at[i] = half.at[i];
    core.half_length[i] = half.at[i];
    core.along[i].at[i] = core.normal[i].at[i] = both(1);
  }
  return core;
}

// ---- Features

/// By their places in `touched_features`, those of Core2d: of a corner on these sides of the middle, and of the side
/// across the first axis or the second (`across_second`: 1 or 0) that is `at` its half edge or, with -1, against it.
HWY_INLINE Doubles corner_feature_2d(const Point2d& sides) {
  const auto bit = [](Doubles side, double value) { return hn::IfThenElseZero(hn::Gt(side, both(0)), both(value)); };
  return hn::Add(both(first_of_2d), hn::Add(bit(sides.at[0], 1), bit(sides.at[1], 2)));
}
HWY_INLINE Doubles side_feature_2d(DoublesMask across_second, Doubles at) {
  return hn::Add(both(first_of_2d + 4),
                 hn::Add(hn::IfThenElseZero(across_second, both(2)), hn::IfThenElseZero(hn::Gt(at, both(0)), both(1))));
}

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
