// SPDX-License-Identifier: MIT
// relation(a, b): apart, touching or overlapping, for any two shapes of one space; the verdict under `intersects`.
//
// What decides it. C: a closed form. S: the supports along the plane's normal, a closed form for every convex shape. P:
// part by part. G: GJK, then EPA. A point is a sphere of radius zero. The lower left half is the upper right one,
// swapped.
//
//               segment ray sphere aabb obb plane half-space triangle capsule polytope compound user's
//   point          C     C    C     C    C    S       S         C        C       G        P       G
//   segment        C     C    C     C    C    S       S         C        C       G        P       G
//   ray                  C    C     C    C    C       C         C        C       G        P       G
//   sphere                    C     C    C    S       S         C        C       G        P       G
//   aabb                            C    C    S       S         C        C       G        P       G
//   obb                                  C    S       S         C        C       G        P       G
//   plane                                     C       C         S        S       S        P       S
//   half-space                                        C         S        S       S        P       S
//   triangle                                                    C        C       G        P       G
//   capsule                                                              C       G        P       G
//   polytope                                                                     G        P       G
//   compound                                                                              P       P
//
// Where the forms are: segments, spheres, boxes, capsules in relation_bounded.hpp; rays, planes, half-spaces in
// relation_unbounded.hpp; triangles in relation_triangle.hpp; G in relation_convex.hpp.
//
// Exact: aabb and point against aabb, points among themselves. The rest calculates in double and calls `touching` what
// is nearer to touching than rounding can tell: C a few epsilon of the pair's own size, however far from the origin; S
// and G a few epsilon of the largest coordinate (of T for a user's shape that calculates in T). Rays, planes and
// half-spaces whose directions are parallel up to a few epsilon are taken as parallel. Coordinates of magnitude 1e-140
// to 1e140: outside, squares leave the range of double.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <concepts>
#include <variant>

#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/relation_bounded.hpp>
#include <graze/query/relation_convex.hpp>
#include <graze/query/relation_triangle.hpp>
#include <graze/query/relation_unbounded.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

namespace detail {

template <class A, class B>
concept HasClosedForm = requires(const A& a, const B& b) {
  closed_form(a, b);
};

template <class S>
inline constexpr bool is_point = false;
template <Dim N, class T>
inline constexpr bool is_point<Vec<N, T>> = true;

template <class S>
inline constexpr bool is_compound = false;
template <Dim N, class T>
inline constexpr bool is_compound<Compound<N, T>> = true;

template <class S>
inline constexpr bool is_any_shape = false;
template <Dim N, class T>
inline constexpr bool is_any_shape<AnyShape<N, T>> = true;

// ---- The shapes whose closed forms among themselves see NaN for what it is.

template <class S>
inline constexpr bool sees_nan = false;
template <Dim N, class T>
inline constexpr bool sees_nan<Segment<N, T>> = true;
template <Dim N, class T>
inline constexpr bool sees_nan<Sphere<N, T>> = true;
template <Dim N, class T>
inline constexpr bool sees_nan<Aabb<N, T>> = true;
template <Dim N, class T>
inline constexpr bool sees_nan<Obb<N, T>> = true;
template <Dim N, class T>
inline constexpr bool sees_nan<Capsule<N, T>> = true;

// ---- NaN if any number of the shape is: comparisons drop a NaN as easily as not, sums keep it. A polytope holds none;
// a user's type is not looked into.

template <class S>
double numbers_of(const S&) {
  return 0;
}

template <Dim N, class T>
double numbers_of(const Vec<N, T>& v) {
  return sum_abs(wide<N, T>(v));
}

template <Dim N, class T>
double numbers_of(const Segment<N, T>& segment) {
  return numbers_of(segment.start) + numbers_of(segment.end);
}

template <Dim N, class T>
double numbers_of(const Ray<N, T>& ray) {
  return numbers_of(ray.origin) + numbers_of(ray.direction);
}

template <Dim N, class T>
double numbers_of(const Sphere<N, T>& sphere) {
  return numbers_of(sphere.center) + static_cast<double>(sphere.radius);
}

template <Dim N, class T>
double numbers_of(const Aabb<N, T>& box) {
  return numbers_of(box.min) + numbers_of(box.max);
}

template <Dim N, class T>
double numbers_of(const Obb<N, T>& box) {
  double sum = numbers_of(box.center) + numbers_of(box.half_extents);
  for (Dim i = 0; i < N; ++i) sum += numbers_of<N, T>(box.axes[i]);
  return sum;
}

template <Dim N, class T>
double numbers_of(const Plane<N, T>& plane) {
  return numbers_of(plane.normal) + static_cast<double>(plane.offset);
}

template <Dim N, class T>
double numbers_of(const HalfSpace<N, T>& solid) {
  return numbers_of(boundary(solid));
}

template <Dim N, class T>
double numbers_of(const Triangle<N, T>& triangle) {
  return numbers_of(triangle.a) + numbers_of(triangle.b) + numbers_of(triangle.c);
}

template <Dim N, class T>
double numbers_of(const Capsule<N, T>& capsule) {
  return numbers_of(axis(capsule)) + static_cast<double>(capsule.radius);
}

template <class A, class B>
Relation decide(const A& a, const B& b);

/// The closest of the parts decides; parts whose boxes are apart beyond all rounding are skipped.
template <Dim N, class T, class S>
Relation relation_of_parts(const Compound<N, T>& compound, const S& shape) {
  const Aabb<N, T> box = touching_bounds(bounds(shape));
  Relation closest = Relation::apart;
  for (const Part<N, T>& part : compound.parts) {
    if (closest == Relation::overlapping) break;
    if (boxes_overlap(touching_bounds(part.box), box)) closest = std::max(closest, decide(part.shape, shape));
  }
  return closest;
}

/// The verdict, without asking whether the shapes are valid: nonsense may get a nonsensical verdict, but it ends, and
/// NaN is apart from everything.
template <class A, class B>
Relation decide(const A& a, const B& b) {
  if constexpr (is_any_shape<A>) {
    return std::visit([&b](const auto& held) { return decide(held, b); }, a);
  } else if constexpr (is_any_shape<B>) {
    return std::visit([&a](const auto& held) { return decide(a, held); }, b);
  } else if constexpr (is_compound<A>) {
    return relation_of_parts(a, b);
  } else if constexpr (is_compound<B>) {
    return relation_of_parts(b, a);
  } else if constexpr (is_point<A> && is_point<B>) {
    return a == b ? Relation::touching : Relation::apart;
  } else if constexpr (is_point<A>) {
    return decide(Sphere<dimension_of<A>, scalar_of<A>>{a, 0}, b);
  } else if constexpr (is_point<B>) {
    return decide(a, Sphere<dimension_of<B>, scalar_of<B>>{b, 0});
  } else if (!(sees_nan<A> && sees_nan<B>)&&std::isnan(numbers_of(a) + numbers_of(b))) {
    return Relation::apart;
  } else if constexpr (HasClosedForm<A, B>) {
    return closed_form(a, b);
  } else if constexpr (HasClosedForm<B, A>) {
    return closed_form(b, a);
  } else {
    return relation_of_convex_ordered(a, b);
  }
}

/// A user's type need not have `defect`; then it is taken to be valid.
template <class S>
bool is_valid_if_known(const S& shape) {
  if constexpr (requires { defect(shape); }) return is_valid(shape);
  return true;
}

}  // namespace detail

/// How two valid shapes (asserted) of the same dimension and number type lie to each other. Swapping the arguments
/// changes nothing. A compound is the union of its parts; one without parts is apart from everything.
template <Shape A, SameSpace<A> B>
Relation relation(const A& a, const B& b) {
  assert(detail::is_valid_if_known(a) && detail::is_valid_if_known(b));
  return detail::decide(a, b);
}

}  // namespace graze
