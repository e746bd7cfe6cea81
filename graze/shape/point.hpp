// SPDX-License-Identifier: MIT
// A point is a GLM vector; these overloads let it stand wherever a shape may.
#pragma once

#include <type_traits>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/fields/defect.hpp>
#include <graze/shape/fields/description.hpp>

namespace graze {

namespace detail {
template <Dim N, class T>
inline constexpr auto description_of<Vec<N, T>> = Description("point",
                                                              field::point("position", Itself(), "coordinate"));
}  // namespace detail

/// The point of a convex shape that lies farthest along `direction` (not zero, any length), in double.
/// Of several such points any one, always the same.
template <Dim N, class T>
Vec<N, double> support(const Vec<N, T>& point, const std::type_identity_t<Vec<N, double>>&) {
  return wide<N, T>(point);
}

}  // namespace graze
