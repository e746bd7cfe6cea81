// SPDX-License-Identifier: MIT
// The face of a core that faces most along a direction, as a few numbered corners: manifold.hpp clips these against
// each other. In double, relative to a point near the pair.
//
// The numbers of features are those of `Feature` in clipped.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/cores/features.hpp>
#include <graze/query/cores/separating_axis.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/cores/surface_point_box.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

/// A convex polygon in 3D, an edge in 2D; or an edge or a point, if a core has nothing more.
template <Dim N>
struct Patch {
  static constexpr std::size_t most_corners = N == 2 ? 2 : 8;

  std::array<Vec<N, double>, most_corners> corners;  ///< In order around the face, in either direction.
  std::array<std::uint32_t, most_corners> vertices;  ///< Their numbers.
  std::array<std::uint32_t, most_corners> edges;     ///< The edges from each corner to the next.
  std::size_t size = 0;                              ///< 0: without bounds.
  std::uint32_t face = 0;
  Vec<N, double> normal = Vec<N, double>(0.0);  ///< A unit vector, outward; zero if it is not a face.

  void add(const Vec<N, double>& corner, std::uint32_t vertex, std::uint32_t edge) {
    corners[size] = corner;
    vertices[size] = vertex;
    edges[size++] = edge;
  }
};

template <Dim N>
double size_of_patch(const Patch<N>& patch) {
  double size = 0;
  for (std::size_t i = 0; i < patch.size; ++i) size = std::max(size, sum_abs(patch.corners[i]));
  return size;
}

/// Half the circumference of a patch: at least its diameter. That of a plane is infinite.
template <Dim N>
double half_perimeter(const Patch<N>& patch) {
  if (patch.size == 0) return std::numeric_limits<double>::infinity();
  double way = 0;
  for (std::size_t i = 0; i < patch.size; ++i) {
    const Vec<N, double> edge = patch.corners[i + 1 < patch.size ? i + 1 : 0] - patch.corners[i];
    way += std::sqrt(dot(edge, edge));
  }
  return 0.5 * way;
}

// ---- patch_of(core, direction); of faces that are equally good, up to rounding, the first.

template <Dim N>
Patch<N> patch_of(const Vec<N, double>& point, const Vec<N, double>&) {
  Patch<N> patch;
  patch.add(point, 0, 0);
  return patch;
}

/// In 2D a segment has two sides; the normal is that of the side that faces along the direction.
template <Dim N>
Patch<N> patch_of(const Segment<N, double>& segment, const Vec<N, double>& direction) {
  Patch<N> patch;
  patch.add(segment.start, 0, 0);
  patch.add(segment.end, 1, 0);
  if constexpr (N == 2) {
    const Vec<2, double> normal = unit_or(perpendicular(segment.end - segment.start), Vec<2, double>(0.0));
    patch.normal = dot(normal, direction) < 0 ? -normal : normal;
  }
  return patch;
}

inline Patch<3> patch_of(const Triangle<3, double>& triangle, const Vec<3, double>& direction) {
  Patch<3> patch;
  const auto corners = triangle.vertices();
  for (std::uint32_t i = 0; i < 3; ++i) patch.add(corners[i], i, i);
  const Vec<3, double> normal = unit_or(face_directions(triangle)[0], Vec<3, double>(0.0));
  patch.normal = dot(normal, direction) < 0 ? -normal : normal;
  return patch;
}

template <Dim N>
bool is_aligned(const Vec<N, double>& a, const Vec<N, double>& b) {
  const Vec<N, double> turn = a - b;
  return dot(turn, turn) <= tolerance::aligned * tolerance::aligned;
}

/// How much better, as a cosine, a later face must match a direction to be preferred.
inline bool looks_more(double candidate, double best) { return candidate > best + tolerance::aligned; }

/// The edges of a convex polygon whose corners `corner(0)`, ..., `corner(count - 1)` are in either order.
template <class Corner>
class PolygonEdges {
 public:
  PolygonEdges(std::size_t count, const Corner& corner) : count_(count), corner_(corner) {
    for (std::size_t i = 2; i < count; ++i) {
      area_ += cross_2d<double>(corner(i - 1) - corner(0), corner(i) - corner(0));
    }
  }

  /// The edge that faces most along a direction: one of the two at the farthest corner. For a flat polygon, which has
  /// two sides, the longest edge: it is as long as the polygon. Corners that hardly turn are skipped.
  Patch<2> along(const Vec<2, double>& direction) const {
    if (area_ == 0) return extended(longest(), direction);
    std::size_t farthest = 0;
    for (std::size_t i = 1; i < count_; ++i) {
      if (dot(corner_(i), direction) > dot(corner_(farthest), direction)) farthest = i;
    }
    const std::size_t before = last_before(farthest);
    const bool is_after_better = looks_more(dot(normal_of(farthest), direction), dot(normal_of(before), direction));
    return extended(is_after_better ? farthest : before, direction);
  }

 private:
  std::size_t next_after(std::size_t i) const { return i + 1 < count_ ? i + 1 : 0; }
  std::size_t last_before(std::size_t i) const { return i > 0 ? i - 1 : count_ - 1; }
  Vec<2, double> way_from(std::size_t i) const { return corner_(next_after(i)) - corner_(i); }

  std::size_t longest() const {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < count_; ++i) {
      if (sum_abs(way_from(i)) > sum_abs(way_from(longest))) longest = i;
    }
    return longest;
  }

  Vec<2, double> normal_of(std::size_t i) const {
    const Vec<2, double> right = unit_or(-perpendicular<double>(way_from(i)), Vec<2, double>(0.0));
    return area_ < 0 ? -right : right;
  }

  Patch<2> extended(std::size_t edge, const Vec<2, double>& direction) const {
    Patch<2> patch;
    patch.normal = normal_of(edge);
    std::size_t first = edge;
    std::size_t last = next_after(edge);
    const auto goes_on = [&](std::size_t i) { return area_ != 0 && is_aligned(normal_of(i), patch.normal); };
    while (last_before(first) != last && goes_on(last_before(first))) first = last_before(first);
    while (next_after(last) != first && goes_on(last)) last = next_after(last);
    patch.face = static_cast<std::uint32_t>(first);
    patch.add(corner_(first), patch.face, patch.face);
    patch.add(corner_(last), static_cast<std::uint32_t>(last), patch.face);
    if (area_ == 0 && dot(patch.normal, direction) < 0) patch.normal = -patch.normal;
    return patch;
  }

  std::size_t count_;
  const Corner& corner_;
  double area_ = 0;
};

inline Patch<2> patch_of(const Triangle<2, double>& triangle, const Vec<2, double>& direction) {
  const auto corners = triangle.vertices();
  const auto corner = [&](std::size_t i) { return corners[i]; };
  return PolygonEdges(3, corner).along(direction);
}

/// The axis whose faces face most along a direction, and their unit normal on that side.
template <Dim N>
struct BoxSide {
  Dim axis = 0;
  bool is_far = false;
  Vec<N, double> normal;
};

template <Dim N>
BoxSide<N> side_along(const Mat<N, double>& normals, const Vec<N, double>& direction) {
  BoxSide<N> side;
  double best = -1;
  for (Dim i = 0; i < N; ++i) {
    const double height = dot(normals[i], direction);
    if (!looks_more(std::fabs(height), best)) continue;
    best = std::fabs(height);
    side = {i, height > 0, height > 0 ? normals[i] : -normals[i]};
  }
  side.normal /= std::sqrt(dot(side.normal, side.normal));  // about 1 already
  return side;
}

// A side without length or width is not a face.

inline Patch<2> patch_of_box(const BoxFrame<2>& box, const BoxSide<2>& side) {
  Patch<2> patch;
  patch.face = static_cast<std::uint32_t>(2 * side.axis + (side.is_far ? 1 : 0));
  patch.normal = side.normal;
  const Dim along = 1 - side.axis;
  const Vec<2, double> middle = box.center + box.half_edges[side.axis] * (side.is_far ? 1.0 : -1.0);
  const std::uint32_t bit = (side.is_far ? 1U : 0U) << static_cast<unsigned>(side.axis);
  patch.add(middle - box.half_edges[along], bit, patch.face);
  patch.add(middle + box.half_edges[along], bit | 1U << static_cast<unsigned>(along), patch.face);
  if (max_abs(box.half_edges[along]) == 0) patch.normal = Vec<2, double>(0.0);
  return patch;
}

/// The numbers of a side of a 3D box and of its features: with the next axis as x and the one after it as y, from the
/// corner at -x, -y to that at +x, -y, and so on.
struct BoxFaceNumbers {
  Dim axis = 0;
  bool is_far = false;

  constexpr Dim next() const { return (axis + 1) % 3; }
  constexpr Dim last() const { return (axis + 2) % 3; }
  constexpr std::uint32_t face() const { return static_cast<std::uint32_t>(2 * axis) + far(); }
  constexpr std::uint32_t vertex(std::uint32_t corner) const {
    const std::uint32_t is_right = (corner ^ corner >> 1U) & 1U;
    return far() << static_cast<unsigned>(axis) | is_right << static_cast<unsigned>(next()) |
           (corner >> 1U) << static_cast<unsigned>(last());
  }
  /// From a corner to the next. The index of an edge along x has as bits its sides along y and `axis`, that of an edge
  /// along y its sides along `axis` and x.
  constexpr std::uint32_t edge(std::uint32_t corner) const {
    if ((corner & 1U) == 0) return static_cast<std::uint32_t>(4 * next()) + (corner >> 1U) + 2 * far();
    return static_cast<std::uint32_t>(4 * last()) + far() + 2 - (corner & 2U);
  }

 private:
  constexpr std::uint32_t far() const { return is_far ? 1 : 0; }
};

inline Patch<3> patch_of_box(const BoxFrame<3>& box, const BoxSide<3>& side) {
  Patch<3> patch;
  const BoxFaceNumbers numbers{side.axis, side.is_far};
  patch.face = numbers.face();
  patch.normal = side.normal;
  const Vec<3, double> middle = box.center + box.half_edges[side.axis] * (side.is_far ? 1.0 : -1.0);
  const Vec<3, double> right = box.half_edges[numbers.next()];
  const Vec<3, double> up = box.half_edges[numbers.last()];
  patch.add(middle - right - up, numbers.vertex(0), numbers.edge(0));
  patch.add(middle + right - up, numbers.vertex(1), numbers.edge(1));
  patch.add(middle + right + up, numbers.vertex(2), numbers.edge(2));
  patch.add(middle - right + up, numbers.vertex(3), numbers.edge(3));
  if (max_abs(right) == 0 || max_abs(up) == 0) patch.normal = Vec<3, double>(0.0);
  return patch;
}

template <Dim N>
Patch<N> patch_of(const Aabb<N, double>& box, const Vec<N, double>& direction) {
  return patch_of_box(frame_of(box), side_along<N>(Mat<N, double>(1.0), direction));
}

template <Dim N>
Patch<N> patch_of(const Obb<N, double>& box, const Vec<N, double>& direction) {
  return patch_of_box(frame_of(box), side_along<N>(face_normals(box.axes), direction));
}

}  // namespace graze::detail
