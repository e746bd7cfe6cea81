// SPDX-License-Identifier: MIT
/// @file
/// The result of shape_cast(a, motion, b) and time_of_impact.
#pragma once

#include <algorithm>
#include <optional>

#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/cores/penetration.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/status.hpp>

namespace graze {

/// When and where two shapes, one or both of them moving, first touch.
template <Dim N, class T = float>
struct Impact {
  T t = T(0);                          ///< Time, from 0 (start of the motion) to 1 (its end); rounded down.
  Vec<N, T> point = Vec<N, T>(T(0));   ///< A point where they touch at t; with a target distance, b's nearest one.
  Vec<N, T> normal = Vec<N, T>(T(0));  ///< Of length 1, from a to b; at t = 0 that of `contact`, which may be zero.
  Status status = Status::converged;   ///< `best_bound`: they do not touch before t, but may touch only later.
  double error = 0;                    ///< Largest gap left at t, a length: see shape_cast.hpp and time_of_impact.hpp.

  friend bool operator==(const Impact&, const Impact&) = default;
};

namespace detail {

/// An impact in double.
template <Dim N>
struct CastHit {
  double t = 0;
  Vec<N, double> point = Vec<N, double>(0.0);
  Vec<N, double> normal = Vec<N, double>(0.0);
  Status status = Status::converged;
  double error = 0;
  double depth = 0;  ///< At t = 0, negative for a gap; later minus the target distance.
};

/// The impact of shapes that are 2^k times as large.
template <Dim N>
std::optional<CastHit<N>> resized(std::optional<CastHit<N>> cast_hit, const PowerOfTwo& power) {
  if (!cast_hit) return cast_hit;
  cast_hit->point = power(cast_hit->point);
  cast_hit->error = power(cast_hit->error);
  cast_hit->depth = power(cast_hit->depth);
  return cast_hit;
}

/// Rounds t down, so that it is not after the touch by what T cannot represent.
template <Scalar T, Dim N>
Impact<N, T> rounded_impact(const CastHit<N>& exact) {
  return {std::max(T(0), round_down<T>(exact.t)) + T(0),  // never minus zero
          Vec<N, T>(exact.point) + T(0), Vec<N, T>(exact.normal) + T(0), exact.status, exact.error};
}

/// The impact of shapes that meet at the start, or of shapes with a negative depth that are as near as a target.
template <Dim N>
CastHit<N> cast_hit_at_start(const Penetration<N>& contact) {
  const Vec<N, double> point = contact.depth < 0 ? contact.point_b : contact.point_a * 0.5 + contact.point_b * 0.5;
  return {0, point, contact.normal, contact.status, contact.error, contact.depth};
}

/// Keeps the earlier of two impacts, and of two at the start the deeper one.
template <Dim N>
void keep_earlier(std::optional<CastHit<N>>& first, const std::optional<CastHit<N>>& other) {
  if (!other) return;
  if (!first || other->t < first->t || (other->t == first->t && other->depth > first->depth)) first = other;
}

}  // namespace detail
}  // namespace graze
