// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string_view>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/plane.hpp>

namespace graze {

/// All x with dot(normal, x) <= offset: the solid behind a plane, the plane included. In 2D the half-plane beside a
/// line. The normal points out of the solid and has any length but zero.
template <Dim N, class T = float>
struct HalfSpace {
  Vec<N, T> normal = unit_axis<N, T>(1);
  T offset = T(0);
};

/// The plane that bounds a half-space.
template <Dim N, class T>
Plane<N, T> boundary(const HalfSpace<N, T>& solid) {
  return {solid.normal, solid.offset};
}

template <Dim N, class T>
std::string_view defect(const HalfSpace<N, T>& solid) {
  return defect(boundary(solid));
}

template <Dim N, class T>
HalfSpace<N, T> transformed(const HalfSpace<N, T>& solid, const Pose<N, T>& pose) {
  const Plane<N, T> moved = transformed(boundary(solid), pose);
  return {moved.normal, moved.offset};
}

}  // namespace graze
