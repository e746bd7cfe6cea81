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
#include <graze/query/closest/fitting_face.hpp>
#include <graze/query/convex/simplex.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/status.hpp>
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
  double radius = 0;  ///< Of what the shapes are the cores of: they meet relative to what is left of the distance.
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
inline constexpr int gjk_stall_limit = 24;

/// What the next step goes on from.
template <Dim N>
struct GjkProgress {
  explicit GjkProgress(const Vec<N, double>& nearest) : toward(nearest), least_squared(dot(nearest, nearest)) {}

  Vec<N, double> toward;  ///< The direction of the nearest point, as long as that is far.
  double least_squared;   ///< The least distance so far.
  int stalls = 0;         ///< How many steps have not made it less.
};

/// The next nearest point. Beside a long edge, and where faces meet nearly flat, a step may be too small to make the
/// distance less, and yet turn the direction towards a corner that does: then the face that fits best is the next one.
/// None when that makes the distance larger, or has not helped for some time. No point is taken that is
/// nearer than the proved bound: of a needle, rounding turns the faces, and the origin may seem to lie between them.
template <Dim N>
std::optional<NearestOnSimplex<N>> gjk_step(const Simplex<N>& extended, const GjkResult<N>& result,
                                            GjkProgress<N>& progress) {
  const double least = std::max(0.0, result.lower - result.resolution);
  const NearestOnSimplex<N> found = nearest_to_origin(extended, least * least);
  if (found.distance_squared < progress.least_squared) {
    progress = GjkProgress<N>(found.point);
    return found;
  }
  if (++progress.stalls > gjk_stall_limit) return std::nullopt;
  const FittingFace<N> fitting = FittingFaceSearch<N>(extended).run();
  const double most = std::sqrt(progress.least_squared) + result.resolution;
  const double squared = fitting.nearest.distance_squared;
  if (!(squared >= least * least && squared <= most * most)) return std::nullopt;
  progress.toward = fitting.toward;
  return fitting.nearest;
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
  GjkProgress<N> progress(start.point);
  // As much beyond the threshold as whoever compares with it wants to see: less would leave the verdict open.
  const auto margin = [&] { return result.resolution + tolerance::rounding * options.threshold; };
  const auto bounds_meet = [&] {
    const double wanted =
        std::isnan(options.threshold) ? tolerance::gjk_relative_gap * std::fabs(result.upper - options.radius) : 0;
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
    const Vec<N, double>& toward = progress.toward;
    const Vec<N, double> next = differences.support(-toward);
    result.resolution = differences.resolution();
    raise_lower(result, dot(toward, next) / result.upper, toward);  // upper > resolution >= 0
    if (result.lower > options.threshold + margin()) return result;
    if (bounds_meet()) return result;
    if (++result.iterations == gjk_iteration_limit || is_corner_of(result.simplex, next)) break;
    extended = result.simplex;
    extended.push(next);
    const std::optional<NearestOnSimplex<N>> found = gjk_step(extended, result, progress);
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

/// Of shapes in range.
template <Convex A, SameDimension<A> B>
GjkResult<dimension_of<A>> usual_gjk(const A& a, const B& b, const GjkOptions& options = {}) {
  Difference<A, B> differences(a, b);
  return gjk_on(differences, options);
}

/// The same of shapes that are 2^k times as large. A bound that is not zero stays so.
template <Dim N>
GjkResult<N> resized(GjkResult<N> result, const PowerOfTwo& power) {
  result.lower = power(result.lower);
  result.upper = resized_distance(result.upper, power);
  result.resolution = resized_distance(result.resolution, power);
  result.separation = power(result.separation);
  for (std::size_t i = 0; i < result.simplex.size; ++i) result.simplex.points[i] = power(result.simplex.points[i]);
  return result;
}

/// Puts the answer for shapes that are out of range in the place of what has been found, if they are.
template <Convex A, Convex B>
[[gnu::noinline, gnu::cold]] void put_in_range(GjkResult<dimension_of<A>>& found, const A& a, const B& b,
                                               const GjkOptions& options) {
  const auto rescaled = answer_in_range<GjkResult<dimension_of<A>>>(
      [&options](const PowerOfTwo& power, const auto& scaled_a, const auto& scaled_b) {
        const GjkOptions scaled_options{power(options.threshold), power(options.radius)};
        return resized(usual_gjk(scaled_a, scaled_b, scaled_options), power.inverse());
      },
      a, b);
  if (rescaled) found = *rescaled;
}

}  // namespace detail

/// The distance between two convex shapes, enclosed. Shapes that meet have upper = 0 or below `resolution`. At most 128
/// steps; if they, or the numbers' precision, end before the bounds meet, the status says so and the bounds still hold.
/// Any finite coordinates, as scaling/range.hpp says, if both shapes are in double.
template <Convex A, SameDimension<A> B>
GjkResult<dimension_of<A>> gjk(const A& a, const B& b, const GjkOptions& options = {}) {
  GjkResult<dimension_of<A>> result = detail::usual_gjk(a, b, options);
  if (!detail::is_usual_error<scalar_of<A>>(result.resolution)) detail::put_in_range(result, a, b, options);
  return result;
}

}  // namespace graze
