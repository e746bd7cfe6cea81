// SPDX-License-Identifier: MIT
// The point of a simplex nearest to the origin.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>

namespace graze::detail {

/// One to N + 1 points, affinely independent or nearly so.
template <Dim N>
struct Simplex {
  std::array<Vec<N, double>, static_cast<std::size_t>(N) + 1> points;
  std::size_t size = 0;

  void push(const Vec<N, double>& point) { points[size++] = point; }
};

/// The projection of the origin to the line through `start` along `edge` (not zero). Its direction must be as accurate
/// as its length, because a rotation towards the edge by rounding would appear as a distance to the edge's end. So it
/// is calculated from the normal in 2D, and corrected once more in 3D.
template <Dim N>
Vec<N, double> closest_on_line(const Vec<N, double>& start, const Vec<N, double>& edge) {
  const double whole = dot(edge, edge);
  if constexpr (N == 2) {
    const Vec<2, double> normal = perpendicular(edge);
    return normal * (dot(normal, start) / whole);
  } else {
    const Vec<3, double> closest = start - edge * (dot(start, edge) / whole);
    return closest - edge * (dot(closest, edge) / whole);
  }
}

/// The nearest point and the smallest face of the simplex (possibly the whole) that contains it.
template <Dim N>
struct NearestOnSimplex {
  Vec<N, double> point = Vec<N, double>(0.0);
  Simplex<N> face;
  double distance_squared = std::numeric_limits<double>::infinity();
};

/// Tries every face of the simplex: corners, edges, triangles, then whether the origin is inside. Slower than walking
/// the regions (Gilbert, Johnson, Keerthi 1988), but without wrong early decisions: the best of all valid candidates
/// wins, and every candidate is a point of the simplex, evaluated at its position.
template <Dim N>
class SimplexSearch {
 public:
  using Point = Vec<N, double>;

  /// `least_squared`: no point is nearer than the square root of this, so that an apparently nearer one, in a simplex
  /// that is flat up to rounding, is not taken.
  SimplexSearch(const Simplex<N>& simplex, double least_squared) : simplex_(simplex), least_squared_(least_squared) {}

  NearestOnSimplex<N> run() {
    const std::size_t size = simplex_.size;
    for (std::size_t i = 0; i < size; ++i) offer(simplex_.points[i], {i});
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = i + 1; j < size; ++j) try_edge(i, j);
    }
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = i + 1; j < size; ++j) {
        for (std::size_t k = j + 1; k < size; ++k) try_triangle(i, j, k);
      }
    }
    if constexpr (N == 3) {
      if (size == 4) try_tetrahedron();
    }
    return best_;
  }

 private:
  template <std::size_t Count>
  void offer(const Point& point, const std::size_t (&corners)[Count]) {
    const double candidate = dot(point, point);
    if (!(candidate < best_.distance_squared) || candidate < least_squared_) return;
    best_.point = point;
    best_.distance_squared = candidate;
    best_.face.size = 0;
    for (const std::size_t corner : corners) best_.face.push(simplex_.points[corner]);
  }

  void try_edge(std::size_t i, std::size_t j) {
    const Point& start = simplex_.points[i];
    const Point edge = simplex_.points[j] - start;
    const double along = -dot(start, edge);
    if (along > 0 && along < dot(edge, edge)) offer(closest_on_line(start, edge), {i, j});
  }

  /// In 3D the projection of the origin to the plane, n (n . p) / n^2, if it is inside; in 2D the origin itself.
  void try_triangle(std::size_t i, std::size_t j, std::size_t k) {
    const Point& p = simplex_.points[i];
    const Point& q = simplex_.points[j];
    const Point& r = simplex_.points[k];
    if constexpr (N == 2) {
      const double turn = cross_2d(q - p, r - p);
      const double sign = turn > 0 ? 1 : -1;
      const double margin = tolerance::rounding * (max_abs(p) + max_abs(q) + max_abs(r));
      const auto is_left = [sign, margin](const Point& from, const Point& to) {
        return sign * cross_2d(to - from, -from) > margin * sum_abs(to - from);
      };
      if (turn != 0 && is_left(p, q) && is_left(q, r) && is_left(r, p)) offer(Point(0.0), {i, j, k});
    } else {
      const Point normal = of_moderate_size(accurate_cross(q - p, r - p));
      const double area_squared = dot(normal, normal);
      if (!(area_squared > 0)) return;
      const Point closest = normal * (dot(normal, p) / area_squared);
      const auto is_left = [&](const Point& from, const Point& to) {
        return dot(normal, cross(to - from, closest - from)) > 0;
      };
      if (is_left(p, q) && is_left(q, r) && is_left(r, p)) offer(closest, {i, j, k});
    }
  }

  /// Inside if the origin and the opposite corner are on the same side of every face, both by more than rounding;
  /// otherwise a face within rounding is the better answer. Four corners of a parallelogram have no interior, but
  /// rounding puts each on some side of the others' plane.
  void try_tetrahedron() {
    static constexpr std::size_t faces[4][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}};
    for (const auto& face : faces) {
      const Point& corner = simplex_.points[face[0]];
      const Point first = simplex_.points[face[1]] - corner;
      const Point second = simplex_.points[face[2]] - corner;
      const Point normal = of_moderate_size(accurate_cross(first, second));
      const double opposite = dot(normal, simplex_.points[face[3]] - corner);
      const double origin = -dot(normal, corner);
      const double size = sum_abs(corner) + sum_abs(first) + sum_abs(second);
      const double margin = tolerance::rounding * sum_abs(normal) * size;
      if (!(std::fabs(opposite) > margin && (opposite > 0 ? origin : -origin) > margin)) return;
    }
    offer(Point(0.0), {0, 1, 2, 3});
  }

  const Simplex<N>& simplex_;
  double least_squared_;
  NearestOnSimplex<N> best_;
};

/// Calls `visit` with vectors perpendicular to the corners (as directions), edges and triangles of a simplex.
template <Dim N, class Visit>
void for_each_perpendicular(const Simplex<N>& simplex, const Visit& visit) {
  for (std::size_t i = 0; i < simplex.size; ++i) {
    const Vec<N, double>& start = simplex.points[i];
    visit(start);
    for (std::size_t j = i + 1; j < simplex.size; ++j) {
      const Vec<N, double> edge = simplex.points[j] - start;
      if (max_abs(edge) > 0) visit(closest_on_line(start, edge));
      if constexpr (N == 3) {
        for (std::size_t k = j + 1; k < simplex.size; ++k) {
          const Vec<3, double> normal = of_moderate_size(accurate_cross(edge, simplex.points[k] - start));
          visit(dot(normal, start) < 0 ? -normal : normal);
        }
      }
    }
  }
}

/// Infinitely far if every point seems nearer than the square root of `least_squared`, below which none can be.
template <Dim N>
NearestOnSimplex<N> nearest_to_origin(const Simplex<N>& simplex, double least_squared = 0) {
  return SimplexSearch<N>(simplex, least_squared).run();
}

}  // namespace graze::detail
