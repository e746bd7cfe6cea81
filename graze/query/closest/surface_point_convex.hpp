// SPDX-License-Identifier: MIT
// surface_point.hpp for convex shapes defined by their support functions alone: GJK from outside, EPA from inside.
#pragma once

#include <cmath>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/closest/nearest_on_hull.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/epa.hpp>
#include <graze/query/gjk.hpp>
#include <graze/shape/polytope.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// A point of the shape, inside if possible: the mean of the extreme points along the axes.
template <Convex S>
Vec<dimension_of<S>, double> middle_of(const S& shape) {
  constexpr Dim N = dimension_of<S>;
  Vec<N, double> sum(0.0);
  for (Dim i = 0; i < N; ++i) sum += wide_support(shape, unit_axis<N>(i)) + wide_support(shape, -unit_axis<N>(i));
  return sum / (2.0 * N);
}

/// A point inside unless the polytope is flat.
template <Dim N, class T>
Vec<N, double> middle_of(const Polytope<N, T>& polytope) {
  return middle_of<N, T>(polytope.vertices());
}

/// The largest coordinate in GJK's run, or less by a few powers of two.
template <Dim N>
double measure_of(const GjkResult<N>& found) {
  return found.resolution / tolerance::convex;
}

template <Convex S>
SurfacePoint<dimension_of<S>> surface_point_outside(const S& shape, const Vec<dimension_of<S>, double>& p,
                                                    double measure = 0) {
  const NearestOnHull<dimension_of<S>> nearest = nearest_on_hull(shape, p);
  return {nearest.point, middle_of(shape), std::sqrt(dot(nearest.off, nearest.off)), measure};
}

/// From inside: the end of the minimum translation that moves p out.
template <Convex S>
SurfacePoint<dimension_of<S>> surface_point(const S& shape, const Vec<dimension_of<S>, double>& p) {
  constexpr Dim N = dimension_of<S>;
  const GjkResult<N> distance = usual_gjk(p, shape, GjkOptions{0});
  const double measure = measure_of(distance);
  if (!(distance.lower <= distance.resolution)) return surface_point_outside(shape, p, measure);
  const EpaResult<N> depth = usual_epa(p, shape, distance.simplex);
  if (depth.gap > depth.resolution) return surface_point_outside(shape, p, measure);
  return {p - depth.normal * depth.upper, middle_of(shape), -depth.upper, measure};
}

}  // namespace graze::detail
