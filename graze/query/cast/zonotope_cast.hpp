// SPDX-License-Identifier: MIT
// The closed form of shape_cast.hpp for all pairs of boxes, capsules and spheres without a simpler one: two zonotopes
// of which one moves, a box or a segment each, inflated by radii. Include shape_cast.hpp.
//
// Their Minkowski difference is a zonotope with rounded edges. The last of its faces' planes to be crossed gives the
// hit if the point is on the face there; otherwise one of the face's edges, as a tube, or one of its corners, as a
// sphere, does. A result is used only with a proof: the two points that it names are at the right distance, and the
// plane between them separates the shapes. So not all edges need be tried; what is not found, or nearly touches, is
// unclear, and left to GJK.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/cast/zonotope_slabs.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/convex/zonotope.hpp>
#include <graze/query/cores/closest.hpp>
#include <graze/query/cores/touching_points.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/ray/verdict.hpp>

namespace graze::detail {

/// Where a point that moves from zero touches a rounded zonotope.
template <Dim N, std::size_t Edges>
struct HitOfZonotope {
  double t = 0;
  Vec<N, double> normal = Vec<N, double>(0.0);  ///< Unit vector, along the motion.
  std::array<double, Edges> places{};           ///< On each half edge, from -1 to 1.
  double error = 0;
};

template <Dim N, std::size_t Edges>
struct RayVerdictOfZonotope {
  RayVerdict verdict = RayVerdict::unclear;
  HitOfZonotope<N, Edges> hit{};
  bool are_places_known = true;  ///< False on a face with edges in more than two directions.
};

/// The part of the zonotope in one supporting plane: the edges along it, with parallel ones added up, and those that
/// end there.
template <Dim N, std::size_t Edges>
struct FaceOfZonotope {
  static constexpr std::size_t none = N;

  std::array<double, Edges> places{};  ///< Of an edge in a group: its orientation relative to the group's sum, 1 or -1.
  std::array<std::size_t, Edges> group{};
  std::array<Vec<N, double>, static_cast<std::size_t>(N)> sums{};
  std::size_t groups = 0;

  /// The middle of the face.
  Vec<N, double> middle(const RoundedZonotope<N, Edges>& solid) const {
    Vec<N, double> result = solid.center;
    for (std::size_t k = 0; k < Edges; ++k) {
      if (group[k] == none) result += solid.half_edges[k] * places[k];
    }
    return result;
  }

  /// The part of the face where one group is at a position: the edge there, or the corner.
  FaceOfZonotope at(std::size_t index, double place) const {
    FaceOfZonotope result = *this;
    for (std::size_t k = 0; k < Edges; ++k) {
      if (group[k] == none || group[k] < index) continue;
      if (group[k] == index) {
        result.places[k] = places[k] * place;
        result.group[k] = none;
      } else {
        result.group[k] = group[k] - 1;
      }
    }
    for (std::size_t g = index; g + 1 < groups; ++g) result.sums[g] = sums[g + 1];
    result.groups = groups - 1;
    return result;
  }
};

/// The face with the lowest points along a unit normal. More than N - 1 groups are too many to determine positions.
template <Dim N, std::size_t Edges>
FaceOfZonotope<N, Edges> lowest_face(const RoundedZonotope<N, Edges>& solid, const Vec<N, double>& normal,
                                     double size) {
  const double tie = tolerance::rounding * size;
  FaceOfZonotope<N, Edges> face;
  for (std::size_t k = 0; k < Edges; ++k) {
    const Vec<N, double>& edge = solid.half_edges[k];
    const double climb = dot(normal, edge);
    face.group[k] = FaceOfZonotope<N, Edges>::none;
    face.places[k] = climb > 0 ? -1 : 1;
    if (std::fabs(climb) > tie || max_abs(edge) <= tie) continue;
    std::size_t g = 0;
    while (g < face.groups) {
      const Vec<3, double> product = cross(lifted(edge), lifted(face.sums[g]));
      if (max_abs(product) <= tie * max_abs(face.sums[g])) break;
      ++g;
    }
    if (g == face.sums.size()) continue;  // too many anyway
    face.places[k] = g < face.groups && dot(edge, face.sums[g]) < 0 ? -1 : 1;
    face.sums[g] += edge * face.places[k];
    face.group[k] = g;
    face.groups = std::max(face.groups, g + 1);
  }
  return face;
}

/// A point that moves from zero to a rounded zonotope.
template <Dim N, std::size_t Edges>
class ZonotopeCast {
 public:
  using Solid = RoundedZonotope<N, Edges>;
  using Face = FaceOfZonotope<N, Edges>;
  using Result = RayVerdictOfZonotope<N, Edges>;

  ZonotopeCast(const Solid& solid, const Vec<N, double>& motion)
      : solid_(solid), motion_(motion), size_(size_of(solid)), margin_(tolerance::ray_side * size_) {}

  Result run() const {
    const bool is_usual = size_ > 0x1p-100 && size_ < 0x1p100 && is_usable(motion_);
    if (!is_usual) return {};
    AxisTimes<N> times(solid_.center, motion_, solid_.radius, size_);
    add_axes(solid_, motion_, times);
    if (times.are_missed()) return missed();
    if (!times.are_entered()) return {};
    const double length = std::sqrt(dot(times.normal(), times.normal()));
    return at_plane(times.enter(), times.normal() / length);  // an axis is not zero
  }

 private:
  static Result missed() { return {RayVerdict::misses}; }

  /// The result at the last plane to be crossed.
  Result at_plane(double t, const Vec<N, double>& normal) const {
    const Face face = lowest_face(solid_, normal, size_);
    if (face.groups >= static_cast<std::size_t>(N)) return {RayVerdict::unclear, {t, normal}, !is_on_way(t, normal)};
    if (face.groups == 0) return at_corner(face);
    const Vec<N, double> place = motion_ * t + normal * solid_.radius - face.middle(solid_);
    if constexpr (N == 3) {
      if (face.groups == 1) return at_edge(face);
      const Vec<3, double> whole = cross(face.sums[0], face.sums[1]);
      const double squared = dot(whole, whole);
      const double first = dot(cross(place, face.sums[1]), whole) / squared;
      const double second = dot(cross(face.sums[0], place), whole) / squared;
      if (solid_.radius == 0 || (std::fabs(first) <= 1 && std::fabs(second) <= 1)) {
        return proved(t, normal, face.at(1, clamped(second)).at(0, clamped(first)));
      }
      return at_edges_of(face, first, second);
    } else {
      const double share = dot(place, face.sums[0]) / dot(face.sums[0], face.sums[0]);
      if (solid_.radius == 0 || std::fabs(share) <= 1) return proved(t, normal, face.at(0, clamped(share)));
      return at_corner(face.at(0, clamped(share)));
    }
  }

  static double clamped(double share) { return std::min(std::max(share, -1.0), 1.0); }

  /// Beside the face, by this many of its half edges: tries the edge that it is farther beside, and then the other.
  Result at_edges_of(const Face& face, double first, double second) const {
    const double beside_first = (std::fabs(first) - 1) * sum_abs(face.sums[0]);
    const double beside_second = (std::fabs(second) - 1) * sum_abs(face.sums[1]);
    const Result nearer =
        beside_first >= beside_second ? at_edge(face.at(0, clamped(first))) : at_edge(face.at(1, clamped(second)));
    if (nearer.verdict != RayVerdict::unclear || std::min(beside_first, beside_second) < 0) return nearer;
    return beside_first >= beside_second ? at_edge(face.at(1, clamped(second))) : at_edge(face.at(0, clamped(first)));
  }

  /// On the tube around an edge, projected along it, if that is between the edge's ends.
  Result at_edge(const Face& edge) const {
    const Vec<N, double>& along = edge.sums[0];
    const double whole = dot(along, along);
    const Vec<N, double> middle = edge.middle(solid_);
    const auto across = [&](const Vec<N, double>& v) { return v - along * (dot(v, along) / whole); };
    const Vec<N, double> motion_across = across(motion_);
    if (!(dot(motion_across, motion_across) > tolerance::ray_side * dot(motion_, motion_))) {
      return at_corner(edge.at(0, dot(motion_, along) > 0 ? -1 : 1));
    }
    const SpherePassage<N> tube(motion_across, across(middle), solid_.radius * solid_.radius);
    const double band = tolerance::ray_filter * size_ * size_;
    if (tube.depth < -band) return passed(tube.off);
    if (!(tube.depth > band)) return {};
    if (tube.enter() < 0) return passed(across(middle));
    const double share = dot(motion_ * tube.enter() - middle, along) / whole;
    if (std::fabs(share) > 1) return at_corner(edge.at(0, clamped(share)));
    return proved(tube.enter(), normal_of(tube.spoke(motion_across)), edge.at(0, share));
  }

  Result at_corner(const Face& corner) const {
    const Vec<N, double> center = corner.middle(solid_);
    const SpherePassage<N> sphere(motion_, center, solid_.radius * solid_.radius);
    const double band = tolerance::ray_filter * size_ * size_;
    if (sphere.depth < -band) return passed(sphere.off);
    if (!(sphere.depth > band)) return {};
    if (sphere.enter() < 0) return passed(center);
    return proved(sphere.enter(), normal_of(sphere.spoke(motion_)), corner);
  }

  /// Towards the set, from a radius vector of the tube or the sphere, whose length is about the radius.
  static Vec<N, double> normal_of(const Vec<N, double>& spoke) { return spoke / -std::sqrt(dot(spoke, spoke)); }

  /// The distance of the whole set along a unit normal from the point's position at t.
  double height_at(double t, const Vec<N, double>& normal) const {
    return dot(normal, solid_.center - motion_ * t) - reach_along(solid_, normal) - solid_.radius;
  }

  /// Missed if the set is beyond a plane perpendicular to this nonzero vector all the time.
  Result passed(const Vec<N, double>& off) const {
    const Vec<N, double> normal = off / std::sqrt(dot(off, off));
    return std::min(height_at(0, normal), height_at(1, normal)) > margin_ ? missed() : Result{};
  }

  /// Whether the set comes nearer by more than the margin before t, and would after it until the end.
  bool is_on_way(double t, const Vec<N, double>& normal) const {
    return std::min(t, 1 - t) * dot(normal, motion_) > margin_;
  }

  /// The hit if it is proved: the zonotope's point at the positions is at the right distance, so the set is no farther;
  /// and the plane there has all of it on the other side, so it is no nearer, and was not before.
  Result proved(double t, const Vec<N, double>& normal, const Face& corner) const {
    if (t > 1 && height_at(1, normal) > margin_) return missed();
    if (!is_on_way(t, normal)) return {};
    const Vec<N, double> miss = motion_ * t + normal * solid_.radius - corner.middle(solid_);
    const double error = std::max(std::sqrt(dot(miss, miss)), -height_at(t, normal));
    if (!(error <= tolerance::rounding * size_)) return {};
    return {RayVerdict::hits, {t, normal, corner.places, error + tolerance::rounding * size_}, true};
  }

  const Solid& solid_;
  const Vec<N, double>& motion_;
  double size_;
  double margin_;
};

/// The closed form's result for two cores, inflated by radii: the hit, if any.
template <Dim N>
struct CastHitOfZonotopes {
  RayVerdict verdict = RayVerdict::unclear;
  CastHit<N> cast_hit{};
};

/// A core that is a zonotope.
template <class Core>
concept HasZonotope = requires(const Core& core) {
  zonotope(core);
};

/// On a face with edges in several directions, where both cores lie flat, the time is known and the point is searched.
template <class A, class B, std::size_t Edges>
CastHitOfZonotopes<dimension_of<A>> cast_hit_of_flat(const A& a, const Vec<dimension_of<A>, double>& motion, const B& b,
                                                     const Radii& radii,
                                                     const HitOfZonotope<dimension_of<A>, Edges>& hit) {
  constexpr Dim N = dimension_of<A>;
  const auto moved_a = relative_to(motion * -hit.t, a);
  const double size = size_around_zero(moved_a) + size_around_zero(b);
  const Vec<N, double> gap = hit.normal * (radii.a + radii.b);
  const ClosestPair<N> nearest = closest_of_touching(relative_to(-gap, moved_a), b, hit.normal, size);
  const double error = std::sqrt(nearest.squared);
  if (!(error <= tolerance::rounding * size)) return {};
  const double rounding = tolerance::rounding * (size + radii.a + radii.b + sum_abs(motion));
  return {RayVerdict::hits,
          {hit.t, nearest.on_b - hit.normal * radii.b, hit.normal, Status::converged, error + rounding}};
}

/// For a core a that moves along `motion`, not zero, from a position apart from b.
template <HasZonotope A, HasZonotope B>
CastHitOfZonotopes<dimension_of<A>> cast_hit_of_zonotopes(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                          const B& b, const Radii& radii) {
  constexpr Dim N = dimension_of<A>;
  const auto zonotope_a = zonotope(a);
  const auto zonotope_b = zonotope(b);
  const auto solid = difference_of(zonotope_a, zonotope_b, radii.a + radii.b);
  const auto found = ZonotopeCast(solid, motion).run();
  if (!found.are_places_known) return cast_hit_of_flat(a, motion, b, radii, found.hit);
  if (found.verdict != RayVerdict::hits) return {found.verdict};
  Vec<N, double> on_b = zonotope_b.reference + zonotope_b.to_center;
  const std::size_t edges_of_a = zonotope_a.half_edges.size();
  for (std::size_t k = 0; k < zonotope_b.half_edges.size(); ++k) {
    on_b += zonotope_b.half_edges[k] * found.hit.places[edges_of_a + k];
  }
  const double error = found.hit.error + tolerance::rounding * sum_abs(motion);
  return {RayVerdict::hits,
          {found.hit.t, on_b - found.hit.normal * radii.b, found.hit.normal, Status::converged, error}};
}

}  // namespace graze::detail
