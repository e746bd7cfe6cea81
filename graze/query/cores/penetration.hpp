// SPDX-License-Identifier: MIT
// The depth of two intersecting shapes, in double: what contact.hpp rounds.
#pragma once

#include <utility>

#include <graze/math/vec.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/status.hpp>

namespace graze::detail {

/// The minimum translation that separates two shapes, and the two points that it brings together: point_a - point_b is
/// about normal * depth.
template <Dim N>
struct Penetration {
  Vec<N, double> normal = Vec<N, double>(0.0);  ///< Unit vector, from a to b; zero if nothing separates them.
  double depth = 0;
  Vec<N, double> point_a = Vec<N, double>(0.0);  ///< On a's surface.
  Vec<N, double> point_b = Vec<N, double>(0.0);  ///< On b's surface.
  Status status = Status::converged;
  double error = 0;
};

/// The same for (b, a). Subtracted from zero, so that a zero keeps its sign.
template <Dim N>
Penetration<N> exchanged(Penetration<N> penetration) {
  std::swap(penetration.point_a, penetration.point_b);
  penetration.normal = Vec<N, double>(0.0) - penetration.normal;
  return penetration;
}

/// The same for shapes scaled by 2^k.
template <Dim N>
Penetration<N> resized(Penetration<N> penetration, const PowerOfTwo& power) {
  penetration.depth = power(penetration.depth);
  penetration.point_a = power(penetration.point_a);
  penetration.point_b = power(penetration.point_b);
  penetration.error = power(penetration.error);
  return penetration;
}

/// The same relative to another origin.
template <Dim N>
Penetration<N> moved_by(Penetration<N> penetration, const Vec<N, double>& origin) {
  penetration.point_a += origin;
  penetration.point_b += origin;
  return penetration;
}

}  // namespace graze::detail
