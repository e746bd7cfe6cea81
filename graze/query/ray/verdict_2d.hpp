// SPDX-License-Identifier: MIT
// The closed forms of ray_cast.hpp for points, segments, rays, triangles, polygons, planes and half-spaces. Include
// ray_cast.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/zonotope.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/relation/unbounded.hpp>
#include <graze/shape/half_space.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

// ---- Points, segments, rays: sets that most rays miss and that others barely touch, which `relation` decides

template <Dim N>
RayFinding<N> ray_verdict_of(const Vec<N, double>& point, const Path<N>& path) {
  const auto& [zero, direction, t_max, far] = path;
  const double t = std::clamp(dot(point, direction) / dot(direction, direction), 0.0, t_max);
  return {RayVerdict::unclear, {t, point, Vec<N, double>(0.0), tolerance::rounding * sum_abs(point)}};
}

/// The range of t in which the path is beside a part of a line.
struct Beside {
  double first;
  double last;
  double size;  ///< What rounding is relative to.
};

/// With w = start, e = edge and n = direction x e, the lines are nearest where t n^2 = (w x e) . n. For nearly parallel
/// lines that may be anywhere, but not where the path is not beside the edge; and they already touch, up to rounding,
/// from where they are as near as rounding can tell. The normal is perpendicular to the edge.
template <Dim N>
RayFinding<N> ray_verdict_of_edge(const Vec<N, double>& start, const Vec<N, double>& edge,
                                  const Vec<N, double>& direction, const Beside& beside) {
  const Vec<3, double> d = lifted(direction);
  const Vec<3, double> e = of_moderate_size(lifted(edge));
  const Vec<3, double> n = accurate_cross(d, e);
  const double whole = dot(n, n);
  RayFinding<N> result{RayVerdict::unclear, {}};
  result.hit.error = tolerance::rounding * beside.size;
  double first = beside.first;
  if (whole > 0) {
    first = dot(accurate_cross(lifted(start), e), n) / whole;
    constexpr double least_sine_squared = 0x1p-40;
    const bool is_parallel = whole < least_sine_squared * (dot(d, d) * dot(e, e));
    if (is_parallel) first -= result.hit.error * std::sqrt(dot(e, e) / whole);
  }
  result.hit.t = std::clamp(first, beside.first, beside.last);
  result.hit.point = direction * result.hit.t;
  result.hit.error += tolerance::rounding * sum_abs(result.hit.point);
  if (max_abs(edge) > 0) result.hit.normal = -straightened(direction, edge);
  return result;
}

template <Dim N>
RayFinding<N> ray_verdict_of(const Segment<N, double>& segment, const Path<N>& path) {
  const auto& [zero, direction, t_max, far] = path;
  const double whole = dot(direction, direction);
  const double start = dot(segment.start, direction) / whole;
  const double end = dot(segment.end, direction) / whole;
  const Vec<N, double> edge = segment.end - segment.start;
  const Beside beside{std::clamp(std::min(start, end), 0.0, t_max), std::clamp(std::max(start, end), 0.0, t_max),
                      sum_abs(segment.start) + sum_abs(edge)};
  return ray_verdict_of_edge<N>(segment.start, edge, direction, beside);
}

/// For an opposite ray that starts farther along the path: the path until its origin is beside it.
template <Dim N>
RayFinding<N> ray_verdict_of(const Ray<N, double>& ray, const Path<N>& path) {
  const auto& [zero, direction, t_max, far] = path;
  const double origin = std::clamp(dot(ray.origin, direction) / dot(direction, direction), 0.0, t_max);
  const double size = sum_abs(ray.origin);
  const Beside beside = dot(ray.direction, direction) > 0 ? Beside{origin, t_max, size} : Beside{0, origin, size};
  const Vec<N, double> edge = ray.direction / max_abs(ray.direction);  // a valid direction is not zero
  return ray_verdict_of_edge<N>(ray.origin, edge, direction, beside);
}

// ---- Triangles in 3D

/// The farthest corner from zero, by the sum of its coordinates.
inline double largest_corner(const Triangle<3, double>& triangle) {
  return std::max(sum_abs(triangle.a), std::max(sum_abs(triangle.b), sum_abs(triangle.c)));
}

/// A ray from zero passes an edge from p to q on the side given by the sign of direction . (p x q), and goes through a
/// triangle if it passes all edges on one side. Two triangles with a common edge get exactly opposite signs, and what
/// is nearer to an edge than rounding can tell is left to `relation`, for which both are touched: no ray passes through
/// a closed mesh (Woop, Benthin, Wald, "Watertight ray/triangle intersection", 2013, achieve the same by rounding both
/// alike).
///
/// With S as the size of the corners, D of the direction and E of the edges, the three signs are trusted from
/// tolerance::ray_side S D E on: then the ray passes that far from the edges, relative to S. A ray is called steep if
/// the sine of its angle with the plane is at least 2^-10; along it, 2^-30 of S is 2^-40 of S away from the plane.
struct TriangleBesidePath {
  /// More than products can lose by underflow.
  static constexpr double least_band = 0x1p-960;

  double size;
  double edges;
  double band;
  double least;
  double most;

  [[gnu::always_inline]] inline TriangleBesidePath(const Triangle<3, double>& triangle, const Path<3>& path)
      : size(path.far + largest_corner(triangle)),
        edges(sum_abs(triangle.b - triangle.a) + sum_abs(triangle.c - triangle.a)),
        band(tolerance::ray_side * size * sum_abs(path.direction) * edges + least_band) {
    const Vec<3, double> first = triangle.b - triangle.a;
    const Vec<3, double> second = triangle.c - triangle.a;
    const double ab = dot(path.direction, cross(triangle.a, first));
    const double bc = dot(path.direction, cross(triangle.b, triangle.c - triangle.b));
    const double ca = dot(path.direction, cross(second, triangle.a));
    least = std::min(ab, std::min(bc, ca));
    most = std::max(ab, std::max(bc, ca));
  }

  bool is_passed() const { return least < -band && most > band; }
};

/// Whether the line of the path passes the triangle: then ray_verdict_of returns a miss. For most paths this is enough,
/// and a verdict alone needs no memory.
[[gnu::always_inline]] inline bool is_missed(const Triangle<3, double>& triangle, const Path<3>& path) {
  return TriangleBesidePath(triangle, path).is_passed();
}

inline RayFinding<3> ray_verdict_of(const Triangle<3, double>& triangle, const Path<3>& path) {
  const auto& [zero, direction, t_max, far] = path;
  const TriangleBesidePath beside(triangle, path);
  if (beside.is_passed()) return missed<3>();
  const auto& [size, edges, band, least, most] = beside;
  const Vec<3, double> first = triangle.b - triangle.a;
  const Vec<3, double> second = triangle.c - triangle.a;
  const Vec<3, double> normal = of_moderate_size(cross_of_directions(first, second));
  const double climb = dot(normal, direction);
  constexpr double least_sine_squared = 0x1p-20;
  const bool is_steep = climb * climb > least_sine_squared * (dot(normal, normal) * dot(direction, direction));
  if (!is_steep) return unsettled<3>();
  RayFinding<3> result{RayVerdict::unclear, {}};
  const double t = dot(normal, triangle.a) / climb;
  const double end_slack = 0x1p10 * tolerance::ray_side * size / max_abs(direction);
  if (t < -end_slack || t > t_max + end_slack) return missed<3>();
  const bool is_inside = least > band || most < -band;
  if (is_inside && t > end_slack && t < t_max - end_slack) result.verdict = RayVerdict::hits;
  result.hit.t = std::clamp(t, 0.0, t_max);
  result.hit.point = direction * result.hit.t;
  result.hit.normal = climb > 0 ? -normal : normal;
  result.hit.error = tolerance::rounding * (size + edges);
  // Beside an edge, the plane is crossed up to 2^10 times as far from the triangle as the ray passes the edge.
  if (!is_inside) {
    result.is_hit_known = surface_point(triangle, result.hit.point).distance <= result.hit.error;
  }
  return result;
}

/// The same for a whole ray, if only the verdict matters; NaN is unclear or a miss.
inline RayVerdict ray_verdict_of_ray(const Triangle<3, double>& triangle, const Ray<3, double>& ray) {
  if (!is_usable(ray.direction)) return RayVerdict::unclear;
  constexpr double forever = std::numeric_limits<double>::infinity();
  return ray_verdict_of(relative_to(ray.origin, triangle), Path<3>{ray.origin, ray.direction, forever}).verdict;
}

// ---- Polygons

/// Where a path enters and leaves the half-planes left of a convex polygon's edges (Cyrus and Beck, "Generalized two-
/// and three-dimensional clipping", 1978), with the change of t that moves it by `margin` across each. No coordinate of
/// a corner, relative to the path's origin, exceeds `size`: the rounding of that rotates short edges.
class EdgeCrossings {
 public:
  EdgeCrossings(double margin, double size) : margin_(margin), noise_(4 * tolerance::epsilon * size), size_(size) {}

  /// False if the path misses the polygon because of this edge.
  bool add(const Vec<2, double>& from, const Vec<2, double>& to, const Vec<2, double>& direction) {
    const Vec<2, double> outward(to.y - from.y, from.x - to.x);
    const double height = -dot(outward, from);  // of zero above the edge
    const double climb = dot(outward, direction);
    const double slack = margin_ * sum_abs(outward) + noise_ * size_;
    constexpr double least_sine = 0x1p-40;
    if (std::fabs(climb) <= (least_sine * sum_abs(outward) + noise_) * sum_abs(direction)) {
      is_along_ = is_along_ || height > -2 * slack;
      return height <= 2 * slack;
    }
    const double t = -height / climb;
    const double slack_t = slack / std::fabs(climb);
    if (climb < 0) {
      latest_enter_ = std::max(latest_enter_, t + slack_t);
      earliest_enter_ = std::max(earliest_enter_, t - slack_t);
      // Entered where the last edge is crossed, however nearly the path runs along it: its slack affects only verdicts.
      if (t > enter_) {
        enter_ = t;
        normal_ = outward;
      }
    } else {
      earliest_exit_ = std::min(earliest_exit_, t - slack_t);
      latest_exit_ = std::min(latest_exit_, t + slack_t);
    }
    return true;
  }

  RayFinding<2> finding(const Vec<2, double>& direction, double t_max) const {
    const double exit = std::min(latest_exit_, t_max);
    if (!(std::max(earliest_enter_, 0.0) <= exit)) return missed<2>();
    if (is_along_) return unsettled<2>();
    RayFinding<2> result{RayVerdict::unclear, {}};
    // Next to a corner, rounding may have the ray leave before it enters: far from where the sides are, if they are
    // nearly parallel to it.
    if (latest_enter_ > earliest_exit_) return unsettled<2>();
    const bool is_hit = latest_enter_ <= t_max && earliest_exit_ >= 0;
    if (is_hit) result.verdict = RayVerdict::hits;
    if (!(enter_ >= 0)) return result;
    result.hit.t = std::min(enter_, exit);
    result.hit.point = direction * result.hit.t;
    result.hit.normal = normal_;
    return result;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  double margin_;
  double noise_;  ///< No coordinate of an edge is off by more.
  double size_;
  double enter_ = -infinity;
  double earliest_enter_ = -infinity;
  double latest_enter_ = -infinity;
  double earliest_exit_ = infinity;
  double latest_exit_ = infinity;
  Vec<2, double> normal_ = Vec<2, double>(0.0);
  bool is_along_ = false;  ///< The path runs along an edge, up to the rounding of the angle.
};

/// Corners as in Polytope, relative to `origin`. `far` is what relation's rounding is relative to, besides the
/// polygon's own size.
template <class T>
RayFinding<2> ray_verdict_of_polygon(Corners<T> corners, double far, const Path<2>& path) {
  const std::size_t count = corners.size();
  const auto corner = [&](std::size_t i) { return wide<2, T>(corners[i]) - path.origin; };
  if (count <= 2) {
    RayFinding<2> result =
        count == 1 ? ray_verdict_of(corner(0), path) : ray_verdict_of(Segment<2, double>{corner(0), corner(1)}, path);
    result.hit.error += tolerance::convex * far;
    return result;
  }
  double size = 0;
  for (std::size_t i = 0; i < count; ++i) size = std::max(size, sum_abs(corner(i)));
  EdgeCrossings crossings(tolerance::ray_side * (size + far + path.far), size);
  Vec<2, double> from = corner(count - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec<2, double> to = corner(i);
    if (!crossings.add(from, to, path.direction)) return missed<2>();
    from = to;
  }
  RayFinding<2> result = crossings.finding(path.direction, path.t_max);
  result.hit.error = tolerance::rounding * size + tolerance::convex * far;
  return result;
}

inline RayFinding<2> ray_verdict_of(const Triangle<2, double>& triangle, const Path<2>& path) {
  if (orientation(triangle.a, triangle.b, triangle.c) == 0) return unsettled<2>();
  const std::array<Vec<2, double>, 3> corners = counter_clockwise(triangle);
  return ray_verdict_of_polygon<double>(corners, 0, {Vec<2, double>(0.0), path.direction, path.t_max, path.far});
}

// ---- Planes and half-spaces, in the original coordinates

/// Whether the path is parallel to the plane, up to rounding.
template <Dim N, class T>
bool is_along(const Plane<N, T>& plane, const Path<N>& path) {
  const Vec<N, double> normal = wide<N, T>(plane.normal);
  return std::fabs(dot(normal, path.direction)) <= tolerance::rounding * dot(abs(normal), abs(path.direction));
}

/// The error of `relation` at either end of a path that ends at `point`.
template <Dim N, class T>
double error_at_plane(const Plane<N, T>& plane, const Path<N>& path, const Vec<N, double>& point) {
  const Vec<N, double> normal = wide<N, T>(plane.normal);
  const Vec<N, double> reach = abs(path.origin) + abs(point);
  const double magnitude = dot(abs(normal), reach) + std::fabs(static_cast<double>(plane.offset));
  return tolerance::convex * magnitude / max_abs(normal);
}

/// The touch of a path that meets the plane in time, or nearly does at one of its ends; its error includes the
/// remaining distance.
template <Dim N, class T>
RawHit<N> hit_of_plane(const Plane<N, T>& plane, const Path<N>& path) {
  const Vec<N, double> normal = wide<N, T>(plane.normal);
  const double height = height_over(plane, path.origin);
  const double climb = dot(normal, path.direction);
  RawHit<N> hit;
  const double t = climb == 0 ? 0 : std::max(0.0, -height / climb);
  hit.t = std::min(t, path.t_max);
  hit.point = path.origin + path.direction * hit.t;
  if (climb != 0) hit.normal = climb > 0 ? -normal : normal;
  hit.error = error_at_plane(plane, path, hit.point);
  if (hit.t != t || hit.t == 0) hit.error += std::fabs(height_over(plane, hit.point)) / max_abs(normal);
  return hit;
}

/// The side of a plane on which a path to a finite t_max begins and ends: 0 if it is nearer than `relation` can tell.
struct SidesOfPath {
  int start;
  int end;
};

template <Dim N, class T>
SidesOfPath sides_of(const Path<N>& path, const Plane<N, T>& plane) {
  const Heights start = heights_over(plane, path.origin);
  const Heights end = heights_over(plane, path.origin + path.direction * path.t_max);
  const double slack = 2 * (start.slack + end.slack);
  const auto side = [slack](double height) { return height > slack ? 1 : height < -slack ? -1 : 0; };
  return {side(start.low), side(end.low)};
}

template <Dim N, class T>
RayVerdict ray_verdict_of_plane(const Plane<N, T>& plane, const Path<N>& path) {
  if (std::isinf(path.t_max)) {
    const Ray<N, T> ray{Vec<N, T>(path.origin), Vec<N, T>(path.direction)};
    return relation_to_plane(plane, ray) == Relation::apart ? RayVerdict::misses : RayVerdict::hits;
  }
  const SidesOfPath sides = sides_of(path, plane);
  if (sides.start == 0 || sides.end == 0) return RayVerdict::unclear;
  return sides.start == sides.end ? RayVerdict::misses : RayVerdict::hits;
}

template <Dim N, class T>
RayFinding<N> ray_verdict_of_boundary(const Plane<N, T>& plane, const Path<N>& path) {
  const RayVerdict verdict = ray_verdict_of_plane(plane, path);
  if (verdict == RayVerdict::misses) return missed<N>();
  return {verdict, hit_of_plane(plane, path)};
}

template <Dim N, class T>
RayVerdict ray_verdict_of_half_space(const HalfSpace<N, T>& solid, const Path<N>& path) {
  if (std::isinf(path.t_max)) {
    const Ray<N, T> ray{Vec<N, T>(path.origin), Vec<N, T>(path.direction)};
    return relation_to_half_space(solid, ray) == Relation::apart ? RayVerdict::misses : RayVerdict::hits;
  }
  const SidesOfPath sides = sides_of(path, boundary(solid));
  if (sides.start < 0 || sides.end < 0) return RayVerdict::hits;
  return sides.start > 0 && sides.end > 0 ? RayVerdict::misses : RayVerdict::unclear;
}

template <Dim N, class T>
RayFinding<N> ray_verdict_of_boundary(const HalfSpace<N, T>& solid, const Path<N>& path) {
  RayFinding<N> result{ray_verdict_of_half_space(solid, path), {}};
  if (result.verdict == RayVerdict::misses) return missed<N>();
  result.hit = hit_of_plane(boundary(solid), path);
  const bool is_leaving = dot(wide<N, T>(solid.normal), path.direction) >= 0;
  const bool is_inside = height_over(boundary(solid), path.origin) < 0;
  if (is_inside) result.hit.error = error_at_plane(boundary(solid), path, path.origin);
  if (is_leaving || is_inside) result.hit = {0, path.origin, Vec<N, double>(0.0), result.hit.error};
  return result;
}

}  // namespace graze::detail
