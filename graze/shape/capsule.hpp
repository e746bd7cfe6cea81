// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <type_traits>

#include <graze/math/vec.hpp>
#include <graze/shape/fields/defect.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/transformed.hpp>
#include <graze/shape/segment.hpp>

namespace graze {

/// All points at most `radius` away from the segment from a to b. Equal ends make it a sphere, a zero radius a segment;
/// both are valid.
template <Dim N, class T = float>
struct Capsule {
  Vec<N, T> a = -unit_axis<N, T>(1);  ///< First end of the axis.
  Vec<N, T> b = unit_axis<N, T>(1);   ///< Second end of the axis.
  T radius = T(1);                    ///< At least zero.
};

/// The axis of a capsule: the segment from a to b.
template <Dim N, class T>
Segment<N, T> axis(const Capsule<N, T>& capsule) {
  return {capsule.a, capsule.b};
}

namespace detail {
template <Dim N, class T>
inline constexpr auto description_of<Capsule<N, T>> = Description("capsule", field::point("a", &Capsule<N, T>::a),
                                                                  field::point("b", &Capsule<N, T>::b),
                                                                  field::length("radius", &Capsule<N, T>::radius));
}  // namespace detail

/// The point that is farthest along `direction` (any nonzero length), in double: that of the axis, moved by the radius.
/// If both ends are equally far, a's. The square of the length must not overflow or underflow.
template <Dim N, class T>
Vec<N, double> support(const Capsule<N, T>& capsule, const std::type_identity_t<Vec<N, double>>& direction) {
  const double size = std::sqrt(dot(direction, direction));
  return support(axis(capsule), direction) + direction * (static_cast<double>(capsule.radius) / size);
}

}  // namespace graze
