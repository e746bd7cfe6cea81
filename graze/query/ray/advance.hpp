// SPDX-License-Identifier: MIT
// Where a ray enters any convex shape, from its support function alone. Include ray_cast.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest/surface_point_convex.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/convex/simplex.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/gjk.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/ray/verdict_2d.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/status.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// If the distance is halved per step, as when a ray grazes a round shape, rounding is reached after 52 steps.
inline constexpr int ray_step_limit = 64;

/// A plane between a point of the ray and the shape.
template <Dim N>
struct Barrier {
  Vec<N, double> normal = Vec<N, double>(0.0);  ///< A unit vector towards the point.
  double height = 0;  ///< The height of the point above the plane; not positive if there is no plane.
  double gap = 0;     ///< An upper bound of the distance of the shape.
  double resolution = 0;
};

/// The plane that GJK's lower bound comes from, moved to the shape's own farthest point. Close to the shape it is not
/// perpendicular to the shortest vector, whose direction is mostly rounding there.
template <Convex S>
Barrier<dimension_of<S>> barrier_at(const S& shape, const Vec<dimension_of<S>, double>& point) {
  constexpr Dim N = dimension_of<S>;
  const auto& inner = core(shape);
  const double radius = core_radius(shape);
  const GjkResult<N> found = usual_gjk(point, inner, GjkOptions{.radius = radius});
  Barrier<N> barrier;
  barrier.gap = std::max(0.0, found.upper - radius);
  barrier.resolution = found.resolution + tolerance::rounding * radius;
  if (!(found.upper > radius + barrier.resolution)) return barrier;
  barrier.normal = unit_or(found.normal, Vec<N, double>(0.0));
  barrier.height = dot(barrier.normal, point - wide_support(inner, barrier.normal)) - radius;
  return barrier;
}

/// How near a missed shape must be for `relation` to decide.
template <Convex S>
double band_of_miss(const S& shape, const Path<dimension_of<S>>& path) {
  constexpr Dim N = dimension_of<S>;
  const auto box = bounds(shape);
  const Vec<N, double> largest = max(abs(wide<N, scalar_of<S>>(box.min)), abs(wide<N, scalar_of<S>>(box.max)));
  return 64 * support_error<S> * (sum_abs(path.origin) + sum_abs(largest) + core_radius(shape) + path.far);
}

/// The state of a point that moves along a path.
template <Convex S>
class Advance {
 public:
  static constexpr Dim N = dimension_of<S>;

  Advance(const S& shape, const Path<N>& path) : shape_(shape), path_(path), point_(path.origin) {}

  const Vec<N, double>& point() const { return point_; }

  /// Moves to the plane with this `normal` (of any nonzero length), above which the point has this `height`; nothing
  /// before the new position is in the shape. The end of the path if that comes first, or if the path does not approach
  /// the plane.
  std::optional<RayFinding<N>> move_to(const Vec<N, double>& normal, double height) {
    const double approach = -dot(normal, path_.direction);
    if (!(approach > 0)) return missed_by(height);
    touch_.normal = normal;
    const double next = touch_.t + height / approach;
    touch_.t = std::min(next, path_.t_max);
    point_ = path_.origin + path_.direction * touch_.t;
    if (next > path_.t_max) return missed_by((next - path_.t_max) * approach);
    return std::nullopt;
  }

  double t() const { return touch_.t; }

  /// The point is this near to the shape.
  RayFinding<N> arrived(double error, Status status = Status::converged) {
    touch_.point = point_;
    touch_.error = error;
    touch_.status = status;
    return {RayVerdict::hits, touch_, true, false};
  }

 private:
  RayFinding<N> missed_by(double height) {
    RayFinding<N> result = arrived(height);
    result.verdict = height > band_of_miss(shape_, path_) ? RayVerdict::misses : RayVerdict::unclear;
    result.is_hit_known = false;
    return result;
  }

  const S& shape_;
  const Path<N>& path_;
  Vec<N, double> point_;
  RawHit<N> touch_;
};

/// Moves along the path, each time to the plane that GJK has found between the point and the shape: Newton's method on
/// the distance, which is a convex function of t, so that it never passes the first touch. Ends where the shape is as
/// near as support points can tell, or is missed, or at the step limit, with the remaining distance as the error; if
/// the distance is greater and still no plane is found between, the result is unclear.
template <Convex S>
RayFinding<dimension_of<S>> advance_by_distance(const S& shape, const Path<dimension_of<S>>& path) {
  Advance<S> advance(shape, path);
  Barrier<dimension_of<S>> barrier;
  for (int step = 0; step < ray_step_limit; ++step) {
    barrier = barrier_at(shape, advance.point());
    if (!(barrier.height > barrier.resolution)) break;
    const double before = advance.t();
    if (const auto end = advance.move_to(barrier.normal, barrier.height - barrier.resolution / 2)) return *end;
    if (advance.t() == before) break;
  }
  const bool has_arrived = barrier.gap <= 2 * barrier.resolution;
  auto result = advance.arrived(barrier.gap + barrier.resolution, has_arrived ? Status::converged : Status::best_bound);
  if (!has_arrived) {
    result.verdict = RayVerdict::unclear;
    result.is_hit_known = false;
  }
  return result;
}

/// A few points of a shape, relative to a moving point: GJK's simplex, but its points belong to the shape alone.
template <Dim N>
class CornersAhead {
 public:
  /// False if it is already included.
  bool add(const Vec<N, double>& corner) {
    if (is_corner_of(corners_, corner)) return false;
    corners_.push(corner);
    return true;
  }

  /// Whether a ray intersects the hull of as many points as there are dimensions by far more than rounding, relative to
  /// `largest`.
  bool are_passed(const Vec<N, double>& origin, const Vec<N, double>& direction, double largest) const {
    if (corners_.size != static_cast<std::size_t>(N)) return false;
    const double far = 4 * largest;
    const Vec<N, double> first = corners_.points[0] - origin;
    const Vec<N, double> second = corners_.points[1] - origin;
    const auto is_ahead = [&](const Vec<N, double>& normal) {
      const double height = dot(normal, first);
      const bool comes_nearer = (height > 0) == (dot(normal, direction) > 0);
      return comes_nearer && std::fabs(height) > tolerance::ray_side * far * sum_abs(normal);
    };
    if constexpr (N == 2) {
      const double band = tolerance::ray_side * far * sum_abs(direction);
      const double left = cross_2d(direction, first);
      const double right = cross_2d(direction, second);
      const bool is_between = std::min(left, right) < -band && std::max(left, right) > band;
      return is_between && is_ahead(perpendicular(second - first));
    } else {
      const Vec<3, double> third = corners_.points[2] - origin;
      const TriangleBesidePath beside({first, second, third}, {Vec<3, double>(0.0), direction, 0, far});
      const bool is_between = beside.least > beside.band || beside.most < -beside.band;
      return is_between && is_ahead(cross(second - first, third - first));
    }
  }

  /// The vector from the nearest point of their hull. Points that do not contribute to it are removed.
  Vec<N, double> nearest_to(const Vec<N, double>& point) {
    Simplex<N> seen;
    for (std::size_t i = 0; i < corners_.size; ++i) seen.push(point - corners_.points[i]);
    const NearestOnSimplex<N> found = nearest_to_origin(seen);
    Simplex<N> kept;
    for (std::size_t i = 0; i < corners_.size; ++i) {
      if (is_corner_of(found.face, seen.points[i]) && kept.size < found.face.size) kept.push(corners_.points[i]);
    }
    corners_ = kept;
    return found.point;
  }

 private:
  Simplex<N> corners_;
};

/// The same, but without waiting for GJK to converge: the point moves as soon as a plane allows it, and the simplex
/// with it (van den Bergen, "Ray casting against general convex objects with application to continuous collision
/// detection", 2004). None if neither the point nor the simplex makes progress.
template <Convex S>
std::optional<RayFinding<dimension_of<S>>> advance_at_once(const S& shape, const Path<dimension_of<S>>& path) {
  constexpr Dim N = dimension_of<S>;
  const auto& inner = core(shape);
  const double radius = core_radius(shape);
  Advance<S> advance(shape, path);
  CornersAhead<N> corners;
  Vec<N, double> nearest = path.origin - wide_support(inner, -path.direction);
  double largest = max_abs(path.origin);
  for (int step = 0; step < ray_step_limit; ++step) {
    const double distance = std::sqrt(dot(nearest, nearest));
    const double resolution = support_error<S> * largest + tolerance::rounding * radius;
    if (distance <= radius + resolution) {
      RayFinding<N> result = advance.arrived(std::max(0.0, distance - radius) + resolution);
      const bool is_exact = support_error<S> <= tolerance::convex;
      result.is_certain = is_exact && corners.are_passed(path.origin, path.direction, largest);
      return result;
    }
    const Vec<N, double> corner = wide_support(inner, nearest);
    largest = std::max({largest, max_abs(corner), max_abs(advance.point())});
    const Vec<N, double> normal = nearest / distance;  // over radius + resolution
    const double height = dot(normal, advance.point() - corner) - radius;
    const bool is_moving = height > resolution;
    if (is_moving) {
      if (const auto end = advance.move_to(normal, height - resolution / 2)) return end;
    }
    if (!corners.add(corner) && !is_moving) return std::nullopt;
    const Vec<N, double> next = corners.nearest_to(advance.point());
    if (!is_moving && !(dot(next, next) < dot(nearest, nearest))) return std::nullopt;
    nearest = next;
  }
  return std::nullopt;
}

/// Where a path first touches any convex shape. A path that is known to touch ends at its nearest point. Next to a
/// shape that is nearer than rounding, a step to a plane along the path may pass it: a miss found this way is unclear.
template <Convex S>
RayFinding<dimension_of<S>> advance_to(const S& shape, const Path<dimension_of<S>>& path) {
  if (const auto result = advance_at_once(shape, path)) return *result;
  RayFinding<dimension_of<S>> result = advance_by_distance(shape, path);
  if (result.verdict == RayVerdict::misses) result.verdict = RayVerdict::unclear;
  return result;
}

// ---- Paths that are known to touch

/// From the path's origin to where it has left a bounded shape.
template <class S>
Vec<dimension_of<S>, double> reach_past(const S& shape, const Path<dimension_of<S>>& path) {
  constexpr Dim N = dimension_of<S>;
  const Aabb<N, scalar_of<S>> box = bounds(shape);
  return reach_to(Ray<N, double>{path.origin, path.direction},
                  Aabb<N, double>{wide<N, scalar_of<S>>(box.min), wide<N, scalar_of<S>>(box.max)});
}

/// The nearest point of a path that only nearly touches the shape. At a grazing angle Newton's method has passed it:
/// the last plane gives only the normal.
template <Convex S>
RawHit<dimension_of<S>> nearest_hit(const S& shape, const Path<dimension_of<S>>& path,
                                    const RawHit<dimension_of<S>>& passed) {
  constexpr Dim N = dimension_of<S>;
  const Vec<N, double> reach = reach_past(shape, path);
  const Vec<N, double> end = path.direction * path.t_max;
  const bool is_cut = is_finite(end) && dot(end, path.direction) < dot(reach, path.direction);
  const Segment<N, double> way{path.origin, path.origin + (is_cut ? end : reach)};
  const auto proximity_of = [&] {
    if constexpr (HasSimpleCore<S>) {
      return proximity_of_simple(shape, way, Relation::apart);
    } else {
      return proximity_of_convex(shape, way, Relation::apart);
    }
  };
  const Proximity<N, double> nearest = proximity_of();
  const double along = dot(nearest.point_b - path.origin, path.direction);
  RawHit<N> hit;
  hit.t = std::clamp(along / dot(path.direction, path.direction), 0.0, path.t_max);  // a direction is not zero
  hit.point = nearest.point_a;
  hit.normal = passed.normal;
  hit.error = nearest.distance + nearest.error;
  hit.status = nearest.status;
  return hit;
}

/// GJK cannot tell a point from one that touches if the gap is at most this many resolutions: one for the plane between
/// point and shape, one for the difference at which GJK's bounds count as equal, and twice as much where rounding keeps
/// the bounds apart.
inline constexpr double most_resolutions_at_touch = 4;

/// The result of GJK for a path that touches according to `relation`. If there was no plane left between the point and
/// the shape, Newton's method may have stopped at the entry without reporting it; it has not passed it then. It is the
/// answer if `relation` finds it on the shape, or if its error is less than the depth of the ray on its way to the
/// nearest point: at most twice the depth in the middle.
template <Convex S>
RawHit<dimension_of<S>> hit_by_advance(const S& shape, const Path<dimension_of<S>>& path) {
  const RayFinding<dimension_of<S>> found = advance_to(shape, path);
  if (found.verdict == RayVerdict::hits) return found.hit;
  const RawHit<dimension_of<S>> nearest = nearest_hit(shape, path, found.hit);
  if (!(found.hit.t < nearest.t)) return nearest;
  const auto barrier = barrier_at(shape, found.hit.point);
  const double off = barrier.gap + barrier.resolution;
  const bool is_on_shape = decide(shape, found.hit.point) != Relation::apart;
  const Vec<dimension_of<S>, double> middle = path.origin + path.direction * (0.5 * found.hit.t + 0.5 * nearest.t);
  const double deepest = std::max(0.0, -2 * surface_point(shape, middle).distance);
  if (!is_on_shape && off >= std::max(nearest.error, deepest)) {
    RawHit<dimension_of<S>> hit = nearest;
    hit.error = std::max(nearest.error, deepest);
    return hit;
  }
  RawHit<dimension_of<S>> hit = found.hit;
  hit.error = is_on_shape ? std::max(found.hit.error, off) : off;
  const bool is_near = barrier.gap <= most_resolutions_at_touch * barrier.resolution;
  hit.status = is_on_shape || is_near ? Status::converged : Status::best_bound;
  return hit;
}

}  // namespace graze::detail
