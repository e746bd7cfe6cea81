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
inline constexpr bool is_bounded_and_convex = !is_plane_or_half_space<S> && !is_ray<S> && !has_parts<S>;

/// What the oracle takes a shape for; none for levels, rays and compounds.
template <Dim N, class T>
std::optional<Solid<N>> bounded_solid(const AnyShape<N, T>& shape) {
  return std::visit(
      [](const auto& held) -> std::optional<Solid<N>> {
        if constexpr (is_bounded_and_convex<std::decay_t<decltype(held)>>) {
          return solid(held);
        } else {
          return std::nullopt;
        }
      },
      shape);
}

/// How far b goes along `way`, which need not be of length 1, until no point of it is before the last one of a;
/// negative if a gap is there already. None for a direction of zero.
template <Dim N>
std::optional<double> overlap_along(const Solid<N>& a, const Solid<N>& b, const Vec<N, double>& way) {
  const RationalVec<N> exact_way = exact(way);
  if (is_zero(exact_way)) return std::nullopt;
  Rational last = dot(a.corners.front(), exact_way);
  for (const RationalVec<N>& corner : a.corners) last = std::max(last, Rational(dot(corner, exact_way)));
  Rational next = dot(b.corners.front(), exact_way);
  for (const RationalVec<N>& corner : b.corners) next = std::min(next, Rational(dot(corner, exact_way)));
  const Wide of_cores = wide_of(last - next) / sqrt(wide_of(dot(exact_way, exact_way)));
  return static_cast<double>(Wide(of_cores + wide_of(a.radius + b.radius)));
}

/// How deep the shapes are in each other when b has gone by `way`, or less than `enough` if it is no more than that; 0
/// where they are apart. None for levels, rays and compounds.
template <Dim N, class T>
std::optional<double> overlap_after(const AnyShape<N, T>& a, const AnyShape<N, T>& b, const Vec<N, double>& way,
                                    double enough) {
  const std::optional<Solid<N>> first = bounded_solid<N, T>(a);
  std::optional<Solid<N>> moved = bounded_solid<N, T>(b);
  if (!first || !moved) return std::nullopt;
  if (const std::optional<double> along = overlap_along<N>(*first, *moved, way)) {
    const double left = *along - std::sqrt(dot(way, way));
    if (left <= enough) return std::max(0.0, left);
  }
  for (RationalVec<N>& corner : moved->corners) corner = corner + exact(way);
  return std::max(0.0, -solid_verdict(*first, *moved, Measure::depth).gap);
}

}  // namespace graze::test
