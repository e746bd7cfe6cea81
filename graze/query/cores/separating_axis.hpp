// SPDX-License-Identifier: MIT
// The direction of the minimum translation that separates two cores: points, segments, boxes and triangles in double,
// see features.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/zonotope.hpp>
#include <graze/query/cores/closest.hpp>
#include <graze/query/cores/features.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/cores/surface_point_box.hpp>
#include <graze/query/cores/touching_points.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

// ---- edge_directions(core): one for all edges that are parallel. Those of a box are its axes, even if it is flat.

template <Dim N>
std::array<Vec<N, double>, 0> edge_directions(const Vec<N, double>&) {
  return {};
}
template <Dim N>
std::array<Vec<N, double>, 1> edge_directions(const Segment<N, double>& segment) {
  return edge_vectors(segment);
}
template <Dim N>
std::array<Vec<N, double>, 3> edge_directions(const Triangle<N, double>& triangle) {
  return edge_vectors(triangle);
}
template <Dim N>
std::array<Vec<N, double>, static_cast<std::size_t>(N)> columns_of(const Mat<N, double>& matrix) {
  std::array<Vec<N, double>, static_cast<std::size_t>(N)> columns;
  for (Dim i = 0; i < N; ++i) columns[static_cast<std::size_t>(i)] = matrix[i];
  return columns;
}
template <Dim N>
auto edge_directions(const Aabb<N, double>&) {
  return columns_of<N>(Mat<N, double>(1.0));
}
template <Dim N>
auto edge_directions(const Obb<N, double>& box) {
  return columns_of<N>(box.axes);
}

// ---- face_directions(core): the normals of its faces, in 2D those of its edges; of any length, zero if all points are
// collinear.

template <class Core>
requires(dimension_of<Core> == 2) auto face_directions(const Core& core) {
  auto directions = edge_directions(core);
  for (auto& direction : directions) direction = -perpendicular(direction);
  return directions;
}
inline std::array<Vec<3, double>, 0> face_directions(const Vec<3, double>&) { return {}; }
inline std::array<Vec<3, double>, 0> face_directions(const Segment<3, double>&) { return {}; }
inline std::array<Vec<3, double>, 1> face_directions(const Triangle<3, double>& triangle) {
  return {cross_of_directions(triangle.b - triangle.a, triangle.c - triangle.a)};
}
inline auto face_directions(const Aabb<3, double>& box) { return edge_directions(box); }
inline auto face_directions(const Obb<3, double>& box) { return columns_of<3>(adjoint_columns(box.axes)); }

/// A unit direction and the gap along it: the height of the lowest point of b above the highest of a. Moving b by minus
/// the gap along the direction makes the cores just touch.
template <Dim N>
struct SeparatingAxis {
  Vec<N, double> normal = unit_axis<N>(0);
  double gap = -std::numeric_limits<double>::infinity();
};

/// Keeps the direction with the largest gap. Of gaps that differ by no more than rounding the first offered wins, so
/// that faces, offered before pairs of edges, remain the answer between frames.
template <class A, class B>
class SeparatingAxisSearch {
 public:
  static constexpr Dim N = dimension_of<A>;

  /// `size` is that of both cores.
  SeparatingAxisSearch(const A& a, const B& b, double size)
      : a_(with_edges(a)), b_(with_edges(b)), margin_(tolerance::rounding * size) {}

  /// A direction of any length, and its opposite. Zero is ignored.
  void offer(const Vec<N, double>& direction) {
    if (is_surely_worse(direction)) return;
    const Vec<N, double> scaled = scaled_direction(direction);
    const double squared = dot(scaled, scaled);
    if (!(squared > 0)) return;
    const Vec<N, double> normal = scaled / std::sqrt(squared);
    const Span on_a = span_along(normal, a_);
    const Span on_b = span_along(normal, b_);
    const double ahead = on_b.low - on_a.high;
    const double behind = on_a.low - on_b.high;
    const double gap = std::max(ahead, behind);
    if (gap > best_.gap + margin_) best_ = {ahead >= behind ? normal : -normal, gap};
  }

  const SeparatingAxis<N>& best() const { return best_; }

 private:
  using EdgedA = std::decay_t<decltype(with_edges(std::declval<const A&>()))>;
  using EdgedB = std::decay_t<decltype(with_edges(std::declval<const B&>()))>;

  /// Whether the gap along a direction is certainly smaller than the best: decided without its length.
  bool is_surely_worse(const Vec<N, double>& direction) const {
    constexpr double far = 1e100;
    const double squared = dot(direction, direction);
    if (!(best_.gap < 0 && squared > 1 / far && squared < far)) return false;
    const Span on_a = span_along(direction, a_);
    const Span on_b = span_along(direction, b_);
    const double gap = std::max(on_b.low - on_a.high, on_a.low - on_b.high);
    constexpr double rounded = 1 + 1e-9;
    return gap < 0 && gap * gap > best_.gap * best_.gap * squared * rounded;
  }

  /// So that no square leaves the range of double.
  static Vec<N, double> scaled_direction(const Vec<N, double>& direction) {
    const double size = max_abs(direction);
    return size > 0 ? direction / size : direction;
  }

  EdgedA a_;
  EdgedB b_;
  double margin_;
  SeparatingAxis<N> best_;
};

/// Offers every normal direction of the Minkowski difference of two cores: the normals of their faces and, in 3D, the
/// common normals of an edge of each (the separating-axis test; Gottschalk, Lin, Manocha, "OBBTree", 1996). If all
/// edges are parallel the difference has no faces; then the perpendicular direction is used, and for points direction
/// x.
template <class A, class B>
void offer_faces(const A& a, const B& b, SeparatingAxisSearch<A, B>& search) {
  constexpr Dim N = dimension_of<A>;
  for (const auto& direction : face_directions(a)) search.offer(direction);
  for (const auto& direction : face_directions(b)) search.offer(direction);
  if constexpr (N == 3) {
    for (const auto& edge_a : edge_directions(a)) {
      for (const auto& edge_b : edge_directions(b)) search.offer(cross_of_directions(edge_a, edge_b));
    }
  }
  if (std::isfinite(search.best().gap)) return;
  Vec<N, double> longest(0.0);
  const auto keep_longest = [&longest](const auto& edges) {
    for (const auto& edge : edges) {
      if (sum_abs(edge) > sum_abs(longest)) longest = edge;
    }
  };
  keep_longest(edge_directions(a));
  keep_longest(edge_directions(b));
  search.offer(across(longest));
}

// ---- moved_by(core, way)

template <Dim N>
Vec<N, double> moved_by(const Vec<N, double>& point, const Vec<N, double>& way) {
  return point + way;
}
template <Dim N>
Segment<N, double> moved_by(const Segment<N, double>& segment, const Vec<N, double>& way) {
  return {segment.start + way, segment.end + way};
}
template <Dim N>
Aabb<N, double> moved_by(const Aabb<N, double>& box, const Vec<N, double>& way) {
  return {box.min + way, box.max + way};
}
template <Dim N>
Obb<N, double> moved_by(const Obb<N, double>& box, const Vec<N, double>& way) {
  return {box.center + way, box.half_extents, box.axes};
}
template <Dim N>
Triangle<N, double> moved_by(const Triangle<N, double>& triangle, const Vec<N, double>& way) {
  return {triangle.a + way, triangle.b + way, triangle.c + way};
}

// ---- Points

/// Moving b along the axis until the cores just touch shows the contact points.
template <class A, class B>
ClosestPair<dimension_of<A>> points_along(const A& a, const B& b, const SeparatingAxis<dimension_of<A>>& axis,
                                          double size) {
  const Vec<dimension_of<A>, double> way = axis.normal * -axis.gap;
  ClosestPair<dimension_of<A>> pair = closest_of_touching(a, moved_by(b, way), axis.normal, size);
  pair.on_b -= way;
  return pair;
}

}  // namespace graze::detail
