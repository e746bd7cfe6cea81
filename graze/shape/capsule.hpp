// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string_view>
#include <type_traits>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/segment.hpp>

namespace graze {

/// All points within `radius` of the segment from a to b. Equal ends make it a sphere, a zero radius a segment; both
/// are valid.
template <Dim N, class T = float>
struct Capsule {
  Vec<N, T> a = -unit_axis<N, T>(1);
  Vec<N, T> b = unit_axis<N, T>(1);
  T radius = T(1);
};

/// The segment that a capsule is built around.
template <Dim N, class T>
Segment<N, T> axis(const Capsule<N, T>& capsule) {
  return {capsule.a, capsule.b};
}

template <Dim N, class T>
std::string_view defect(const Capsule<N, T>& capsule) {
  if (!is_finite(capsule.a)) return "has an a that is not finite";
  if (!is_finite(capsule.b)) return "has a b that is not finite";
  if (!std::isfinite(capsule.radius)) return "has a radius that is not finite";
  if (capsule.radius < T(0)) return "has a negative radius";
  return "";
}

template <Dim N, class T>
Vec<N, double> support(const Capsule<N, T>& capsule, const std::type_identity_t<Vec<N, double>>& direction) {
  const double size = std::sqrt(dot(direction, direction));
  return support(axis(capsule), direction) + direction * (static_cast<double>(capsule.radius) / size);
}

template <Dim N, class T>
Capsule<N, T> transformed(const Capsule<N, T>& capsule, const Pose<N, T>& pose) {
  return {transformed(capsule.a, pose), transformed(capsule.b, pose), capsule.radius};
}

}  // namespace graze
