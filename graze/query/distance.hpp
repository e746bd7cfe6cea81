// SPDX-License-Identifier: MIT
/// @file
/// distance(a, b) for any two shapes; the table at the top of closest_points.hpp lists the algorithm of each pair.
#pragma once

#include <cassert>
#include <variant>

#include <graze/math/vec.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/compiled/instances.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/simplex_cache.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/mesh.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

namespace detail {

/// Whether both shapes are meshes that meet. To know that takes much less time than to find the first faces that do.
template <class A, class B>
bool do_meshes_meet(const A& a, const B& b) {
  if constexpr (is_any_shape<A> && is_any_shape<B>) {
    using SameMesh = Mesh<dimension_of<A>, scalar_of<A>>;
    if (!std::holds_alternative<SameMesh>(a) || !std::holds_alternative<SameMesh>(b)) return false;
    return decide(a, b) != Relation::apart;
  } else if constexpr (is_mesh<A> && is_mesh<B>) {
    return decide(a, b) != Relation::apart;
  }
  return false;
}

template <class A, class B>
scalar_of<A> distance_of(const A& a, const B& b, SimplexCache<dimension_of<A>>* cache = nullptr) {
  assert(is_valid_if_known(a) && is_valid_if_known(b));
  if (do_meshes_meet(a, b)) return 0;
  const auto nearest = proximity(a, b, cache);
  return rounded_distance<scalar_of<A>>(nearest.distance, nearest.relation);
}

}  // namespace detail

/// The distance of two valid shapes (asserted) of the same dimension and number type: 0 if and only if they touch or
/// overlap, as `intersects(a, b)` decides. Symmetric to the last bit. A compound without parts is infinitely far from
/// everything. The error is that of `closest_points` plus half an ulp of T. For points, segments, boxes and triangles
/// `distance_squared` is cheaper, but squared and not consistent with `intersects`.
template <Shape A, SameSpace<A> B>
scalar_of<A> distance(const A& a, const B& b) {
  return detail::distance_of(a, b);
}

/// The same distance, found faster for 3D polytopes that have moved little since the last call with this cache: see
/// `closest_points`.
template <Shape A, SameSpace<A> B>
scalar_of<A> distance(const A& a, const B& b, SimplexCache<dimension_of<A>>& cache) {
  return detail::distance_of(a, b, &cache);
}

// GLM has its own `distance` for two arguments of any one type, which argument-dependent lookup finds for vectors, and
// therefore for variants of them. Overload resolution prefers these two.

/// The distance of two points; exactly 0 if and only if they are equal. Preferred to GLM's function of the same name.
template <Dim N, Scalar T>
T distance(const Vec<N, T>& a, const Vec<N, T>& b) {
  return detail::distance_of(a, b);
}

/// The distance of two variants, as for the shapes that they hold.
template <Dim N, Scalar T>
T distance(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return detail::distance_of(a, b);
}

GRAZE_DECLARE_INSTANCES(GRAZE_DISTANCE_INSTANCES)

}  // namespace graze
