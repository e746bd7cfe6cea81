// SPDX-License-Identifier: MIT
/// @file
/// distance_squared(a, b): the squared distance of points, segments, boxes and triangles, 0 if they touch or overlap,
/// in double. Cheaper than `distance`, because it takes no square root. The error of its root is a few epsilon of the
/// vectors between and along the two shapes, however far from the origin. These vectors must be zero or 1e-130 to 1e150
/// long. Between points and axis-aligned boxes any length is allowed: a square that overflows is infinite, one below
/// half the least positive double is 0. `distance` accepts shapes of any size.
///
///                point    segment   aabb     obb      triangle
///     point      closed   closed    closed   closed   closed
///     segment             closed    closed   closed   closed
///     aabb                          closed
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/zonotope.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/triangle.hpp>

namespace graze {

/// The squared distance of two points.
template <Dim N, class T>
double distance_squared(const Vec<N, T>& a, const Vec<N, T>& b) {
  const Vec<N, double> between = wide<N, T>(b) - wide<N, T>(a);
  return dot(between, between);
}

/// The squared distance of a point from a segment: to the foot of the perpendicular, or to the nearer end (Ericson,
/// Real-Time Collision Detection, 5.1.2). Beyond the far end the vector starts at that end, so that no rounding of the
/// foot enters.
template <Dim N, class T>
double distance_squared(const Vec<N, T>& point, const Segment<N, T>& segment) {
  const Vec<N, double> edge = wide<N, T>(segment.end) - wide<N, T>(segment.start);
  const Vec<N, double> to_point = wide<N, T>(point) - wide<N, T>(segment.start);
  const double along = dot(to_point, edge);
  const double whole = dot(edge, edge);
  if (along <= 0) return dot(to_point, to_point);
  if (along >= whole) return distance_squared(point, segment.end);
  const Vec<N, double> off = to_point - edge * (along / whole);  // whole > along > 0
  return dot(off, off);
}

namespace detail {

inline double inner(double a, double b) { return a * b; }
inline double inner(const Vec<3, double>& a, const Vec<3, double>& b) { return dot(a, b); }

/// The vector scaled to a largest coordinate of 1; zero stays zero.
inline double of_unit_size(double a) { return a > 0 ? 1.0 : a < 0 ? -1.0 : 0.0; }
inline Vec<3, double> of_unit_size(const Vec<3, double>& a) {
  const double size = max_abs(a);
  return size > 0 ? a / size : a;
}

/// The cross product with a relative error of a few epsilon.
inline double cross_of_edges(const Vec<2, double>& a, const Vec<2, double>& b) { return accurate_cross(a, b); }
inline Vec<3, double> cross_of_edges(const Vec<3, double>& a, const Vec<3, double>& b) {
  return cross_of_directions(a, b);
}

/// The squared distance of a point from the segment between zero and `edge`.
template <Dim N>
double distance_squared_from_edge(const Vec<N, double>& point, const Vec<N, double>& edge) {
  const double along = dot(point, edge);
  const double whole = dot(edge, edge);
  if (along <= 0) return dot(point, point);
  const Vec<N, double> off = point - edge * (along < whole ? along / whole : 1.0);  // whole > 0 if along < whole
  return dot(off, off);
}

/// The squared distance along the common perpendicular of two lines, if it meets both segments; +infinity if they are
/// parallel. With p(s) = start_a + s u, q(t) = start_b + t v, w = start_b - start_a, n = u x v, the perpendicular is at
/// s n^2 = (w x v) . n, t n^2 = (w x u) . n. Both feet are rounded, more so the more parallel the lines are, so each
/// foot's own distance from the other segment counts, and the smaller one is returned.
template <Dim N>
double perpendicular_distance_squared(const Segment<N, double>& first, const Segment<N, double>& second) {
  const Vec<N, double> u = first.end - first.start;
  const Vec<N, double> v = second.end - second.start;
  const Vec<N, double> w = second.start - first.start;
  const auto n = accurate_cross(u, v);
  const auto n0 = of_unit_size(n);  // replaces one n; n^2 could leave the range of double
  const double whole = inner(n, n0);
  if (!(whole > 0)) return std::numeric_limits<double>::infinity();
  const double s = std::clamp(inner(accurate_cross(w, v), n0) / whole, 0.0, 1.0);
  const double t = std::clamp(inner(accurate_cross(w, u), n0) / whole, 0.0, 1.0);
  return std::min(distance_squared_from_edge(u * s - w, v), distance_squared_from_edge(v * t + w, u));
}

template <Dim N, class T>
Segment<N, double> wide_segment(const Segment<N, T>& segment) {
  return {wide<N, T>(segment.start), wide<N, T>(segment.end)};
}

}  // namespace detail

/// The squared distance of two segments: the least of the four distances from an end and of that along the common
/// perpendicular. Symmetric to the last bit.
template <Dim N, class T>
double distance_squared(const Segment<N, T>& a, const Segment<N, T>& b) {
  const double from_a = std::min(distance_squared(a.start, b), distance_squared(a.end, b));
  const double from_b = std::min(distance_squared(b.start, a), distance_squared(b.end, a));
  const double inside = detail::perpendicular_distance_squared(detail::wide_segment(a), detail::wide_segment(b));
  return std::min({from_a, from_b, inside});
}

/// The squared distance of two axis-aligned boxes.
template <Dim N, class T>
double distance_squared(const Aabb<N, T>& a, const Aabb<N, T>& b) {
  double sum = 0;
  for (Dim i = 0; i < N; ++i) {
    const double below = static_cast<double>(b.min[i]) - static_cast<double>(a.max[i]);
    const double above = static_cast<double>(a.min[i]) - static_cast<double>(b.max[i]);
    const double outside = std::max(std::max(below, above), 0.0);  // of a list, GCC would compare with branches
    sum += outside * outside;
  }
  return sum;
}

/// The squared distance of a point from a box; exactly 0 if the box contains the point.
template <Dim N, class T>
double distance_squared(const Vec<N, T>& point, const Aabb<N, T>& box) {
  return distance_squared(Aabb<N, T>{point, point}, box);
}

namespace detail {

/// The squared distance of a box from the points t * edge, 0 <= t <= 1: a convex function of t, quadratic between the
/// knots, where the segment crosses a face's plane. Its derivative tells which piece contains the minimum.
template <Dim N>
class DistanceAlongSegment {
 public:
  DistanceAlongSegment(const Vec<N, double>& edge, const Aabb<N, double>& box) : edge_(edge), box_(box) {
    for (Dim i = 0; i < N; ++i) {
      if (edge[i] == 0) continue;
      for (const double face : {box.min[i], box.max[i]}) insert_knot(face / edge[i]);
    }
    knots_[count_++] = 1.0;
  }

  double least() const {
    double best = value_at(0.0);
    double begin = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      // On the piece [begin, end] the slope is linear: its zero is a candidate. Pieces beyond the zero cannot be
      // better.
      const double end = knots_[k];
      const double middle = 0.5 * (begin + end);
      const Slope slope = slope_at(middle);
      const double zero = slope.change > 0 ? std::clamp(middle - slope.value / slope.change, begin, end) : middle;
      best = std::min({best, value_at(zero), value_at(end)});
      if (slope.value > 0 && zero > begin) break;
      begin = end;
    }
    return best;
  }

 private:
  /// Half the derivative at t, and its slope there.
  struct Slope {
    double value = 0;
    double change = 0;
  };

  double value_at(double t) const { return distance_squared(edge_ * t, box_); }

  Slope slope_at(double t) const {
    Slope slope;
    for (Dim i = 0; i < N; ++i) {
      const double x = t * edge_[i];
      const double outside = x < box_.min[i] ? x - box_.min[i] : x > box_.max[i] ? x - box_.max[i] : 0.0;
      slope.value += outside * edge_[i];
      if (outside != 0) slope.change += edge_[i] * edge_[i];
    }
    return slope;
  }

  void insert_knot(double t) {
    if (!(t > 0 && t < 1)) return;
    std::size_t place = count_++;
    for (; place > 0 && knots_[place - 1] > t; --place) knots_[place] = knots_[place - 1];
    knots_[place] = t;
  }

  Vec<N, double> edge_;
  Aabb<N, double> box_;
  std::array<double, 2 * static_cast<std::size_t>(N) + 1> knots_{};
  std::size_t count_ = 0;
};

}  // namespace detail

/// The squared distance of a segment from a box; 0 if they meet. Calculated relative to the segment's start, so that
/// rounding does not grow with the distance from zero.
template <Dim N, class T>
double distance_squared(const Segment<N, T>& segment, const Aabb<N, T>& box) {
  const Vec<N, double> start = wide<N, T>(segment.start);
  const Aabb<N, double> seen{wide<N, T>(box.min) - start, wide<N, T>(box.max) - start};
  return detail::DistanceAlongSegment<N>(wide<N, T>(segment.end) - start, seen).least();
}

/// The squared distance of a point from an oriented box; 0 inside. From the clamped projections on the axes, two steps
/// of projected descent compensate axes that are not quite orthonormal: each step shrinks that error by at least
/// tolerance::orthonormal, and it enters the distance squared.
template <Dim N, class T>
double distance_squared(const Vec<N, T>& point, const Obb<N, T>& box) {
  Vec<N, double> off = wide<N, T>(point) - wide<N, T>(box.center);
  Vec<N, double> place(0.0);
  for (int step = 0; step < 3; ++step) {
    for (Dim i = 0; i < N; ++i) {
      const Vec<N, double> axis = wide<N, T>(box.axes[i]);
      const double half = static_cast<double>(box.half_extents[i]);
      const double wanted =
          std::clamp(place[i] + dot(off, axis) / dot(axis, axis), -half, half);  // a valid axis is not zero
      off -= axis * (wanted - place[i]);
      place[i] = wanted;
    }
  }
  return dot(off, off);
}

/// The squared distance of a segment from an oriented box: 0 if they meet; else the nearest points are an end of the
/// segment and the box, or the segment and an edge of the box.
template <Dim N, class T>
double distance_squared(const Segment<N, T>& segment, const Obb<N, T>& box) {
  const Vec<N, double> center = wide<N, T>(box.center);
  if (detail::relation_of_zonotopes(detail::zonotope(segment), detail::zonotope(box)) != Relation::apart) return 0;
  double best = std::min(distance_squared(segment.start, box), distance_squared(segment.end, box));
  // Relative to the box's center, so that rounding does not grow with the distance from zero.
  const Segment<N, double> line{wide<N, T>(segment.start) - center, wide<N, T>(segment.end) - center};
  const Mat<N, double> edges = half_edges(box);
  constexpr unsigned corners_of_face = 1U << (N - 1);
  for (Dim along = 0; along < N; ++along) {
    for (unsigned corner = 0; corner < corners_of_face; ++corner) {
      Vec<N, double> middle(0.0);
      unsigned bits = corner;
      for (Dim i = 0; i < N; ++i) {
        if (i == along) continue;
        middle += (bits & 1U) != 0 ? edges[i] : -edges[i];
        bits >>= 1U;
      }
      best = std::min(best, distance_squared(line, Segment<N, double>{middle - edges[along], middle + edges[along]}));
    }
  }
  return best;
}

namespace detail {

/// The squared distance of a point from the foot of its perpendicular on a triangle's plane, if the foot is inside,
/// else +infinity: then an edge is nearest. With edges u, v from a corner, w from it to the point and n = u x v, the
/// foot is at s u + t v with s n^2 = (w x v) . n, t n^2 = (u x w) . n. For a needle, s and t may have large rounding
/// errors; their foot is still a point of the triangle, and if it is off by more than rounding, an edge is as near.
template <Dim N>
double closest_distance_squared(const Vec<N, double>& w, const Vec<N, double>& u, const Vec<N, double>& v) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto n = cross_of_edges(u, v);
  const auto n0 = of_unit_size(n);
  const double whole = inner(n, n0);
  if (!(whole > 0)) return infinity;
  const double s = inner(cross_of_edges(w, v), n0) / whole;
  if (!(s >= 0)) return infinity;
  const double t = inner(cross_of_edges(u, w), n0) / whole;
  if (!(t >= 0 && s + t <= 1)) return infinity;
  if constexpr (N == 2) return 0;
  const Vec<N, double> off = (w - u * s) - v * t;
  return dot(off, off);
}

}  // namespace detail

/// The squared distance of a point from a triangle: the least of those from the edges and from the plane over the face.
/// Ericson, Real-Time Collision Detection, 5.1.5, selects a region by differences of products, in which the angles of a
/// needle are lost; here every candidate is the distance from a point of the triangle.
template <Dim N, class T>
double distance_squared(const Vec<N, T>& point, const Triangle<N, T>& triangle) {
  const Vec<N, double> corner = wide<N, T>(triangle.a);
  const double inside = detail::closest_distance_squared(wide<N, T>(point) - corner, wide<N, T>(triangle.b) - corner,
                                                         wide<N, T>(triangle.c) - corner);
  return std::min({inside, distance_squared(point, Segment<N, T>{triangle.a, triangle.b}),
                   distance_squared(point, Segment<N, T>{triangle.b, triangle.c}),
                   distance_squared(point, Segment<N, T>{triangle.c, triangle.a})});
}

namespace detail {

/// The squared distance of a triangle from the point where the line through zero along `edge` crosses its plane, if
/// that is between zero and `edge`, else +infinity. However it is rounded, it is a point of the segment.
inline double crossing_distance_squared(const Vec<3, double>& edge, const Triangle<3, double>& triangle) {
  const Vec<3, double> n = of_unit_size(cross_of_directions(triangle.b - triangle.a, triangle.c - triangle.a));
  const double climb = dot(n, edge);
  if (climb == 0) return std::numeric_limits<double>::infinity();
  const double place = dot(n, triangle.a) / climb;
  if (!(place >= 0 && place <= 1)) return std::numeric_limits<double>::infinity();
  return distance_squared(edge * place, triangle);
}

}  // namespace detail

/// The squared distance of a segment from a triangle: the least of those of the ends from the triangle, of the corners
/// from the segment, along the common perpendiculars with the edges, and where the segment crosses the triangle's
/// plane.
template <Dim N, class T>
double distance_squared(const Segment<N, T>& segment, const Triangle<N, T>& triangle) {
  // Relative to the segment's start, so that rounding does not grow with the distance from zero.
  const Vec<N, double> start = wide<N, T>(segment.start);
  const Segment<N, double> line{Vec<N, double>(0.0), wide<N, T>(segment.end) - start};
  const Triangle<N, double> seen{wide<N, T>(triangle.a) - start, wide<N, T>(triangle.b) - start,
                                 wide<N, T>(triangle.c) - start};
  double best = std::min(distance_squared(line.start, seen), distance_squared(line.end, seen));
  const std::array<Vec<N, double>, 3> corners = seen.vertices();
  for (std::size_t i = 0; i < 3; ++i) {
    const Segment<N, double> edge{corners[i], corners[(i + 1) % 3]};
    best = std::min({best, distance_squared(edge.start, line), detail::perpendicular_distance_squared(line, edge)});
  }
  if constexpr (N == 3) best = std::min(best, detail::crossing_distance_squared(line.end, seen));
  return best;
}

}  // namespace graze
