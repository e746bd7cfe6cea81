// SPDX-License-Identifier: MIT
/// @file
/// intersects(a, b) for any two shapes; the table at the top of relation.hpp lists the algorithm of each pair.
#pragma once

#include <cassert>
#include <limits>

#include <graze/query/ray/filters.hpp>
#include <graze/query/ray/verdict_2d.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

namespace detail {

/// A shape for which the filters of ray_cast.hpp, or the closed form there, decide most rays.
template <class S>
concept HasFastRayVerdict = HasQuickCast<S> || requires(const S& shape, const Ray<dimension_of<S>, scalar_of<S>>& ray) {
  ray_verdict_of_ray(shape, ray);
};

template <Dim N, class T, HasFastRayVerdict S>
RayVerdict fast_ray_verdict(const S& shape, const Ray<N, T>& ray) {
  if constexpr (HasQuickCast<S>) {
    return quick_cast(shape, ray, std::numeric_limits<T>::infinity()).verdict();
  } else {
    return ray_verdict_of_ray(shape, ray);
  }
}

/// Uses the fast verdict, and `relation` where that is unclear. Fewer steps than `relation`, because touching need not
/// be distinguished from overlapping.
template <Dim N, class T, HasFastRayVerdict S>
bool is_met(const Ray<N, T>& ray, const S& shape) {
  const RayVerdict verdict = fast_ray_verdict(shape, ray);
  if (verdict != RayVerdict::unclear) return verdict == RayVerdict::hits;
  return decide(shape, ray) != Relation::apart;
}

}  // namespace detail

/// True if two valid shapes (asserted) share a point; touching counts. Every pair of the same dimension and number type
/// has an algorithm. Symmetric in its arguments. The error is that of `relation`, which also distinguishes touching
/// from overlapping.
template <Shape A, SameSpace<A> B>
inline bool intersects(const A& a, const B& b) {
  if constexpr (detail::is_a<Ray, A> && detail::HasFastRayVerdict<B>) {
    assert(detail::is_valid_if_known(a) && detail::is_valid_if_known(b));
    return detail::is_met(a, b);
  } else if constexpr (detail::is_a<Ray, B> && detail::HasFastRayVerdict<A>) {
    assert(detail::is_valid_if_known(a) && detail::is_valid_if_known(b));
    return detail::is_met(b, a);
  } else {
    return relation(a, b) != Relation::apart;
  }
}

}  // namespace graze
