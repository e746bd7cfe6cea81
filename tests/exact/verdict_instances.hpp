// SPDX-License-Identifier: MIT
// The definitions behind exact.hpp, for the files that instantiate them. They share no formula with graze.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <graze/math/vec.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>

#include "exact.hpp"
#include "exact/difference.hpp"
#include "exact/kinds.hpp"
#include "exact/numbers.hpp"
#include "exact/solid.hpp"
#include "exact/unbounded.hpp"
#include "exact/verdict.hpp"
#include "parts_of.hpp"

namespace graze::test {

/// Decided by the nearest points of the cores or, if these intersect, by whether they overlap with depth.
template <Dim N>
ExactVerdict solid_verdict(const DifferenceSet<N>& differences, const Rational& reach, Measure measure) {
  const NearestDifference<N> nearest = differences.nearest();
  ExactVerdict result{Relation::touching, 0, 0, 0, false};
  if (is_zero(nearest.sum)) {
    if (reach == 0 && !differences.holds_origin_inside(nearest)) return result;
    result.relation = Relation::overlapping;
    result.gap = measure == Measure::depth ? -(to_double(reach) + differences.depth())
                                           : -std::numeric_limits<double>::infinity();
    return result;
  }
  const Integer length = nearest.weight * differences.unit();
  const Rational squared(dot(nearest.sum, nearest.sum), length * length);
  const Rational beyond = squared - reach * reach;
  if (beyond == 0) return result;
  // d - r = (d^2 - r^2) / (d + r), without cancellation.
  result.gap = static_cast<double>(wide_of(beyond) / (sqrt(wide_of(squared)) + wide_of(reach)));
  result.relation = beyond > 0 ? Relation::apart : Relation::overlapping;
  return result;
}

template <Dim N>
ExactVerdict solid_verdict(const Solid<N>& a, const Solid<N>& b, Measure measure) {
  const DifferenceSet<N> differences(a, b);
  const Rational reach = a.radius + b.radius;
  ExactVerdict result = solid_verdict(differences, reach, measure);
  if (measure == Measure::distance) return result;
  result.largest = std::max(to_double(largest_coordinate(a)), to_double(largest_coordinate(b)));
  for (const RationalVec<N>& on_a : a.corners) {
    for (const RationalVec<N>& on_b : b.corners) {
      const Rational size = largest_coordinate<N>(on_a - on_b) + reach;
      result.own_size = std::max(result.own_size, to_double(size));
    }
  }
  return result;
}

/// The verdict on two simple shapes of one space.
template <class A, class B>
ExactVerdict simple_verdict(const A& a, const B& b, Measure measure) {
  if constexpr (is_plane_or_half_space<A> && is_plane_or_half_space<B>) {
    return level_verdict(level(a), level(b));
  } else if constexpr (is_plane_or_half_space<B>) {
    return simple_verdict(b, a, measure);
  } else if constexpr (is_plane_or_half_space<A> && is_ray<B>) {
    return level_verdict(level(a), b);
  } else if constexpr (is_plane_or_half_space<A>) {
    return level_verdict(level(a), solid(b));
  } else if constexpr (is_ray<A> && is_ray<B>) {
    const auto [first, second] = cut_rays(a, b);
    ExactVerdict result = solid_verdict(first, second, measure);
    const auto rest_squared = compare_directions<dimension_of<A>>(exact(a.direction), exact(b.direction)).second;
    result.is_nearly_parallel = is_barely(rest_squared, dot(exact(b.direction), exact(b.direction)));
    return result;
  } else if constexpr (is_ray<A>) {
    const auto other = solid(b);
    return solid_verdict(solid_beside(a, other), other, measure);
  } else if constexpr (is_ray<B>) {
    return simple_verdict(b, a, measure);
  } else {
    return solid_verdict(solid(a), solid(b), measure);
  }
}

/// The verdict of the nearest or deepest part.
template <Dim N, class T>
ExactVerdict parts_verdict(const Compound<N, T>& compound, const AnyShape<N, T>& shape, Measure measure) {
  ExactVerdict nearest;
  for (const Part<N, T>& part : compound.parts) {
    const ExactVerdict verdict = exact_verdict<N, T>(part.shape, shape, measure);
    nearest.relation = std::max(nearest.relation, verdict.relation);
    nearest.gap = std::min(nearest.gap, verdict.gap);
    nearest.own_size = std::max(nearest.own_size, verdict.own_size);
    nearest.largest = std::max(nearest.largest, verdict.largest);
    nearest.is_nearly_parallel = nearest.is_nearly_parallel || verdict.is_nearly_parallel;
  }
  return nearest;
}

template <Dim N, class T>
ExactVerdict exact_verdict(const AnyShape<N, T>& a, const AnyShape<N, T>& b, Measure measure) {
  return detail::visit(
      [&](const auto& held_a, const auto& held_b) -> ExactVerdict {
        if constexpr (has_parts<std::decay_t<decltype(held_a)>>) {
          return parts_verdict(*parts_of<N, T>(a), b, measure);
        } else if constexpr (has_parts<std::decay_t<decltype(held_b)>>) {
          return parts_verdict(*parts_of<N, T>(b), a, measure);
        } else {
          return simple_verdict(held_a, held_b, measure);
        }
      },
      a, b);
}

}  // namespace graze::test
