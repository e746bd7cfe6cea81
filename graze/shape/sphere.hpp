// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string_view>
#include <type_traits>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>

namespace graze {

/// The solid sphere (in 2D the disc), surface included. A zero radius is valid: the sphere is a point.
template <Dim N, class T = float>
struct Sphere {
  Vec<N, T> center = Vec<N, T>(T(0));
  T radius = T(1);
};

template <class T = float>
using Circle = Sphere<2, T>;

template <Dim N, class T>
std::string_view defect(const Sphere<N, T>& sphere) {
  if (!is_finite(sphere.center)) return "has a center that is not finite";
  if (!std::isfinite(sphere.radius)) return "has a radius that is not finite";
  if (sphere.radius < T(0)) return "has a negative radius";
  return "";
}

template <Dim N, class T>
Vec<N, double> support(const Sphere<N, T>& sphere, const std::type_identity_t<Vec<N, double>>& direction) {
  const double size = std::sqrt(dot(direction, direction));
  return wide<N, T>(sphere.center) + direction * (static_cast<double>(sphere.radius) / size);
}

template <Dim N, class T>
Sphere<N, T> transformed(const Sphere<N, T>& sphere, const Pose<N, T>& pose) {
  return {transformed(sphere.center, pose), sphere.radius};
}

}  // namespace graze
