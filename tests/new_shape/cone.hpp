// SPDX-License-Identifier: MIT
// The first of the three places: the header of a new shape, which is defined by its support function alone.
#pragma once

#include <cmath>
#include <type_traits>

#include <graze/math/vec.hpp>
#include <graze/shape/fields/defect.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/transformed.hpp>

namespace graze {

/// The convex hull of a tip and of a disc around a base, perpendicular to the axis between them. If the two coincide,
/// it is a sphere.
template <Dim N, class T = float>
struct Cone {
  Vec<N, T> tip = unit_axis<N, T>(1);
  Vec<N, T> base = Vec<N, T>(T(0));
  T radius = T(1);
};

namespace detail {
template <Dim N, class T>
inline constexpr auto description_of<Cone<N, T>> = Description("cone", field::point("tip", &Cone<N, T>::tip),
                                                               field::point("base", &Cone<N, T>::base),
                                                               field::length("radius", &Cone<N, T>::radius));
}  // namespace detail

template <Dim N, class T>
Vec<N, double> support(const Cone<N, T>& cone, const std::type_identity_t<Vec<N, double>>& direction) {
  const Vec<N, double> tip = wide<N, T>(cone.tip);
  const Vec<N, double> axis = wide<N, T>(cone.base) - tip;
  const double axis_squared = dot(axis, axis);
  const Vec<N, double> across = axis_squared > 0 ? direction - axis * (dot(direction, axis) / axis_squared) : direction;
  const double size = std::sqrt(dot(across, across));
  Vec<N, double> rim = tip + axis;
  if (size > 0) rim += across * (static_cast<double>(cone.radius) / size);
  return dot(tip, direction) > dot(rim, direction) ? tip : rim;
}

}  // namespace graze
