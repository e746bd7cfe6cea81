// SPDX-License-Identifier: MIT
// Filters: cheap tests that decide all pairs but those that nearly touch, and leave those to the precise closed forms
// of bounded.hpp. No answer means "too close to tell". NaN anywhere gives no answer, or apart.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/query/relation/obb_filter.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

template <Dim N, class Real = double>
using Numbers = std::array<Real, static_cast<std::size_t>(N)>;

/// A box or a segment in the axes of a first box: coordinate i of a vector is its dot product with axis i. The second
/// shape is all between + sum of u[j] * half[j] * directions[j] with |u[j]| <= 1. Plain arrays, because compilers
/// optimise loops over them better than loops over indexed vectors.
template <Dim N, Dim Edges, class Real = double>
struct InFrameOfBox {
  Numbers<N, Real> box_half{};  ///< The first box's half extents.
  Numbers<N, Real> between{};   ///< From center to center.
  std::array<Numbers<N, Real>, static_cast<std::size_t>(Edges)>
      directions{};             ///< Of a box: its axes. Of a segment: half of it.
  Numbers<Edges, Real> half{};  ///< Of a box: its half extents. Of a segment: 1.
  Real length = 1;              ///< No direction is longer.
};

/// A number for every coordinate of every direction.
template <Dim N, Dim Edges, class Real>
using PerDirection = std::array<Numbers<N, Real>, static_cast<std::size_t>(Edges)>;

/// The gap of the two on the cross product of the box's axis i and direction j, multiplied by that product's length.
template <Dim Edges, class Real>
[[gnu::always_inline]] inline Real gap_across(const InFrameOfBox<3, Edges, Real>& seen,
                                              const PerDirection<3, Edges, Real>& shadow, std::size_t i,
                                              std::size_t j) {
  const std::size_t i1 = (i + 1) % 3;
  const std::size_t i2 = (i + 2) % 3;
  Real reach = seen.box_half[i1] * shadow[j][i2] + seen.box_half[i2] * shadow[j][i1];
  if constexpr (Edges == 3) {
    const std::size_t j1 = (j + 1) % 3;
    const std::size_t j2 = (j + 2) % 3;
    reach += seen.half[j1] * shadow[j2][i] + seen.half[j2] * shadow[j1][i];
  }
  return std::fabs(seen.between[i2] * seen.directions[j][i1] - seen.between[i1] * seen.directions[j][i2]) - reach;
}

/// Whether the only axes that leave the verdict undecided are cross products of nearly parallel edges.
template <Dim Edges, class Real>
[[gnu::noinline]] bool only_parallel_edges_are_open(const InFrameOfBox<3, Edges, Real>& seen,
                                                    const PerDirection<3, Edges, Real>& shadow, Real cross_band,
                                                    Real parallel) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < static_cast<std::size_t>(Edges); ++j) {
      const bool is_parallel = shadow[j][(i + 1) % 3] + shadow[j][(i + 2) % 3] < parallel;
      if (!is_parallel && !(gap_across(seen, shadow, i, j) < -cross_band)) return false;
    }
  }
  return true;
}

/// The widest gap on a few axes, and the sum of all lengths involved.
template <class Real>
struct WidestGap {
  Real gap = -std::numeric_limits<Real>::infinity();
  Real size = 0;
};

/// On the axes of the first box. The size is NaN if any number is.
template <Dim N, Dim Edges, class Real>
[[gnu::always_inline]] inline WidestGap<Real> widest_on_own_axes(const InFrameOfBox<N, Edges, Real>& seen,
                                                                 const PerDirection<N, Edges, Real>& shadow) {
  WidestGap<Real> widest;
#pragma GCC unroll 3
  for (std::size_t i = 0; i < static_cast<std::size_t>(N); ++i) {
    Real reach = seen.box_half[i];
#pragma GCC unroll 3
    for (std::size_t j = 0; j < static_cast<std::size_t>(Edges); ++j) reach += seen.half[j] * shadow[j][i];
    const Real between = std::fabs(seen.between[i]);
    widest.gap = std::max(widest.gap, between - reach);
    widest.size += between + reach;
  }
  return widest;
}

/// On the axes of a second box.
template <Dim N, class Real>
[[gnu::always_inline]] inline Real widest_on_other_axes(const InFrameOfBox<N, N, Real>& seen,
                                                        const PerDirection<N, N, Real>& shadow) {
  Real widest = -std::numeric_limits<Real>::infinity();
#pragma GCC unroll 3
  for (std::size_t j = 0; j < static_cast<std::size_t>(N); ++j) {
    Real along = 0;
    Real reach = seen.half[j];
#pragma GCC unroll 3
    for (std::size_t i = 0; i < static_cast<std::size_t>(N); ++i) {
      along += seen.between[i] * seen.directions[j][i];
      reach += seen.box_half[i] * shadow[j][i];
    }
    widest = std::max(widest, std::fabs(along) - reach);
  }
  return widest;
}

/// On the cross products of an axis of the box and a direction.
template <Dim Edges, class Real>
[[gnu::always_inline]] inline Real widest_across(const InFrameOfBox<3, Edges, Real>& seen,
                                                 const PerDirection<3, Edges, Real>& shadow) {
  Real widest = -std::numeric_limits<Real>::infinity();
#pragma GCC unroll 3
  for (std::size_t i = 0; i < 3; ++i) {
#pragma GCC unroll 3
    for (std::size_t j = 0; j < static_cast<std::size_t>(Edges); ++j) {
      widest = std::max(widest, gap_across(seen, shadow, i, j));
    }
  }
  return widest;
}

/// In 2D, on the normal of a segment.
template <class Real>
Real widest_across(const InFrameOfBox<2, 1, Real>& seen, const PerDirection<2, 1, Real>& shadow) {
  const Real reach = seen.box_half[0] * shadow[0][1] + seen.box_half[1] * shadow[0][0];
  return std::fabs(seen.between[0] * seen.directions[0][1] - seen.between[1] * seen.directions[0][0]) - reach;
}

/// The separating-axis test in the frame of the first box (Gottschalk, Lin, Manocha, "OBBTree", 1996). It assumes that
/// the axes of boxes are orthonormal, which they are up to `skew`, the largest |dot(axis i, axis j) - (i == j)|: an
/// axis is within 3 skew of the face's normal that it represents. So, in units of the size, the sum of all lengths, the
/// gap on a face's axis is off by 7 skew and that on a cross product of edges by 10, which covers its two factors and
/// the products that replace dot products with it.
///
/// The cross product of edges that are parallel up to s = 32 skew proves nothing; nor is it needed if all other axes
/// find a depth of 4 s: projected along the edges, the two shapes are polygons that overlap as deeply, less s for the
/// edge that is not quite parallel to the projection and 2 s for the rotation of the others.
template <Dim N, Dim Edges, class Real>
[[gnu::always_inline]] inline std::optional<Relation> filter_of_boxes(const InFrameOfBox<N, Edges, Real>& seen,
                                                                      Real orthonormality_error) {
  PerDirection<N, Edges, Real> shadow;
#pragma GCC unroll 3
  for (std::size_t j = 0; j < static_cast<std::size_t>(Edges); ++j) {
#pragma GCC unroll 3
    for (std::size_t i = 0; i < static_cast<std::size_t>(N); ++i) shadow[j][i] = std::fabs(seen.directions[j][i]);
  }
  auto [widest, size] = widest_on_own_axes(seen, shadow);
  // Products of two lengths must not be close to the smallest numbers, whose rounding is coarse.
  constexpr Real least_product = Real(0x1p20) * std::numeric_limits<Real>::min();
  if (!(size * std::min(size, seen.length) > least_product)) return std::nullopt;
  if constexpr (Edges == 1) {
    if (!(size * seen.length < std::numeric_limits<Real>::max() / 8)) return std::nullopt;
  }
  const Real band = static_cast<Real>(tolerance::box_filter) * orthonormality_error * size;
  if (widest > band) return Relation::apart;
  if constexpr (Edges == N) {
    widest = std::max(widest, widest_on_other_axes(seen, shadow));
    if (widest > band) return Relation::apart;
  }
  Real least_depth = band;
  if constexpr (N == 3 || Edges == 1) {
    const Real cross_band = band * seen.length;
    const Real across = widest_across(seen, shadow);
    if (across > cross_band) return Relation::apart;
    if (!(across < -cross_band)) {
      if constexpr (N == 2) {
        return std::nullopt;
      } else {
        const Real parallel = 2 * static_cast<Real>(tolerance::box_filter) * orthonormality_error * seen.length;
        if (!only_parallel_edges_are_open(seen, shadow, cross_band, parallel)) return std::nullopt;
        least_depth = 8 * band;
      }
    }
  }
  if (widest < -least_depth) return Relation::overlapping;
  return std::nullopt;
}

// ---- Two boxes, or a box and a segment, in the first box's frame

template <class Real, Dim N, class T>
[[gnu::always_inline]] inline Numbers<N, Real> numbers(const Vec<N, T>& v) {
  if constexpr (N == 2) {
    return {static_cast<Real>(v.x), static_cast<Real>(v.y)};
  } else {
    return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)};
  }
}

template <class Real, Dim N, class T>
[[gnu::always_inline]] inline PerDirection<N, N, Real> columns(const Mat<N, T>& axes) {
  if constexpr (N == 2) {
    return {numbers<Real, 2, T>(axes[0]), numbers<Real, 2, T>(axes[1])};
  } else {
    return {numbers<Real, 3, T>(axes[0]), numbers<Real, 3, T>(axes[1]), numbers<Real, 3, T>(axes[2])};
  }
}

template <std::size_t Count, class Real>
[[gnu::always_inline]] inline Real inner(const std::array<Real, Count>& a, const std::array<Real, Count>& b) {
  Real sum = 0;
  for (std::size_t i = 0; i < Count; ++i) sum += a[i] * b[i];
  return sum;
}

template <class Real, Dim N, class T>
[[gnu::always_inline]] inline InFrameOfBox<N, N, Real> in_frame_of_box(const Obb<N, T>& a, const Obb<N, T>& b) {
  InFrameOfBox<N, N, Real> seen;
  const auto axes_a = columns<Real, N, T>(a.axes);
  const auto axes_b = columns<Real, N, T>(b.axes);
  const auto between = numbers<Real, N, Real>(Vec<N, Real>(b.center) - Vec<N, Real>(a.center));
  seen.box_half = numbers<Real>(a.half_extents);
  seen.half = numbers<Real>(b.half_extents);
  for (std::size_t i = 0; i < axes_a.size(); ++i) {
    seen.between[i] = inner(axes_a[i], between);
    for (std::size_t j = 0; j < axes_b.size(); ++j) seen.directions[j][i] = inner(axes_a[i], axes_b[j]);
  }
  return seen;
}

template <class Real, Dim N, class T>
[[gnu::always_inline]] inline InFrameOfBox<N, N, Real> in_frame_of_box(const Aabb<N, T>& a, const Obb<N, T>& b) {
  const Vec<N, Real> corner(a.min);
  const Vec<N, Real> half = Real(0.5) * (Vec<N, Real>(a.max) - corner);
  return {numbers<Real>(half), numbers<Real, N, Real>((Vec<N, Real>(b.center) - corner) - half),
          columns<Real, N, T>(b.axes), numbers<Real>(b.half_extents), Real(1)};
}

template <class Real, Dim N, class T>
[[gnu::always_inline]] inline InFrameOfBox<N, 1, Real> in_frame_of_box(const Aabb<N, T>& box,
                                                                       const Segment<N, T>& segment) {
  const Vec<N, Real> corner(box.min);
  const Vec<N, Real> start(segment.start);
  const Vec<N, Real> box_half = Real(0.5) * (Vec<N, Real>(box.max) - corner);
  const Vec<N, Real> half = Real(0.5) * (Vec<N, Real>(segment.end) - start);
  return {numbers<Real>(box_half),
          numbers<Real, N, Real>(((start - corner) + half) - box_half),
          {numbers<Real>(half)},
          {Real(1)},
          sum_abs(half)};
}

template <class Real, Dim N, class T>
[[gnu::always_inline]] inline InFrameOfBox<N, 1, Real> in_frame_of_box(const Obb<N, T>& box,
                                                                       const Segment<N, T>& segment) {
  InFrameOfBox<N, 1, Real> seen;
  const auto axes = columns<Real, N, T>(box.axes);
  const Vec<N, Real> start(segment.start);
  const Vec<N, Real> half = Real(0.5) * (Vec<N, Real>(segment.end) - start);
  const auto between = numbers<Real, N, Real>((start - Vec<N, Real>(box.center)) + half);
  const auto edge = numbers<Real>(half);
  seen.box_half = numbers<Real>(box.half_extents);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    seen.directions[0][i] = inner(axes[i], edge);
    seen.between[i] = inner(axes[i], between);
  }
  seen.half = {Real(1)};
  seen.length = sum_abs(half);
  return seen;
}

template <Dim N, class T>
double orthonormality_error_of(const Aabb<N, T>&) {
  return 0;
}
template <Dim N, class T>
double orthonormality_error_of(const Segment<N, T>&) {
  return 0;
}
template <Dim N, class T>
double orthonormality_error_of(const Obb<N, T>& box) {
  const auto axes = columns<double, N, T>(box.axes);
  double orthonormality_error = 0;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    for (std::size_t j = i; j < axes.size(); ++j) {
      orthonormality_error = std::max(orthonormality_error, std::fabs(inner(axes[i], axes[j]) - (i == j ? 1.0 : 0.0)));
    }
  }
  return orthonormality_error;
}

/// In double, with the skew of these boxes, and never with less than rounding.
template <class Box, class Other>
[[gnu::noinline]] std::optional<Relation> second_filter_of_box(const Box& box, const Other& other) {
  return filter_of_boxes(in_frame_of_box<double>(box, other),
                         std::max({orthonormality_error_of(box), orthonormality_error_of(other), tolerance::rounding}));
}

/// First in the type of the shapes, whose rounding is far below the skew that any valid box may have. If that
/// overflows, there is no answer.
template <class Box, class Other>
std::optional<Relation> filter_of_box(const Box& box, const Other& other) {
  using Real = scalar_of<Box>;
#ifdef GRAZE_HAS_LANES
  if constexpr (std::is_same_v<Box, Obb<3, float>> && std::is_same_v<Other, Box>) {
    if (const auto verdict = filter_of_obbs(box, other)) return verdict;
    return second_filter_of_box(box, other);
  }
#endif
  const auto seen = in_frame_of_box<Real>(box, other);
  if (const auto verdict = filter_of_boxes(seen, static_cast<Real>(tolerance::orthonormal))) return verdict;
  return second_filter_of_box(box, other);
}

// ---- A sphere, or a segment with a radius, against a box

/// The vector from the center, clamped to the box along each axis. If axes are orthonormal up to `skew`, the nearest
/// point is off by 6 skew of the size at most.
template <Dim N, class T>
std::optional<Relation> filter_of_sphere(const Vec<N, T>& center, const Obb<N, T>& box, double reach) {
  const auto axes = columns<double, N, T>(box.axes);
  const Numbers<N> half = numbers<double>(box.half_extents);
  Numbers<N> rest = numbers<double, N, double>(wide<N, T>(center) - wide<N, T>(box.center));
  Numbers<N> along{};
  double size = reach;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    along[i] = inner(axes[i], rest);
    size += std::fabs(rest[i]) + half[i];
  }
  if (!is_usual_size<T>(size)) return std::nullopt;
  const double slack = tolerance::box_filter * tolerance::orthonormal * size;
  bool is_inside = true;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double place = std::clamp(along[i], -half[i], half[i]);
    is_inside = is_inside && std::fabs(along[i]) - half[i] < -slack;
    for (std::size_t k = 0; k < axes.size(); ++k) rest[k] -= place * axes[i][k];
  }
  if (is_inside) return Relation::overlapping;
  return clear_verdict(inner(rest, rest), reach, slack);
}

/// Boxes, in their own frame, against the segment.
template <Dim N, class Box, class T>
std::optional<Relation> filter_of_widened(const Box& box, const Segment<N, T>& segment, double reach) {
  const InFrameOfBox<N, 1> seen = in_frame_of_box<double>(box, segment);
  double size = reach;
  double widest = -std::numeric_limits<double>::infinity();
  Vec<N, double> start;
  Vec<N, double> edge;
  Vec<N, double> half;
  for (std::size_t i = 0; i < seen.between.size(); ++i) {
    const double both = seen.box_half[i] + std::fabs(seen.directions[0][i]);
    widest = std::max(widest, std::fabs(seen.between[i]) - both);
    size += std::fabs(seen.between[i]) + both;
    const auto k = static_cast<Dim>(i);
    start[k] = seen.between[i] - seen.directions[0][i];
    edge[k] = 2 * seen.directions[0][i];
    half[k] = seen.box_half[i];
  }
  if (!is_usual_size<T>(size)) return std::nullopt;
  const double slack = tolerance::box_filter * tolerance::orthonormal * size;
  if (widest > reach + slack) return Relation::apart;
  return clear_verdict(DistanceAlongSegment<N>(edge, {-half - start, half - start}).least(), reach, slack);
}

}  // namespace graze::detail
