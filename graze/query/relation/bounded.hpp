// SPDX-License-Identifier: MIT
// The closed forms of relation.hpp for segments, spheres, boxes and capsules. Include relation.hpp. All of them return
// apart for NaN.
#pragma once

#include <optional>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/zonotope.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/query/relation/box_filter.hpp>
#include <graze/query/relation/segment_filter.hpp>
#include <graze/query/relation/sphere_filter.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/sphere.hpp>

namespace graze::detail {

// ---- Distance of cores compared with a reach. The distance can be off by a few epsilon of the vectors that it is
// calculated from: those between the two cores and those along them.

template <Dim N, class T>
Vec<N, double> reference(const Vec<N, T>& point) {
  return wide<N, T>(point);
}

template <Dim N, class T>
double extent(const Vec<N, T>&) {
  return 0;
}

template <Dim N, class T>
Vec<N, double> reference(const Segment<N, T>& segment) {
  return wide<N, T>(segment.start);
}

template <Dim N, class T>
double extent(const Segment<N, T>& segment) {
  return sum_abs(wide<N, T>(segment.end) - wide<N, T>(segment.start));
}

template <Dim N, class T>
Vec<N, double> reference(const Aabb<N, T>& box) {
  return wide<N, T>(box.min);
}

template <Dim N, class T>
double extent(const Aabb<N, T>& box) {
  return sum_abs(wide<N, T>(box.max) - wide<N, T>(box.min));
}

template <Dim N, class T>
Vec<N, double> reference(const Obb<N, T>& box) {
  return wide<N, T>(box.center);
}

template <Dim N, class T>
double extent(const Obb<N, T>& box) {
  return 2 * sum_abs(wide<N, T>(box.half_extents));
}

// ---- The fast path for cores that have a filter.

template <class A, class B>
std::optional<Relation> filter_of_cores(const A&, const B&, double) {
  return std::nullopt;
}

template <Dim N, class T>
std::optional<Relation> filter_of_cores(const Vec<N, T>& center, const Obb<N, T>& box, double reach) {
  return filter_of_sphere(center, box, reach);
}

template <Dim N, class T>
std::optional<Relation> filter_of_cores(const Segment<N, T>& a, const Segment<N, T>& b, double reach) {
  return filter_of_segments(a, b, reach);
}

template <Dim N, class T>
std::optional<Relation> filter_of_cores(const Segment<N, T>& segment, const Aabb<N, T>& box, double reach) {
  return filter_of_widened(box, segment, reach);
}

template <Dim N, class T>
std::optional<Relation> filter_of_cores(const Segment<N, T>& segment, const Obb<N, T>& box, double reach) {
  return filter_of_widened(box, segment, reach);
}

/// Compares the distance with the reach. If rounding hides whether the widened shapes touch, the cores may still
/// overlap deeply: `relation_of_cores(core_a, core_b)` decides.
template <class A, class B, class RelationOfCores>
Relation careful_relation_of_widened(const A& core_a, const B& core_b, double reach, double slack,
                                     const RelationOfCores& relation_of_cores) {
  const Relation verdict = verdict_on_distance(distance_squared(core_a, core_b), reach, slack);
  if (verdict == Relation::touching && relation_of_cores(core_a, core_b) == Relation::overlapping) {
    return Relation::overlapping;
  }
  return verdict;
}

template <class A, class B, class RelationOfCores>
Relation relation_of_widened(const A& core_a, const B& core_b, double reach, const RelationOfCores& relation_of_cores);

/// The same for cores that may be out of range.
template <class A, class B, class RelationOfCores>
[[gnu::noinline, gnu::cold]] Relation widened_in_range(const A& core_a, const B& core_b, double reach, double slack,
                                                       const RelationOfCores& relation_of_cores) {
  const auto verdict =
      answer_in_range<Relation>([&](const auto&, const auto& a, const auto& b,
                                    const auto& at) { return relation_of_widened(a, b, at.x, relation_of_cores); },
                                core_a, core_b, Vec<2, scalar_of<A>>(reach, 0));
  return verdict ? *verdict : careful_relation_of_widened(core_a, core_b, reach, slack, relation_of_cores);
}

/// The verdict on two cores widened by `reach` in all. Swapping the cores changes no bit.
template <class A, class B, class RelationOfCores>
Relation relation_of_widened(const A& core_a, const B& core_b, double reach, const RelationOfCores& relation_of_cores) {
  if (const auto verdict = filter_of_cores(core_a, core_b, reach)) return *verdict;
  const double between = sum_abs(reference(core_b) - reference(core_a));
  const double slack = tolerance::rounding * (between + (extent(core_a) + extent(core_b)) + reach);
  if (!is_usual_error<scalar_of<A>>(slack)) return widened_in_range(core_a, core_b, reach, slack, relation_of_cores);
  return careful_relation_of_widened(core_a, core_b, reach, slack, relation_of_cores);
}

/// Points have no depth against points and segments.
struct NeverOverlapping {
  template <class A, class B>
  constexpr Relation operator()(const A&, const B&) const {
    return Relation::touching;
  }
};

struct RelationByForm {
  template <class A, class B>
  Relation operator()(const A& a, const B& b) const {
    return decide(a, b);
  }
};

/// Exact. Everything is compared before anything is decided: a mispredicted branch costs more than six comparisons.
template <Dim N, class T>
[[gnu::always_inline]] inline Relation relation_of_boxes(const Aabb<N, T>& a, const Aabb<N, T>& b) {
  unsigned meets = 1;
  unsigned is_deep = 1;
  for (Dim i = 0; i < N; ++i) {
    meets &= static_cast<unsigned>(a.min[i] <= b.max[i]) & static_cast<unsigned>(b.min[i] <= a.max[i]);
    is_deep &= static_cast<unsigned>(a.min[i] < b.max[i]) & static_cast<unsigned>(b.min[i] < a.max[i]);
  }
  if (meets == 0) return Relation::apart;
  return is_deep != 0 ? Relation::overlapping : Relation::touching;
}

template <class Box, class Other>
[[gnu::noinline]] Relation careful_relation_with_box(const Box& box, const Other& other) {
  const double size = sum_abs(reference(other) - reference(box)) + (extent(box) + extent(other));
  if (!is_usual_size<scalar_of<Box>>(size)) {
    if (const auto verdict = verdict_in_range(box, other)) return *verdict;
  }
  return relation_of_zonotopes(zonotope(box), zonotope(other));
}

/// A box against a box or a segment.
template <class Box, class Other>
Relation relation_with_box(const Box& box, const Other& other) {
  if (const auto verdict = filter_of_box(box, other)) return *verdict;
  return careful_relation_with_box(box, other);
}

// ---- Segment against ...

/// In 3D two segments touch at most; in 2D they overlap when they cross.
template <Dim N, class T>
Relation closed_form(const Segment<N, T>& a, const Segment<N, T>& b) {
  return relation_of_widened(a, b, 0, [](const auto& first, const auto& second) {
    const bool can_cross = N == 2 && first.start != first.end && second.start != second.end;
    return can_cross ? relation_of_zonotopes(zonotope(first), zonotope(second)) : Relation::touching;
  });
}

template <Dim N, class T>
Relation closed_form(const Segment<N, T>& segment, const Sphere<N, T>& sphere) {
  return relation_of_widened(sphere.center, segment, static_cast<double>(sphere.radius), NeverOverlapping());
}

template <Dim N, class T>
Relation closed_form(const Segment<N, T>& segment, const Aabb<N, T>& box) {
  return relation_with_box(box, segment);
}

template <Dim N, class T>
Relation closed_form(const Segment<N, T>& segment, const Obb<N, T>& box) {
  return relation_with_box(box, segment);
}

template <Dim N, class T>
Relation closed_form(const Segment<N, T>& segment, const Capsule<N, T>& capsule) {
  return relation_of_widened(segment, axis(capsule), static_cast<double>(capsule.radius), RelationByForm());
}

// ---- Sphere against ...

template <Dim N, class T>
[[gnu::noinline]] Relation careful_closed_form(const Sphere<N, T>& a, const Sphere<N, T>& b) {
  const double reach = static_cast<double>(a.radius) + static_cast<double>(b.radius);
  return relation_of_widened(a.center, b.center, reach, NeverOverlapping());
}

template <Dim N, class T>
[[gnu::always_inline]] inline Relation closed_form(const Sphere<N, T>& a, const Sphere<N, T>& b) {
  if (const auto verdict = filter_of_spheres(a.center, b.center, a.radius + b.radius)) return *verdict;
  return careful_closed_form(a, b);
}

/// For a sphere that nearly touches, or is too small or large to square in T. A sum of squares of differences, each
/// with relative rounding: the error is no larger than the radius where it matters.
template <Dim N, class T>
[[gnu::noinline]] Relation careful_closed_form(const Sphere<N, T>& sphere, const Aabb<N, T>& box) {
  if (!(sphere.radius >= T(0)) || !boxes_overlap(box, box)) return Relation::apart;  // NaN
  const Relation core = relation_of_boxes(Aabb<N, T>{sphere.center, sphere.center}, box);
  if (core == Relation::overlapping || sphere.radius == T(0)) return core;
  const double radius = static_cast<double>(sphere.radius);
  if (!is_usual_size<T>(radius)) {
    if (const auto verdict = verdict_in_range(sphere, box)) return *verdict;
  }
  return verdict_on_distance(distance_squared(sphere.center, box), radius, tolerance::rounding * radius);
}

template <Dim N, class T>
[[gnu::always_inline]] inline Relation closed_form(const Sphere<N, T>& sphere, const Aabb<N, T>& box) {
  if (const auto verdict = filter_of_sphere(sphere.center, box, sphere.radius)) return *verdict;
  return careful_closed_form(sphere, box);
}

/// A point against a box: exact.
template <Dim N, class T>
[[gnu::always_inline]] inline Relation closed_form(const Vec<N, T>& point, const Aabb<N, T>& box) {
  return relation_of_boxes(Aabb<N, T>{point, point}, box);
}

template <Dim N, class T>
Relation closed_form(const Sphere<N, T>& sphere, const Obb<N, T>& box) {
  return relation_of_widened(
      sphere.center, box, static_cast<double>(sphere.radius),
      [](const auto& center, const auto& around) { return relation_of_zonotopes(zonotope(center), zonotope(around)); });
}

template <Dim N, class T>
Relation closed_form(const Sphere<N, T>& sphere, const Capsule<N, T>& capsule) {
  const double reach = static_cast<double>(sphere.radius) + static_cast<double>(capsule.radius);
  return relation_of_widened(sphere.center, axis(capsule), reach, NeverOverlapping());
}

// ---- Box against ...

template <Dim N, class T>
[[gnu::always_inline]] inline Relation closed_form(const Aabb<N, T>& a, const Aabb<N, T>& b) {
  return relation_of_boxes(a, b);
}

template <Dim N, class T>
Relation closed_form(const Aabb<N, T>& a, const Obb<N, T>& b) {
  return relation_with_box(a, b);
}

template <Dim N, class T>
Relation closed_form(const Aabb<N, T>& box, const Capsule<N, T>& capsule) {
  return relation_of_widened(axis(capsule), box, static_cast<double>(capsule.radius), RelationByForm());
}

template <Dim N, class T>
Relation closed_form(const Obb<N, T>& a, const Obb<N, T>& b) {
  return relation_with_box(a, b);
}

template <Dim N, class T>
Relation closed_form(const Obb<N, T>& box, const Capsule<N, T>& capsule) {
  return relation_of_widened(axis(capsule), box, static_cast<double>(capsule.radius), RelationByForm());
}

// ---- Capsule against capsule

template <Dim N, class T>
Relation closed_form(const Capsule<N, T>& a, const Capsule<N, T>& b) {
  const double reach = static_cast<double>(a.radius) + static_cast<double>(b.radius);
  return relation_of_widened(axis(a), axis(b), reach, RelationByForm());
}

}  // namespace graze::detail
