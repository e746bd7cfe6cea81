// SPDX-License-Identifier: MIT
// Whether a translation separates two shapes, as stored: this tests the normal of a contact. First by the plane
// perpendicular to the translation, which is fast and certain; if this leaves an overlap, by the oracle, on the moved
// shapes.
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

/// The oracle's form of a shape; none for planes, rays and compounds.
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

/// How far b must move along `way`, which need not have length 1, until all of it is beyond the last point of a;
/// negative if there already is a gap. None if the direction is zero.
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

/// How deep the shapes overlap after b has moved by `way`; may be any value below `enough` if it is no more than that;
/// 0 if they are apart. None for planes, rays and compounds.
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
