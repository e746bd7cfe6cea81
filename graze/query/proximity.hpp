// SPDX-License-Identifier: MIT
/// @file
/// The result of closest_points(a, b).
#pragma once

#include <algorithm>
#include <limits>

#include <graze/math/vec.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/status.hpp>
#include <graze/query/verdict.hpp>

namespace graze {

/// The distance of two shapes and their nearest points. Default: infinitely far, no points.
template <Dim N, class T = float>
struct Proximity {
  T distance = std::numeric_limits<T>::infinity();  ///< 0 if and only if the shapes touch or overlap.
  /// The point of a nearest to b; a common point if they meet.
  Vec<N, T> point_a = Vec<N, T>(std::numeric_limits<T>::quiet_NaN());
  /// The point of b nearest to a; the same if they meet.
  Vec<N, T> point_b = Vec<N, T>(std::numeric_limits<T>::quiet_NaN());
  Vec<N, T> normal = Vec<N, T>(T(0));   ///< Of length 1, from a to b; or zero: see closest_points.hpp.
  Relation relation = Relation::apart;  ///< relation(a, b).
  Status status = Status::converged;    ///< Always `converged` for closed forms.
  double error = 0;                     ///< Largest error of `distance` before rounding to T.

  friend bool operator==(const Proximity&, const Proximity&) = default;
};

namespace detail {

/// The result for (b, a). Subtracts from zero, so that a zero keeps its sign.
template <Dim N, class T>
Proximity<N, T> exchanged(Proximity<N, T> proximity) {
  std::swap(proximity.point_a, proximity.point_b);
  proximity.normal = Vec<N, T>(T(0)) - proximity.normal;
  return proximity;
}

/// The result for shapes that are 2^k times as large.
template <Dim N>
Proximity<N, double> resized(Proximity<N, double> proximity, const PowerOfTwo& power) {
  proximity.distance = power(proximity.distance);
  proximity.point_a = power(proximity.point_a);
  proximity.point_b = power(proximity.point_b);
  proximity.error = power(proximity.error);
  return proximity;
}

/// A distance in T, which is zero if and only if the shapes meet.
template <Scalar T>
T rounded_distance(double distance, Relation relation) {
  if (relation != Relation::apart) return T(0);
  return std::max(static_cast<T>(distance), std::numeric_limits<T>::denorm_min());
}

template <Scalar T, Dim N>
Proximity<N, T> rounded(const Proximity<N, double>& exact) {
  return {rounded_distance<T>(exact.distance, exact.relation),
          Vec<N, T>(exact.point_a) + T(0),  // never minus zero
          Vec<N, T>(exact.point_b) + T(0),
          Vec<N, T>(exact.normal) + T(0),
          exact.relation,
          exact.status,
          exact.error};
}

}  // namespace detail
}  // namespace graze
