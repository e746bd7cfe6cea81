// SPDX-License-Identifier: MIT
// The corners of the convex hull of 3D points, in integers and by brute force: all planes through three of the points,
// or for flat sets all lines through two, with all others on one side.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/hull/lexicographic.hpp>

#include "exact/numbers.hpp"

namespace graze::test {

/// Points times the least power of two that makes them integers.
template <class T>
std::vector<IntegerVec<3>> whole_places(const std::vector<Vec<3, T>>& points) {
  Integer denominator = 1;
  for (const Vec<3, T>& point : points) {
    for (const Rational& x : exact(point))
      denominator = std::max(denominator, Integer(boost::multiprecision::denominator(x)));
  }
  std::vector<IntegerVec<3>> places;
  for (const Vec<3, T>& point : points) {
    IntegerVec<3>& place = places.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational x = exact(point)[i] * denominator;
      place[i] = boost::multiprecision::numerator(x);
    }
  }
  return places;
}

/// The faces that support a point: it is a corner if their normals span what all points span.
class Supports {
 public:
  void add(const IntegerVec<3>& normal) {
    if (normals_.size() < 3 && is_new(normal)) normals_.push_back(normal);
  }
  std::size_t rank() const { return normals_.size(); }

 private:
  bool is_new(const IntegerVec<3>& normal) const {
    if (normals_.empty()) return true;
    if (normals_.size() == 1) return !is_zero(cross(normals_[0], normal));
    return dot(cross(normals_[0], normals_[1]), normal) != 0;
  }

  std::vector<IntegerVec<3>> normals_;
};

/// Adds `normal` to the points on the plane through `origin` if all others are on one side of it.
inline void add_support(const std::vector<IntegerVec<3>>& places, const IntegerVec<3>& origin,
                        const IntegerVec<3>& normal, std::vector<Supports>& supports) {
  std::vector<std::size_t> on_plane;
  bool is_above = false;
  bool is_below = false;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Integer height = dot(normal, places[i] - origin);
    is_above = is_above || height > 0;
    is_below = is_below || height < 0;
    if (height == 0) on_plane.push_back(i);
  }
  if (is_above && is_below) return;
  if (!is_above && !is_below) return;  // the plane that contains all points
  for (const std::size_t i : on_plane) supports[i].add(normal);
}

/// For distinct points that span a volume, a plane or a line: the normals of a plane's lines are in the plane.
inline std::vector<Supports> supports_of(const std::vector<IntegerVec<3>>& places, std::size_t dimensions,
                                         const IntegerVec<3>& plane_normal) {
  std::vector<Supports> supports(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = i + 1; j < places.size(); ++j) {
      const IntegerVec<3> edge = places[j] - places[i];
      if (dimensions == 1) {
        add_support(places, places[i], edge, supports);
        add_support(places, places[j], edge, supports);
      } else if (dimensions == 2) {
        add_support(places, places[i], cross(plane_normal, edge), supports);
      } else {
        for (std::size_t k = j + 1; k < places.size(); ++k) {
          const IntegerVec<3> normal = cross(edge, places[k] - places[i]);
          if (!is_zero(normal)) add_support(places, places[i], normal, supports);
        }
      }
    }
  }
  return supports;
}

/// In lexicographic order, without duplicates. Slow: for up to a dozen points.
template <class T>
std::vector<Vec<3, T>> exact_corners(std::vector<Vec<3, T>> points) {
  std::sort(points.begin(), points.end(), detail::lexicographically_less<3, T>);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  const std::vector<IntegerVec<3>> places = whole_places(points);
  std::size_t dimensions = 1;
  IntegerVec<3> normal{};
  const IntegerVec<3> edge = places[1] - places[0];
  for (std::size_t i = 2; i < places.size() && dimensions == 1; ++i) {
    normal = cross(edge, places[i] - places[0]);
    if (!is_zero(normal)) dimensions = 2;
  }
  for (std::size_t i = 2; i < places.size() && dimensions == 2; ++i) {
    if (dot(normal, places[i] - places[0]) != 0) dimensions = 3;
  }
  const std::vector<Supports> supports = supports_of(places, dimensions, normal);
  std::vector<Vec<3, T>> corners;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (supports[i].rank() == dimensions) corners.push_back(points[i]);
  }
  return corners;
}

}  // namespace graze::test
