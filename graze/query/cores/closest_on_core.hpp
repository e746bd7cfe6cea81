// SPDX-License-Identifier: MIT
// closest_on(shape, p): the point of a segment, a ray or a 3D triangle that is nearest to p, and of a convex polygon's
// outline, in double.
//
// For triangles and polygons the position is accurate to a few epsilon of the vectors from p to the corners, however
// thin they are, not only the distance: two projections of p that are a width of 1e-8 apart are equally far from it in
// double, so distances cannot decide between them. Sides can: if p is outside an edge and beside it, no other
// projection is nearer.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include <graze/math/orientation.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

/// The nearest point of a line, and the vector from it to p: not their difference, but calculated from vectors between
/// p and the shape, so that it is accurate far from the origin too.
template <Dim N>
struct ClosestOnCore {
  Vec<N, double> point;
  Vec<N, double> off;
  double share = 0;  ///< Its parameter on the segment.
  double whole = 0;  ///< The squared length of the edge, if it was calculated.
};

template <Dim N>
double squared(const ClosestOnCore<N>& closest) {
  return dot(closest.off, closest.off);
}

/// Ericson, Real-Time Collision Detection (2005), 5.1.2, relative to the nearer end. There is no division for equal
/// ends: then `along` is zero.
template <Dim N, class T>
[[gnu::always_inline]] inline ClosestOnCore<N> closest_on(const Segment<N, T>& segment, const Vec<N, double>& p) {
  const Vec<N, double> start = wide<N, T>(segment.start);
  const Vec<N, double> end = wide<N, T>(segment.end);
  const Vec<N, double> edge = end - start;
  const double along = dot(p - start, edge);
  const double whole = dot(edge, edge);
  if (!(along > 0)) return {start, p - start, 0, whole};
  if (!(along < whole)) return {end, p - end, 1, whole};
  const double share = along / whole;  // whole > along > 0
  if (share <= 0.5) return {start + edge * share, p - start - edge * share, share, whole};
  return {end - edge * (1 - share), p - end + edge * (1 - share), share, whole};
}

template <Dim N, class T>
[[gnu::always_inline]] inline ClosestOnCore<N> closest_on(const Ray<N, T>& ray, const Vec<N, double>& p) {
  const Vec<N, double> origin = wide<N, T>(ray.origin);
  const Vec<N, double> direction = wide<N, T>(ray.direction);
  const double along = dot(p - origin, direction);
  const double whole = dot(direction, direction);
  if (!(along > 0)) return {origin, p - origin, 0, whole};
  const double share = along / whole;  // a valid direction is not zero
  return {origin + direction * share, p - origin - direction * share, 0, whole};
}

/// Whether the projection is between the ends of a segment.
template <Dim N>
bool is_between_ends(const ClosestOnCore<N>& closest) {
  return closest.share > 0 && closest.share < 1;
}

// ---- 3D triangles, polygons

/// The nearest corner, the first of several. Which of two is nearer is decided by the vector between them, which is
/// accurate relative to its length.
template <Dim N, class T>
ClosestOnCore<N> nearest_corner(std::span<const Vec<N, T>> corners, const Vec<N, double>& p) {
  Vec<N, double> best = wide<N, T>(corners.front());
  for (const Vec<N, T>& corner : corners.subspan(1)) {
    const Vec<N, double> other = wide<N, T>(corner);
    if (dot(other - best, (p - other) + (p - best)) > 0) best = other;
  }
  return {best, p - best};
}

/// u x v, with u from corner to first and v from corner to second, within a few epsilon of its length, however thin the
/// triangle is: this requires the differences' rounding errors, too. Zero if the sine of the angle is below a few
/// epsilon.
inline Vec<3, double> accurate_normal(const Vec<3, double>& corner, const Vec<3, double>& first,
                                      const Vec<3, double>& second) {
  Vec<3, double> u;
  Vec<3, double> v;
  Vec<3, double> u_rest;
  Vec<3, double> v_rest;
  for (Dim i = 0; i < 3; ++i) {
    const Rounded to_first = two_sum(first[i], -corner[i]);
    const Rounded to_second = two_sum(second[i], -corner[i]);
    u[i] = to_first.value;
    v[i] = to_second.value;
    u_rest[i] = to_first.error;
    v_rest[i] = to_second.error;
  }
  const Vec<3, double> normal = accurate_cross(u, v) + (cross(u_rest, v) + cross(u, v_rest));
  const bool is_straight = !(max_abs(normal) > tolerance::rounding * max_abs(u) * max_abs(v));
  return is_straight ? Vec<3, double>(0.0) : normal;
}

/// Whether p is on the inner side of an edge, seen along the normal, with certainty: by more than the determinant's
/// rounding error, 7 half epsilon of the sum of its products.
inline bool is_surely_inside(const Vec<3, double>& normal, const Vec<3, double>& edge, const Vec<3, double>& to_p) {
  const Vec<3, double> n = abs(normal);
  const Vec<3, double> e = abs(edge);
  const Vec<3, double> w = abs(to_p);
  const double products = n.x * (e.y * w.z + e.z * w.y) + n.y * (e.z * w.x + e.x * w.z) + n.z * (e.x * w.y + e.y * w.x);
  return dot(normal, cross(edge, to_p)) > 4 * tolerance::epsilon * products;
}

/// A triangle with precomputed data for projections.
struct FacedTriangle {
  Triangle<3, double> triangle;
  std::size_t longest;    ///< The index of the corner where the longest edge starts.
  Vec<3, double> normal;  ///< The largest coordinate is 1 or -1; zero if the triangle is a line.
};

inline FacedTriangle faced(const Triangle<3, double>& triangle) {
  const std::array<Vec<3, double>, 3> corners = triangle.vertices();
  const std::array<double, 3> lengths = {length_squared(corners[1] - corners[0]),
                                         length_squared(corners[2] - corners[1]),
                                         length_squared(corners[0] - corners[2])};
  const std::size_t longest = lengths[0] >= lengths[1] && lengths[0] >= lengths[2] ? 0
                              : lengths[1] >= lengths[2]                           ? 1
                                                                                   : 2;
  const Vec<3, double> normal =
      accurate_normal(corners[(longest + 2) % 3], corners[longest], corners[(longest + 1) % 3]);
  const double size = max_abs(normal);
  return {triangle, longest, size > 0 ? normal / size : normal};  // or its square leaves the range of double
}

/// Inside all edges, the projection to the plane; otherwise the projection to an edge that p is outside of, or nearly,
/// if it is between the edge's ends; otherwise the nearest corner. If rounding leaves open which, both are right, but
/// beyond a blunt corner p can be near the line of one edge and certainly inside the next, which then has the
/// projection. A triangle that is a line is its longest edge: the other two run along it, or the angle between them,
/// from which the normal is calculated, would not be straight.
inline ClosestOnCore<3> closest_on(const FacedTriangle& face, const Vec<3, double>& p) {
  const std::array<Vec<3, double>, 3> corners = face.triangle.vertices();
  const auto edge_at = [&](std::size_t i) { return Segment<3, double>{corners[i % 3], corners[(i + 1) % 3]}; };
  const Vec<3, double>& normal = face.normal;
  if (!(max_abs(normal) > 0)) return closest_on(edge_at(face.longest), p);
  std::array<double, 3> share{};  // inside an edge, any value
  std::array<bool, 3> is_inside{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Segment<3, double> edge = edge_at(i);
    is_inside[i] = is_surely_inside(normal, edge.end - edge.start, p - edge.start);
    if (is_inside[i]) continue;
    const ClosestOnCore<3> closest = closest_on(edge, p);
    if (is_between_ends(closest)) return closest;
    share[i] = closest.share;
  }
  if (is_inside[0] && is_inside[1] && is_inside[2]) {
    const Vec<3, double> off = normal * (dot(normal, p - corners[0]) / dot(normal, normal));
    return {p - off, off};
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (share[i] == 0 ? i + 2 : i + 1) % 3;
    if (is_inside[i] || !is_inside[next]) continue;
    const ClosestOnCore<3> closest = closest_on(edge_at(next), p);
    if (is_between_ends(closest)) return closest;
  }
  return nearest_corner<3, double>(corners, p);
}

inline ClosestOnCore<3> closest_on(const Triangle<3, double>& triangle, const Vec<3, double>& p) {
  return closest_on(faced(triangle), p);
}

/// A convex polygon's corners, counter-clockwise, none on the line between its neighbours: or one or two points.
template <class T>
using Corners = std::span<const Vec<2, T>>;

/// The nearest projection to a polygon's edges from inside, the first of several, decided by the vector between their
/// positions, relative to a corner.
template <class T>
ClosestOnCore<2> closest_from_inside(Corners<T> corners, const Vec<2, double>& p) {
  const Vec<2, double> corner = wide<2, T>(corners[0]);
  ClosestOnCore<2> best{Vec<2, double>(0.0), Vec<2, double>(0.0)};
  Vec<2, double> best_place(0.0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Segment<2, T> edge{corners[i], corners[i + 1 < corners.size() ? i + 1 : 0]};
    const ClosestOnCore<2> closest = closest_on(edge, p);
    const Vec<2, double> start = wide<2, T>(edge.start);
    const Vec<2, double> place = start - corner + (wide<2, T>(edge.end) - start) * closest.share;
    if (i > 0 && !(dot(place - best_place, closest.off + best.off) > 0)) continue;
    best = closest;
    best_place = place;
  }
  return best;
}

struct ClosestOnPolygon {
  ClosestOnCore<2> closest;  ///< On the outline.
  bool is_inside;            ///< Of the polygon, its outline included; never of one without area.
};

/// Like 3D triangles, but `orientation` decides exactly on which side of an edge p is.
template <class T>
ClosestOnPolygon closest_on_polygon(Corners<T> corners, const Vec<2, double>& p) {
  const std::size_t count = corners.size();
  const bool has_area = count > 3 || (count == 3 && orientation(corners[0], corners[1], corners[2]) != 0);
  bool is_inside = has_area;
  for (std::size_t i = 0; i < count; ++i) {
    const Segment<2, T> edge{corners[i], corners[i + 1 < count ? i + 1 : 0]};
    if (has_area && orientation(wide<2, T>(edge.start), wide<2, T>(edge.end), p) >= 0) continue;
    is_inside = false;
    const ClosestOnCore<2> closest = closest_on(edge, p);
    if (is_between_ends(closest)) return {closest, false};
  }
  return {is_inside ? closest_from_inside<T>(corners, p) : nearest_corner<2, T>(corners, p), is_inside};
}

}  // namespace graze::detail
