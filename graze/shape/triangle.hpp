// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <type_traits>

#include <graze/math/vec.hpp>
#include <graze/shape/fields/defect.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/transformed.hpp>

namespace graze {

/// The convex hull of three points; in 3D it has no thickness. Collinear and equal corners are valid.
template <Dim N, class T = float>
struct Triangle {
  Vec<N, T> a = Vec<N, T>(T(0));     ///< First corner.
  Vec<N, T> b = unit_axis<N, T>(0);  ///< Second corner.
  Vec<N, T> c = unit_axis<N, T>(1);  ///< Third corner.

  /// The corners a, b, c.
  std::array<Vec<N, T>, 3> vertices() const { return {a, b, c}; }
};

namespace detail {
template <Dim N, class T>
inline constexpr auto description_of<Triangle<N, T>> = Description("triangle",
                                                                   field::point("a", &Triangle<N, T>::a, "corner"),
                                                                   field::point("b", &Triangle<N, T>::b, "corner"),
                                                                   field::point("c", &Triangle<N, T>::c, "corner"));
}  // namespace detail

/// The corner that is farthest along `direction` (any nonzero length), in double; of several the first of a, b, c.
template <Dim N, class T>
Vec<N, double> support(const Triangle<N, T>& triangle, const std::type_identity_t<Vec<N, double>>& direction) {
  Vec<N, double> best = wide<N, T>(triangle.a);
  for (const Vec<N, double>& vertex : {wide<N, T>(triangle.b), wide<N, T>(triangle.c)}) {
    if (dot(vertex, direction) > dot(best, direction)) best = vertex;
  }
  return best;
}

}  // namespace graze
