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

#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/broad/contacts/round_lanes-inl.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

using FlatPoint = LaneVec<2, double>;

HWY_INLINE FlatPoint operator+(const FlatPoint& a, const FlatPoint& b) {
  return {{hn::Add(a.at[0], b.at[0]), hn::Add(a.at[1], b.at[1])}};
}
HWY_INLINE FlatPoint operator-(const FlatPoint& a, const FlatPoint& b) { return difference(a, b); }
HWY_INLINE FlatPoint operator-(const FlatPoint& v) { return {{hn::Neg(v.at[0]), hn::Neg(v.at[1])}}; }
HWY_INLINE FlatPoint operator*(const FlatPoint& v, Doubles factor) {
  return {{hn::Mul(v.at[0], factor), hn::Mul(v.at[1], factor)}};
}
HWY_INLINE Doubles dot(const FlatPoint& a, const FlatPoint& b) {
  return hn::Add(hn::Mul(a.at[0], b.at[0]), hn::Mul(a.at[1], b.at[1]));
}
HWY_INLINE Doubles sum_abs(const FlatPoint& v) { return hn::Add(hn::Abs(v.at[0]), hn::Abs(v.at[1])); }
HWY_INLINE FlatPoint perpendicular(const FlatPoint& v) { return {{hn::Neg(v.at[1]), v.at[0]}}; }
HWY_INLINE FlatPoint one_of(const DoublesMask& mask, const FlatPoint& yes, const FlatPoint& no) {
  return {{hn::IfThenElse(mask, yes.at[0], no.at[0]), hn::IfThenElse(mask, yes.at[1], no.at[1])}};
}
/// As std::copysign(1.0, v).
HWY_INLINE Doubles side_of(Doubles v) { return hn::CopySign(both(1), v); }

/// As kernels of space have it.
HWY_INLINE Point in_space(const FlatPoint& v) { return {{v.at[0], v.at[1], both(0)}}; }
HWY_INLINE FlatPoint in_plane(const Point& v) { return {{v.at[0], v.at[1]}}; }

/// As FlatCore.
template <std::size_t axes>
struct FlatCoreLanes {
  FlatPoint center;
  FlatPoint half_edge[2];
  FlatPoint along[2];
  Doubles half_length[2];
  FlatPoint normal[2];
  Doubles radius;

  /// A constructor would be called by those of structs that hold one, which are compiled for any machine.
  HWY_INLINE void clear() {
    const FlatPoint zero{{both(0), both(0)}};
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

  HWY_INLINE FlatPoint corner(const FlatPoint& sides) const {
    return center + half_edge[0] * sides.at[0] + half_edge[1] * sides.at[1];
  }

  HWY_INLINE FlatPoint sides_of(const FlatPoint& place) const {
    const FlatPoint off = place - center;
    return {{side_of(dot(off, half_edge[0])), side_of(dot(off, half_edge[1]))}};
  }

  HWY_INLINE void set_edge(std::size_t i, const FlatPoint& half) {
    half_edge[i] = half;
    half_length[i] = hn::Sqrt(dot(half, half));
    along[i] = half * hn::Div(both(1), half_length[i]);
  }
};

// ---- Of shapes in memory, as flat_core(shape, origin): `origin` where they are seen from

HWY_INLINE FlatCoreLanes<1> flat_core_of(const CapsuleLanes& capsule, const FlatPoint& origin) {
  const FlatPoint start = in_plane(capsule.start) - origin;
  const FlatPoint end = in_plane(capsule.end) - origin;
  FlatCoreLanes<1> core;
  core.clear();
  core.center = (start + end) * both(0.5);
  core.set_edge(0, (end - start) * both(0.5));
  core.normal[1] = perpendicular(core.along[0]);
  core.radius = capsule.radius;
  return core;
}

/// An oriented box' center, half extents and axes.
struct FlatObbLanes {
  FlatPoint center;
  Doubles half[2];
  FlatPoint axes[2];

  template <class T>
  HWY_INLINE explicit FlatObbLanes(const T* const* rows) {
    Doubles numbers[8];
    load_wide(rows, numbers);
    center = {{numbers[0], numbers[1]}};
    for (std::size_t i = 0; i < 2; ++i) {
      half[i] = numbers[2 + i];
      axes[i] = {{numbers[4 + 2 * i], numbers[5 + 2 * i]}};
    }
  }
};

HWY_INLINE FlatCoreLanes<2> flat_core_of(const FlatObbLanes& box, const FlatPoint& origin) {
  FlatCoreLanes<2> core;
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
struct FlatAabbLanes {
  FlatPoint min;
  FlatPoint max;

  template <class T>
  HWY_INLINE explicit FlatAabbLanes(const T* const* rows) {
    Doubles numbers[4];
    load_wide(rows, numbers);
    min = {{numbers[0], numbers[1]}};
    max = {{numbers[2], numbers[3]}};
  }
};

HWY_INLINE FlatCoreLanes<2> flat_core_of(const FlatAabbLanes& box, const FlatPoint& origin) {
  const FlatPoint low = box.min - origin;
  const FlatPoint high = box.max - origin;
  const FlatPoint half = (high - low) * both(0.5);
  FlatCoreLanes<2> core;
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

/// By their places in `touched_features`, those of FlatCore: of a corner on these sides of the middle, and of the side
/// across the first axis or the second (`across_second`: 1 or 0) that is `at` its half edge or, with -1, against it.
HWY_INLINE Doubles flat_corner_feature(const FlatPoint& sides) {
  const auto bit = [](Doubles side, double value) { return hn::IfThenElseZero(hn::Gt(side, both(0)), both(value)); };
  return hn::Add(both(first_of_flat), hn::Add(bit(sides.at[0], 1), bit(sides.at[1], 2)));
}
HWY_INLINE Doubles flat_side_feature(DoublesMask across_second, Doubles at) {
  return hn::Add(both(first_of_flat + 4),
                 hn::Add(hn::IfThenElseZero(across_second, both(2)), hn::IfThenElseZero(hn::Gt(at, both(0)), both(1))));
}

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
