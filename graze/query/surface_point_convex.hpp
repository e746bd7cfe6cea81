// SPDX-License-Identifier: MIT
// surface_point.hpp for convex shapes known by their support points alone: GJK
// from outside, EPA from inside.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/epa.hpp>
#include <graze/query/gjk.hpp>
#include <graze/query/simplex.hpp>
#include <graze/query/surface_point.hpp>
#include <graze/query/wide_support.hpp>
#include <graze/shape/polytope.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// A point of the shape, an inner one if it can be had: the mean of what lies farthest along the axes.
template <Convex S>
Vec<dimension_of<S>, double> middle_of(const S& shape) {
  constexpr Dim N = dimension_of<S>;
  Vec<N, double> sum(0.0);
  for (Dim i = 0; i < N; ++i) sum += wide_support(shape, unit_axis<N>(i)) + wide_support(shape, -unit_axis<N>(i));
  return sum / (2.0 * N);
}

/// An inner point unless the polytope is flat.
template <Dim N, class T>
Vec<N, double> middle_of(const Polytope<N, T>& polytope) {
  return middle_of<N, T>(polytope.vertices());
}

/// From the nearest point of a shape to p, and the simplex of differences that it was found on.
template <Dim N>
struct Separation {
  Vec<N, double> off;
  Simplex<N> face;
};

/// GJK stops when the distance is known well enough, but then the point can be off by the root of that. So it goes on
/// until no support point is nearer by more than rounding: on a polytope, until the right face is found.
template <Convex S>
Separation<dimension_of<S>> separation_of(const S& shape, const Vec<dimension_of<S>, double>& p) {
  constexpr Dim N = dimension_of<S>;
  const GjkResult<N> distance = gjk(p, shape);
  Separation<N> result{distance.separation, distance.simplex};
  int stalls = 0;
  for (int step = 0; step < gjk_iteration_limit && result.face.size <= static_cast<std::size_t>(N); ++step) {
    const Vec<N, double> next = p - wide_support(shape, result.off);
    const double nearer_by = dot(result.off, result.off - next);
    if (!(nearer_by > tolerance::epsilon * dot(abs(result.off), abs(next))) || is_corner_of(result.face, next)) break;
    Simplex<N> extended = result.face;
    extended.push(next);
    const std::optional<NearestOnSimplex<N>> found = gjk_step(extended, result.off, stalls);
    if (!found) break;
    result = {found->point, found->face};
  }
  return result;
}

/// The nearest point from outside. A corner is taken as it is stored, not as what was left of it after rounding.
template <Convex S>
SurfacePoint<dimension_of<S>> surface_point_outside(const S& shape, const Vec<dimension_of<S>, double>& p) {
  constexpr Dim N = dimension_of<S>;
  const Separation<N> nearest = separation_of(shape, p);
  const Vec<N, double> corner = wide_support(shape, nearest.off);
  const bool is_corner = nearest.face.size == 1 && p - corner == nearest.off;
  return {is_corner ? corner : p - nearest.off, middle_of(shape), std::sqrt(dot(nearest.off, nearest.off))};
}

/// From inside: where the least translation that would take p out leads to.
template <Convex S>
SurfacePoint<dimension_of<S>> surface_point(const S& shape, const Vec<dimension_of<S>, double>& p) {
  constexpr Dim N = dimension_of<S>;
  const GjkResult<N> distance = gjk(p, shape, GjkOptions{0});
  if (!(distance.lower <= distance.resolution)) return surface_point_outside(shape, p);
  const EpaResult<N> depth = epa(p, shape, distance.simplex);
  if (depth.gap > depth.resolution) return surface_point_outside(shape, p);
  return {p - depth.normal * depth.upper, middle_of(shape), -depth.upper};
}

}  // namespace graze::detail
