// SPDX-License-Identifier: MIT
// The corners, edges and nearest points of cores, used for closest points: points, segments, boxes and triangles in
// double, all relative to a point near the pair, so that rounding errors do not grow with the distance from zero.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/math/orientation.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/cores/closest_on_core.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/cores/surface_point_box.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/shape.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

// ---- closest_on(core, p): the core's point nearest to p, and the vector from there to p. For segments and 3D
// triangles see closest_on_core.hpp.

template <Dim N>
ClosestOnCore<N> closest_on(const Vec<N, double>& core, const Vec<N, double>& p) {
  return {core, p - core};
}

template <Dim N>
ClosestOnCore<N> closest_on(const Aabb<N, double>& box, const Vec<N, double>& p) {
  const Vec<N, double> inside = clamp(p, box.min, box.max);
  return {inside, p - inside};
}

template <Dim N>
ClosestOnCore<N> closest_on(const Obb<N, double>& box, const Vec<N, double>& p) {
  const PlaceInBox<N> nearest = place_in(box, p);
  return {box.center + box.axes * nearest.place, nearest.off};
}

/// A point inside is its own projection.
inline ClosestOnCore<2> closest_on(const Triangle<2, double>& triangle, const Vec<2, double>& p) {
  const std::array<Vec<2, double>, 3> corners = counter_clockwise(triangle);
  const ClosestOnPolygon nearest = closest_on_polygon<double>(corners, p);
  return nearest.is_inside ? ClosestOnCore<2>{p, Vec<2, double>(0.0)} : nearest.closest;
}

/// A core in the form of closest_on for many points.
template <class Core>
const Core& with_feet(const Core& core) {
  return core;
}
inline FacedTriangle with_feet(const Triangle<3, double>& triangle) { return faced(triangle); }

// ---- Boxes as a center and the vectors from it to the centers of the faces

template <Dim N>
struct BoxFrame {
  Vec<N, double> center;
  Mat<N, double> half_edges;
};

template <Dim N>
BoxFrame<N> frame_of(const Aabb<N, double>& box) {
  BoxFrame<N> frame{box.center(), Mat<N, double>(1.0)};
  const Vec<N, double> half_extents = box.half_extents();
  for (Dim i = 0; i < N; ++i) frame.half_edges[i] *= half_extents[i];
  return frame;
}

template <Dim N>
BoxFrame<N> frame_of(const Obb<N, double>& box) {
  return {box.center, half_edges(box)};
}

template <class Core>
concept BoxCore = requires(const Core& core) {
  frame_of(core);
};

// ---- corner_points(core)

template <Dim N>
std::array<Vec<N, double>, 1> corner_points(const Vec<N, double>& point) {
  return {point};
}

template <Dim N>
std::array<Vec<N, double>, 2> corner_points(const Segment<N, double>& segment) {
  return {segment.start, segment.end};
}

template <Dim N>
std::array<Vec<N, double>, 3> corner_points(const Triangle<N, double>& triangle) {
  return triangle.vertices();
}

/// Corner number k is on the far side of axis i if bit i of k is set.
template <BoxCore Box>
auto corner_points(const Box& box) {
  const auto frame = frame_of(box);
  constexpr Dim N = dimension_of<Box>;
  std::array<Vec<N, double>, std::size_t{1} << N> corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    corners[k] = frame.center;
    for (Dim i = 0; i < N; ++i) corners[k] += (k >> i & 1U) != 0 ? frame.half_edges[i] : -frame.half_edges[i];
  }
  return corners;
}

/// Those of an AABB are exact.
template <Dim N>
std::array<Vec<N, double>, std::size_t{1} << N> corner_points(const Aabb<N, double>& box) {
  std::array<Vec<N, double>, std::size_t{1} << N> corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    for (Dim i = 0; i < N; ++i) corners[k][i] = (k >> i & 1U) != 0 ? box.max[i] : box.min[i];
  }
  return corners;
}

/// A bound on the sum of the absolute coordinates of every point.
template <class Core>
double size_around_zero(const Core& core) {
  double size = 0;
  for (const auto& corner : corner_points(core)) size = std::max(size, sum_abs(corner));
  return size;
}

// ---- Edges: the vectors along them, one for all that are parallel; and the segments themselves

template <Dim N>
std::array<Vec<N, double>, 1> edge_vectors(const Segment<N, double>& segment) {
  return {segment.end - segment.start};
}

template <Dim N>
std::array<Vec<N, double>, 3> edge_vectors(const Triangle<N, double>& triangle) {
  return {triangle.b - triangle.a, triangle.c - triangle.b, triangle.a - triangle.c};
}

template <Dim N>
std::array<Vec<N, double>, static_cast<std::size_t>(N)> edge_vectors(const BoxFrame<N>& box) {
  std::array<Vec<N, double>, static_cast<std::size_t>(N)> edges;
  for (Dim i = 0; i < N; ++i) edges[static_cast<std::size_t>(i)] = box.half_edges[i] * 2.0;
  return edges;
}

/// Whether `way` has a component against `direction`, by more than rounding.
template <Dim N>
bool leads_back(const Vec<N, double>& way, const Vec<N, double>& direction) {
  return dot(way, direction) < -tolerance::extreme_edge * sum_abs(way) * sum_abs(direction);
}

/// Calls `visit` with the edges along edge_vectors(core)[index]; except those from which a vector along the core, to
/// another of them or to the third corner of a triangle, satisfies `leads_on`.
template <Dim N, class LeadsOn, class Visit>
void visit_edges_along(const Segment<N, double>& segment, std::size_t, const LeadsOn&, const Visit& visit) {
  visit(segment);
}

template <Dim N, class LeadsOn, class Visit>
void visit_edges_along(const Triangle<N, double>& triangle, std::size_t index, const LeadsOn& leads_on,
                       const Visit& visit) {
  const std::array<Vec<N, double>, 3> corners = triangle.vertices();
  const Vec<N, double>& start = corners[index];
  if (!leads_on(start - corners[(index + 2) % 3])) visit(Segment<N, double>{start, corners[(index + 1) % 3]});
}

template <Dim N, class LeadsOn, class Visit>
void visit_edges_along(const BoxFrame<N>& box, std::size_t index, const LeadsOn& leads_on, const Visit& visit) {
  const auto along = static_cast<Dim>(index);
  for (unsigned sides = 0; sides < 1U << (N - 1); ++sides) {
    Vec<N, double> middle = box.center;
    bool is_foremost = true;
    unsigned bits = sides;
    for (Dim i = 0; i < N; ++i) {
      if (i == along) continue;
      const Vec<N, double> way = (bits & 1U) != 0 ? box.half_edges[i] : -box.half_edges[i];
      bits >>= 1U;
      middle += way;
      is_foremost = is_foremost && !leads_on(way);
    }
    if (is_foremost) visit(Segment<N, double>{middle - box.half_edges[along], middle + box.half_edges[along]});
  }
}

/// Calls `visit` with the foremost edges along edge_vectors(core)[index], seen along `direction` (perpendicular to
/// these edges); two or more if rounding cannot decide between them.
template <Dim N, class Core, class Visit>
void visit_foremost_edges(const Core& core, std::size_t index, const Vec<N, double>& direction, const Visit& visit) {
  const auto leads_on = [&direction](const Vec<N, double>& way) { return leads_back(way, direction); };
  visit_edges_along(core, index, leads_on, visit);
}

/// A core in the form of the functions of edges: boxes by their frames.
template <class Core>
const Core& with_edges(const Core& core) {
  return core;
}
template <BoxCore Box>
auto with_edges(const Box& box) {
  return frame_of(box);
}

/// Points have no edges, and are their own nearest points.
template <class Core>
concept HasEdges = requires(const Core& core) {
  edge_vectors(with_edges(core));
};

/// Calls `visit` with every edge.
template <HasEdges Core, class Visit>
void visit_edges(const Core& core, const Visit& visit) {
  const auto& edged = with_edges(core);
  const auto never = [](const auto&) { return false; };
  constexpr std::size_t directions = std::tuple_size_v<decltype(edge_vectors(edged))>;
  for (std::size_t i = 0; i < directions; ++i) visit_edges_along(edged, i, never, visit);
}

// ---- The heights of a core along a direction, in units of its length

struct Span {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

template <Dim N, class Core>
Span span_along(const Vec<N, double>& direction, const Core& core) {
  Span span;
  for (const Vec<N, double>& corner : corner_points(core)) {
    const double height = dot(direction, corner);
    span.low = std::min(span.low, height);
    span.high = std::max(span.high, height);
  }
  return span;
}

template <Dim N>
Span span_along(const Vec<N, double>& direction, const BoxFrame<N>& box) {
  const double middle = dot(direction, box.center);
  double reach = 0;
  for (Dim i = 0; i < N; ++i) reach += std::fabs(dot(direction, box.half_edges[i]));
  return {middle - reach, middle + reach};
}

}  // namespace graze::detail
