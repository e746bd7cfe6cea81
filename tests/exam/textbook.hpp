// SPDX-License-Identifier: MIT
// The tests in textbooks and tutorials, as printed there: in the shapes' own number type, with the usual constants.
// They are compared with graze, which does not use them.
//
//               sphere  aabb  obb  plane  triangle
//   point         x      x     x
//   segment                                   x
//   sphere        x      x     x     x
//   aabb                 x     x     x
//   obb                        x     x
//   triangle                                  x
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/sphere.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::exam::textbook {

template <class T>
using Vec3 = Vec<3, T>;

template <class T>
bool meet(const Vec3<T>& point, const Sphere<3, T>& sphere) {
  const Vec3<T> off = point - sphere.center;
  return dot(off, off) <= sphere.radius * sphere.radius;
}

template <class T>
bool meet(const Vec3<T>& point, const Aabb<3, T>& box) {
  for (Dim i = 0; i < 3; ++i) {
    if (point[i] < box.min[i] || point[i] > box.max[i]) return false;
  }
  return true;
}

template <class T>
bool meet(const Vec3<T>& point, const Obb<3, T>& box) {
  const Vec3<T> off = point - box.center;
  for (Dim i = 0; i < 3; ++i) {
    if (std::fabs(dot(off, box.axes[i])) > box.half_extents[i]) return false;
  }
  return true;
}

template <class T>
bool meet(const Sphere<3, T>& a, const Sphere<3, T>& b) {
  const Vec3<T> off = b.center - a.center;
  const T reach = a.radius + b.radius;
  return dot(off, off) <= reach * reach;
}

/// By the nearest point of the box (Arvo 1990, Graphics Gems).
template <class T>
bool meet(const Sphere<3, T>& sphere, const Aabb<3, T>& box) {
  T squared = 0;
  for (Dim i = 0; i < 3; ++i) {
    const T off = sphere.center[i] - std::clamp(sphere.center[i], box.min[i], box.max[i]);
    squared += off * off;
  }
  return squared <= sphere.radius * sphere.radius;
}

template <class T>
bool meet(const Sphere<3, T>& sphere, const Obb<3, T>& box) {
  const Vec3<T> to_center = sphere.center - box.center;
  Vec3<T> nearest = box.center;
  for (Dim i = 0; i < 3; ++i) {
    nearest += box.axes[i] * std::clamp(dot(to_center, box.axes[i]), -box.half_extents[i], box.half_extents[i]);
  }
  return meet(nearest, sphere);
}

template <class T>
bool meet(const Sphere<3, T>& sphere, const Plane<3, T>& plane) {
  const T length = std::sqrt(dot(plane.normal, plane.normal));
  return std::fabs(dot(plane.normal, sphere.center) - plane.offset) / length <= sphere.radius;
}

template <class T>
bool meet(const Aabb<3, T>& a, const Aabb<3, T>& b) {
  for (Dim i = 0; i < 3; ++i) {
    if (a.max[i] < b.min[i] || b.max[i] < a.min[i]) return false;
  }
  return true;
}

template <class T>
Obb<3, T> oriented(const Aabb<3, T>& box) {
  return {(box.min + box.max) * T(0.5), (box.max - box.min) * T(0.5), Mat<3, T>(T(1))};
}

template <class T>
bool meet(const Obb<3, T>& box, const Plane<3, T>& plane) {
  T reach = 0;
  for (Dim i = 0; i < 3; ++i) reach += box.half_extents[i] * std::fabs(dot(plane.normal, box.axes[i]));
  return std::fabs(dot(plane.normal, box.center) - plane.offset) <= reach;
}

template <class T>
bool meet(const Aabb<3, T>& box, const Plane<3, T>& plane) {
  return meet(oriented(box), plane);
}

/// Fifteen separating axes, with the usual constant added to every cosine so that the cross product of parallel edges
/// separates nothing (Gottschalk, Lin, Manocha 1996; Ericson 2005, 4.4.1).
template <class T>
bool meet(const Obb<3, T>& a, const Obb<3, T>& b) {
  constexpr T usual = T(1e-6);
  std::array<std::array<T, 3>, 3> turn{};
  std::array<std::array<T, 3>, 3> size{};
  std::array<T, 3> t{};
  const Vec3<T> between = b.center - a.center;
  for (std::size_t i = 0; i < 3; ++i) {
    t[i] = dot(between, a.axes[static_cast<Dim>(i)]);
    for (std::size_t j = 0; j < 3; ++j) {
      turn[i][j] = dot(a.axes[static_cast<Dim>(i)], b.axes[static_cast<Dim>(j)]);
      size[i][j] = std::fabs(turn[i][j]) + usual;
    }
  }
  const std::array<T, 3> half_a{a.half_extents.x, a.half_extents.y, a.half_extents.z};
  const std::array<T, 3> half_b{b.half_extents.x, b.half_extents.y, b.half_extents.z};
  for (std::size_t i = 0; i < 3; ++i) {
    const T reach_b = half_b[0] * size[i][0] + half_b[1] * size[i][1] + half_b[2] * size[i][2];
    if (std::fabs(t[i]) > half_a[i] + reach_b) return false;
    const T reach_a = half_a[0] * size[0][i] + half_a[1] * size[1][i] + half_a[2] * size[2][i];
    if (std::fabs(t[0] * turn[0][i] + t[1] * turn[1][i] + t[2] * turn[2][i]) > half_b[i] + reach_a) return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i1 = (i + 1) % 3;
    const std::size_t i2 = (i + 2) % 3;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3;
      const std::size_t j2 = (j + 2) % 3;
      const T reach_a = half_a[i1] * size[i2][j] + half_a[i2] * size[i1][j];
      const T reach_b = half_b[j1] * size[i][j2] + half_b[j2] * size[i][j1];
      if (std::fabs(t[i2] * turn[i1][j] - t[i1] * turn[i2][j]) > reach_a + reach_b) return false;
    }
  }
  return true;
}

template <class T>
bool meet(const Aabb<3, T>& a, const Obb<3, T>& b) {
  return meet(oriented(a), b);
}

/// Moeller and Trumbore 1997, with the usual constant against segments parallel to the plane.
template <class T>
bool meet(const Segment<3, T>& segment, const Triangle<3, T>& triangle) {
  constexpr T usual = T(1e-6);
  const Vec3<T> way = segment.end - segment.start;
  const Vec3<T> edge_1 = triangle.b - triangle.a;
  const Vec3<T> edge_2 = triangle.c - triangle.a;
  const Vec3<T> p = cross(way, edge_2);
  const T determinant = dot(edge_1, p);
  if (determinant > -usual && determinant < usual) return false;
  const Vec3<T> to_start = segment.start - triangle.a;
  const T u = dot(to_start, p) / determinant;
  if (u < 0 || u > 1) return false;
  const Vec3<T> q = cross(to_start, edge_1);
  const T v = dot(way, q) / determinant;
  if (v < 0 || u + v > 1) return false;
  const T t = dot(edge_2, q) / determinant;
  return t >= 0 && t <= 1;
}

/// The heights of a triangle's corners above a plane; those close to zero are set to zero.
template <class T>
std::array<T, 3> heights(const Vec3<T>& normal, T offset, const std::array<Vec3<T>, 3>& corners) {
  constexpr T usual = T(1e-6);
  std::array<T, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const T height = dot(normal, corners[i]) + offset;
    result[i] = std::fabs(height) < usual ? T(0) : height;
  }
  return result;
}

template <class T>
bool all_on_one_side(const std::array<T, 3>& heights) {
  return heights[0] * heights[1] > 0 && heights[0] * heights[2] > 0;
}

/// Where a triangle that crosses the other's plane intersects the common line of both planes: `places` are its corners'
/// projections to an axis. The corner `i` that is alone on its side is an end of both crossing edges.
template <class T>
std::pair<T, T> interval(const std::array<T, 3>& places, const std::array<T, 3>& heights) {
  std::size_t alone = 0;
  if (heights[0] * heights[1] > 0) {
    alone = 2;
  } else if (heights[0] * heights[2] > 0) {
    alone = 1;
  } else if (heights[1] * heights[2] > 0 || heights[0] != 0) {
    alone = 0;
  } else {
    alone = heights[1] != 0 ? 1 : 2;
  }
  const auto crossing = [&](std::size_t other) {
    return places[alone] + (places[other] - places[alone]) * heights[alone] / (heights[alone] - heights[other]);
  };
  const T first = crossing((alone + 1) % 3);
  const T second = crossing((alone + 2) % 3);
  return std::minmax({first, second});
}

/// Two segments in the plane of the axes i, j.
template <class T>
// NOLINTNEXTLINE(readability-function-size): two edges and two axes
bool edges_cross(const Vec3<T>& p, const Vec3<T>& p_end, const Vec3<T>& q, const Vec3<T>& q_end, Dim i, Dim j) {
  const auto side = [i, j](const Vec3<T>& from, const Vec3<T>& to, const Vec3<T>& point) {
    return (to[i] - from[i]) * (point[j] - from[j]) - (to[j] - from[j]) * (point[i] - from[i]);
  };
  return side(p, p_end, q) * side(p, p_end, q_end) <= 0 && side(q, q_end, p) * side(q, q_end, p_end) <= 0;
}

template <class T>
bool holds_in_plane(const std::array<Vec3<T>, 3>& corners, const Vec3<T>& point, Dim i, Dim j) {
  bool below = false;
  bool above = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3<T>& from = corners[k];
    const Vec3<T>& to = corners[(k + 1) % 3];
    const T side = (to[i] - from[i]) * (point[j] - from[j]) - (to[j] - from[j]) * (point[i] - from[i]);
    below = below || side < 0;
    above = above || side > 0;
  }
  return !(below && above);
}

template <class T>
Dim largest_axis(const Vec3<T>& v) {
  Dim best = 0;
  for (Dim i = 1; i < 3; ++i) {
    if (std::fabs(v[i]) > std::fabs(v[best])) best = i;
  }
  return best;
}

template <class T>
bool coplanar_meet(const Vec3<T>& normal, const std::array<Vec3<T>, 3>& a, const std::array<Vec3<T>, 3>& b) {
  const Dim dropped = largest_axis(normal);
  const Dim i = (dropped + 1) % 3;
  const Dim j = (dropped + 2) % 3;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t l = 0; l < 3; ++l) {
      if (edges_cross(a[k], a[(k + 1) % 3], b[l], b[(l + 1) % 3], i, j)) return true;
    }
  }
  return holds_in_plane(a, b[0], i, j) || holds_in_plane(b, a[0], i, j);
}

/// Moeller 1997, "A fast triangle-triangle intersection test": each against the other's plane, then the two intervals
/// on the common line.
template <class T>
bool meet(const Triangle<3, T>& a, const Triangle<3, T>& b) {
  const std::array<Vec3<T>, 3> corners_a{a.a, a.b, a.c};
  const std::array<Vec3<T>, 3> corners_b{b.a, b.b, b.c};
  const Vec3<T> normal_a = cross(a.b - a.a, a.c - a.a);
  const std::array<T, 3> heights_b = heights(normal_a, -dot(normal_a, a.a), corners_b);
  if (all_on_one_side(heights_b)) return false;
  const Vec3<T> normal_b = cross(b.b - b.a, b.c - b.a);
  const std::array<T, 3> heights_a = heights(normal_b, -dot(normal_b, b.a), corners_a);
  if (all_on_one_side(heights_a)) return false;
  const bool is_coplanar = heights_a[0] == 0 && heights_a[1] == 0 && heights_a[2] == 0;
  if (is_coplanar) return coplanar_meet(normal_a, corners_a, corners_b);
  const Dim axis = largest_axis(cross(normal_a, normal_b));
  const auto [low_a, high_a] = interval({a.a[axis], a.b[axis], a.c[axis]}, heights_a);
  const auto [low_b, high_b] = interval({b.a[axis], b.b[axis], b.c[axis]}, heights_b);
  return high_a >= low_b && high_b >= low_a;
}

}  // namespace graze::exam::textbook
