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

/// A convex shape seen through a pose: turned, then moved. What it is for are shapes of one's own, which `transformed`
/// does not know: through it they are placed without being written anew. Every query answers about it from its support
/// points, in the shape's own numbers, rounded relative to where it is before and after: shapes of one's own are best
/// written around zero. For graze's own shapes `transformed(shape, pose)` is as good and has their closed forms.
/// `Polytope`s seen through poses are not copied. A radius is not changed by a rotation that is only nearly one.
/// Default: the default shape where it is.
template <Convex S>
struct Posed {
  S shape{};
  Pose<dimension_of<S>, scalar_of<S>> pose{};
};

template <Convex S>
struct ShapeTraits<Posed<S>> : Space<dimension_of<S>, scalar_of<S>> {};

namespace detail {

/// What a shape's support points are calculated in.
template <Convex S>
using SupportScalar = std::conditional_t<SupportsIn<S, dimension_of<S>, double>, double, scalar_of<S>>;
template <Convex S>
using SupportVec = Vec<dimension_of<S>, SupportScalar<S>>;

}  // namespace detail

/// Of the set of all rotation * x + position with x in the shape: exactly that set up to rounding, also for a rotation
/// that is only nearly one.
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

/// What is wrong with the shape, if that can be told, or with the pose: its numbers are finite, its rotation is
/// orthonormal up to tolerance::orthonormal.
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

template <Convex S>
Posed<S> transformed(const Posed<S>& posed, const Pose<dimension_of<S>, scalar_of<S>>& pose) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  return {posed.shape, {rotated<N, T>(posed.pose.rotation, pose), transformed<N, T>(posed.pose.position, pose)}};
}

}  // namespace graze
