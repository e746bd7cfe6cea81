// SPDX-License-Identifier: MIT
// Filters for 3D triangles: decide all pairs but those that nearly touch, or where a corner of one triangle lies nearly
// in the plane of the other, and leave those to triangle.hpp. No answer means "too close to tell". NaN anywhere gives
// no answer, or apart.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/relation/sphere_filter.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

/// The sides of a plane that three corners are on: bit k of `above` is set if corner k is above the plane.
struct SidesOfPlane {
  unsigned above;
  bool are_clear;  ///< None is in the plane, up to rounding.

  bool are_one() const { return are_clear && (above == 0 || above == 7); }
  /// The corner that is alone on its side.
  std::size_t lone() const {
    constexpr std::array<std::size_t, 8> lone_of = {0, 0, 1, 2, 2, 1, 0, 0};
    return lone_of[above];
  }
};

using Corners3 = std::array<Vec<3, double>, 3>;

/// The corners relative to the plane through `origin`; heights of at least `bound` are certain.
inline SidesOfPlane sides_of_plane(const Corners3& corners, const Vec<3, double>& normal, const Vec<3, double>& origin,
                                   double bound) {
  const double a = dot(normal, corners[0] - origin);
  const double b = dot(normal, corners[1] - origin);
  const double c = dot(normal, corners[2] - origin);
  const unsigned above =
      static_cast<unsigned>(a > 0) | static_cast<unsigned>(b > 0) << 1U | static_cast<unsigned>(c > 0) << 2U;
  return {above, std::min(std::min(std::fabs(a), std::fabs(b)), std::fabs(c)) > bound};
}

/// How large two triangles are.
struct SizesOfPair {
  double extent;  ///< At least each coordinate of a vector from one to the other.
  double first;   ///< At least the sum of the absolute coordinates of each edge of the first.
  double second;
};

/// Triangles that intersect each other's planes meet if they overlap on the common line of both planes. Each covers an
/// interval of it between two edges, those from its lone corner to the others. Edge u from p and edge v from q cross
/// the line in the order given by the sign of u x v . (q - p), with a fixed orientation: the intervals are disjoint if
/// and only if all four signs are equal (Guigue and Devillers, "Fast and robust triangle-triangle overlap test using
/// orientation predicates", 2003, find two of the four that suffice).
///
/// Every product of three is off by 8 epsilon of the extent and the sizes of two edges; it is trusted beyond
/// tolerance::coarse, 64 of these. So overlapping triangles still meet however one is moved by 56 epsilon of the
/// extent, since no sign would change: they are deeper than the band of the precise test, 16 along an axis measured by
/// the sum of its coordinates, 28 at most. And the plane of the nearest two edges, or of a triangle, separates the
/// others by 56.
inline std::optional<Relation> filter_of_triangles(const Corners3& a, const Corners3& b, const SizesOfPair& sizes) {
  const double slack = tolerance::coarse * sizes.extent;
  const auto sides_b = sides_of_plane(b, cross(a[1] - a[0], a[2] - a[0]), a[0], slack * sizes.first * sizes.first);
  if (sides_b.are_one()) return Relation::apart;
  const auto sides_a = sides_of_plane(a, cross(b[1] - b[0], b[2] - b[0]), b[0], slack * sizes.second * sizes.second);
  if (sides_a.are_one()) return Relation::apart;
  if (!sides_a.are_clear || !sides_b.are_clear) return std::nullopt;
  const std::size_t i = sides_a.lone();
  const std::size_t j = sides_b.lone();
  const Vec<3, double> between = b[j] - a[i];
  const Vec<3, double> first = cross(b[(j + 1) % 3] - b[j], between);
  const Vec<3, double> second = cross(b[(j + 2) % 3] - b[j], between);
  const Vec<3, double> u = a[(i + 1) % 3] - a[i];
  const Vec<3, double> v = a[(i + 2) % 3] - a[i];
  const double products[] = {dot(u, first), dot(u, second), dot(v, first), dot(v, second)};
  const double low = std::min(std::min(products[0], products[1]), std::min(products[2], products[3]));
  const double high = std::max(std::max(products[0], products[1]), std::max(products[2], products[3]));
  const double bound = slack * sizes.first * sizes.second;
  if (low > bound || high < -bound) return Relation::apart;
  if (low < -bound && high > bound) return Relation::overlapping;
  return std::nullopt;
}

// ---- A triangle and a segment

/// The segment from p to q crosses the triangle if the plane separates p from q, and it passes all sides with the same
/// orientation: the products (q - p) . (corner - p) x side have the sign of the climb. A side that it passes with the
/// other orientation spans, with q - p, a plane that separates the two. Signs are trusted, and verdicts certain, as
/// above.
inline std::optional<Relation> filter_of_triangle_and_segment(const Corners3& corners, const Vec<3, double>& p,
                                                              const Vec<3, double>& q, const SizesOfPair& sizes) {
  const double slack = tolerance::coarse * sizes.extent;
  const auto& [a, b, c] = corners;
  const Vec<3, double> ab = b - a;
  const Vec<3, double> ca = a - c;
  const Vec<3, double> normal = cross(ca, ab);
  const double from = dot(normal, p - a);
  const double to = dot(normal, q - a);
  if (!(std::min(std::fabs(from), std::fabs(to)) > slack * sizes.first * sizes.first)) return std::nullopt;
  if ((from > 0) == (to > 0)) return Relation::apart;
  const Vec<3, double> way = q - p;
  const double climb = to > 0 ? 1 : -1;
  const double passes_ab = climb * dot(way, cross(a - p, ab));
  const double passes_bc = climb * dot(way, cross(b - p, c - b));
  const double passes_ca = climb * dot(way, cross(c - p, ca));
  const double least = std::min(std::min(passes_ab, passes_bc), passes_ca);
  const double bound = slack * sizes.first * sizes.second;
  if (!(std::fabs(least) > bound)) return std::nullopt;
  return least > 0 ? Relation::overlapping : Relation::apart;
}

// ---- A triangle and a sphere

/// The least squared distance from zero along an edge, |corner|^2 - 2 t along + t^2 whole with 0 <= t <= 1. The edge
/// has a length.
inline double least_along_edge(double squared_corner, double along, double whole) {
  const double t = 1 - above_zero(1 - above_zero(along / whole));
  return squared_corner + t * (t * whole - 2 * along);
}

/// The verdict on a triangle with the corners a, a + u, a + v and a sphere centered at zero. The foot a + s u + t v of
/// the perpendicular from zero solves s u.u + t u.v = -u.a, s u.v + t v.v = -v.a; if it is outside, an edge is nearest
/// (all from six dot products, as in Eberly's "Distance between point and triangle in 3D", 1999, but without his seven
/// regions, whose branches take longer than the three edges do).
///
/// The angle at a is at least 7 degrees from flat, so that u.u v.v - (u.v)^2 is no smaller than 1/64 of its terms. Then
/// s and t are known to 1600 epsilon of |a| / |u| and |a| / |v|, and the squared distance from the plane to 3400
/// epsilon of a.a; a foot that is mistaken for inside or outside is as near to the edge, and the squared distance from
/// the edge differs by the square of that. The distances from the edges are known to 100 epsilon of the sum of the
/// squares.
inline std::optional<Relation> filter_of_triangle_and_sphere(const Vec<3, double>& a, const Vec<3, double>& u,
                                                             const Vec<3, double>& v, double radius) {
  constexpr double least_sine_squared = 1.0 / 64;
  const double aa = dot(a, a);
  const double uu = dot(u, u);
  const double vv = dot(v, v);
  const double uv = dot(u, v);
  const double ua = -dot(u, a);
  const double va = -dot(v, a);
  const double det = uu * vv - uv * uv;
  const double squares = aa + uu + vv + radius * radius;
  // All products are in the range of double.
  if (!(det > std::max(least_sine_squared * (uu * vv), 0x1p-900) && squares < 0x1p400)) return std::nullopt;
  const double s = (ua * vv - va * uv) / det;
  const double t = (va * uu - ua * uv) / det;
  const double to_plane = aa - (s * ua + t * va);
  const double to_first = least_along_edge(aa, ua, uu);
  const double to_second = least_along_edge(aa, va, vv);
  const double to_third = least_along_edge(aa - 2 * ua + uu, (va - uv) - (ua - uu), uu + vv - 2 * uv);
  const double to_edges = std::min(std::min(to_first, to_second), to_third);
  const auto is_inside = static_cast<double>(std::min(std::min(s, t), 1 - s - t) > 0);
  const double squared_distance = to_edges + is_inside * (to_plane - to_edges);
  const double squared_radius = radius * radius;
  if (!(std::fabs(squared_distance - squared_radius) > tolerance::triangle_filter * squares)) return std::nullopt;
  return squared_distance < squared_radius ? Relation::overlapping : Relation::apart;
}

}  // namespace graze::detail
