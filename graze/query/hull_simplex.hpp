// SPDX-License-Identifier: MIT
// The point of a simplex in space nearest to the origin, and the shares that its corners have in it, quickly: only
// faces that the origin is outside of are tried, and only those with the newest corner. What rounding makes of that,
// whoever asks has to find out. SimplexSearch in simplex.hpp tries all.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <graze/math/vec.hpp>

namespace graze::detail {

/// Up to four points, each in a place of its own.
using HullSimplex = std::array<Vec<3, double>, 4>;

/// The face of a simplex that is nearest to the origin: its corners by their places, and the point that has these
/// shares of them. Of size 4 it is the whole, and the point is the origin.
struct NearFace {
  Vec<3, double> nearest = Vec<3, double>(0.0);
  double squared = std::numeric_limits<double>::infinity();  ///< Its distance from the origin.
  std::array<double, 4> shares{};
  std::array<std::uint8_t, 4> places{};
  std::uint8_t size = 0;
};

inline NearFace near_corner(const HullSimplex& simplex, std::uint8_t p) {
  return {simplex[p], dot(simplex[p], simplex[p]), {1}, {p}, 1};
}

/// On the edge between two corners.
inline NearFace near_edge(const HullSimplex& simplex, std::uint8_t p, std::uint8_t q) {
  const Vec<3, double> edge = simplex[q] - simplex[p];
  const double whole = dot(edge, edge);
  const double along = -dot(simplex[p], edge);
  if (!(along > 0)) return near_corner(simplex, p);
  if (!(along < whole)) return near_corner(simplex, q);
  const double share = along / whole;
  const Vec<3, double> foot = simplex[p] + edge * share;
  const Vec<3, double> straight = foot - edge * (dot(foot, edge) / whole);
  return {straight, dot(straight, straight), {1 - share, share}, {p, q}, 2};
}

/// On the triangle of three corners, if nothing on the edge of p and q is nearer.
inline NearFace near_triangle(const HullSimplex& simplex, std::uint8_t newest, std::uint8_t p, std::uint8_t q) {
  const Vec<3, double>& corner = simplex[newest];
  const Vec<3, double> to_p = simplex[p] - corner;
  const Vec<3, double> to_q = simplex[q] - corner;
  const double pp = dot(to_p, to_p);
  const double pq = dot(to_p, to_q);
  const double qq = dot(to_q, to_q);
  const double along_p = -dot(to_p, corner);
  const double along_q = -dot(to_q, corner);
  const double of_p = qq * along_p - pq * along_q;
  const double of_q = pp * along_q - pq * along_p;
  const Vec<3, double> normal = cross(to_p, to_q);
  const double area = dot(normal, normal);
  if (of_p > 0 && of_q > 0 && of_p + of_q < area) {
    const double inverse = 1 / area;
    const Vec<3, double> foot = normal * (dot(normal, corner) * inverse);
    const double share_p = of_p * inverse;
    const double share_q = of_q * inverse;
    return {foot, dot(foot, foot), {1 - share_p - share_q, share_p, share_q}, {newest, p, q}, 3};
  }
  if (of_p > 0 && !(of_q > 0)) return near_edge(simplex, newest, p);
  if (of_q > 0 && !(of_p > 0)) return near_edge(simplex, newest, q);
  const NearFace on_p = near_edge(simplex, newest, p);
  const NearFace on_q = near_edge(simplex, newest, q);
  return on_q.squared < on_p.squared ? on_q : on_p;
}

/// In the tetrahedron of all four, of which one is the newest: the whole if the origin is inside.
inline NearFace near_tetrahedron(const HullSimplex& simplex, std::uint8_t newest) {
  const std::uint8_t others[3] = {static_cast<std::uint8_t>(newest ^ 1U), static_cast<std::uint8_t>(newest ^ 2U),
                                  static_cast<std::uint8_t>(newest ^ 3U)};
  const Vec<3, double>& corner = simplex[newest];
  const Vec<3, double> edges[3] = {simplex[others[0]] - corner, simplex[others[1]] - corner,
                                   simplex[others[2]] - corner};
  const Vec<3, double> normals[3] = {cross(edges[1], edges[2]), cross(edges[2], edges[0]), cross(edges[0], edges[1])};
  const double volume = dot(edges[0], normals[0]);
  const double heights[3] = {-dot(corner, normals[0]), -dot(corner, normals[1]), -dot(corner, normals[2])};
  const auto is_within = [volume](double height) { return volume > 0 ? height > 0 : height < 0; };
  const double rest = volume - (heights[0] + heights[1] + heights[2]);
  const bool is_below = is_within(heights[0]) && is_within(heights[1]) && is_within(heights[2]);
  if (is_below && is_within(rest)) {
    const double inverse = 1 / volume;
    return {Vec<3, double>(0.0),
            0,
            {rest * inverse, heights[0] * inverse, heights[1] * inverse, heights[2] * inverse},
            {newest, others[0], others[1], others[2]},
            4};
  }
  NearFace best;
  for (std::size_t k = 0; k < 3; ++k) {
    if (is_within(heights[k]) && !is_below) continue;  // the origin is on the inner side of that face
    const NearFace found = near_triangle(simplex, newest, others[(k + 1) % 3], others[(k + 2) % 3]);
    if (found.squared < best.squared) best = found;
  }
  return best;
}

/// Of the corners of a face with up to three and a newest one, without which there is nothing nearer. At an infinite
/// distance if rounding leaves nothing.
inline NearFace near_face(const HullSimplex& simplex, std::uint8_t newest, const NearFace& face) {
  switch (face.size) {
    case 0:
      return near_corner(simplex, newest);
    case 1:
      return near_edge(simplex, newest, face.places[0]);
    case 2:
      return near_triangle(simplex, newest, face.places[0], face.places[1]);
    default:
      return near_tetrahedron(simplex, newest);
  }
}

}  // namespace graze::detail
