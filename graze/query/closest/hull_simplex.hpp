// SPDX-License-Identifier: MIT
// The point of a 3D simplex nearest to the origin, and its barycentric coordinates, fast: only faces that the origin is
// outside of are tried, and only those with the newest corner. A step of GJK needs only the vector to it, which takes
// no division. The caller must check for rounding errors. SimplexSearch in simplex.hpp tries all faces.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <graze/math/vec.hpp>

namespace graze::detail {

/// Up to four points, each at a fixed index.
using HullSimplex = std::array<Vec<3, double>, 4>;

/// Up to four indices in a register: reading bytes together that were written one by one would stall.
class HullPlaces {
 public:
  HullPlaces() = default;
  explicit HullPlaces(std::uint32_t p) : bytes_(p) {}
  HullPlaces(std::uint32_t p, std::uint32_t q) : bytes_(p | q << 8U) {}
  HullPlaces(std::uint32_t p, std::uint32_t q, std::uint32_t r) : bytes_(p | q << 8U | r << 16U) {}
  HullPlaces(std::uint32_t p, std::uint32_t q, std::uint32_t r, std::uint32_t s)
      : bytes_(p | q << 8U | r << 16U | s << 24U) {}

  std::uint32_t operator[](std::size_t i) const { return bytes_ >> (8 * i) & 0xFFU; }

 private:
  std::uint32_t bytes_ = 0;
};

/// The face of a simplex that is nearest to the origin: the indices of its corners, and the vector from the origin to
/// it. Size 4 means the whole simplex, with the origin inside.
struct NearFace {
  Vec<3, double> toward = Vec<3, double>(0.0);  ///< The nearest point times any positive number.
  double height = 0;                            ///< Of the face along that: `toward` times the nearest point.
  double squared = std::numeric_limits<double>::infinity();  ///< Its distance from the origin.
  HullPlaces places;
  std::uint32_t size = 0;
};

/// A corner of a simplex, kept in a register, because reading it from memory right after writing would stall.
struct PlacedCorner {
  std::uint32_t place;
  Vec<3, double> at;
};

inline NearFace near_corner(const PlacedCorner& p) {
  const double squared = dot(p.at, p.at);
  return {p.at, squared, squared, HullPlaces(p.place), 1};
}

/// The plane of a face with more corners, from one of these and its normal pointing away from the origin.
inline NearFace near_plane(const Vec<3, double>& normal, const Vec<3, double>& corner) {
  const double height = dot(normal, corner);
  return {normal, height, height * (height / dot(normal, normal)), {}, 0};
}

/// On the edge between two corners.
inline NearFace near_edge(const PlacedCorner& p, const PlacedCorner& q) {
  const Vec<3, double> edge = q.at - p.at;
  const double along = -dot(p.at, edge);
  if (!(along > 0)) return near_corner(p);
  if (!(along < dot(edge, edge))) return near_corner(q);
  NearFace face = near_plane(cross(edge, cross(p.at, edge)), p.at);
  face.places = HullPlaces(p.place, q.place);
  face.size = 2;
  return face;
}

/// The position of the origin's projection in a triangle's plane: the barycentric coordinates of its last two corners,
/// both times `whole`.
struct TriangleShares {
  Vec<3, double> normal;
  double of_p;
  double of_q;
  double whole;

  TriangleShares(const Vec<3, double>& corner, const Vec<3, double>& p, const Vec<3, double>& q)
      : normal(cross(p - corner, q - corner)), whole(dot(normal, normal)) {
    const Vec<3, double> to_p = p - corner;
    const Vec<3, double> to_q = q - corner;
    const double pp = dot(to_p, to_p);
    const double pq = dot(to_p, to_q);
    const double qq = dot(to_q, to_q);
    const double along_p = -dot(to_p, corner);
    const double along_q = -dot(to_q, corner);
    of_p = qq * along_p - pq * along_q;
    of_q = pp * along_q - pq * along_p;
  }
};

/// On the triangle of three corners, unless a point on the edge of p and q is nearer.
inline NearFace near_triangle(const PlacedCorner& newest, const PlacedCorner& p, const PlacedCorner& q) {
  const TriangleShares shares(newest.at, p.at, q.at);
  if (shares.of_p > 0 && shares.of_q > 0 && shares.of_p + shares.of_q < shares.whole) {
    const double side = dot(shares.normal, newest.at) < 0 ? -1.0 : 1.0;
    NearFace face = near_plane(shares.normal * side, newest.at);
    face.places = HullPlaces(newest.place, p.place, q.place);
    face.size = 3;
    return face;
  }
  if (shares.of_p > 0 && !(shares.of_q > 0)) return near_edge(newest, p);
  if (shares.of_q > 0 && !(shares.of_p > 0)) return near_edge(newest, q);
  const NearFace on_p = near_edge(newest, p);
  const NearFace on_q = near_edge(newest, q);
  return on_q.squared < on_p.squared ? on_q : on_p;
}

/// The position of the origin in a tetrahedron: the barycentric coordinates of its last three corners, all times
/// `whole`.
struct TetrahedronShares {
  std::array<double, 3> heights;
  double whole;

  TetrahedronShares(const Vec<3, double>& corner, const Vec<3, double>& p, const Vec<3, double>& q,
                    const Vec<3, double>& r) {
    const Vec<3, double> edges[3] = {p - corner, q - corner, r - corner};
    const Vec<3, double> normals[3] = {cross(edges[1], edges[2]), cross(edges[2], edges[0]), cross(edges[0], edges[1])};
    whole = dot(edges[0], normals[0]);
    heights = {-dot(corner, normals[0]), -dot(corner, normals[1]), -dot(corner, normals[2])};
  }

  bool is_within(double height) const { return whole > 0 ? height > 0 : height < 0; }
  double rest() const { return whole - (heights[0] + heights[1] + heights[2]); }
};

/// In the tetrahedron of all four, of which one is the newest: the whole if the origin is inside.
inline NearFace near_tetrahedron(const PlacedCorner& newest, const std::array<PlacedCorner, 3>& others) {
  const auto& [p, q, r] = others;
  const TetrahedronShares shares(newest.at, p.at, q.at, r.at);
  const bool is_within[3] = {shares.is_within(shares.heights[0]), shares.is_within(shares.heights[1]),
                             shares.is_within(shares.heights[2])};
  const bool is_below = is_within[0] && is_within[1] && is_within[2];
  if (is_below && shares.is_within(shares.rest())) {
    return {Vec<3, double>(0.0), 0, 0, HullPlaces(newest.place, p.place, q.place, r.place), 4};
  }
  NearFace best;
  for (std::size_t k = 0; k < 3; ++k) {
    if (is_within[k] && !is_below) continue;  // the origin is on the inner side of that face
    const NearFace found = near_triangle(newest, others[(k + 1) % 3], others[(k + 2) % 3]);
    if (found.squared < best.squared) best = found;
  }
  return best;
}

/// The nearest face among those with the newest corner and up to three others; no other can be nearer. Its distance is
/// infinite if rounding leaves nothing.
inline NearFace near_face(const HullSimplex& simplex, const PlacedCorner& newest, const NearFace& face) {
  const auto corner = [&simplex](std::uint32_t place) { return PlacedCorner{place, simplex[place]}; };
  switch (face.size) {
    case 0:
      return near_corner(newest);
    case 1:
      return near_edge(newest, corner(face.places[0]));
    case 2:
      return near_triangle(newest, corner(face.places[0]), corner(face.places[1]));
    default:
      return near_tetrahedron(newest,
                              {corner(newest.place ^ 1U), corner(newest.place ^ 2U), corner(newest.place ^ 3U)});
  }
}

/// The barycentric coordinates of a near face's nearest point, in the order of its indices; their sum is one.
inline std::array<double, 4> shares_of(const HullSimplex& simplex, const NearFace& face) {
  const auto corner = [&](std::size_t i) -> const Vec<3, double>& { return simplex[face.places[i]]; };
  switch (face.size) {
    case 1:
      return {1};
    case 2: {
      const Vec<3, double> edge = corner(1) - corner(0);
      const double share = -dot(corner(0), edge) / dot(edge, edge);
      return {1 - share, share};
    }
    case 3: {
      const TriangleShares shares(corner(0), corner(1), corner(2));
      const double inverse = 1 / shares.whole;
      const double of_p = shares.of_p * inverse;
      const double of_q = shares.of_q * inverse;
      return {1 - of_p - of_q, of_p, of_q};
    }
    default: {
      const TetrahedronShares shares(corner(0), corner(1), corner(2), corner(3));
      const double inverse = 1 / shares.whole;
      return {shares.rest() * inverse, shares.heights[0] * inverse, shares.heights[1] * inverse,
              shares.heights[2] * inverse};
    }
  }
}

}  // namespace graze::detail
