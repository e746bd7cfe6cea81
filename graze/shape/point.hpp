// SPDX-License-Identifier: MIT
// A point is a GLM vector; these overloads let it stand wherever a shape may.
#pragma once

#include <string_view>
#include <type_traits>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>

namespace graze {

/// What is wrong with a shape's numbers, as the rest of a sentence that begins with the shape; empty when nothing is.
template <Dim N, class T>
std::string_view defect(const Vec<N, T>& point) {
  return is_finite(point) ? "" : "has a coordinate that is not finite";
}

/// The point of a convex shape that lies farthest along `direction` (not zero, any length), in double.
/// Of several such points any one, always the same.
template <Dim N, class T>
Vec<N, double> support(const Vec<N, T>& point, const std::type_identity_t<Vec<N, double>>&) {
  return wide<N, T>(point);
}

}  // namespace graze
