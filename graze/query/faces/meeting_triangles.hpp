// SPDX-License-Identifier: MIT
// Whether two triangles share a point, and whether two faces share more than their common vertices: decided by exact
// orientations, for any triangles, flat ones included.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <graze/math/orientation.hpp>
#include <graze/math/orientation_3d.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/mesh/flat_triangle.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

template <Dim N, class T>
using TriangleCorners = std::array<Vec<N, T>, 3>;

// ---- In the plane

/// Whether c, on the line through a and b, is between them, ends included.
template <class T>
bool is_between(const Vec<2, T>& a, const Vec<2, T>& b, const Vec<2, T>& c) {
  const auto [low_x, high_x] = std::minmax(a[0], b[0]);
  const auto [low_y, high_y] = std::minmax(a[1], b[1]);
  return low_x <= c[0] && c[0] <= high_x && low_y <= c[1] && c[1] <= high_y;
}

template <class T>
bool do_segments_meet(const Vec<2, T>& a, const Vec<2, T>& b, const Vec<2, T>& c, const Vec<2, T>& d) {
  const int at_c = orientation(a, b, c);
  const int at_d = orientation(a, b, d);
  const int at_a = orientation(c, d, a);
  const int at_b = orientation(c, d, b);
  if (at_c * at_d < 0 && at_a * at_b < 0) return true;
  return (at_c == 0 && is_between(a, b, c)) || (at_d == 0 && is_between(a, b, d)) ||
         (at_a == 0 && is_between(c, d, a)) || (at_b == 0 && is_between(c, d, b));
}

/// Of a triangle with an area.
template <class T>
bool does_hold(const TriangleCorners<2, T>& corners, const Vec<2, T>& point) {
  const int turn = orientation(corners[0], corners[1], corners[2]);
  bool is_inside = turn != 0;
  for (std::size_t i = 0; i < 3; ++i) {
    is_inside = is_inside && orientation(corners[i], corners[(i + 1) % 3], point) * turn >= 0;
  }
  return is_inside;
}

/// Closed sets: the segment a, b and the triangle.
template <class T>
bool does_segment_meet(const Vec<2, T>& a, const Vec<2, T>& b, const TriangleCorners<2, T>& corners) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (do_segments_meet(a, b, corners[i], corners[(i + 1) % 3])) return true;
  }
  return does_hold(corners, a);
}

template <class T>
bool do_triangles_meet(const TriangleCorners<2, T>& a, const TriangleCorners<2, T>& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (does_segment_meet(a[i], a[(i + 1) % 3], b)) return true;
  }
  return does_hold(a, b[0]);
}

// ---- In space

/// An axis along which coplanar points are seen without any two falling together: across their plane, or if they are
/// collinear, along an axis that is not that of their line.
template <class T, std::size_t count>
Dim axis_of_plane(const std::array<Vec<3, T>, count>& points) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      for (std::size_t k = j + 1; k < count; ++k) {
        if (const Dim axis = axis_across(points[i], points[j], points[k]); axis >= 0) return axis;
      }
    }
  }
  for (Dim axis = 0; axis < 3; ++axis) {  // a coordinate in which they differ is kept
    for (const Vec<3, T>& point : points) {
      if (seen_along(axis, point) != seen_along(axis, points[0])) return axis;
    }
  }
  return 0;
}

/// The ends of the longest of three collinear corners' segments.
template <class T>
std::array<Vec<3, T>, 2> ends_of(const TriangleCorners<3, T>& corners) {
  const auto is_before = [](const Vec<3, T>& a, const Vec<3, T>& b) {
    return std::lexicographical_compare(&a[0], &a[0] + 3, &b[0], &b[0] + 3);
  };
  const auto [first, last] = std::minmax_element(corners.begin(), corners.end(), is_before);
  return {*first, *last};
}

template <class T>
bool do_segments_meet(const Vec<3, T>& a, const Vec<3, T>& b, const Vec<3, T>& c, const Vec<3, T>& d) {
  if (orientation(a, b, c, d) != 0) return false;
  const Dim axis = axis_of_plane(std::array{a, b, c, d});
  return do_segments_meet(seen_along(axis, a), seen_along(axis, b), seen_along(axis, c), seen_along(axis, d));
}

/// The segment a, b and the triangle, which may be flat.
template <class T>
bool does_segment_meet(const Vec<3, T>& a, const Vec<3, T>& b, const TriangleCorners<3, T>& corners) {
  const Dim axis = axis_across(corners[0], corners[1], corners[2]);
  if (axis < 0) {
    const std::array<Vec<3, T>, 2> ends = ends_of(corners);
    return do_segments_meet(a, b, ends[0], ends[1]);
  }
  const int side_a = orientation(corners[0], corners[1], corners[2], a);
  const int side_b = orientation(corners[0], corners[1], corners[2], b);
  if (side_a * side_b > 0) return false;
  if (side_a == 0 && side_b == 0) {
    return does_segment_meet(seen_along(axis, a), seen_along(axis, b), seen_along(axis, corners));
  }
  // The line through a and b passes all edges on the same side, or touches some.
  std::array<int, 3> turns{};
  for (std::size_t i = 0; i < 3; ++i) turns[i] = orientation(a, b, corners[i], corners[(i + 1) % 3]);
  const auto [least, greatest] = std::minmax_element(turns.begin(), turns.end());
  return !(*least < 0 && *greatest > 0);
}

/// Whether the corners of a triangle are all on one side of another's plane.
template <class T>
bool is_beside(const TriangleCorners<3, T>& a, const TriangleCorners<3, T>& b) {
  const int side = orientation(b[0], b[1], b[2], a[0]);
  return side != 0 && orientation(b[0], b[1], b[2], a[1]) == side && orientation(b[0], b[1], b[2], a[2]) == side;
}

/// Two convex sets without a common point on the boundary of either have none, except if one is inside the other, which
/// triangles in space are only in a common plane.
template <class T>
bool do_triangles_meet(const TriangleCorners<3, T>& a, const TriangleCorners<3, T>& b) {
  if (is_beside(a, b) || is_beside(b, a)) return false;  // most are
  for (std::size_t i = 0; i < 3; ++i) {
    if (does_segment_meet(a[i], a[(i + 1) % 3], b)) return true;
    if (does_segment_meet(b[i], b[(i + 1) % 3], a)) return true;
  }
  return false;
}

// ---- Faces with common vertices

/// The places of the common vertices of two faces in each of them, those in the first face in order.
struct CommonVertices {
  std::array<std::size_t, 3> in_a{};
  std::array<std::size_t, 3> in_b{};
  std::size_t count = 0;
};

/// Each vertex of b is used once.
inline CommonVertices common_vertices(const std::array<std::uint32_t, 3>& a, const std::array<std::uint32_t, 3>& b) {
  CommonVertices common;
  std::array<bool, 3> is_used{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (a[i] != b[j] || is_used[j]) continue;
      is_used[j] = true;
      common.in_a[common.count] = i;
      common.in_b[common.count++] = j;
      break;
    }
  }
  return common;
}

/// Whether two segments from one point share more than it.
template <class T>
bool do_point_the_same_way(const Vec<2, T>& start, const Vec<2, T>& a, const Vec<2, T>& b) {
  if (a == start || b == start || orientation(start, a, b) != 0) return false;
  return is_between(start, a, b) || is_between(start, b, a);
}
template <class T>
bool do_point_the_same_way(const Vec<3, T>& start, const Vec<3, T>& a, const Vec<3, T>& b) {
  if (axis_across(start, a, b) >= 0) return false;
  const Dim axis = axis_of_plane(std::array{start, a, b});
  return do_point_the_same_way(seen_along(axis, start), seen_along(axis, a), seen_along(axis, b));
}

/// For two triangles u, v, a and u, v, b: whether they share more than the edge.
template <class T>
bool do_meet_beyond_edge(const Vec<2, T>& u, const Vec<2, T>& v, const Vec<2, T>& a, const Vec<2, T>& b) {
  const int side_a = orientation(u, v, a);
  const int side_b = orientation(u, v, b);
  if (side_a * side_b > 0) return true;
  if (side_a != 0 || side_b != 0) return false;
  // Both are segments on one line: they share more if both reach beyond the same end.
  const auto is_beyond = [](const Vec<2, T>& start, const Vec<2, T>& end, const Vec<2, T>& point) {
    return !is_between(start, end, point) && is_between(start, point, end);
  };
  if (u == v) return do_point_the_same_way(u, a, b);
  return (is_beyond(u, v, a) && is_beyond(u, v, b)) || (is_beyond(v, u, a) && is_beyond(v, u, b));
}
template <class T>
bool do_meet_beyond_edge(const Vec<3, T>& u, const Vec<3, T>& v, const Vec<3, T>& a, const Vec<3, T>& b) {
  if (orientation(u, v, a, b) != 0) return false;
  const Dim axis = axis_of_plane(std::array{u, v, a, b});
  return do_meet_beyond_edge(seen_along(axis, u), seen_along(axis, v), seen_along(axis, a), seen_along(axis, b));
}

/// The triangle has the vertex; whether it and the segment from there to `end` share more than that.
template <Dim N, class T>
bool does_segment_enter(const Vec<N, T>& vertex, const Vec<N, T>& end, const TriangleCorners<N, T>& corners,
                        const std::array<Vec<N, T>, 2>& opposite) {
  if (end == vertex) return false;
  return does_segment_meet(end, end, corners) || do_segments_meet(vertex, end, opposite[0], opposite[1]);
}

/// For triangles with one common vertex: whether they share another point. It can be moved away from the vertex, in
/// both of them, until it is on the opposite edge of one. A flat triangle is two segments from the vertex.
template <Dim N, class T>
bool do_meet_beyond_vertex(const Vec<N, T>& vertex, const std::array<Vec<N, T>, 2>& of_a,
                           const TriangleCorners<N, T>& a, const std::array<Vec<N, T>, 2>& of_b,
                           const TriangleCorners<N, T>& b) {
  const bool is_a_flat = is_flat(a);
  const bool is_b_flat = is_flat(b);
  if (!is_a_flat && !is_b_flat) {
    return does_segment_meet(of_a[0], of_a[1], b) || does_segment_meet(of_b[0], of_b[1], a);
  }
  if (!is_b_flat) return does_segment_enter(vertex, of_a[0], b, of_b) || does_segment_enter(vertex, of_a[1], b, of_b);
  if (!is_a_flat) return does_segment_enter(vertex, of_b[0], a, of_a) || does_segment_enter(vertex, of_b[1], a, of_a);
  return do_point_the_same_way(vertex, of_a[0], of_b[0]) || do_point_the_same_way(vertex, of_a[0], of_b[1]) ||
         do_point_the_same_way(vertex, of_a[1], of_b[0]) || do_point_the_same_way(vertex, of_a[1], of_b[1]);
}

/// Whether two faces share a point that is on no common vertex and no common edge.
template <Dim N, class T>
bool do_faces_cross(const TriangleCorners<N, T>& a, const TriangleCorners<N, T>& b, const CommonVertices& common) {
  if (common.count == 0) return do_triangles_meet(a, b);
  if (common.count == 3) return true;
  const std::size_t in_a = common.in_a[0];
  const std::size_t in_b = common.in_b[0];
  if (common.count == 1) {
    return do_meet_beyond_vertex<N, T>(a[in_a], {a[(in_a + 1) % 3], a[(in_a + 2) % 3]}, a,
                                       {b[(in_b + 1) % 3], b[(in_b + 2) % 3]}, b);
  }
  return do_meet_beyond_edge(a[in_a], a[common.in_a[1]], a[3 - in_a - common.in_a[1]], b[3 - in_b - common.in_b[1]]);
}

}  // namespace graze::detail
