// SPDX-License-Identifier: MIT
/// @file
/// relation(a, b): apart, touching or overlapping, for any two shapes of the same dimension and number type. It decides
/// `intersects`.
///
/// What decides it. C: closed form. S: the supports along the plane's normal, a closed form for every convex shape. P:
/// part by part. G: GJK, then EPA. C/G: C in 2D, G in 3D. A point counts as a sphere of radius zero. The lower left
/// half of the table equals the upper right one.
///
///                 segment ray sphere aabb obb plane half-space triangle capsule polytope compound user's
///     point          C     C    C     C    C    S       S         C        C      C/G       P       G
///     segment        C     C    C     C    C    S       S         C        C       G        P       G
///     ray                  C    C     C    C    C       C         C        C       G        P       G
///     sphere                    C     C    C    S       S         C        C       G        P       G
///     aabb                            C    C    S       S         C        C       G        P       G
///     obb                                  C    S       S         C        C       G        P       G
///     plane                                     C       C         S        S       S        P       S
///     half-space                                        C         S        S       S        P       S
///     triangle                                                    C        C       G        P       G
///     capsule                                                              C       G        P       G
///     polytope                                                                     G        P       G
///     compound                                                                              P       P
///
/// The closed forms: segments, spheres, boxes and capsules in relation/bounded.hpp; rays, planes and half-spaces in
/// relation/unbounded.hpp; triangles in relation/triangle.hpp; a point and a polygon in relation/polygon.hpp. G is in
/// relation/convex.hpp.
///
/// Exact: aabb and point against aabb, and points against points. Everything else is calculated in double and returns
/// `touching` if the gap or depth is below the rounding error: C a few epsilon of the pair's own size, however far from
/// the origin; S and G a few epsilon of the largest coordinate (of T for a user's shape that calculates in T). Rays,
/// planes and half-spaces whose directions are parallel up to a few epsilon count as parallel. Coordinates may be any
/// finite numbers; see range.hpp for sizes that differ by more than a factor of 2^900.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/compiled/instances.hpp>
#include <graze/query/parts/inside.hpp>
#include <graze/query/parts/may_touch_obb.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/query/relation/bounded.hpp>
#include <graze/query/relation/convex.hpp>
#include <graze/query/relation/polygon.hpp>
#include <graze/query/relation/triangle.hpp>
#include <graze/query/relation/unbounded.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/nan_check.hpp>
#include <graze/shape/fields/visit.hpp>
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
inline constexpr bool is_any_shape = false;
template <Dim N, class T>
inline constexpr bool is_any_shape<AnyShape<N, T>> = true;

// Whether the closed form of two shapes detects NaN by itself.

template <template <Dim, class> class Type, class S>
inline constexpr bool is_a = false;
template <template <Dim, class> class Type, Dim N, class T>
inline constexpr bool is_a<Type, Type<N, T>> = true;

template <class S>
inline constexpr bool is_sphere_or_box = is_a<Sphere, S> || is_a<Aabb, S> || is_a<Obb, S>;
template <class S>
inline constexpr bool is_core = is_sphere_or_box<S> || is_a<Segment, S> || is_a<Capsule, S>;
template <class S>
inline constexpr bool is_filtered = is_a<Sphere, S> || is_a<Segment, S> || is_a<Triangle, S>;

template <class A, class B>
inline constexpr bool sees_nan = (is_core<A> && is_core<B>) || (is_point<A> && is_a<Aabb, B>) ||
                                 ((is_a<Plane, A> || is_a<HalfSpace, A>)&&(is_core<B> || is_a<Triangle, B>)) ||
                                 (dimension_of<A> == 3 && is_filtered<A> && is_a<Triangle, B>);

/// The closest part decides; parts whose boxes are apart beyond rounding are skipped. What no face of a solid mesh
/// touches may still be inside.
template <HasParts Whole, class S>
Relation relation_of_parts(const Whole& whole, const S& shape) {
  Relation closest = Relation::apart;
  const auto visit = [&](const auto& part, std::size_t) {
    closest = std::max(closest, decide(part.shape, shape));
    return closest != Relation::overlapping;
  };
  visit_parts(whole, may_touch(shape), visit);
  if (closest == Relation::apart && point_inside(whole, shape)) return Relation::overlapping;
  return closest;
}

/// The same for two meshes, by both trees.
template <Dim N, class T>
Relation relation_of_meshes(const Mesh<N, T>& a, const Mesh<N, T>& b) {
  const PlacedMesh<N, T>& faces_a = placed(a);
  const PlacedMesh<N, T>& faces_b = placed(b);
  Relation closest = Relation::apart;
  visit_near_faces(faces_a, faces_b, [&](std::uint32_t face_a, std::uint32_t face_b) {
    closest = std::max(closest, decide(faces_a.triangle(face_a), faces_b.triangle(face_b)));
    return closest != Relation::overlapping;
  });
  // Of a mesh that touches a solid, some faces may be inside that do not touch it.
  if (closest == Relation::touching && N == 3) {
    if (b.kind() == MeshKind::solid) closest = relation_of_parts(a, b);
    if (closest == Relation::touching && a.kind() == MeshKind::solid) closest = relation_of_parts(b, a);
  }
  if (closest == Relation::apart && (point_inside(b, a) || point_inside(a, b))) return Relation::overlapping;
  return closest;
}

/// The verdict, but apart if any number is NaN. The check comes last and is rare, because most pairs are apart anyway.
template <class A, class B>
inline Relation unless_nan(const A& a, const B& b, Relation verdict) {
  if constexpr (sees_nan<A, B> || sees_nan<B, A>) return verdict;
  if (verdict == Relation::apart || any_nan(a, b)) return Relation::apart;
  return verdict;
}

/// The verdict, without checking that the shapes are valid. Invalid shapes may get a meaningless verdict, but the call
/// returns, and NaN is apart from everything. Declared inline, as is everything on the way to `intersects`; otherwise
/// compilers emit a function call for a few comparisons.
template <class A, class B>
inline Relation decide(const A& a, const B& b) {
  if constexpr (is_any_shape<A>) {
    return detail::visit([&b](const auto& held) { return decide(held, b); }, a);
  } else if constexpr (is_any_shape<B>) {
    return detail::visit([&a](const auto& held) { return decide(a, held); }, b);
  } else if constexpr (is_mesh<A> && is_mesh<B>) {
    return relation_of_meshes(a, b);
  } else if constexpr (is_compound<A> || (is_mesh<A> && !is_compound<B>)) {
    return relation_of_parts(a, b);
  } else if constexpr (HasParts<B>) {
    return relation_of_parts(b, a);
  } else if constexpr (are_exchanged<A, B>) {
    return decide(b, a);
  } else if constexpr (is_point<A> && is_point<B>) {
    return a == b ? Relation::touching : Relation::apart;
  } else if constexpr (is_point<A> && !HasClosedForm<A, B>) {
    return decide(Sphere<dimension_of<A>, scalar_of<A>>{a, 0}, b);
  } else if constexpr (HasClosedForm<A, B>) {
    return unless_nan(a, b, closed_form(a, b));
  } else if constexpr (HasClosedForm<B, A>) {
    return unless_nan(a, b, closed_form(b, a));
  } else {
    if (any_nan(a, b)) return Relation::apart;
    return relation_of_convex_ordered(a, b);
  }
}

/// The overload for variants. It compiles every pair of types and is therefore not inline, so that it is compiled once.
template <Dim N, class T>
Relation decide(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return detail::visit([&b](const auto& held) { return decide(held, b); }, a);
}

/// A user's type without `defect` counts as valid.
template <class S>
bool is_valid_if_known(const S& shape) {
  if constexpr (requires { defect(shape); }) return is_valid(shape);
  return true;
}

}  // namespace detail

/// Whether two valid shapes (asserted) of the same dimension and number type are apart, touching or overlapping.
/// Symmetric in its arguments. A compound is the union of its parts; without parts it is apart from everything. See the
/// top of this file for the algorithm and error of each pair; `intersects` is cheaper for some pairs.
template <Shape A, SameSpace<A> B>
inline Relation relation(const A& a, const B& b) {
  assert(detail::is_valid_if_known(a) && detail::is_valid_if_known(b));
  return detail::decide(a, b);
}

/// The overload for variants; graze::graze holds it compiled.
template <Dim N, class T>
Relation relation(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  assert(is_valid(a) && is_valid(b));
  return detail::decide(a, b);
}

GRAZE_DECLARE_INSTANCES(GRAZE_RELATION_INSTANCES)

}  // namespace graze
