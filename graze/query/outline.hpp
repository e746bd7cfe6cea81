// SPDX-License-Identifier: MIT
/// @file
/// outline(shape, view): the outline of a shape in a drawing, in picture coordinates.
///
///     bounded and convex       outline(shape, view)          exact
///     ray, plane, half-space   outline(shape, view, box)     exact, cut off at the box
///     a user's convex shape    outline(shape, view)          a polygon through sampled support points
///     compound                 is not convex: outline its parts
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/half_space.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/polytope.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/shape.hpp>
#include <graze/shape/sphere.hpp>
#include <graze/shape/triangle.hpp>

namespace graze {

/// A parallel projection onto a picture; size does not decrease with distance. `right` and `up` are orthonormal and
/// point along the edges of the picture. Default: in 2D the identity, in 3D from above (x to the right, y up).
template <Dim N>
struct View {
  Vec<N, double> right = unit_axis<N>(0);  ///< The direction that points right in the picture; length 1.
  /// The direction that points up in the picture; length 1, perpendicular to `right`.
  Vec<N, double> up = unit_axis<N>(1);
};

/// The isometric view: x, y and z appear equally long, z up, x to the lower right, y to the upper right.
inline View<3> isometric_view() {
  return {Vec<3, double>(1, 1, 0) / std::sqrt(2.0), Vec<3, double>(-1, 1, 2) / std::sqrt(6.0)};
}

/// The direction from the scene to the eye, of length 1.
inline Vec<3, double> to_viewer(const View<3>& view) { return cross(view.right, view.up); }

/// Picture coordinates of a point or direction.
template <Dim N>
Vec<2, double> seen(const std::type_identity_t<Vec<N, double>>& point, const View<N>& view) {
  return {dot(point, view.right), dot(point, view.up)};
}

/// The projection of a bounded convex shape: all points of the picture within `radius` of the convex hull of `core`. An
/// outline with an empty core is empty.
struct Outline {
  std::vector<Vec<2, double>> core;  ///< Corners counter-clockwise (y up), each once.
  double radius = 0;                 ///< At least zero.
};

/// The point of a nonempty outline that is farthest along `direction` (any nonzero length). It makes outlines convex
/// shapes, for `bounds` and all queries.
inline Vec<2, double> support(const Outline& outline, const Vec<2, double>& direction) {
  Vec<2, double> best = outline.core.front();
  for (const Vec<2, double>& corner : outline.core) {
    if (dot(corner, direction) > dot(best, direction)) best = corner;
  }
  return best + direction * (outline.radius / std::sqrt(dot(direction, direction)));
}

/// The outline of all points within `radius` of the convex hull of points; empty if there are none. Throws
/// std::invalid_argument if a coordinate is not finite.
template <Dim N>
Outline outline_of_hull(std::span<const Vec<N, double>> points, const View<N>& view, double radius = 0) {
  if (points.empty()) return {};
  std::vector<Vec<2, double>> image;
  image.reserve(points.size());
  for (const Vec<N, double>& point : points) image.push_back(seen(point, view));
  const Polytope<2, double> hull = convex_hull<2, double>(image);
  return {{hull.vertices().begin(), hull.vertices().end()}, radius};
}

namespace detail {

/// Corner `which` of a box: bit i of `which` chooses the upper side along axis i.
template <Dim N, class T>
Vec<N, double> box_corner(const Aabb<N, T>& box, std::uint32_t which) {
  Vec<N, double> corner;
  for (Dim i = 0; i < N; ++i) corner[i] = static_cast<double>((which >> i & 1U) != 0 ? box.max[i] : box.min[i]);
  return corner;
}

template <Dim N, class T>
Vec<N, double> box_corner(const Obb<N, T>& box, std::uint32_t which) {
  const Mat<N, double> edges = half_edges(box);
  Vec<N, double> corner = wide<N, T>(box.center);
  for (Dim i = 0; i < N; ++i) corner += (which >> i & 1U) != 0 ? edges[i] : -edges[i];
  return corner;
}

template <Dim N>
inline constexpr std::uint32_t box_corners = 1U << N;

template <Dim N, class Box>
Outline outline_of_box(const Box& box, const View<N>& view) {
  std::array<Vec<N, double>, box_corners<N>> corners;
  for (std::uint32_t i = 0; i < box_corners<N>; ++i) corners[i] = box_corner(box, i);
  return outline_of_hull<N>(corners, view);
}

}  // namespace detail

/// The outline of a point: one corner.
template <Dim N, class T>
Outline outline(const Vec<N, T>& point, const View<N>& view = {}) {
  return {{seen(wide<N, T>(point), view)}, 0};
}

/// The outline of a segment: two corners, or one if its image is a point.
template <Dim N, class T>
Outline outline(const Segment<N, T>& segment, const View<N>& view = {}) {
  return outline_of_hull<N>(std::array{wide<N, T>(segment.start), wide<N, T>(segment.end)}, view);
}

/// The outline of a sphere: its center and radius.
template <Dim N, class T>
Outline outline(const Sphere<N, T>& sphere, const View<N>& view = {}) {
  return {{seen(wide<N, T>(sphere.center), view)}, static_cast<double>(sphere.radius)};
}

/// The outline of an axis-aligned box: in 3D up to six corners.
template <Dim N, class T>
Outline outline(const Aabb<N, T>& box, const View<N>& view = {}) {
  return detail::outline_of_box(box, view);
}

/// The outline of an oriented box: in 3D up to six corners.
template <Dim N, class T>
Outline outline(const Obb<N, T>& box, const View<N>& view = {}) {
  return detail::outline_of_box(box, view);
}

/// The outline of a triangle: fewer than three corners if it is seen edge-on.
template <Dim N, class T>
Outline outline(const Triangle<N, T>& triangle, const View<N>& view = {}) {
  const std::array corners = {wide<N, T>(triangle.a), wide<N, T>(triangle.b), wide<N, T>(triangle.c)};
  return outline_of_hull<N>(corners, view);
}

/// The outline of a capsule: the ends of its axis and its radius.
template <Dim N, class T>
Outline outline(const Capsule<N, T>& capsule, const View<N>& view = {}) {
  const std::array ends = {wide<N, T>(capsule.a), wide<N, T>(capsule.b)};
  return outline_of_hull<N>(ends, view, static_cast<double>(capsule.radius));
}

/// The outline of a polytope: the convex hull of its projected vertices.
template <Dim N, class T>
Outline outline(const Polytope<N, T>& polytope, const View<N>& view = {}) {
  std::vector<Vec<N, double>> points;
  points.reserve(polytope.vertices().size());
  for (const Vec<N, T>& vertex : polytope.vertices()) points.push_back(wide<N, T>(vertex));
  return outline_of_hull<N>(points, view);
}

/// The part of a ray inside a box, in the ray's direction; none if the ray misses the box. Slabs (Kay and Kajiya 1986);
/// rays parallel to a slab are decided by comparison.
template <Dim N, class T>
std::optional<Segment<N, double>> cut(const Ray<N, T>& ray, const Aabb<N, double>& box) {
  const Vec<N, double> origin = wide<N, T>(ray.origin);
  const Vec<N, double> direction = wide<N, T>(ray.direction) / static_cast<double>(max_abs(ray.direction));
  double enter = 0;
  double leave = std::numeric_limits<double>::infinity();
  for (Dim i = 0; i < N; ++i) {
    if (direction[i] == 0) {
      if (origin[i] < box.min[i] || origin[i] > box.max[i]) return std::nullopt;
      continue;
    }
    const double to_min = (box.min[i] - origin[i]) / direction[i];
    const double to_max = (box.max[i] - origin[i]) / direction[i];
    enter = std::fmax(enter, std::fmin(to_min, to_max));
    leave = std::fmin(leave, std::fmax(to_min, to_max));
  }
  if (!(enter <= leave)) return std::nullopt;
  return Segment<N, double>{origin + direction * enter, origin + direction * leave};
}

/// The corners of the part of a plane inside a box, in no particular order, up to rounding: where the plane crosses the
/// edges of the box. In 2D the two ends of a segment, in 3D up to six corners of a polygon; fewer if the plane only
/// touches the box, none if it misses it.
template <Dim N, class T>
std::vector<Vec<N, double>> cut(const Plane<N, T>& plane, const Aabb<N, double>& box) {
  const Plane<N, double> unit = unit_plane(plane);
  std::vector<Vec<N, double>> corners;
  for (std::uint32_t i = 0; i < detail::box_corners<N>; ++i) {
    const Vec<N, double> from = detail::box_corner(box, i);
    const double from_height = dot(unit.normal, from) - unit.offset;
    if (from_height == 0) corners.push_back(from);
    for (Dim axis = 0; axis < N; ++axis) {
      if ((i >> axis & 1U) != 0) continue;  // each edge once, from its lower end
      const Vec<N, double> to = detail::box_corner(box, i | 1U << axis);
      const double to_height = dot(unit.normal, to) - unit.offset;
      // Heights of opposite signs are not both zero, so neither is their difference.
      if ((from_height < 0 && to_height > 0) || (from_height > 0 && to_height < 0)) {
        corners.push_back(from + (to - from) * (from_height / (from_height - to_height)));
      }
    }
  }
  return corners;
}

/// The corners of the part of a half-space inside a box, in no particular order, up to rounding; none if it misses the
/// box.
template <Dim N, class T>
std::vector<Vec<N, double>> cut(const HalfSpace<N, T>& solid, const Aabb<N, double>& box) {
  std::vector<Vec<N, double>> corners = cut(boundary(solid), box);
  const Plane<N, double> unit = unit_plane(boundary(solid));
  for (std::uint32_t i = 0; i < detail::box_corners<N>; ++i) {
    const Vec<N, double> corner = detail::box_corner(box, i);
    if (dot(unit.normal, corner) < unit.offset) corners.push_back(corner);
  }
  return corners;
}

/// The outline of the part of a ray inside a box; empty if the ray misses it.
template <Dim N, class T>
Outline outline(const Ray<N, T>& ray, const View<N>& view, const std::type_identity_t<Aabb<N, double>>& box) {
  const std::optional<Segment<N, double>> piece = cut(ray, box);
  return piece ? outline(*piece, view) : Outline{};
}

/// The outline of the part of a plane inside a box; empty if the plane misses it.
template <Dim N, class T>
Outline outline(const Plane<N, T>& plane, const View<N>& view, const std::type_identity_t<Aabb<N, double>>& box) {
  return outline_of_hull<N>(cut(plane, box), view);
}

/// The outline of the part of a half-space inside a box; empty if it misses the box.
template <Dim N, class T>
Outline outline(const HalfSpace<N, T>& solid, const View<N>& view, const std::type_identity_t<Aabb<N, double>>& box) {
  return outline_of_hull<N>(cut(solid, box), view);
}

/// The number of directions in which a user's shape is sampled.
inline constexpr int outline_samples = 64;

/// The outline of a user's convex shape: the polygon through its support points in 64 directions of the picture. It
/// lies inside the true outline and, between neighbouring corners p and q, falls short of it by at most tan(pi / 64)
/// |pq| / 2, which is 2.5 % of |pq|.
template <Convex S>
Outline outline(const S& shape, const View<dimension_of<S>>& view = {}) {
  constexpr Dim N = dimension_of<S>;
  using Direction = std::conditional_t<SupportsIn<S, N, double>, Vec<N, double>, Vec<N, scalar_of<S>>>;
  std::vector<Vec<N, double>> points;
  for (int i = 0; i < outline_samples; ++i) {
    const double angle = 2 * std::numbers::pi * i / outline_samples;
    const Vec<N, double> direction = view.right * std::cos(angle) + view.up * std::sin(angle);
    points.push_back(Vec<N, double>(support(shape, Direction(direction))));
  }
  return outline_of_hull<N>(points, view);
}

}  // namespace graze
