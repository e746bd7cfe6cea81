// SPDX-License-Identifier: MIT
// distance(a, b) for every two shapes; the table of what finds it for each pair is at the top of closest_points.hpp.
#pragma once

#include <cassert>

#include <graze/math/vec.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/simplex_cache.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

namespace detail {

template <class A, class B>
scalar_of<A> distance_of(const A& a, const B& b, SimplexCache<dimension_of<A>>* cache = nullptr) {
  assert(is_valid_if_known(a) && is_valid_if_known(b));
  const auto nearest = proximity(a, b, cache);
  return rounded_distance<scalar_of<A>>(nearest.distance, nearest.relation);
}

}  // namespace detail

/// How far apart two valid shapes (asserted) of the same dimension and number type are: 0 if and only if they touch or
/// overlap, as intersects(a, b) says. Swapping the arguments changes no bit. A compound without parts is infinitely far
/// from everything. The error is that of `closest_points`, half an ulp of T more. Cheaper for points, segments, boxes
/// and triangles, but squared and without that promise: `distance_squared`.
template <Shape A, SameSpace<A> B>
scalar_of<A> distance(const A& a, const B& b) {
  return detail::distance_of(a, b);
}

/// The same, faster for polytopes in space that have moved a little since the cache was given last: see
/// `closest_points`.
template <Shape A, SameSpace<A> B>
scalar_of<A> distance(const A& a, const B& b, SimplexCache<dimension_of<A>>& cache) {
  return detail::distance_of(a, b, &cache);
}

// GLM has a `distance` of its own, which takes two of any one type and is found for vectors, and so for variants of
// them, without being asked for. These two are preferred to it.

template <Dim N, Scalar T>
T distance(const Vec<N, T>& a, const Vec<N, T>& b) {
  return detail::distance_of(a, b);
}

template <Dim N, Scalar T>
T distance(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return detail::distance_of(a, b);
}

}  // namespace graze
