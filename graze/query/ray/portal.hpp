// SPDX-License-Identifier: MIT
// Where most rays enter a 3D polytope, or that they miss it. Include ray_cast.hpp.
//
// Projected along the ray, the polytope is a planar set of points, and the ray is one point. Three corners around it
// are a portal, through which the ray must pass (Snethen, "XenoCollide: complex collision made simple", 2008). The
// corner that is farthest in front of the portal's plane replaces one of the three, until there is none: then the
// portal lies in the face that the ray enters.
//
// The search for the portal need not be exact, because its result is verified: the triangle belongs to the polytope,
// and all corners are behind its plane, up to rounding. From the three corners and the plane, the ray's intersection is
// then as certain as with a triangle. Anything not verified is left to advance.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/ray/advance.hpp>
#include <graze/query/ray/corners_in_frame.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/ray/verdict_2d.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/polytope.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

/// A ray against a hull of 32 corners takes six support points on average. A search that takes ten times as many
/// alternates because of rounding.
inline constexpr int portal_step_limit = 64;

/// Three corners relative to the ray's origin. Projected along the ray they are counter-clockwise around it: direction
/// . (a x b) is positive, and so are those of b and c, and c and a.
struct Portal {
  Vec<3, double> a;
  Vec<3, double> b;
  Vec<3, double> c;

  /// Towards the ray's origin.
  Vec<3, double> normal() const { return cross(c - a, b - a); }
};

/// More corners than fit into CornersInFrame, each read in place.
template <class T>
class CornersInPlace {
 public:
  CornersInPlace(const Polytope<3, T>& polytope, const Vec<3, double>& origin) : polytope_(polytope), origin_(origin) {}

  Aabb<3, double> bounds() const { return relative_to(origin_, graze::bounds(polytope_)); }
  Vec<3, double> farthest(const Vec<3, double>& direction) const { return support(polytope_, direction) - origin_; }

 private:
  const Polytope<3, T>& polytope_;
  const Vec<3, double>& origin_;
};

/// Finds the portal of a ray from its origin.
template <class Corners>
class PortalSearch {
 public:
  PortalSearch(const Corners& corners, const Path<3>& path)
      : corners_(corners),
        path_(path),
        box_(corners.bounds()),
        size_(sum_abs(path.origin) + sum_abs(max(abs(box_.min + path.origin), abs(box_.max + path.origin))) + path.far),
        band_(64 * tolerance::convex * size_),
        past_(2 * size_ / max_abs(path.direction)) {}

  /// None unless it is certain by far.
  std::optional<RayFinding<3>> finding() const {
    const auto is_moderate = [](double x) { return x > 0x1p-160 && x < 0x1p160; };  // no product overflows
    if (!is_moderate(size_) || !is_moderate(max_abs(path_.direction))) return std::nullopt;
    if (is_behind()) return missed<3>();
    Portal portal;
    switch (find(portal)) {
      case RayVerdict::misses:
        return missed<3>();
      case RayVerdict::hits:
        return enter(portal);
      default:
        return std::nullopt;
    }
  }

 private:
  /// Whether the path moves away from the box, by what `relation` may call touching.
  bool is_behind() const {
    const Vec<3, double> corner = max(box_.min * path_.direction, box_.max * path_.direction);
    return corner.x + corner.y + corner.z < -band_ * sum_abs(path_.direction);
  }

  /// Twice the area between the ray and two corners, projected along the ray.
  double area(const Vec<3, double>& p, const Vec<3, double>& q) const { return dot(path_.direction, cross(p, q)); }

  /// From a point perpendicularly to the ray.
  Vec<3, double> towards_ray(const Vec<3, double>& p) const {
    return path_.direction * (dot(p, path_.direction) / dot(path_.direction, path_.direction)) - p;
  }

  /// The corner farthest in a direction perpendicular to the ray, and whether it is beyond the ray: if not, all are on
  /// one side, and if it falls short of it by more than what `relation` may call touching, the ray misses. If the
  /// direction is little more than rounding, the angle may be arbitrary; then the ray itself may approach the corners.
  RayVerdict reach(const Vec<3, double>& direction, Vec<3, double>& corner) const {
    corner = corners_.farthest(direction);
    const double height = dot(direction, corner);
    if (height > 0) return RayVerdict::hits;
    const double lowest_of_ray = std::min(0.0, dot(direction, path_.direction)) * past_;
    return height < lowest_of_ray - band_ * sum_abs(direction) ? RayVerdict::misses : RayVerdict::unclear;
  }

  /// Any portal. Two corners have the ray on their left; the farthest on that side completes the portal, or replaces
  /// one of the two.
  RayVerdict find(Portal& portal) const {
    auto& [a, b, c] = portal;
    RayVerdict verdict = reach(towards_ray((box_.min + box_.max) * 0.5), a);
    if (verdict == RayVerdict::misses) return verdict;
    verdict = reach(towards_ray(a), b);
    if (verdict != RayVerdict::hits) return verdict;
    if (area(a, b) < 0) std::swap(a, b);
    for (int step = 0; step < portal_step_limit; ++step) {
      verdict = reach(cross(path_.direction, b - a), c);
      if (verdict != RayVerdict::hits) return verdict;
      if (area(b, c) < 0) {
        a = c;
      } else if (area(c, a) < 0) {
        b = c;
      } else {
        return RayVerdict::hits;
      }
    }
    return RayVerdict::unclear;
  }

  std::optional<RayFinding<3>> enter(Portal portal) const {
    auto& [a, b, c] = portal;
    for (int step = 0; step < portal_step_limit; ++step) {
      const Vec<3, double> normal = portal.normal();
      const Vec<3, double> corner = corners_.farthest(normal);
      const double slack = tolerance::rounding * size_ * max_abs(normal);
      if (dot(normal, corner - a) <= slack) {
        const bool is_flat = dot(normal, corner - b) <= slack && dot(normal, corner - c) <= slack;
        return is_flat ? passage(portal, normal) : std::nullopt;
      }
      if (corner == a || corner == b || corner == c) return std::nullopt;
      const double beside_a = area(a, corner);
      const double beside_b = area(b, corner);
      if (beside_a <= 0 && beside_b >= 0) {
        c = corner;
      } else if (beside_b <= 0 && area(c, corner) >= 0) {
        a = corner;
      } else {
        b = corner;
      }
    }
    return std::nullopt;
  }

  /// The ray through a triangle of the polytope that no corner rises above by more than tolerance::rounding of the
  /// size; the rounding of heights, t and the point is as much again. The end of the path is decided as for triangles,
  /// whose steepness makes end_slack the same distance from the plane.
  std::optional<RayFinding<3>> passage(const Portal& portal, const Vec<3, double>& normal) const {
    const auto& [origin, direction, t_max, far] = path_;
    const TriangleBesidePath beside({portal.a, portal.b, portal.c}, {Vec<3, double>(0.0), direction, t_max, size_});
    const bool is_inside = beside.least > beside.band;
    const double climb = dot(normal, direction);
    constexpr double least_sine_squared = 0x1p-20;
    const bool is_steep = climb * climb > least_sine_squared * (dot(normal, normal) * dot(direction, direction));
    if (!is_inside || !is_steep || climb > 0) return std::nullopt;
    const double t = dot(normal, portal.a) / climb;
    const double end_slack = 0x1p10 * tolerance::ray_side * size_ / max_abs(direction);
    if (t > t_max + end_slack) return missed<3>();
    if (!(t > -end_slack)) return std::nullopt;
    RayFinding<3> result{t > end_slack && t < t_max - end_slack ? RayVerdict::hits : RayVerdict::unclear, {}};
    result.hit.t = std::clamp(t, 0.0, t_max);
    result.hit.point = origin + direction * result.hit.t;
    result.hit.normal = normal;
    result.hit.error = 2 * tolerance::rounding * size_;
    return result;
  }

  const Corners& corners_;
  const Path<3>& path_;
  Aabb<3, double> box_;  ///< From the path's origin.
  double size_;          ///< No coordinates, of corners and path, have a larger sum.
  double band_;          ///< What `relation` may call touching.
  double past_;          ///< The t at which the ray is past everything.
};

/// Where a path enters a 3D polytope.
template <class T>
RayFinding<3> ray_verdict_of_polytope(const Polytope<3, T>& polytope, const Path<3>& path) {
  std::optional<RayFinding<3>> result;
  if (polytope.vertices().size() <= CornersInFrame::room) {
    result = PortalSearch(CornersInFrame(polytope.vertices(), path.origin), path).finding();
  } else {
    result = PortalSearch(CornersInPlace(polytope, path.origin), path).finding();
  }
  return result ? *result : advance_to(polytope, path);
}

}  // namespace graze::detail
