// SPDX-License-Identifier: MIT
// bounding_obb(points): an oriented box around points; in 2D the one of least area, in 3D one of small surface.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <graze/math/orientation.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounding/box.hpp>
#include <graze/query/bounding/fitted_axes.hpp>
#include <graze/query/bounding/flush_rectangle.hpp>
#include <graze/query/bounding/hull_corners.hpp>
#include <graze/shape/obb.hpp>

namespace graze {
namespace detail {

/// The measure to minimise: the area in 2D, part of the surface area in 3D.
template <class T>
double size_of(const Obb<2, T>& box, double scale) {
  const Vec<2, double> half = wide<2, T>(box.half_extents) * scale;
  return half.x * half.y;
}
template <class T>
double size_of(const Obb<3, T>& box, double scale) {
  return surface_of(wide<3, T>(box.half_extents) * scale);
}

/// The oriented box along the coordinate axes around the center of `box`, with the least half extents that contain it.
template <Dim N, class T>
Obb<N, T> upright_obb(const Aabb<N, T>& box) {
  Obb<N, T> result{Vec<N, T>(oriented(box).center), Vec<N, T>(T(0)), Mat<N, T>(T(1))};
  for (Dim i = 0; i < N; ++i) {
    const double center = static_cast<double>(result.center[i]);
    const double below = add_up(center, -static_cast<double>(box.min[i]));
    const double above = add_up(static_cast<double>(box.max[i]), -center);
    result.half_extents[i] = round_up<T>(std::max(below, above));
  }
  return result;
}

/// The vectors r_i with u_i = dot(r_i, v) / det(axes) for v = axes * u, each coordinate accurate to two epsilon: the
/// rows of the adjoint matrix. Exact in 2D.
inline std::array<Vec<2, double>, 2> adjoint_rows(const Mat<2, double>& axes) {
  return {Vec<2, double>(axes[1].y, -axes[1].x), Vec<2, double>(-axes[0].y, axes[0].x)};
}
inline std::array<Vec<3, double>, 3> adjoint_rows(const Mat<3, double>& axes) {
  return {accurate_cross(axes[1], axes[2]), accurate_cross(axes[2], axes[0]), accurate_cross(axes[0], axes[1])};
}

/// True if `row` is exactly perpendicular to a point's offset from a center; can be true only where rows are exact, in
/// 2D. With the scale, products and their errors are in the range of double.
template <class T>
bool is_on_axis(const Vec<2, double>& row, const Vec<2, T>& point, const Vec<2, T>& center, double scale) {
  std::array<double, 8> terms{};
  std::size_t count = 0;
  for (Dim i = 0; i < 2; ++i) {
    const Rounded offset = two_sum(static_cast<double>(point[i]), -static_cast<double>(center[i]));
    for (const double part : {offset.value, offset.error}) {
      const Rounded product = two_product(row[i], part * scale);
      terms[count++] = product.value;
      terms[count++] = product.error;
    }
  }
  return sign_of_sum(terms) == 0;
}
template <class T>
bool is_on_axis(const Vec<3, double>&, const Vec<3, T>&, const Vec<3, T>&, double) {
  return false;
}

/// The extent of a point along an axis from the center of a box, times the determinant of the axes: |dot(row, p - c)|
/// plus a bound on its error, which also covers subsequent roundings: in total 4 epsilon of the products' absolute
/// values in 2D, 8.5 in 3D, where the rows are rounded.
template <Dim N, class T>
double reach_of(const Vec<N, double>& row, const Vec<N, T>& point, const LocalFrame<N>& frame,
                const Vec<N, T>& center) {
  const Vec<N, double> offset = frame.local(point);
  double size = 0;
  for (Dim i = 0; i < N; ++i) size += std::fabs(row[i] * offset[i]);
  const double reach = std::fabs(dot(row, offset));
  const double error = static_cast<double>(N - 1) * tolerance::rounding * size;
  return reach <= error && is_on_axis(row, point, center, frame.scale) ? 0 : reach + error;
}

/// The smallest box with the given axes (orthonormal, right-handed) around points, up to rounding; with those axes as
/// stored in T it contains the points exactly. Half extents beyond T become infinite.
template <Dim N, class T>
Obb<N, T> obb_along(std::span<const Vec<N, T>> points, const Mat<N, double>& axes, const LocalFrame<N>& frame) {
  Obb<N, T> box;
  for (Dim i = 0; i < N; ++i) box.axes[i] = Vec<N, T>(axes[i]);
  const Mat<N, double> stored = wide_matrix<N, T>(box.axes);
  const auto rows = adjoint_rows(stored);
  const double determinant = dot(rows[0], stored[0]);  // about 1: the axes are orthonormal up to the rounding to T
  Aabb<N, double> range = Aabb<N, double>::nothing();
  for (const Vec<N, T>& point : points) {
    const Vec<N, double> offset = frame.local(point);
    Vec<N, double> u;
    for (Dim i = 0; i < N; ++i) u[i] = dot(rows[static_cast<std::size_t>(i)], offset);
    range.grow(u);
  }
  box.center = Vec<N, T>(frame.world(stored * (range.center() / determinant)));
  const LocalFrame<N> around_center{wide<N, T>(box.center), frame.scale};
  Vec<N, double> reach(0.0);
  for (const Vec<N, T>& point : points) {
    for (Dim i = 0; i < N; ++i) {
      reach[i] = std::max(reach[i], reach_of(rows[static_cast<std::size_t>(i)], point, around_center, box.center));
    }
  }
  for (Dim i = 0; i < N; ++i) box.half_extents[i] = round_up<T>(multiply_up(reach[i] / determinant, 1 / frame.scale));
  return box;
}

/// The smallest rectangle around points, though not necessarily the axis-aligned one among those of the same area. Its
/// first axis is in the first quadrant.
template <class T>
Obb<2, T> turned_obb(std::span<const Vec<2, T>> points, const LocalFrame<2>& frame) {
  const std::vector<Vec<2, T>> hull = hull_corners(points, frame);
  const std::span<const Vec<2, T>> corners(hull);
  const auto area = [](double width, double height) { return width * height; };
  Vec<2, double> along = best_flush_direction(corners, frame.scale, area);
  while (!(along.x > 0 && along.y >= 0)) along = perpendicular(along);
  return obb_along(corners, Mat<2, double>(along, perpendicular(along)), frame);
}

/// A box of small surface area around points.
template <class T>
Obb<3, T> turned_obb(std::span<const Vec<3, T>> points, const LocalFrame<3>& frame) {
  return obb_along(points, fitted_axes(points, frame), frame);
}

}  // namespace detail

/// An oriented box around points. In 2D a rectangle of the least area. In 3D a box of small surface: never more than
/// that of the axis-aligned box, and for the corners of a box that box itself (observed, not proven).
///
/// Every point is contained exactly in the box as stored: center + axes * u with |u[i]| <= half_extents[i]. The axes
/// are right-handed and orthonormal up to rounding. Because they are rounded, in 2D the half extents exceed those of
/// the least rectangle by up to
///
///     2 * epsilon(T) * (size + largest |coordinate|) + 16 * epsilon(double) * size
///
/// where size is the longer side of `bounding_box`; a flat set may get a thickness of that order. If the axis-aligned
/// box is no larger, the axes are the coordinate axes and the half extents are the least in T: zero along an axis
/// across which the set is flat. One point, or all points equal: zero half extents. For points farther apart than the
/// largest T, the box is axis-aligned. Throws std::invalid_argument if there are no points or a coordinate is not
/// finite.
///
/// 2D: convex hull with the exact `orientation`, then rotating calipers; n log n in the number of points outside the
/// polygon of a few extreme ones. 3D: a few passes over the points. Both allocate. Coordinates may be any finite
/// numbers; half extents below the least normal number of T are rounded up to a multiple of its least number.
template <Dim N, class T>
Obb<N, T> bounding_obb(std::span<const Vec<N, T>> points) {
  const Aabb<N, T> box = detail::checked_box(points, "bounding_obb");
  const Obb<N, T> upright = detail::upright_obb(box);
  const double side = detail::largest_side(box);
  if (side == 0 || !std::isfinite(side)) return upright;
  const detail::LocalFrame<N> frame = detail::local_frame(box);
  const Obb<N, T> turned = detail::turned_obb(points, frame);
  return detail::size_of(turned, frame.scale) < detail::size_of(upright, frame.scale) ? turned : upright;
}

/// The overload for a vector or a braced list.
template <Dim N, class T>
Obb<N, T> bounding_obb(const std::vector<Vec<N, T>>& points) {
  return bounding_obb(std::span<const Vec<N, T>>(points));
}

/// The overload for anything that converts to a span of points.
template <PointRow Row>
auto bounding_obb(const Row& points) {
  return bounding_obb(span_of(points));
}

/// The overload with the dimension given explicitly.
template <Dim N, PointRowIn<N> Row>
auto bounding_obb(const Row& points) {
  return bounding_obb(span_of(points));
}

}  // namespace graze
