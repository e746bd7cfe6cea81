// SPDX-License-Identifier: MIT
/// @file
/// The distance between any two convex shapes, from their support functions alone. Gilbert, Johnson, Keerthi, "A fast
/// procedure for computing the distance between complex objects in three-dimensional space" (1988); bounds after van
/// den Bergen, "A fast and robust GJK implementation" (1999).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/closest/fitting_face.hpp>
#include <graze/query/compiled/instances.hpp>
#include <graze/query/convex/simplex.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/status.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

/// Bounds on the distance of two convex shapes: lower <= distance <= upper, up to `resolution`.
template <Dim N>
struct GjkResult {
  double lower = 0;                                 ///< Proved by a plane perpendicular to `normal`.
  double upper = 0;                                 ///< Attained by two points of the shapes; 0 if they meet.
  double resolution = 0;                            ///< The rounding error of support points, and so of both bounds.
  Vec<N, double> separation = Vec<N, double>(0.0);  ///< From b to a; its length is `upper`.
  Vec<N, double> normal = Vec<N, double>(0.0);      ///< Towards a, of any length; zero if nothing separates the shapes.
  Status status = Status::converged;                ///< `best_bound`: the bounds hold, but did not meet.
  int iterations = 0;                               ///< Steps taken, at most 128.
  detail::Simplex<N>
      simplex;  ///< Points of the Minkowski difference a - b whose hull contains the one nearest to the origin.
};

/// Lets GJK stop early if only the comparison with a threshold matters: as soon as lower > threshold or upper <
/// threshold by more than rounding, and not before unless the bounds meet up to rounding.
struct GjkOptions {
  double threshold = std::numeric_limits<double>::quiet_NaN();  ///< NaN: continue until the bounds meet.
  /// The total radius if the shapes are the cores of round shapes: the bounds must then meet relative to distance -
  /// radius.
  double radius = 0;
};

namespace detail {

inline constexpr int gjk_iteration_limit = 128;

template <Dim N>
bool is_corner_of(const Simplex<N>& simplex, const Vec<N, double>& point) {
  return std::find(simplex.points.begin(), simplex.points.begin() + simplex.size, point) !=
         simplex.points.begin() + simplex.size;
}

/// All differences lie beyond a plane perpendicular to `normal`, at `distance` from the origin.
template <Dim N>
void raise_lower(GjkResult<N>& result, double distance, const Vec<N, double>& normal) {
  if (!(distance > result.lower)) return;
  result.lower = distance;
  result.normal = normal;
}

/// Raises the lower bound. Near the origin the nearest point, and so its direction, is mostly rounding error, but the
/// directions perpendicular to the simplex' faces are not.
template <Dim N>
void prove_distance(AnyDifference<N>& differences, const Simplex<N>& simplex, GjkResult<N>& result) {
  for_each_perpendicular(simplex, [&](const Vec<N, double>& direction) {
    const double size = std::sqrt(dot(direction, direction));
    if (!(size > 0)) return;
    raise_lower(result, dot(direction, differences.support(-direction)) / size, direction);
  });
  result.resolution = differences.resolution();
}

/// The largest number of consecutive steps without measurable progress.
inline constexpr int gjk_stall_limit = 24;

/// The state of the iteration.
template <Dim N>
struct GjkProgress {
  explicit GjkProgress(const Vec<N, double>& nearest) : toward(nearest), least_squared(dot(nearest, nearest)) {}

  Vec<N, double> toward;  ///< The direction of the nearest point; its length is the distance.
  double least_squared;   ///< The least distance so far.
  int stalls = 0;         ///< Number of steps that have not reduced it.
};

/// The next nearest point. Beside a long edge, and where faces meet nearly flat, a step may be too small to reduce the
/// distance and still turn the direction towards a corner that does; then the best-fitting face is next. None if that
/// increases the distance or has not helped for some steps. No point nearer than the proved bound is accepted: rounding
/// turns the faces of a needle, so that the origin may seem to lie between them.
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

/// Each step takes the point of the difference set that is farthest against the nearest point found. It bounds the
/// distance from below; the simplex of such points, reduced to the face that matters, bounds it from above. Without
/// progress the current bounds are the result. The iteration starts at `start`, the nearest point of the hull of some
/// differences, and its face.
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
  // Beyond the threshold by as much as the caller's comparison needs; less would leave the verdict open.
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
  prove_distance<N>(differences, extended, result);
  if (!bounds_meet()) result.status = Status::best_bound;
  return result;
}

/// Starts at the support point of an axis.
template <class Differences>
GjkResult<Differences::dimension> gjk_on(Differences& differences, const GjkOptions& options) {
  constexpr Dim N = Differences::dimension;
  NearestOnSimplex<N> start;
  start.point = differences.support(unit_axis<N>(0));
  start.face.push(start.point);
  return gjk_walk(differences, start, options);
}

/// For numbers in range.
template <Convex A, SameDimension<A> B>
GjkResult<dimension_of<A>> usual_gjk(const A& a, const B& b, const GjkOptions& options = {}) {
  Difference<A, B> differences(a, b);
  return gjk_on(differences, options);
}

/// The result for shapes 2^k times as large. A bound that is not zero stays nonzero.
template <Dim N>
GjkResult<N> resized(GjkResult<N> result, const PowerOfTwo& power) {
  result.lower = power(result.lower);
  result.upper = resized_distance(result.upper, power);
  result.resolution = resized_distance(result.resolution, power);
  result.separation = power(result.separation);
  for (std::size_t i = 0; i < result.simplex.size; ++i) result.simplex.points[i] = power(result.simplex.points[i]);
  return result;
}

/// If numbers are out of range, replaces `found` by the result of rescaled shapes.
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

GRAZE_DECLARE_INSTANCES_OF_DIMENSIONS(GRAZE_GJK_INSTANCES)

/// Bounds on the distance of two convex shapes, in double. If the shapes meet, upper is 0 or below `resolution`. At
/// most 128 steps; if these or the precision end before the bounds meet, the status says so and the bounds still hold.
/// If both shapes are in double, coordinates may be any finite numbers. `distance` and `intersects` use closed forms
/// where there are any and are cheaper.
template <Convex A, SameDimension<A> B>
GjkResult<dimension_of<A>> gjk(const A& a, const B& b, const GjkOptions& options = {}) {
  GjkResult<dimension_of<A>> result = detail::usual_gjk(a, b, options);
  if (!detail::is_usual_error<scalar_of<A>>(result.resolution)) detail::put_in_range(result, a, b, options);
  return result;
}

}  // namespace graze
