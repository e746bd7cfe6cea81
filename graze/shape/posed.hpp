// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <type_traits>

#include <graze/math/pose.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

/// A convex shape seen through a pose: rotated, then translated. Intended for user-defined shapes, which `transformed`
/// does not know: it places them without a new class. Queries use its support points, in the shape's own number type.
/// Their errors are relative to the coordinates before and after the pose, so define such shapes around the origin. For
/// built-in shapes `transformed(shape, pose)` is equally exact and has closed forms; but a posed `Polytope` is not
/// copied. A radius does not change if the rotation is orthonormal only nearly. Default: the default shape with the
/// identity.
template <Convex S>
struct Posed {
  S shape{};                                   ///< In its own coordinates.
  Pose<dimension_of<S>, scalar_of<S>> pose{};  ///< Takes the shape's coordinates to the world's.
};

template <Convex S>
struct ShapeTraits<Posed<S>> : Space<dimension_of<S>, scalar_of<S>> {};

namespace detail {

/// The number type of a shape's support points.
template <Convex S>
using SupportScalar = std::conditional_t<SupportsIn<S, dimension_of<S>, double>, double, scalar_of<S>>;
template <Convex S>
using SupportVec = Vec<dimension_of<S>, SupportScalar<S>>;

}  // namespace detail

/// The point farthest along `direction` (any nonzero length) of the set of all rotation * x + position with x in the
/// shape. Exact up to rounding, also for a rotation that is orthonormal only nearly.
template <Convex S>
detail::SupportVec<S> support(const Posed<S>& posed, const std::type_identity_t<detail::SupportVec<S>>& direction) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  using Number = detail::SupportScalar<S>;
  const Mat<N, double> rotation = wide_matrix<N, T>(posed.pose.rotation);
  const Vec<N, double> turned_back = transpose(rotation) * wide<N, Number>(direction);
  const Vec<N, Number> on_shape = support(posed.shape, Vec<N, Number>(turned_back));
  return Vec<N, Number>(rotation * wide<N, Number>(on_shape) + wide<N, T>(posed.pose.position));
}

/// Empty for valid values. Otherwise the first fault, worded as the rest of a sentence: the shape's own defect if it
/// has one, a position that is not finite, or a rotation that deviates from orthonormal by more than
/// `tolerance::orthonormal`.
template <Convex S>
std::string_view defect(const Posed<S>& posed) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  if constexpr (requires { defect(posed.shape); }) {
    if (const std::string_view of_shape = defect(posed.shape); !of_shape.empty()) return of_shape;
  }
  if (!is_finite(posed.pose.position)) return "has a position that is not finite";
  if (!(orthonormal_error<N, T>(posed.pose.rotation) <= tolerance::orthonormal)) {
    return "has a rotation whose columns are not orthonormal";
  }
  return "";
}

/// Applies `pose` after the pose it has; the shape itself is kept. Each number is rounded to the shape's type once.
template <Convex S>
Posed<S> transformed(const Posed<S>& posed, const Pose<dimension_of<S>, scalar_of<S>>& pose) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  return {posed.shape, {rotated<N, T>(posed.pose.rotation, pose), transformed<N, T>(posed.pose.position, pose)}};
}

}  // namespace graze
