// SPDX-License-Identifier: MIT
// distance_squared(a, b): the squared distance of points, segments and boxes, 0 when they touch or overlap, in double.
// The cheaper sibling of a distance: no root. The error of its root is a few epsilon of the vectors between and along
// the two shapes, however far from the origin they lie.
//
//              point    segment   aabb     obb
//   point      closed   closed    closed   closed
//   segment             closed    closed   closed
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/zonotope.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/segment.hpp>

namespace graze {

template <Dim N, class T>
double distance_squared(const Vec<N, T>& a, const Vec<N, T>& b) {
  const Vec<N, double> between = wide<N, T>(b) - wide<N, T>(a);
  return dot(between, between);
}

/// The foot of the perpendicular, or the nearer end (Ericson, Real-Time Collision Detection, 5.1.2). Past the far end
/// the vector is taken from that end, so that no rounding of the foot enters.
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

/// The squared distance of a point from the segment between zero and `edge`.
template <Dim N>
double distance_squared_from_edge(const Vec<N, double>& point, const Vec<N, double>& edge) {
  const double along = dot(point, edge);
  const double whole = dot(edge, edge);
  if (along <= 0) return dot(point, point);
  const Vec<N, double> off = point - edge * (along < whole ? along / whole : 1.0);  // whole > 0 if along < whole
  return dot(off, off);
}

/// The squared distance about the mutual perpendicular of two lines, as far as it meets the segments; +infinity if they
/// are parallel. With p(s) = start_a + s u, q(t) = start_b + t v, w = start_b - start_a, n = u x v the perpendicular
/// is at s n^2 = (w x v) . n, t n^2 = (w x u) . n. Both feet are rounded, and the more the more parallel the lines are,
/// but not apart from each other: each foot's own distance from the other segment is what counts, and the better one.
template <Dim N>
double perpendicular_distance_squared(const Segment<N, double>& first, const Segment<N, double>& second) {
  const Vec<N, double> u = first.end - first.start;
  const Vec<N, double> v = second.end - second.start;
  const Vec<N, double> w = second.start - first.start;
  const auto n = accurate_cross(u, v);
  const double whole = inner(n, n);
  if (!(whole > 0)) return std::numeric_limits<double>::infinity();
  const double s = std::clamp(inner(accurate_cross(w, v), n) / whole, 0.0, 1.0);
  const double t = std::clamp(inner(accurate_cross(w, u), n) / whole, 0.0, 1.0);
  return std::min(distance_squared_from_edge(u * s - w, v), distance_squared_from_edge(v * t + w, u));
}

template <Dim N, class T>
Segment<N, double> wide_segment(const Segment<N, T>& segment) {
  return {wide<N, T>(segment.start), wide<N, T>(segment.end)};
}

}  // namespace detail

/// The least of the four distances from an end and of that about the mutual perpendicular. Swapping changes no bit.
template <Dim N, class T>
double distance_squared(const Segment<N, T>& a, const Segment<N, T>& b) {
  const double from_a = std::min(distance_squared(a.start, b), distance_squared(a.end, b));
  const double from_b = std::min(distance_squared(b.start, a), distance_squared(b.end, a));
  const double inside = detail::perpendicular_distance_squared(detail::wide_segment(a), detail::wide_segment(b));
  return std::min({from_a, from_b, inside});
}

template <Dim N, class T>
double distance_squared(const Vec<N, T>& point, const Aabb<N, T>& box) {
  double sum = 0;
  for (Dim i = 0; i < N; ++i) {
    const double below = static_cast<double>(box.min[i]) - static_cast<double>(point[i]);
    const double above = static_cast<double>(point[i]) - static_cast<double>(box.max[i]);
    const double outside = std::max({below, above, 0.0});
    sum += outside * outside;
  }
  return sum;
}

namespace detail {

/// The squared distance of a box from the points t * edge, 0 <= t <= 1: a convex function of t, quadratic between the
/// knots, where the segment crosses a face's plane. Its derivative tells which piece holds the minimum.
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
  /// Half the derivative at a place, and how fast it changes there.
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

/// Both are seen from the segment's start, so that no rounding grows with the distance from zero.
template <Dim N, class T>
double distance_squared(const Segment<N, T>& segment, const Aabb<N, T>& box) {
  const Vec<N, double> start = wide<N, T>(segment.start);
  const Aabb<N, double> seen{wide<N, T>(box.min) - start, wide<N, T>(box.max) - start};
  return detail::DistanceAlongSegment<N>(wide<N, T>(segment.end) - start, seen).least();
}

/// Starting from the clamped projections on the axes, two steps of projected descent take up what the axes lack of
/// being orthonormal: each step shrinks that error by tolerance::orthonormal at least, and it enters the distance
/// squared.
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

/// Zero if they meet; else the nearest points are an end of the segment and the box, or the segment and an edge of the
/// box.
template <Dim N, class T>
double distance_squared(const Segment<N, T>& segment, const Obb<N, T>& box) {
  const Vec<N, double> center = wide<N, T>(box.center);
  if (detail::relation_of_zonotopes(detail::zonotope(segment), detail::zonotope(box)) != Relation::apart) return 0;
  double best = std::min(distance_squared(segment.start, box), distance_squared(segment.end, box));
  // Seen from the box's center, so that no rounding grows with the distance from zero.
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

}  // namespace graze
