// SPDX-License-Identifier: MIT
// graze's distances of any two shapes.
#pragma once

#include <graze/math/vec.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/simplex_cache.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::test {

/// closest_points(a, b).
template <Dim N, class T>
Proximity<N, T> closest_points_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return closest_points(a, b);
}

/// distance(a, b).
template <Dim N, class T>
T distance_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return distance(a, b);
}

/// closest_points(a, b) before it is rounded to T.
template <Dim N, class T>
Proximity<N, double> proximity_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return detail::proximity(a, b);
}

}  // namespace graze::test
