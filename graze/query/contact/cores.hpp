// SPDX-License-Identifier: MIT
// The closed forms of contact.hpp: shapes whose cores are points, segments, rays, boxes and triangles. Include
// contact.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact/boxes.hpp>
#include <graze/query/cores/closest.hpp>
#include <graze/query/cores/features.hpp>
#include <graze/query/cores/penetration.hpp>
#include <graze/query/cores/separating_axis.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

// ---- Rays with bounded shapes

/// A ray truncated so far away that no depth changes. With the other shape's points within R of the ray's origin, a
/// direction u at the angle t to the plane perpendicular to the ray has the depth h(u) + L sin t, where h is the depth
/// of the origin alone; and the projected direction v in that plane has no more, if L >= 2 R >= h(v) + R.
template <Dim N, class T, class S>
Segment<N, double> cut_for_depth(const Ray<N, T>& ray, const S& other) {
  const Vec<N, double> origin = wide<N, T>(ray.origin);
  const Vec<N, double> reach = reach_to(ray, bounds(other)) * 2.0;  // 2.5 R
  return {origin, origin + (max_abs(reach) > 0 ? reach : wide<N, T>(ray.direction))};
}

/// A core in double, relative to a point near the pair.
template <class Core, class Other>
auto seen_whole(const Vec<dimension_of<Core>, double>& origin, const Core& core, const Other& other) {
  if constexpr (is_ray<Core>) {
    constexpr Dim N = dimension_of<Core>;
    const Ray<N, double> seen{reference(core) - origin, wide<N, scalar_of<Core>>(core.direction)};
    return cut_for_depth(seen, relative_to(origin, other));
  } else {
    return relative_to(origin, core);
  }
}

// ---- Overlapping cores, and cores that are apart by less than their radii

/// The answer for shapes whose cores are separated by an axis, given the points of the cores.
template <Dim N>
Penetration<N> widened_along(const SeparatingAxis<N>& axis, const ClosestPair<N>& cores, const Radii& radii) {
  Penetration<N> result;
  const double depth = (radii.a + radii.b) - axis.gap;
  result.normal = axis.normal;
  result.depth = std::max(0.0, depth);
  result.point_a = cores.on_a + axis.normal * radii.a;
  result.point_b = cores.on_b - axis.normal * radii.b;
  result.error = std::max(0.0, -depth);
  return result;
}

/// A gap that remains between the points after the move is an error of the depth: cores that are taken to overlap may
/// be apart, by rounding, in a direction other than the axis.
template <class A, class B>
Penetration<dimension_of<A>> penetration_of_meeting(const A& a, const B& b, double size, const Radii& radii) {
  SeparatingAxisSearch<A, B> search(a, b, size);
  offer_faces(a, b, search);
  const ClosestPair<dimension_of<A>> pair = points_along(a, b, search.best(), size);
  Penetration<dimension_of<A>> result = widened_along(search.best(), pair, radii);
  result.error += std::sqrt(pair.squared);
  return result;
}

/// Offers a direction, made exactly perpendicular to each edge that it is almost perpendicular to.
template <class A, class B, class Core>
void offer_straightened(const Vec<dimension_of<A>, double>& direction, const Core& core,
                        SeparatingAxisSearch<A, B>& search) {
  for (const auto& edge : edge_directions(core)) {
    const auto scaled = edge / std::max(max_abs(edge), std::numeric_limits<double>::min());
    if (max_abs(scaled) > 0) search.offer(straightened(direction, scaled));
  }
}

/// Separate cores have their depth along the vector between the nearest points. If that is so short that rounding
/// rotates it, the faces' own normals, and what is perpendicular to the nearest edges, are more accurate.
template <class A, class B>
Penetration<dimension_of<A>> penetration_of_apart(const A& a, const B& b, double size, const Radii& radii) {
  constexpr Dim N = dimension_of<A>;
  const ClosestPair<N> cores = closest_of_apart(a, b, size);
  const double distance = std::sqrt(cores.squared);
  const SeparatingAxis<N> between{unit_or(cores.between, unit_axis<N>(0)), distance};
  if (distance > tolerance::known_direction * size) return widened_along(between, cores, radii);
  SeparatingAxisSearch<A, B> search(a, b, size);
  search.offer(between.normal);
  offer_straightened(between.normal, a, search);
  offer_straightened(between.normal, b, search);
  offer_faces(a, b, search);
  Penetration<N> result = widened_along(search.best(), cores, radii);
  const Vec<N, double> rest = cores.between - search.best().normal * search.best().gap;
  result.error += std::sqrt(dot(rest, rest));
  return result;
}

template <class S>
inline constexpr bool is_box = is_a<Aabb, S> || is_a<Obb, S>;

/// Two boxes, at most one of them an AABB.
template <class A, class B>
inline constexpr bool are_boxes = is_box<A>&& is_box<B> && !(is_a<Aabb, A> && is_a<Aabb, B>);

template <class A, class B>
requires are_boxes<A, B> Penetration<dimension_of<A>> penetration_of_simple(const A& a, const B& b) {
  const Vec<dimension_of<A>, double> origin = reference(a);
  return moved_by(penetration_of_boxes(relative_to(origin, a), relative_to(origin, b)), origin);
}

template <HasSimpleCore A, HasSimpleCore B>
requires(!are_boxes<A, B>) Penetration<dimension_of<A>> penetration_of_simple(const A& a, const B& b) {
  const auto& core_a = core(a);
  const auto& core_b = core(b);
  const Radii radii{core_radius(a), core_radius(b)};
  const Vec<dimension_of<A>, double> origin = reference(core_a);
  const auto local_a = seen_whole(origin, core_a, core_b);
  const auto local_b = seen_whole(origin, core_b, core_a);
  const double size = size_around_zero(local_a) + size_around_zero(local_b);
  const bool has_radius = radii.a > 0 || radii.b > 0;
  const bool are_apart = has_radius && decide(core_a, core_b) == Relation::apart;
  Penetration<dimension_of<A>> result = are_apart ? penetration_of_apart(local_a, local_b, size, radii)
                                                  : penetration_of_meeting(local_a, local_b, size, radii);
  result.error += 2 * tolerance::rounding * (size + (radii.a + radii.b));  // of the gap, and of the search's preference
  return moved_by(result, origin);
}

/// For AABBs, depths are differences of stored coordinates, and the points are in the middle of the common part of the
/// faces.
template <Dim N, class T>
Penetration<N> penetration_of_simple(const Aabb<N, T>& a, const Aabb<N, T>& b) {
  const Vec<N, double> zero(0.0);
  const Aabb<N, double> box_a = relative_to(zero, a);
  const Aabb<N, double> box_b = relative_to(zero, b);
  Penetration<N> result;
  result.depth = std::numeric_limits<double>::infinity();
  Dim axis = 0;
  for (Dim i = 0; i < N; ++i) {
    const double ahead = box_a.max[i] - box_b.min[i];
    const double behind = box_b.max[i] - box_a.min[i];
    const double depth = std::min(ahead, behind);
    if (!(depth < result.depth)) continue;
    axis = i;
    result.depth = depth;
    result.normal = unit_axis<N>(i) * (ahead <= behind ? 1.0 : -1.0);
  }
  result.point_a = result.point_b = closest_of_boxes(box_a, box_b).on_a;
  const bool is_ahead = result.normal[axis] > 0;
  result.point_a[axis] = is_ahead ? box_a.max[axis] : box_a.min[axis];
  result.point_b[axis] = is_ahead ? box_b.min[axis] : box_b.max[axis];
  result.error = tolerance::epsilon * result.depth;
  return result;
}

}  // namespace graze::detail
