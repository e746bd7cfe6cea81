// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <type_traits>

#include <graze/math/vec.hpp>
#include <graze/shape/fields/defect.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/transformed.hpp>

namespace graze {

/// The solid sphere, in 2D the disc, surface included. A zero radius is valid: the sphere is a point.
template <Dim N, class T = float>
struct Sphere {
  Vec<N, T> center = Vec<N, T>(T(0));  ///< Center of the sphere.
  T radius = T(1);                     ///< At least zero.
};

/// The solid circle: a 2D Sphere.
template <class T = float>
using Circle = Sphere<2, T>;

namespace detail {
template <Dim N, class T>
inline constexpr auto description_of<Sphere<N, T>> = Description("sphere",
                                                                 field::point("center", &Sphere<N, T>::center),
                                                                 field::length("radius", &Sphere<N, T>::radius));
}  // namespace detail

/// The point that is farthest along `direction` (any nonzero length), in double. The square of the length must not
/// overflow or underflow.
template <Dim N, class T>
Vec<N, double> support(const Sphere<N, T>& sphere, const std::type_identity_t<Vec<N, double>>& direction) {
  const double size = std::sqrt(dot(direction, direction));
  return wide<N, T>(sphere.center) + direction * (static_cast<double>(sphere.radius) / size);
}

}  // namespace graze
