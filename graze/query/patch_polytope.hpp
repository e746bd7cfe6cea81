// SPDX-License-Identifier: MIT
// patch.hpp for polytopes, which know their corners, but in space not their faces.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <graze/math/orientation.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/patch.hpp>
#include <graze/query/surface_point.hpp>
#include <graze/shape/polytope.hpp>

namespace graze::detail {

template <class T>
Patch<2> patch_of_polytope(const Polytope<2, T>& polytope, const Vec<2, double>& origin,
                           const Vec<2, double>& direction) {
  const auto vertices = polytope.vertices();
  if (vertices.size() == 1) return patch_of(wide<2, T>(vertices[0]) - origin, direction);
  const auto corner = [&](std::size_t i) { return wide<2, T>(vertices[i]) - origin; };
  return PolygonEdges(vertices.size(), corner).along(direction);
}

/// Finds a face by wrapping: a plane laid on the corner that is farthest along a direction is tilted as little as it
/// takes to lie on a second one, then about the edge between the two, until it lies on a third (Chand and Kapur, "An
/// algorithm for convex polytopes", 1970).
class FaceWrapping {
 public:
  using Point = Vec<3, double>;

  FaceWrapping(const std::vector<Point>& points, const Point& direction) : points_(points), up_(direction) {
    for (std::size_t i = 1; i < points_.size(); ++i) {
      if (dot(up_, points_[i]) > dot(up_, points_[first_])) first_ = i;
    }
    for (const Point& point : points_) size_ = std::max(size_, sum_abs(point - points_[first_]));
  }

  Patch<3> run() {
    Patch<3> patch;
    const std::size_t second = least_tilt([this](const Point& w) {
      const double drop = -dot(up_, w);
      const Point level = w + up_ * drop;
      return drop / std::sqrt(dot(level, level));
    });
    if (second == first_) {
      patch.add(points_[first_], number(first_), 0);
      return patch;
    }
    const Point edge = points_[second] - points_[first_];
    const std::size_t third = third_corner(edge);
    if (third == first_) return edge_patch(first_, second);
    const Point normal = unit_or(accurate_cross(edge, points_[third] - points_[first_]), up_);
    return face_patch(dot(normal, up_) < 0 ? -normal : normal, edge);
  }

 private:
  static std::uint32_t number(std::size_t i) { return static_cast<std::uint32_t>(i); }

  /// Of all other corners the one towards which the plane tilts least; the first corner itself if there is none.
  template <class Tilt>
  std::size_t least_tilt(const Tilt& tilt) const {
    double least = std::numeric_limits<double>::infinity();
    std::size_t best = first_;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (i == first_) continue;
      const double candidate = tilt(points_[i] - points_[first_]);
      if (!(candidate < least)) continue;
      least = candidate;
      best = i;
    }
    return best;
  }

  /// To whichever side of the edge needs the smaller tilt. What lies on the edge's line, up to rounding, is no side.
  std::size_t third_corner(const Point& edge) const {
    const Point level = unit_or(up_ - edge * (dot(up_, edge) / dot(edge, edge)), up_);
    const Point side = unit_or(cross(level, edge), Point(0.0));
    return least_tilt([&](const Point& w) {
      const double beside = std::fabs(dot(side, w));
      if (beside <= tolerance::convex * size_) return std::numeric_limits<double>::infinity();
      return -dot(level, w) / beside;
    });
  }

  std::uint32_t edge_number(std::size_t i, std::size_t j) const {
    return number(std::min(i, j) * points_.size() + std::max(i, j));
  }

  Patch<3> edge_patch(std::size_t i, std::size_t j) const {
    Patch<3> patch;
    patch.face = edge_number(i, j);
    patch.add(points_[std::min(i, j)], number(std::min(i, j)), patch.face);
    patch.add(points_[std::max(i, j)], number(std::max(i, j)), patch.face);
    return patch;
  }

  struct FlatCorner {
    Vec<2, double> place;
    std::size_t index;
  };

  /// All corners on the face, in order around it. Corners of what is meant to be one face may be off by the rounding of
  /// their coordinates.
  Patch<3> face_patch(const Point& normal, const Point& edge) const {
    const Point x = unit_or(edge, Point(0.0));
    const Point y = cross(normal, x);
    std::vector<FlatCorner> flat;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Point w = points_[i] - points_[first_];
      if (std::fabs(dot(normal, w)) <= tolerance::aligned * size_) flat.push_back({{dot(x, w), dot(y, w)}, i});
    }
    const std::vector<FlatCorner> around = hull_of(std::move(flat));
    Patch<3> patch;
    patch.normal = normal;
    const std::size_t count = std::min(around.size(), Patch<3>::most_corners);
    const auto chosen = [&](std::size_t i) { return around[i % count * around.size() / count].index; };
    for (std::size_t i = 0; i < count; ++i) {
      patch.add(points_[chosen(i)], number(chosen(i)), edge_number(chosen(i), chosen(i + 1)));
    }
    patch.face = *std::min_element(patch.vertices.begin(), patch.vertices.begin() + patch.size);
    return patch;
  }

  /// Andrew's chain (1979), from the first corner by coordinates.
  static std::vector<FlatCorner> hull_of(std::vector<FlatCorner> corners) {
    std::sort(corners.begin(), corners.end(), [](const FlatCorner& p, const FlatCorner& q) {
      return lexicographically_less<2, double>(p.place, q.place);
    });
    std::vector<FlatCorner> hull;
    const auto extend = [&hull](const FlatCorner& corner, std::size_t fixed) {
      while (hull.size() > fixed &&
             orientation<double>(hull[hull.size() - 2].place, hull.back().place, corner.place) <= 0) {
        hull.pop_back();
      }
      hull.push_back(corner);
    };
    for (const FlatCorner& corner : corners) extend(corner, 1);
    const std::size_t lower = hull.size();
    for (auto corner = corners.rbegin() + 1; corner != corners.rend(); ++corner) extend(*corner, lower);
    hull.pop_back();
    return hull;
  }

  const std::vector<Point>& points_;
  Point up_;
  std::size_t first_ = 0;
  double size_ = 0;
};

/// Of faces with more than eight corners, eight of them.
template <class T>
Patch<3> patch_of_polytope(const Polytope<3, T>& polytope, const Vec<3, double>& origin,
                           const Vec<3, double>& direction) {
  std::vector<Vec<3, double>> points;
  points.reserve(polytope.vertices().size());
  for (const Vec<3, T>& vertex : polytope.vertices()) points.push_back(wide<3, T>(vertex) - origin);
  return FaceWrapping(points, direction).run();
}

}  // namespace graze::detail
