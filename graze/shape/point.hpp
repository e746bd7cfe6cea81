// SPDX-License-Identifier: MIT
/// @file
/// A point is a GLM vector; these overloads make it a shape.
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

/// The point of a convex shape that lies farthest along `direction` (any nonzero length), in double. If there are
/// several, which one is returned depends only on the arguments.
template <Dim N, class T>
Vec<N, double> support(const Vec<N, T>& point, const std::type_identity_t<Vec<N, double>>&) {
  return wide<N, T>(point);
}

}  // namespace graze
