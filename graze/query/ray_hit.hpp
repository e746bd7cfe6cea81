// SPDX-License-Identifier: MIT
/// @file
/// The result and the options of ray_cast(shape, ray, t_max).
#pragma once

#include <optional>

#include <graze/math/vec.hpp>
#include <graze/query/status.hpp>

namespace graze {

/// Where a ray enters or leaves a shape.
template <Dim N, class T = float>
struct RayHit {
  T t = T(0);                          ///< In units of the ray's direction; at least zero.
  Vec<N, T> point = Vec<N, T>(T(0));   ///< origin + t * direction, moved onto the surface.
  Vec<N, T> normal = Vec<N, T>(T(0));  ///< Of length 1, out of the shape; see ray_cast.hpp for special cases.
  Status status = Status::converged;   ///< `best_bound`: GJK could not come nearer.
  double error = 0;  ///< Largest error of the point, a length, before rounding to T; see ray_cast.hpp.

  friend bool operator==(const RayHit&, const RayHit&) = default;
};

/// Which end of the ray's way through a shape is returned.
enum class RaySide {
  entry,  ///< The first point on the shape.
  exit,   ///< The last one; none if the ray does not leave the shape.
};

/// Options of `ray_cast`.
struct RayOptions {
  RaySide side = RaySide::entry;  ///< Entry or exit.
};

namespace detail {

/// A hit in double, with a normal of any length. A zero normal stands for the direction against the ray.
template <Dim N>
struct RawHit {
  double t = 0;
  Vec<N, double> point = Vec<N, double>(0.0);
  Vec<N, double> normal = Vec<N, double>(0.0);
  double error = 0;
  Status status = Status::converged;
};

/// True if there is a hit, but after t_max.
template <Dim N, class T>
bool is_after(const std::optional<RayHit<N, T>>& hit, T t_max) {
  return hit && !(hit->t <= t_max);
}

}  // namespace detail
}  // namespace graze
