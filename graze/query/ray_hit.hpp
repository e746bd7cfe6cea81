// SPDX-License-Identifier: MIT
// What ray_cast(shape, ray, t_max) answers, and what it can be asked.
#pragma once

#include <optional>

#include <graze/math/vec.hpp>
#include <graze/query/status.hpp>

namespace graze {

/// Where a ray meets a shape.
template <Dim N, class T = float>
struct RayHit {
  T t = T(0);                          ///< In units of the ray's direction.
  Vec<N, T> point = Vec<N, T>(T(0));   ///< origin + t * direction, put onto the surface.
  Vec<N, T> normal = Vec<N, T>(T(0));  ///< Of length 1, out of the shape; see ray_cast.hpp.
  Status status = Status::converged;   ///< `best_bound` where GJK could not get nearer.
  double error = 0;                    ///< How far the hit may be off, its rounding to T left out; see ray_cast.hpp.

  friend bool operator==(const RayHit&, const RayHit&) = default;
};

/// Which end of the ray's way through a shape is asked for.
enum class RaySide {
  entry,  ///< The first point of the shape.
  exit,   ///< The last one, if the ray leaves the shape.
};

struct RayOptions {
  RaySide side = RaySide::entry;
};

namespace detail {

/// A hit in double, and before it has a normal of length 1. A normal of zero stands for the one against the ray.
template <Dim N>
struct Touch {
  double t = 0;
  Vec<N, double> point = Vec<N, double>(0.0);
  Vec<N, double> normal = Vec<N, double>(0.0);
  double error = 0;
  Status status = Status::converged;
};

/// Whether there is a hit, but not until then.
template <Dim N, class T>
bool is_after(const std::optional<RayHit<N, T>>& hit, T t_max) {
  return hit && !(hit->t <= t_max);
}

}  // namespace detail
}  // namespace graze
