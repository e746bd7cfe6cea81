// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string_view>

#include <graze/math/platform/throw.hpp>
#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>

namespace graze {

/// All points origin + t * direction with t >= 0. The direction has any length but zero.
template <Dim N, class T = float>
struct Ray {
  Vec<N, T> origin = Vec<N, T>(T(0));
  Vec<N, T> direction = unit_axis<N, T>(0);
};

template <Dim N, class T>
std::string_view defect(const Ray<N, T>& ray) {
  if (!is_finite(ray.origin)) return "has an origin that is not finite";
  if (!is_finite(ray.direction)) return "has a direction that is not finite";
  if (max_abs(ray.direction) == T(0)) return "has a direction of length zero";
  return "";
}

template <Dim N, class T>
Ray<N, T> transformed(const Ray<N, T>& ray, const Pose<N, T>& pose) {
  return {transformed(ray.origin, pose), rotated<N, T>(ray.direction, pose)};
}

/// The ray from one point through another, at t = 1. Equal points have no direction: std::invalid_argument.
template <Dim N, class T>
Ray<N, T> ray_between(const Vec<N, T>& from, const Vec<N, T>& to) {
  if (from == to)
    GRAZE_THROW(std::invalid_argument("ray_between: the two points are equal, so the ray has no direction"));
  return {from, to - from};
}

}  // namespace graze
