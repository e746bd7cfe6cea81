// SPDX-License-Identifier: MIT
// The face of a simplex that contains the point nearest to the origin, for cases where distances cannot distinguish it:
// beside the edge at which two faces meet nearly flat. simplex.hpp finds it in all other cases, and faster.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/simplex.hpp>

namespace graze::detail {

/// A face of a simplex and its point nearest to the origin.
template <Dim N>
struct FittingFace {
  NearestOnSimplex<N> nearest;
  Vec<N, double> toward = Vec<N, double>(0.0);  ///< As long as the vector to that point, perpendicular to the face.
  double misfit = std::numeric_limits<double>::infinity();  ///< See FittingFaceSearch.
};

/// Tries the faces with the last corner: a face is the nearest if the projection of the origin is in it, and no corner
/// of the simplex is below the plane through the projection perpendicular to it. The misfit of a face is how far its
/// projection is outside, or how far a corner is below, whichever is more; the face with the least misfit is taken.
///
/// Both are lengths that rounding changes by a few epsilon of the coordinates. Distances are less sensitive: for a
/// projection that is outside by x at a height h, the distance is larger only by x^2 / 2h. And a direction from the
/// origin to a point has an error of epsilon / h, while the normal of a triangle does not.
template <Dim N>
class FittingFaceSearch {
 public:
  using Point = Vec<N, double>;

  explicit FittingFaceSearch(const Simplex<N>& simplex) : simplex_(simplex), last_(simplex.size - 1) {
    for (std::size_t i = 0; i < simplex.size; ++i) size_ = std::max(size_, max_abs(simplex.points[i]));
  }

  FittingFace<N> run() {
    offer<1>(simplex_.points[last_], {simplex_.points[last_], 0}, {last_});
    for (std::size_t i = 0; i < last_; ++i) {
      try_edge(i);
      if constexpr (N == 3) {
        for (std::size_t j = i + 1; j < last_; ++j) try_triangle(i, j);
      }
    }
    return best_;
  }

 private:
  /// The point of a face nearest to some other point, and their distance.
  struct Place {
    Point point;
    double off;
  };

  static Place place_on_edge(const Point& start, const Point& edge, const Point& point) {
    const double share = std::clamp(dot(point - start, edge) / dot(edge, edge), 0.0, 1.0);  // corners are distinct
    const Point place = start + edge * share;
    const Point way = point - place;
    return {place, std::sqrt(dot(way, way))};
  }

  /// How far the lowest corner is below the plane perpendicular to a direction through a point.
  double depth_below(const Point& direction, const Point& point) const {
    double deepest = 0;
    for (std::size_t i = 0; i < simplex_.size; ++i) {
      deepest = std::max(deepest, dot(direction, point - simplex_.points[i]));
    }
    return deepest / std::sqrt(dot(direction, direction));
  }

  /// A projection that is outside by no more than rounding is used unchanged, because it is along the direction.
  template <std::size_t Count>
  void offer(const Point& closest, const Place& inside, const std::array<std::size_t, Count>& corners) {
    if (!(max_abs(closest) > 0)) return;
    const double misfit = std::max(inside.off, depth_below(closest, simplex_.points[corners[0]]));
    if (!(misfit < best_.misfit)) return;
    best_.misfit = misfit;
    best_.nearest.point = inside.off <= tolerance::rounding * size_ ? closest : inside.point;
    best_.nearest.distance_squared = dot(best_.nearest.point, best_.nearest.point);
    best_.toward = closest * std::sqrt(best_.nearest.distance_squared / dot(closest, closest));
    best_.nearest.face.size = 0;
    for (const std::size_t corner : corners) best_.nearest.face.push(simplex_.points[corner]);
  }

  void try_edge(std::size_t i) {
    const Point& start = simplex_.points[i];
    const Point edge = simplex_.points[last_] - start;
    if (!(max_abs(edge) > 0)) return;
    const Point closest = closest_on_line(start, edge);
    const double along = -dot(start, edge);
    const double whole = dot(edge, edge);
    const double outside = std::max({-along, along - whole, 0.0}) / std::sqrt(whole);
    offer<2>(closest, {place_on_edge(start, edge, closest).point, outside}, {i, last_});
  }

  void try_triangle(std::size_t i, std::size_t j) {
    const std::array<Point, 3> corners = {simplex_.points[i], simplex_.points[j], simplex_.points[last_]};
    const Point normal = of_moderate_size(accurate_cross(corners[1] - corners[0], corners[2] - corners[0]));
    const double area_squared = dot(normal, normal);
    if (!(area_squared > 0)) return;
    const Point closest = normal * (dot(normal, corners[0]) / area_squared);
    Place inside{closest, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      const Point edge = corners[(k + 1) % 3] - corners[k];
      if (!(dot(normal, cross(edge, closest - corners[k])) < 0)) continue;
      const Place place = place_on_edge(corners[k], edge, closest);
      if (inside.off == 0 || place.off < inside.off) inside = place;
    }
    offer<3>(closest, inside, {i, j, last_});
  }

  const Simplex<N>& simplex_;
  std::size_t last_;
  double size_ = 0;
  FittingFace<N> best_;
};

}  // namespace graze::detail
