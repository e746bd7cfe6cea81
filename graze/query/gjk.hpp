// SPDX-License-Identifier: MIT
// The distance between any two convex shapes, from nothing but their support functions.
// Gilbert, Johnson, Keerthi, "A fast procedure for computing the distance between complex objects in three-dimensional
// space" (1988); bounds after van den Bergen, "A fast and robust GJK implementation" (1999).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/simplex.hpp>
#include <graze/query/status.hpp>
#include <graze/query/wide_support.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

/// The distance of two convex shapes, enclosed: lower <= distance <= upper, up to `resolution`.
template <Dim N>
struct GjkResult {
  double lower = 0;                                 ///< Proved by a plane across `normal`.
  double upper = 0;                                 ///< Attained by two points of the shapes; 0 when they meet.
  double resolution = 0;                            ///< The rounding of support points: both bounds may be off by it.
  Vec<N, double> separation = Vec<N, double>(0.0);  ///< From b to a, as long as `upper`.
  Vec<N, double> normal = Vec<N, double>(0.0);      ///< Of any length, towards a; zero if nothing parts them.
  Status status = Status::converged;
  int iterations = 0;
  detail::Simplex<N>
      simplex;  ///< Points of the set of differences a - b whose hull holds the nearest one to the origin.
};

/// When an answer about a threshold is enough: GJK stops as soon as lower > threshold or upper < threshold, by more
/// than rounding, and not before unless the bounds meet up to rounding.
struct GjkOptions {
  double threshold = std::numeric_limits<double>::quiet_NaN();  ///< NaN: go on until the bounds meet.
};

namespace detail {

inline constexpr int gjk_iteration_limit = 128;

template <Dim N>
bool is_corner_of(const Simplex<N>& simplex, const Vec<N, double>& point) {
  return std::find(simplex.points.begin(), simplex.points.begin() + simplex.size, point) !=
         simplex.points.begin() + simplex.size;
}

/// All differences lie beyond a plane across `normal`, at `distance` from the origin.
template <Dim N>
void raise_lower(GjkResult<N>& result, double distance, const Vec<N, double>& normal) {
  if (!(distance > result.lower)) return;
  result.lower = distance;
  result.normal = normal;
}

/// Raises the lower bound: near the origin the nearest point is mostly rounding, and so is its direction, but those at
/// right angles to the simplex' faces are not.
template <class Differences>
void prove_distance(Differences& differences, const Simplex<Differences::dimension>& simplex,
                    GjkResult<Differences::dimension>& result) {
  for_each_perpendicular(simplex, [&](const Vec<Differences::dimension, double>& direction) {
    const double size = std::sqrt(dot(direction, direction));
    if (!(size > 0)) return;
    raise_lower(result, dot(direction, differences.support(-direction)) / size, direction);
  });
  result.resolution = differences.resolution();
}

/// How often in a row a step may bring nothing that can be measured.
inline constexpr int gjk_stall_limit = 8;

/// The next nearest point. Beside a long edge, a step along it may be too small to make the distance smaller, and yet
/// turn the direction towards a corner that does: so a new corner is taken if it makes the distance no larger. None
/// when it does, or when that has not helped for some time. No point is taken that is nearer than the proved bound: of
/// a needle, rounding turns the faces, and the origin may seem to lie between them.
template <Dim N>
std::optional<NearestOnSimplex<N>> gjk_step(const Simplex<N>& extended, const GjkResult<N>& result, int& stalls) {
  const Vec<N, double>& nearest = result.separation;
  const double before = dot(nearest, nearest);
  const double least = std::max(0.0, result.lower - result.resolution);
  const NearestOnSimplex<N> found = nearest_to_origin(extended, least * least);
  if (found.distance_squared < before) {
    stalls = 0;
    return found;
  }
  const NearestOnSimplex<N> sideways = nearest_with_last_corner(extended, least * least);
  const bool is_as_near = sideways.distance_squared <= before * (1 + tolerance::rounding);
  if (!is_as_near || ++stalls > gjk_stall_limit) return std::nullopt;
  return sideways;
}

/// Each step asks for the point of the difference set farthest against the nearest one found. That point bounds the
/// distance from below; the simplex of such points, reduced to the face that matters, from above. Without progress the
/// bounds at hand are the answer. The walk begins at `start`, the
/// nearest point of the hull of some differences, and its face.
template <class Differences>
GjkResult<Differences::dimension> gjk_walk(Differences& differences,
                                           const NearestOnSimplex<Differences::dimension>& start,
                                           const GjkOptions& options) {
  constexpr Dim N = Differences::dimension;
  GjkResult<N> result;
  Vec<N, double> nearest = start.point;
  result.simplex = start.face;
  Simplex<N> extended = result.simplex;
  int stalls = 0;
  // As much beyond the threshold as whoever compares with it wants to see: less would leave the verdict open.
  const auto margin = [&] { return result.resolution + tolerance::rounding * options.threshold; };
  const auto bounds_meet = [&] {
    const double wanted = std::isnan(options.threshold) ? tolerance::gjk_relative_gap * result.upper : 0;
    return result.upper - result.lower <= wanted + result.resolution;
  };
  while (true) {
    result.upper = std::sqrt(dot(nearest, nearest));
    result.separation = nearest;
    result.resolution = differences.resolution();
    if (result.upper <= result.resolution || result.simplex.size == static_cast<std::size_t>(N) + 1) {
      result.lower = 0;
      result.normal = Vec<N, double>(0.0);
      return result;
    }
    if (result.upper < options.threshold - margin()) return result;
    const Vec<N, double> next = differences.support(-nearest);
    result.resolution = differences.resolution();
    raise_lower(result, dot(nearest, next) / result.upper, nearest);  // upper > resolution >= 0
    if (result.lower > options.threshold + margin()) return result;
    if (bounds_meet()) return result;
    if (++result.iterations == gjk_iteration_limit || is_corner_of(result.simplex, next)) break;
    extended = result.simplex;
    extended.push(next);
    const std::optional<NearestOnSimplex<N>> found = gjk_step(extended, result, stalls);
    if (!found) break;
    nearest = found->point;
    result.simplex = found->face;
  }
  prove_distance(differences, extended, result);
  if (!bounds_meet()) result.status = Status::best_bound;
  return result;
}

/// From the support point of an axis.
template <class Differences>
GjkResult<Differences::dimension> gjk_on(Differences& differences, const GjkOptions& options) {
  constexpr Dim N = Differences::dimension;
  NearestOnSimplex<N> start;
  start.point = differences.support(unit_axis<N>(0));
  start.face.push(start.point);
  return gjk_walk(differences, start, options);
}

}  // namespace detail

/// The distance between two convex shapes, enclosed. Shapes that meet have upper = 0 or below `resolution`. At most 128
/// steps; if they, or the numbers' precision, end before the bounds meet, the status says so and the bounds still hold.
template <Convex A, SameDimension<A> B>
GjkResult<dimension_of<A>> gjk(const A& a, const B& b, const GjkOptions& options = {}) {
  detail::Difference<A, B> differences(a, b);
  return detail::gjk_on(differences, options);
}

}  // namespace graze
