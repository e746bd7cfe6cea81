// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>
#include <type_traits>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>

namespace graze {

/// The convex hull of three points; in 3D it has no thickness. Corners on one line, or in one place, are valid.
template <Dim N, class T = float>
struct Triangle {
  Vec<N, T> a = Vec<N, T>(T(0));
  Vec<N, T> b = unit_axis<N, T>(0);
  Vec<N, T> c = unit_axis<N, T>(1);

  std::array<Vec<N, T>, 3> vertices() const { return {a, b, c}; }
};

template <Dim N, class T>
std::string_view defect(const Triangle<N, T>& triangle) {
  for (const Vec<N, T>& vertex : triangle.vertices()) {
    if (!is_finite(vertex)) return "has a corner that is not finite";
  }
  return "";
}

template <Dim N, class T>
Vec<N, double> support(const Triangle<N, T>& triangle, const std::type_identity_t<Vec<N, double>>& direction) {
  Vec<N, double> best = wide<N, T>(triangle.a);
  for (const Vec<N, double>& vertex : {wide<N, T>(triangle.b), wide<N, T>(triangle.c)}) {
    if (dot(vertex, direction) > dot(best, direction)) best = vertex;
  }
  return best;
}

template <Dim N, class T>
Triangle<N, T> transformed(const Triangle<N, T>& triangle, const Pose<N, T>& pose) {
  return {transformed(triangle.a, pose), transformed(triangle.b, pose), transformed(triangle.c, pose)};
}

}  // namespace graze
