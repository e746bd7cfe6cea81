// SPDX-License-Identifier: MIT
// Whether a translation parts two shapes, as stored: what judges the normal of a contact. Quickly, and for certain, by
// the plane across the way that they go; and where that one leaves an overlap, by the oracle, on the shapes as moved.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <variant>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact/kinds.hpp"
#include "exact/numbers.hpp"
#include "exact/solid.hpp"
#include "exact/verdict.hpp"
#include "exact/verdict_instances.hpp"

namespace graze::test {

template <class S>
inline constexpr bool is_bounded_and_convex = !is_level<S> && !is_ray<S> && !has_parts<S>;

/// How far b goes along `way`, which need not be of length 1, until no point of it is before the last one of a;
/// negative if a gap is there already. None for levels, rays and compounds, and for a direction of zero.
template <Dim N, class T>
std::optional<double> overlap_along(const AnyShape<N, T>& a, const AnyShape<N, T>& b, const Vec<N, double>& way) {
  return std::visit(
      [&way](const auto& held_a, const auto& held_b) -> std::optional<double> {
        if constexpr (is_bounded_and_convex<std::decay_t<decltype(held_a)>> &&
                      is_bounded_and_convex<std::decay_t<decltype(held_b)>>) {
          const RationalVec<N> exact_way = exact(way);
          if (is_zero(exact_way)) return std::nullopt;
          const Solid<N> first = solid(held_a);
          const Solid<N> second = solid(held_b);
          Rational last = dot(first.corners.front(), exact_way);
          for (const RationalVec<N>& corner : first.corners) last = std::max(last, Rational(dot(corner, exact_way)));
          Rational next = dot(second.corners.front(), exact_way);
          for (const RationalVec<N>& corner : second.corners) next = std::min(next, Rational(dot(corner, exact_way)));
          const Wide of_cores = wide_of(last - next) / sqrt(wide_of(dot(exact_way, exact_way)));
          return static_cast<double>(Wide(of_cores + wide_of(first.radius + second.radius)));
        } else {
          return std::nullopt;
        }
      },
      a, b);
}

/// How deep the shapes are in each other when b has gone by `way`, or less than `enough` if it is no more than that; 0
/// where they are apart. None as above.
template <Dim N, class T>
std::optional<double> overlap_after(const AnyShape<N, T>& a, const AnyShape<N, T>& b, const Vec<N, double>& way,
                                    double enough) {
  if (const std::optional<double> along = overlap_along<N, T>(a, b, way)) {
    const double left = *along - std::sqrt(dot(way, way));
    if (left <= enough) return std::max(0.0, left);
  }
  return std::visit(
      [&way](const auto& held_a, const auto& held_b) -> std::optional<double> {
        if constexpr (is_bounded_and_convex<std::decay_t<decltype(held_a)>> &&
                      is_bounded_and_convex<std::decay_t<decltype(held_b)>>) {
          Solid<N> moved = solid(held_b);
          for (RationalVec<N>& corner : moved.corners) corner = corner + exact(way);
          return std::max(0.0, -solid_verdict(solid(held_a), moved, Measure::depth).gap);
        } else {
          return std::nullopt;
        }
      },
      a, b);
}

}  // namespace graze::test
