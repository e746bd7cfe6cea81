// SPDX-License-Identifier: MIT
// surface_point.hpp for boxes.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>

namespace graze::detail {

/// From inside, the nearest face; of equally near faces the first, by coordinates, min before max.
template <Dim N, class T>
[[gnu::always_inline]] inline SurfacePoint<N> surface_point(const Aabb<N, T>& box, const Vec<N, double>& p) {
  const Vec<N, double> min = wide<N, T>(box.min);
  const Vec<N, double> max = wide<N, T>(box.max);
  const Vec<N, double> inside = clamp(p, min, max);
  if (inside != p) {
    const double squared_distance = dot(p - inside, p - inside);
    return {inside, inside, std::sqrt(squared_distance), squared_distance};
  }
  SurfacePoint<N> nearest{p, p, -std::numeric_limits<double>::infinity()};
  for (Dim i = 0; i < N; ++i) {
    for (const double face : {min[i], max[i]}) {
      const double depth = -std::fabs(p[i] - face);
      if (!(depth > nearest.distance)) continue;
      nearest.point = p;
      nearest.point[i] = face;
      nearest.distance = depth;
    }
  }
  nearest.inner = nearest.point;  // exact: rounding never leaves the box
  nearest.measure = std::isfinite(nearest.distance) ? 1 : 0;
  return nearest;
}

/// The position in a box, in units of its axes, where a point is or is nearest to.
template <Dim N>
struct PlaceInBox {
  Vec<N, double> place = Vec<N, double>(0.0);
  Vec<N, double> off;  ///< From there to the point.
};

/// Projected descent along all axes at once (Jacobi's method, with clamped steps): each round reduces the error from
/// the axes' orthonormality error by at least twice that, until only rounding is left; five suffice for the most
/// oblique valid box.
template <Dim N, class T>
PlaceInBox<N> place_in(const Obb<N, T>& box, const Vec<N, double>& p) {
  constexpr int rounds = 5;
  constexpr double shrinks_to = 4 * tolerance::orthonormal;
  const Mat<N, double> axes = wide_matrix<N, T>(box.axes);
  const Vec<N, double> half = wide<N, T>(box.half_extents);
  Mat<N, double> across;  // a valid axis is not zero
  for (Dim i = 0; i < N; ++i) across[i] = axes[i] / dot(axes[i], axes[i]);
  PlaceInBox<N> result;
  result.off = p - wide<N, T>(box.center);
  const double noise = tolerance::epsilon * sum_abs(result.off);
  for (int round = 0; round < rounds; ++round) {
    Vec<N, double> step;
    for (Dim i = 0; i < N; ++i) {
      const double wanted = result.place[i] + dot(result.off, across[i]);
      step[i] = std::min(std::max(wanted, -half[i]), half[i]) - result.place[i];
    }
    result.place += step;
    for (Dim i = 0; i < N; ++i) result.off -= axes[i] * step[i];
    if (sum_abs(step) * shrinks_to <= noise) break;
  }
  return result;
}

/// The rows of the adjoint matrix of a box's axes, as columns: the determinant, about 1 or -1 in a valid box, times the
/// rows of the inverse.
inline Mat<2, double> adjoint_columns(const Mat<2, double>& axes) {
  return {-perpendicular<double>(axes[1]), perpendicular<double>(axes[0])};
}

inline Mat<3, double> adjoint_columns(const Mat<3, double>& axes) {
  return {cross(axes[1], axes[2]), cross(axes[2], axes[0]), cross(axes[0], axes[1])};
}

/// One of them.
inline Vec<2, double> adjoint_column(const Mat<2, double>& axes, Dim i) {
  return i == 0 ? -perpendicular<double>(axes[1]) : perpendicular<double>(axes[0]);
}
inline Vec<3, double> adjoint_column(const Mat<3, double>& axes, Dim i) {
  return cross(axes[(i + 1) % 3], axes[(i + 2) % 3]);
}

/// Column i is the outward normal of the face at +half_extents[i], scaled so that it gives a point's i-th coordinate:
/// the rows of the inverse of the axes.
template <Dim N>
Mat<N, double> face_normals(const Mat<N, double>& axes) {
  Mat<N, double> normals = adjoint_columns(axes);
  const double determinant = dot(normals[0], axes[0]);
  for (Dim i = 0; i < N; ++i) normals[i] /= determinant;
  return normals;
}

/// How far a point is beyond the faces of a box, up to 3e-4 of itself and rounding; zero or less if inside.
template <Dim N, class T>
double beyond_faces(const Obb<N, T>& box, const Vec<N, double>& p) {
  const Mat<N, double> axes = wide_matrix<N, T>(box.axes);
  const Mat<N, double> normals = adjoint_columns(axes);
  const double determinant = std::fabs(dot(normals[0], axes[0]));
  const Vec<N, double> off = p - wide<N, T>(box.center);
  double beyond = -std::numeric_limits<double>::infinity();
  for (Dim i = 0; i < N; ++i) {
    const double half = static_cast<double>(box.half_extents[i]);
    beyond = std::max(beyond, std::fabs(dot(normals[i], off)) - half * determinant);
  }
  return beyond;
}

/// The largest coordinate of any point of a box.
template <Dim N, class T>
double largest_coordinate(const Obb<N, T>& box) {
  Vec<N, double> reach = abs(wide<N, T>(box.center));
  for (Dim i = 0; i < N; ++i) reach += abs(wide<N, T>(box.axes[i])) * static_cast<double>(box.half_extents[i]);
  return max_abs(reach);
}

/// From the center to the nearest face.
template <Dim N, class T>
double thickness_of(const Obb<N, T>& box) {
  T least = box.half_extents[0];
  for (Dim i = 1; i < N; ++i) least = std::min(least, box.half_extents[i]);
  return static_cast<double>(least);
}

/// The size of a point and a box relative to its center.
template <Dim N, class T>
double size_beside(const Obb<N, T>& box, const Vec<N, double>& p) {
  return sum_abs(p - wide<N, T>(box.center)) + 2 * sum_abs(wide<N, T>(box.half_extents));
}

/// The rounding error of the distance between a point and a box.
template <Dim N, class T>
double slack_of(const Obb<N, T>& box, const Vec<N, double>& p) {
  return tolerance::rounding * size_beside(box, p);
}

/// From inside, the nearest face; of equally near faces the first, by axes, negative side first.
template <Dim N, class T>
SurfacePoint<N> surface_point(const Obb<N, T>& box, const Vec<N, double>& p) {
  const Vec<N, double> center = wide<N, T>(box.center);
  const Vec<N, double> halves = wide<N, T>(box.half_extents);
  const Mat<N, double> axes = wide_matrix<N, T>(box.axes);
  const double thickness = thickness_of(box);
  const double size = size_beside(box, p);
  const auto finished = [&](const Vec<N, double>& place, double distance) -> SurfacePoint<N> {
    const Vec<N, double> room = halves - thickness;
    return {center + axes * place, center + axes * clamp(place, -room, room), distance, size};
  };
  const PlaceInBox<N> nearest = place_in(box, p);
  const double distance = std::sqrt(dot(nearest.off, nearest.off));
  if (!(distance <= tolerance::rounding * size)) return finished(nearest.place, distance);
  const Mat<N, double> normals = face_normals(axes);
  SurfacePoint<N> best{p, p, -std::numeric_limits<double>::infinity()};
  for (Dim i = 0; i < N; ++i) {
    const double length = std::sqrt(dot(normals[i], normals[i]));  // about 1
    for (const double side : {-1.0, 1.0}) {
      const double depth = -std::max(0.0, (halves[i] - side * nearest.place[i]) / length);
      if (!(depth > best.distance)) continue;
      // From p along the normal to the face, in units of the axes, minus the part that rounding puts beyond the face's
      // edges.
      const Vec<N, double> outward = normals[i] * (side / length);
      Vec<N, double> place = nearest.place;
      for (Dim j = 0; j < N; ++j) place[j] -= dot(normals[j], outward) * depth;
      place[i] = side * halves[i];
      best = finished(clamp(place, -halves, halves), depth);
    }
  }
  return best;
}

}  // namespace graze::detail
