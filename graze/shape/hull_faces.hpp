// SPDX-License-Identifier: MIT
// hull_faces(points): the surface of the convex hull of points in space, as triangles.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <graze/math/orientation_3d.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/plane.hpp>

namespace graze::detail {

/// The places of three points, counter-clockwise seen from outside.
using HullTriangle = std::array<std::uint32_t, 3>;

/// Grows a convex hull by the point that is farthest outside, face by face. Barber, Dobkin, Huhdanpaa, "The Quickhull
/// Algorithm for Convex Hulls" (1996), with exact tests of sides instead of their tolerances: a point outside a face is
/// strictly outside, so the faces that see it are a disk, none of the new ones is degenerate, and each point that is
/// still outside sees one of these.
template <class T>
class Quickhull {
 public:
  explicit Quickhull(std::span<const Vec<3, T>> points) : points_(points) {}

  /// Empty when all points lie on one plane.
  std::vector<HullTriangle> faces() {
    if (!begin()) return {};
    while (!open_.empty()) {
      const std::uint32_t face = open_.back();
      open_.pop_back();
      if (faces_[face].is_alive && faces_[face].outside != none) grow(face);
    }
    std::vector<HullTriangle> result;
    for (const Face& face : faces_) {
      if (face.is_alive) result.push_back(face.corners);
    }
    return result;
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  struct Face {
    HullTriangle corners{};
    std::array<std::uint32_t, 3> neighbours{};    ///< The face beyond the edge from corner i to the next.
    Vec<3, double> normal = Vec<3, double>(0.0);  ///< Rough: it only tells which point to take first.
    std::uint32_t outside = none;                 ///< The first of the points that see it; the farthest, roughly.
    double farthest = -1;
    bool is_alive = true;
    bool sees = false;  ///< The point that is being added.
  };

  /// An edge between a face that sees a point and one that does not.
  struct HorizonEdge {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t beyond;
  };

  Vec<3, double> at(std::uint32_t point) const { return wide<3, T>(points_[point]); }

  bool is_outside(const Face& face, std::uint32_t point) const {
    return orientation(points_[face.corners[0]], points_[face.corners[1]], points_[face.corners[2]], points_[point]) >
           0;
  }

  /// The point for which `measure` is largest, and `counts` holds; none if it holds for none.
  template <class Measure, class Counts>
  std::uint32_t farthest_by(const Measure& measure, const Counts& counts) const {
    std::uint32_t best = none;
    double largest = -1;
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      const double size = measure(at(i));
      if (!(size > largest) && best != none) continue;
      if (!counts(i)) continue;
      largest = size;
      best = i;
    }
    return best;
  }

  /// A tetrahedron of four far points, and the faces that the others are outside of.
  bool begin() {
    if (points_.size() < 4) return false;
    const std::uint32_t a = 0;
    const Vec<3, double> origin = at(a);
    const std::uint32_t b = farthest_by([&](const Vec<3, double>& p) { return dot(p - origin, p - origin); },
                                        [&](std::uint32_t i) { return points_[i] != points_[a]; });
    if (b == none) return false;
    const Vec<3, double> edge = at(b) - origin;
    const auto across = [&](const Vec<3, double>& p) {
      const Vec<3, double> normal = accurate_cross(edge, p - origin);
      return dot(normal, normal);
    };
    const std::uint32_t c =
        farthest_by(across, [&](std::uint32_t i) { return !are_on_one_line(points_[a], points_[b], points_[i]); });
    if (c == none) return false;
    const Vec<3, double> normal = accurate_cross(edge, at(c) - origin);
    const std::uint32_t d =
        farthest_by([&](const Vec<3, double>& p) { return std::fabs(dot(normal, p - origin)); },
                    [&](std::uint32_t i) { return orientation(points_[a], points_[b], points_[c], points_[i]) != 0; });
    if (d == none) return false;
    const bool is_above = orientation(points_[a], points_[b], points_[c], points_[d]) > 0;
    add_tetrahedron(a, is_above ? c : b, is_above ? b : c, d);
    for (std::uint32_t i = 0; i < points_.size(); ++i) assign(i, 0);
    return true;
  }

  /// d lies on the inner side of a, b, c.
  void add_tetrahedron(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    next_of_.assign(points_.size(), none);
    add_face({a, b, c}, {1, 2, 3});
    add_face({b, a, d}, {0, 3, 2});
    add_face({c, b, d}, {0, 1, 3});
    add_face({a, c, d}, {0, 2, 1});
  }

  void add_face(const HullTriangle& corners, const std::array<std::uint32_t, 3>& neighbours) {
    Face face;
    face.corners = corners;
    face.neighbours = neighbours;
    const Vec<3, double> normal = accurate_cross(at(corners[1]) - at(corners[0]), at(corners[2]) - at(corners[0]));
    const double length = std::sqrt(dot(normal, normal));
    if (length > 0) face.normal = normal / length;
    faces_.push_back(face);
  }

  /// Puts a point on the list of the first face, from `first` on, that it is outside of.
  void assign(std::uint32_t point, std::uint32_t first) {
    for (std::uint32_t i = first; i < faces_.size(); ++i) {
      Face& face = faces_[i];
      if (!is_outside(face, point)) continue;
      const double height = dot(face.normal, at(point) - at(face.corners[0]));
      if (face.outside == none) open_.push_back(i);
      if (face.outside == none || height > face.farthest) {
        face.farthest = height;
        next_of_[point] = face.outside;
        face.outside = point;
      } else {
        next_of_[point] = next_of_[face.outside];
        next_of_[face.outside] = point;
      }
      return;
    }
  }

  /// Adds the farthest of the points outside a face.
  void grow(std::uint32_t face) {
    const std::uint32_t point = faces_[face].outside;
    find_horizon(face, point);
    const auto first_new = static_cast<std::uint32_t>(faces_.size());
    // By the corner from which its horizon edge leaves, each new face is found by the one before it.
    for (const HorizonEdge& edge : horizon_) {
      const auto at_place = static_cast<std::uint32_t>(faces_.size());
      face_from_[edge.from] = at_place;
      add_face({edge.from, edge.to, point}, {edge.beyond, none, none});
      Face& beyond = faces_[edge.beyond];
      for (std::size_t i = 0; i < 3; ++i) {
        if (beyond.corners[i] == edge.to && beyond.corners[(i + 1) % 3] == edge.from) beyond.neighbours[i] = at_place;
      }
    }
    for (std::uint32_t i = first_new; i < faces_.size(); ++i) {
      const std::uint32_t next = face_from_[faces_[i].corners[1]];
      faces_[i].neighbours[1] = next;
      faces_[next].neighbours[2] = i;
    }
    for (const std::uint32_t seen : seen_) {
      for (std::uint32_t other = faces_[seen].outside; other != none;) {
        const std::uint32_t next = next_of_[other];
        if (other != point) assign(other, first_new);
        other = next;
      }
      faces_[seen].outside = none;
      faces_[seen].is_alive = false;
    }
  }

  /// The faces that see a point, and the edges around them.
  void find_horizon(std::uint32_t face, std::uint32_t point) {
    face_from_.resize(points_.size());
    seen_.assign(1, face);
    horizon_.clear();
    faces_[face].sees = true;
    for (std::size_t k = 0; k < seen_.size(); ++k) {
      const Face current = faces_[seen_[k]];
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t other = current.neighbours[i];
        if (faces_[other].sees) continue;
        if (is_outside(faces_[other], point)) {
          faces_[other].sees = true;
          seen_.push_back(other);
        } else {
          horizon_.push_back({current.corners[i], current.corners[(i + 1) % 3], other});
        }
      }
    }
  }

  std::span<const Vec<3, T>> points_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> open_;     // faces that had points outside when they were put here
  std::vector<std::uint32_t> next_of_;  // by point: the next outside the same face
  std::vector<std::uint32_t> seen_;
  std::vector<HorizonEdge> horizon_;
  std::vector<std::uint32_t> face_from_;  // by corner: the new face whose horizon edge leaves it
};

/// The surface of the convex hull, for points in any order, duplicates allowed: triangles that share their edges two by
/// two, none of them without area. Which side a point is on is decided exactly, so no corner is lost, whatever is
/// nearly on one plane. Faces with more than three corners come in several triangles. Empty when all points lie on one
/// plane, exactly. At most 2^32 - 2 points.
template <class T>
std::vector<HullTriangle> hull_faces(std::span<const Vec<3, T>> points) {
  return Quickhull<T>(points).faces();
}

}  // namespace graze::detail
