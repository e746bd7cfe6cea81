// SPDX-License-Identifier: MIT
/// @file
/// The penetration depth of any two convex shapes: the length of the shortest translation that separates them. van den
/// Bergen, "Proximity queries and penetration depth computation on 3D game objects" (2001), section 4.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include <graze/math/exact/twofold.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/compiled/instances.hpp>
#include <graze/query/convex/depth_face.hpp>
#include <graze/query/convex/growing_hull.hpp>
#include <graze/query/convex/inplace_vector.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/gjk.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/status.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

/// Bounds on the depth of two convex shapes that meet: lower <= depth <= upper, up to `resolution`.
template <Dim N>
struct EpaResult {
  double lower = 0;  ///< A sphere of this radius around the origin lies in the Minkowski difference a - b.
  double upper = std::numeric_limits<double>::infinity();  ///< Moving b by `normal` * upper separates the shapes.
  double gap = 0;         ///< A proved distance along some direction, if the shapes turn out not to meet.
  double resolution = 0;  ///< The rounding error of support points, and so of all bounds.
  /// The shapes meet: no face of a polytope in the Minkowski difference separates it from the origin.
  bool holds_origin = false;
  Vec<N, double> normal = unit_axis<N>(0);  ///< Of length 1, from a to b: the direction of `upper`.
  Status status = Status::converged;        ///< `best_bound`: the bounds hold, but did not meet.
  int iterations = 0;                       ///< Steps taken, at most 128.
  detail::Simplex<N> face;  ///< Points of the Minkowski difference whose hull contains normal * upper, up to rounding;
                            ///< none if the nearest face is curved or only a threshold was asked for.
};

/// Lets EPA stop early if only the comparison with a threshold matters: as soon as lower > threshold or upper <=
/// threshold, by more than rounding.
struct EpaOptions {
  double threshold = std::numeric_limits<double>::quiet_NaN();  ///< NaN: continue until the bounds meet.
};

namespace detail {

inline constexpr int epa_iteration_limit = 128;
static_assert(epa_iteration_limit <= static_cast<int>(most_hull_inserts));

/// Computes the bounds by expanding a polytope.
template <Dim N>
class Expansion {
 public:
  using Point = Vec<N, double>;
  using Start = InplaceVector<Point, most_hull_starts<N>>;

  Expansion(AnyDifference<N>& differences, const EpaOptions& options) : differences_(differences), options_(options) {}

  EpaResult<N> run(const Simplex<N>& simplex) {
    for (Dim i = 0; i < N; ++i) differences_.support(unit_axis<N>(i));  // for the resolution
    const std::optional<Start> points = spanning_points(simplex);
    if (points) expand(GrowingHull<N>(points->all()));
    result_.resolution = differences_.resolution();
    return result_;
  }

 private:
  /// The support point along a unit direction; its height is an upper bound of the depth for any direction.
  Point probe(const Point& direction) {
    const Point point = differences_.support(direction);
    const double signed_height = dot(direction, point);
    result_.gap =
        std::max(result_.gap, has_met_ ? std::min(-signed_height, differences_.resolution()) : -signed_height);
    const double height = std::max(signed_height, 0.0);
    if (height < result_.upper) {
      result_.upper = height;
      result_.normal = direction;
    }
    return point;
  }

  /// Points whose hull contains the simplex and has an interior; none if the difference set is so flat that the depth
  /// is within rounding, as the upper bound then states. Adds both extremes perpendicular to the span so far: at most
  /// two points for each dimension.
  std::optional<Start> spanning_points(const Simplex<N>& simplex) {
    Start points(std::span(simplex.points).first(simplex.size));
    Frame<N> frame;
    for (std::size_t i = 1; i < simplex.size; ++i) frame.add(points[i] - points[0], differences_.resolution());
    while (!frame.is_full()) {
      const Point across = frame.across();
      const Point high = probe(across);
      const Point low = probe(-across);
      points.push_back(high);
      points.push_back(low);
      if (!frame.add(high - low, differences_.resolution())) return std::nullopt;
    }
    return points;
  }

  /// Moves the hull's face nearest to the origin outward until it is a face of the difference set itself. A face that
  /// has the origin outside comes first, because the shapes may not meet after all.
  /// Once the bounds have met, a comparison with a threshold is decided. Without a threshold, the search goes on to the
  /// face of the minimum translation; what it finds on the way no longer changes whether the shapes overlap, because
  /// `relation`, which uses a threshold, stops earlier.
  void expand(GrowingHull<N> hull) {
    for (; result_.iterations < epa_iteration_limit; ++result_.iterations) {
      const auto face = hull.nearest_face();
      if (!face) break;
      if (has_met_ && face->height > result_.upper + differences_.resolution()) return;
      const Point point = probe(face->normal);
      const double resolution = differences_.resolution();
      if (result_.gap > resolution) return;
      raise_lower(face->height);
      result_.holds_origin = face->height >= -resolution;
      has_met_ = has_met_ || (result_.holds_origin && is_answered(resolution));
      if (has_met_ && !std::isnan(options_.threshold)) return;
      if (rises_above(face->normal, face->height, point) && hull.insert(point, *face)) continue;
      const DepthFace<N> exact = exact_face(hull.corners_of(*face));
      if (max_abs(exact.normal - face->normal) > 2 * tolerance::epsilon && max_abs(exact.normal) > 0) {
        const Point other = probe(exact.normal);
        if (rises_above(exact.normal, exact.height, other) && hull.insert(other, *face)) continue;
      }
      if (exact.outside <= tolerance::rounding * hull.size()) {
        keep(exact.normal, hull.corners_of(*face));
        if (has_met_ || is_answered(resolution)) return;
        most_lower_ = std::min(most_lower_, exact.height);
      }
      if (!hull.settle(*face)) break;
    }
    if (!has_met_) result_.status = Status::best_bound;
  }

  void raise_lower(double height) {
    result_.lower = std::min({std::max({height, result_.lower, 0.0}), result_.upper, most_lower_});
  }

  static bool rises_above(const Point& normal, double height, const Point& point) {
    return dot(normal, point) - height > 2 * tolerance::epsilon * dot(abs(normal), abs(point));
  }

  DepthFace<N> exact_face(const HullFaceCorners<N>& corners) const {
    std::array<TwofoldVec<N>, static_cast<std::size_t>(N)> exact;
    for (std::size_t i = 0; i < corners.size(); ++i) exact[i] = differences_.exact(corners[i]);
    return depth_face<N>(exact);
  }

  void keep(const Point& normal, const HullFaceCorners<N>& corners) {
    result_.normal = normal;
    result_.face.size = 0;
    for (const Point& corner : corners) result_.face.push(corner);
  }

  bool is_answered(double resolution) const {
    if (result_.lower > options_.threshold + resolution || result_.upper <= options_.threshold) return true;
    return result_.upper - result_.lower <= tolerance::gjk_relative_gap * result_.upper + resolution;
  }

  AnyDifference<N>& differences_;
  EpaOptions options_;
  EpaResult<N> result_;
  bool has_met_ = false;                                         ///< The bounds have met.
  double most_lower_ = std::numeric_limits<double>::infinity();  ///< The least lower bound of settled faces.
};

template <Dim N>
EpaResult<N> epa_on(AnyDifference<N>& differences, const Simplex<N>& simplex, const EpaOptions& options) {
  return Expansion<N>(differences, options).run(simplex);
}

/// For numbers in range.
template <Convex A, SameDimension<A> B>
EpaResult<dimension_of<A>> usual_epa(const A& a, const B& b, const Simplex<dimension_of<A>>& simplex,
                                     const EpaOptions& options = {}) {
  Difference<A, B> differences(a, b);
  return epa_on<dimension_of<A>>(differences, simplex, options);
}

/// The result for shapes 2^k times as large.
template <Dim N>
EpaResult<N> resized(EpaResult<N> result, const PowerOfTwo& power) {
  result.lower = power(result.lower);
  result.upper = power(result.upper);
  result.gap = power(result.gap);
  result.resolution = resized_distance(result.resolution, power);
  for (std::size_t i = 0; i < result.face.size; ++i) result.face.points[i] = power(result.face.points[i]);
  return result;
}

/// If numbers are out of range, replaces `found` by the result of rescaled shapes. Their simplex is computed anew,
/// because the points of the given one may have been rounded.
template <Convex A, Convex B>
[[gnu::noinline, gnu::cold]] void put_in_range(EpaResult<dimension_of<A>>& found, const A& a, const B& b,
                                               const EpaOptions& options) {
  const auto rescaled = answer_in_range<EpaResult<dimension_of<A>>>(
      [&options](const PowerOfTwo& power, const auto& scaled_a, const auto& scaled_b) {
        const auto simplex = usual_gjk(scaled_a, scaled_b).simplex;
        return resized(usual_epa(scaled_a, scaled_b, simplex, {power(options.threshold)}), power.inverse());
      },
      a, b);
  if (rescaled) found = *rescaled;
}

}  // namespace detail

GRAZE_DECLARE_INSTANCES_OF_DIMENSIONS(GRAZE_EPA_INSTANCES)

/// Bounds on the depth of two convex shapes that meet, given the simplex with which `gjk` ended. Flat sets of
/// differences, as of two coplanar triangles, have depth 0. At most 128 steps; if these or the precision end before the
/// bounds meet, the status says so and the bounds still hold. If both shapes are in double, coordinates may be any
/// finite numbers. Allocates nothing on the heap; uses up to 22 KiB of stack. `contact` uses closed forms where there
/// are any and is cheaper.
template <Convex A, SameDimension<A> B>
EpaResult<dimension_of<A>> epa(const A& a, const B& b, const detail::Simplex<dimension_of<A>>& simplex,
                               const EpaOptions& options = {}) {
  EpaResult<dimension_of<A>> result = detail::usual_epa(a, b, simplex, options);
  if (!detail::is_usual_error<scalar_of<A>>(result.resolution)) detail::put_in_range(result, a, b, options);
  return result;
}

}  // namespace graze
