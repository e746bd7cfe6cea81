// SPDX-License-Identifier: MIT
// The closed forms of relation.hpp for triangles. Include relation.hpp.
//
// Every pair is decided in two stages. The fast one calculates plainly; its verdict is certain, or it has none. The
// precise one, for the remaining pairs, calculates accurately, on corners that it has sorted: so a verdict never
// depends on the order of arguments or corners.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/query/relation/triangle_axes.hpp>
#include <graze/query/relation/triangle_filter.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/fields/nan_check.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/sphere.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

// ---- The precise stage: the accurate axes and, if these find the pair neither apart nor deep, the distance.

template <Dim N>
bool is_before(const Vec<N, double>& p, const Vec<N, double>& q) {
  for (Dim i = 0; i < N; ++i) {
    if (p[i] != q[i]) return p[i] < q[i];
  }
  return false;
}

/// The same triangle for any order of its corners.
template <Dim N>
Triangle<N, double> sorted(Triangle<N, double> triangle) {
  if (is_before(triangle.b, triangle.a)) std::swap(triangle.a, triangle.b);
  if (is_before(triangle.c, triangle.b)) std::swap(triangle.b, triangle.c);
  if (is_before(triangle.b, triangle.a)) std::swap(triangle.a, triangle.b);
  return triangle;
}

template <Dim N>
Triangle<N, double> canonical(const Triangle<N, double>& triangle, double factor) {
  return sorted<N>({triangle.a * factor, triangle.b * factor, triangle.c * factor});
}

template <Dim N>
Segment<N, double> canonical(const Segment<N, double>& segment, double factor) {
  return {segment.start * factor, segment.end * factor};
}

template <Dim N>
Aabb<N, double> canonical(const Aabb<N, double>& box, double factor) {
  return {box.min * factor, box.max * factor};
}

template <Dim N>
Obb<N, double> canonical(const Obb<N, double>& box, double factor) {
  return {box.center, box.half_extents * factor, box.axes};
}

template <Dim N>
bool is_within(double distance, const Segment<N, double>& segment, const Triangle<N, double>& triangle) {
  return distance_squared(segment, triangle) <= distance * distance;
}

template <Dim N>
std::array<Segment<N, double>, 3> sides(const Triangle<N, double>& triangle) {
  return {{{triangle.a, triangle.b}, {triangle.b, triangle.c}, {triangle.c, triangle.a}}};
}

/// The nearest points of disjoint solids are a corner of one and a point of the other, or on two edges.
template <Dim N>
bool is_within(double distance, const Triangle<N, double>& a, const Triangle<N, double>& b) {
  const double squared = distance * distance;
  for (const Vec<N, double>& corner : a.vertices()) {
    if (distance_squared(corner, b) <= squared) return true;
  }
  for (const Vec<N, double>& corner : b.vertices()) {
    if (distance_squared(corner, a) <= squared) return true;
  }
  for (const Segment<N, double>& side_a : sides(a)) {
    for (const Segment<N, double>& side_b : sides(b)) {
      if (distance_squared(side_a, side_b) <= squared) return true;
    }
  }
  return false;
}

/// Corner number k is the one on the far side of axis i if bit i of k is set.
template <Dim N>
std::array<Vec<N, double>, std::size_t{1} << N> corners_of(const Mat<N, double>& half_edges) {
  std::array<Vec<N, double>, std::size_t{1} << N> corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    corners[k] = Vec<N, double>(0.0);
    for (Dim i = 0; i < N; ++i) corners[k] += (k >> i & 1U) != 0 ? half_edges[i] : -half_edges[i];
  }
  return corners;
}

/// The same for a box around zero.
template <Dim N, class Box>
bool is_box_within(double distance, const Box& box, const Mat<N, double>& half_edges,
                   const Triangle<N, double>& triangle) {
  const double squared = distance * distance;
  const auto corners = corners_of<N>(half_edges);
  for (const Vec<N, double>& corner : triangle.vertices()) {
    if (distance_squared(corner, box) <= squared) return true;
  }
  for (const Vec<N, double>& corner : corners) {
    if (distance_squared(corner, triangle) <= squared) return true;
  }
  for (const Segment<N, double>& side : sides(triangle)) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      for (Dim i = 0; i < N; ++i) {
        if ((k >> i & 1U) != 0) continue;
        const Segment<N, double> edge{corners[k], corners[k | std::size_t{1} << i]};
        if (distance_squared(edge, side) <= squared) return true;
      }
    }
  }
  return false;
}

template <Dim N>
bool is_within(double distance, const Aabb<N, double>& box, const Triangle<N, double>& triangle) {
  return is_box_within<N>(distance, box, half_edges(oriented(box)), triangle);
}

template <Dim N>
bool is_within(double distance, const Obb<N, double>& box, const Triangle<N, double>& triangle) {
  return is_box_within<N>(distance, box, half_edges(box), triangle);
}

template <Dim N, class S>
Relation careful_verdict(const S& other, const Triangle<N, double>& triangle, double extent) {
  const double slack = 2 * tolerance::rounding * extent;
  const Relation along_axes = AccurateAxes<N, S>(other, triangle, slack).verdict();
  if (along_axes != Relation::touching) return along_axes;
  // A slack of depth along a unit axis, measured by the sum of coordinates, is a depth of at most sqrt(3) slack.
  return is_within(2 * slack, other, triangle) ? Relation::touching : Relation::apart;
}

// ---- Both stages

/// Products of four sizes stay in the range of double.
constexpr bool is_of_moderate_size(double extent) { return extent > 0x1p-200 && extent < 0x1p200; }

template <Dim N, class S>
std::optional<Relation> quick_verdict(const S& other, const Triangle<N, double>& triangle, double extent) {
  if constexpr (N == 2) {
    const Relation along_axes = AccurateAxes<2, S>(other, triangle, 2 * tolerance::rounding * extent).verdict();
    return along_axes == Relation::touching ? std::nullopt : std::optional(along_axes);
  } else {
    return QuickAxes<S>(other, triangle, tolerance::coarse * extent).verdict();
  }
}

/// For a pair relative to a point near both; segments and boxes are centered at zero. `rescaled()` is called first if
/// the pair is not of usual size.
template <Dim N, class S, class Rescaled>
Relation relation_in_frame(const S& other, const Triangle<N, double>& triangle, const Rescaled& rescaled) {
  const double extent = std::max(extent_around_zero(other), extent_around_zero(triangle));
  if (is_of_moderate_size(extent)) {
    const std::optional<Relation> quick = quick_verdict<N>(other, triangle, extent);
    if (quick) return *quick;
  } else if (const std::optional<Relation> verdict = rescaled()) {
    return *verdict;
  }
  if (!std::isfinite(extent)) return Relation::apart;
  if (extent == 0) return Relation::touching;
  const double to_unit_size = std::ldexp(1.0, -std::ilogb(extent));
  return careful_verdict<N>(canonical(other, to_unit_size), canonical(triangle, to_unit_size), extent * to_unit_size);
}

template <Dim N, class T>
Triangle<N, double> local_triangle(const Vec<N, double>& reference, const Vec<N, double>& to_center,
                                   const Triangle<N, T>& triangle) {
  return {(wide<N, T>(triangle.a) - reference) - to_center, (wide<N, T>(triangle.b) - reference) - to_center,
          (wide<N, T>(triangle.c) - reference) - to_center};
}

// ---- A triangle and a widened point or segment centered at zero

/// The point of the triangle nearest to zero or, due to rounding, another of its points. Ericson, Real-Time Collision
/// Detection, 5.1.5. NaN for some degenerate triangles: a quotient 0 / 0.
template <Dim N>
Vec<N, double> nearest_to_zero(const Triangle<N, double>& triangle) {
  const Vec<N, double>& a = triangle.a;
  const Vec<N, double> ab = triangle.b - a;
  const Vec<N, double> ac = triangle.c - a;
  const double d1 = -dot(ab, a);
  const double d2 = -dot(ac, a);
  if (d1 <= 0 && d2 <= 0) return a;
  const double d3 = -dot(ab, triangle.b);
  const double d4 = -dot(ac, triangle.b);
  if (d3 >= 0 && d4 <= d3) return triangle.b;
  const double area_c = d1 * d4 - d3 * d2;
  if (area_c <= 0 && d1 >= 0 && d3 <= 0) return a + ab * (d1 / (d1 - d3));
  const double d5 = -dot(ab, triangle.c);
  const double d6 = -dot(ac, triangle.c);
  if (d6 >= 0 && d5 <= d6) return triangle.c;
  const double area_b = d5 * d2 - d1 * d6;
  if (area_b <= 0 && d2 >= 0 && d6 <= 0) return a + ac * (d2 / (d2 - d6));
  const double area_a = d3 * d6 - d5 * d4;
  const double past_b = d4 - d3;
  const double past_c = d5 - d6;
  if (area_a <= 0 && past_b >= 0 && past_c >= 0) {
    return triangle.b + (triangle.c - triangle.b) * (past_b / (past_b + past_c));
  }
  return a + (ab * area_b + ac * area_c) / (area_a + area_b + area_c);
}

template <Dim N>
double reach_along(const Vec<N, double>&, Dim) {
  return 0;
}

template <Dim N>
double reach_along(const Segment<N, double>& core, Dim i) {
  return std::fabs(core.end[i]);
}

template <Dim N>
Vec<N, double> nearest_on(const Vec<N, double>& core, const Vec<N, double>&) {
  return core;
}

template <Dim N>
Vec<N, double> nearest_on(const Segment<N, double>& core, const Vec<N, double>& point) {
  const double along = dot(point, core.end);
  const double whole = dot(core.end, core.end);
  if (std::fabs(along) >= whole) return along < 0 ? core.start : core.end;
  return core.end * (along / whole);  // whole > |along| >= 0
}

/// The largest gap along a coordinate axis.
template <Dim N, class Core>
double gap_between_boxes(const Core& core, const Triangle<N, double>& triangle) {
  const Vec<N, double> low = min(min(triangle.a, triangle.b), triangle.c);
  const Vec<N, double> high = max(max(triangle.a, triangle.b), triangle.c);
  double gap = -std::numeric_limits<double>::infinity();
  for (Dim i = 0; i < N; ++i) gap = std::max(gap, std::max(low[i], -high[i]) - reach_along(core, i));
  return gap;
}

/// Certain, or none. A point of each core near the other bounds the distance from above. The direction between them
/// bounds it from below: however it was found, the cores are at least as far apart as their projections onto it. A few
/// steps from one core to the nearest point of the other leave few pairs undecided.
template <Dim N, class Core>
std::optional<Relation> quick_verdict_on_distance(const Core& core, const Triangle<N, double>& triangle, double near,
                                                  double far) {
  if (gap_between_boxes(core, triangle) > far) return Relation::apart;
  constexpr int steps = std::is_same_v<Core, Vec<N, double>> ? 1 : 3;
  Vec<N, double> on_core(0.0);
  for (int step = 0; step < steps; ++step) {
    const Vec<N, double> to_triangle =
        nearest_to_zero<N>({triangle.a - on_core, triangle.b - on_core, triangle.c - on_core});
    const Vec<N, double> on_triangle = on_core + to_triangle;
    on_core = nearest_on(core, on_triangle);
    const Vec<N, double> between = on_triangle - on_core;
    const double squared = dot(between, between);
    if (near > 0 && squared < near * near) return Relation::overlapping;
    const double gap = projection_on(between, triangle).low - projection_on(between, core).high;
    if (gap > 0 && gap * gap > far * far * squared) return Relation::apart;
  }
  return std::nullopt;
}

/// The relation of a triangle and a core centered at zero that is widened by `reach`. If rounding hides whether they
/// touch, `relation_of_cores` decides, as in bounded.hpp. `rescaled()` as above.
template <Dim N, class Core, class RelationOfCores, class Rescaled>
Relation relation_to_widened(const Core& core, const Triangle<N, double>& triangle, double reach,
                             const RelationOfCores& relation_of_cores, const Rescaled& rescaled) {
  const double extent = std::max(extent_around_zero(core), extent_around_zero(triangle));
  const double slack = 2 * tolerance::rounding * (extent + reach);
  if (is_of_moderate_size(extent + reach)) {
    const auto quick = quick_verdict_on_distance<N>(core, triangle, reach - 4 * slack, reach + 4 * slack);
    if (quick) return *quick;
  } else if (const std::optional<Relation> verdict = rescaled()) {
    return *verdict;
  }
  const Relation verdict = verdict_on_distance(distance_squared(core, sorted(triangle)), reach, slack);
  if (verdict == Relation::touching && relation_of_cores() == Relation::overlapping) return Relation::overlapping;
  return verdict;
}

// ---- The pairs

template <Dim N, class T>
Aabb<N, T> box_around(const Segment<N, T>& segment) {
  return {min(segment.start, segment.end), max(segment.start, segment.end)};
}

template <Dim N, class T>
Aabb<N, T> box_around(const Triangle<N, T>& triangle) {
  return {min(min(triangle.a, triangle.b), triangle.c), max(max(triangle.a, triangle.b), triangle.c)};
}

template <class T>
Corners3 wide_corners(const Triangle<3, T>& triangle) {
  return {wide<3, T>(triangle.a), wide<3, T>(triangle.b), wide<3, T>(triangle.c)};
}

inline std::optional<Relation> filter_of_sized(const Corners3& a, const Corners3& b, const SizesOfPair& sizes) {
  return filter_of_triangles(a, b, sizes);
}
inline std::optional<Relation> filter_of_sized(const Corners3& a, const Segment<3, double>& b,
                                               const SizesOfPair& sizes) {
  return filter_of_triangle_and_segment(a, b.start, b.end, sizes);
}

template <class T>
Segment<3, double> wide_corners(const Segment<3, T>& segment) {
  return {wide<3, T>(segment.start), wide<3, T>(segment.end)};
}

/// The fast verdict in 3D, from differences of corners. Disjoint bounding boxes are decided exactly.
template <class T, class S>
std::optional<Relation> filter_of_corners(const Triangle<3, T>& triangle, const S& other) {
  const Aabb<3, T> box = box_around(triangle);
  const Aabb<3, T> other_box = box_around(other);
  if (!boxes_overlap(box, other_box)) return Relation::apart;
  const Vec<3, double> sides = wide<3, T>(box.max) - wide<3, T>(box.min);
  const Vec<3, double> other_sides = wide<3, T>(other_box.max) - wide<3, T>(other_box.min);
  const Vec<3, double> joint = wide<3, T>(max(box.max, other_box.max)) - wide<3, T>(min(box.min, other_box.min));
  const SizesOfPair sizes{std::max(std::max(joint.x, joint.y), joint.z), sides.x + sides.y + sides.z,
                          other_sides.x + other_sides.y + other_sides.z};
  if (!is_of_moderate_size(sizes.extent)) return std::nullopt;
  return filter_of_sized(wide_corners(triangle), wide_corners(other), sizes);
}

template <Dim N, class T>
[[gnu::noinline]] Relation careful_closed_form(const Segment<N, T>& segment, const Triangle<N, T>& triangle) {
  if (any_nan(segment, triangle)) return Relation::apart;
  const Vec<N, double> start = wide<N, T>(segment.start);
  const Vec<N, double> half = 0.5 * (wide<N, T>(segment.end) - start);
  return relation_in_frame<N>(Segment<N, double>{-half, half}, local_triangle(start, half, triangle),
                              [&] { return verdict_in_range(segment, triangle); });
}

template <Dim N, class T>
Relation closed_form(const Segment<N, T>& segment, const Triangle<N, T>& triangle) {
  if constexpr (N == 3) {
    if (const auto verdict = filter_of_corners(triangle, segment)) return *verdict;
  }
  return careful_closed_form(segment, triangle);
}

/// In 3D a point touches at most.
template <Dim N, class T>
[[gnu::noinline]] Relation careful_closed_form(const Sphere<N, T>& sphere, const Triangle<N, T>& triangle) {
  if (any_nan(sphere, triangle)) return Relation::apart;
  const Vec<N, double> zero(0.0);
  const auto seen = local_triangle(wide<N, T>(sphere.center), zero, triangle);
  const auto rescaled = [&] { return verdict_in_range(sphere, triangle); };
  const auto of_center = [&] {
    return N == 3 ? Relation::touching : relation_in_frame<N>(Segment<N, double>{zero, zero}, seen, rescaled);
  };
  return relation_to_widened<N>(zero, seen, static_cast<double>(sphere.radius), of_center, rescaled);
}

template <Dim N, class T>
Relation closed_form(const Sphere<N, T>& sphere, const Triangle<N, T>& triangle) {
  if constexpr (N == 3) {
    const Vec<3, double> corner = wide<3, T>(triangle.a);
    const auto verdict =
        filter_of_triangle_and_sphere(corner - wide<3, T>(sphere.center), wide<3, T>(triangle.b) - corner,
                                      wide<3, T>(triangle.c) - corner, static_cast<double>(sphere.radius));
    if (verdict) return *verdict;
  }
  return careful_closed_form(sphere, triangle);
}

template <Dim N, class T>
Relation closed_form(const Aabb<N, T>& box, const Triangle<N, T>& triangle) {
  const Vec<N, double> min = wide<N, T>(box.min);
  const Vec<N, double> half = 0.5 * (wide<N, T>(box.max) - min);
  return relation_in_frame<N>(Aabb<N, double>{-half, half}, local_triangle(min, half, triangle),
                              [&] { return verdict_in_range(box, triangle); });
}

template <Dim N, class T>
Relation closed_form(const Obb<N, T>& box, const Triangle<N, T>& triangle) {
  const Vec<N, double> zero(0.0);
  const Obb<N, double> around_zero{zero, wide<N, T>(box.half_extents), wide_matrix<N, T>(box.axes)};
  return relation_in_frame<N>(around_zero, local_triangle(wide<N, T>(box.center), zero, triangle),
                              [&] { return verdict_in_range(box, triangle); });
}

/// Relative to the least of their coordinates, which is the same for swapped triangles.
template <Dim N, class T>
[[gnu::noinline]] Relation careful_closed_form(const Triangle<N, T>& a, const Triangle<N, T>& b) {
  if (any_nan(a, b)) return Relation::apart;
  const Vec<N, double> reference = wide<N, T>(min(box_around(a).min, box_around(b).min));
  const Vec<N, double> zero(0.0);
  return relation_in_frame<N>(local_triangle(reference, zero, a), local_triangle(reference, zero, b),
                              [&] { return verdict_in_range(a, b); });
}

template <Dim N, class T>
Relation closed_form(const Triangle<N, T>& a, const Triangle<N, T>& b) {
  if constexpr (N == 3) {
    if (const auto verdict = filter_of_corners(a, b)) return *verdict;
  }
  return careful_closed_form(a, b);
}

template <Dim N, class T>
Relation closed_form(const Triangle<N, T>& triangle, const Capsule<N, T>& capsule) {
  const Vec<N, double> start = wide<N, T>(capsule.a);
  const Vec<N, double> half = 0.5 * (wide<N, T>(capsule.b) - start);
  const Segment<N, double> core{-half, half};
  const auto seen = local_triangle(start, half, triangle);
  const auto rescaled = [&] { return verdict_in_range(triangle, capsule); };
  return relation_to_widened<N>(
      core, seen, static_cast<double>(capsule.radius), [&] { return relation_in_frame<N>(core, seen, rescaled); },
      rescaled);
}

}  // namespace graze::detail
