// SPDX-License-Identifier: MIT
/// @file
/// What makes a type a shape. No base class and no registration is needed: a type in any namespace is a convex shape if
/// argument-dependent lookup finds `support(shape, direction)` for it.
#pragma once

#include <concepts>
#include <string_view>

#include <graze/math/vec.hpp>
#include <graze/shape/point.hpp>

namespace graze {

/// `support(shape, direction)` takes and returns vectors of this dimension and number type.
template <class S, Dim N, class T>
concept SupportsIn = requires(const S& shape, const Vec<N, T>& direction) {
  { support(shape, direction) } -> std::same_as<Vec<N, T>>;
};

/// A dimension and a number type, as ShapeTraits has them.
template <Dim N, Scalar T>
struct Space {
  static constexpr Dim dimension = N;  ///< 2 or 3.
  using scalar = T;                    ///< float or double.
};

/// The dimension and number type of a shape. For built-in types they are taken from the template arguments, for a
/// user's type from the type of `support`. Specialise it for a type to which neither applies.
template <class S>
struct ShapeTraits {};

template <template <Dim, class> class S, Dim N, Scalar T>
struct ShapeTraits<S<N, T>> : Space<N, T> {};

template <Dim N, Scalar T>
struct ShapeTraits<Vec<N, T>> : Space<N, T> {};

template <SupportsIn<2, float> S>
struct ShapeTraits<S> : Space<2, float> {};

template <SupportsIn<2, double> S>
struct ShapeTraits<S> : Space<2, double> {};

template <SupportsIn<3, float> S>
struct ShapeTraits<S> : Space<3, float> {};

template <SupportsIn<3, double> S>
struct ShapeTraits<S> : Space<3, double> {};

/// A type with a known dimension and number type.
template <class S>
concept Shape = requires {
  typename ShapeTraits<S>::scalar;
  { ShapeTraits<S>::dimension } -> std::convertible_to<Dim>;
};

/// The dimension of a shape, 2 or 3.
template <Shape S>
inline constexpr Dim dimension_of = ShapeTraits<S>::dimension;

/// The number type of a shape, float or double.
template <Shape S>
using scalar_of = typename ShapeTraits<S>::scalar;

/// A bounded convex shape: it has a support function, in double (built-in shapes, whatever they store) or in its own
/// number type.
template <class S>
concept Convex = Shape<S> &&(SupportsIn<S, dimension_of<S>, double> || SupportsIn<S, dimension_of<S>, scalar_of<S>>);

/// A convex shape of the same dimension as another.
template <class B, class A>
concept SameDimension = Convex<A> && Convex<B> && dimension_of<A>
== dimension_of<B>;

/// A shape of the same dimension and number type as another.
template <class B, class A>
concept SameSpace = Shape<A> && Shape<B> && dimension_of<A>
== dimension_of<B>&& std::same_as<scalar_of<A>, scalar_of<B>>;

/// True if a shape's numbers make sense: finite, no negative size, no zero direction. Queries may assume it. Degenerate
/// shapes (zero radius, equal ends, flat boxes) are valid. `defect(shape)` tells in words what is wrong.
template <Shape S>
bool is_valid(const S& shape) {
  return defect(shape).empty();
}

}  // namespace graze
