// SPDX-License-Identifier: MIT
// Every epsilon of graze, each with its reason. All are relative: a caller multiplies by the size of the numbers at
// hand.
#pragma once

#include <limits>

#include <graze/math/vec.hpp>

namespace graze::tolerance {

/// The spacing of doubles just above 1.
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// How far a sum of a few products can be off, relative to the sum of the products' absolute values. Our longest are
/// differences of two coordinates multiplied by a cross product and summed over three axes: under 8 roundings of
/// epsilon / 2 each; doubled, because the magnitudes are themselves estimated in double.
inline constexpr double rounding = 8 * epsilon;

/// How far an oriented box's axes may be from orthonormal. Float rotations stay within it though a thousand of them are
/// multiplied without care (measured: 7e-5); a matrix with scale or shear, the usual mistake, does not.
inline constexpr double orthonormal = 1e-4;

/// GJK stops when its upper and lower bounds on the distance agree to this, relative to the upper bound.
inline constexpr double gjk_relative_gap = 1e-12;

/// What GJK and EPA cannot resolve, relative to the largest coordinate of the two shapes: a support point carries about
/// four roundings, their difference and the projection on a unit normal about as many again.
inline constexpr double convex = 32 * epsilon;

/// Boxes are grown by this, relative to their largest coordinate, before boxes that miss each other are taken as proof
/// that their shapes do: more than any verdict's rounding band, relative to the same coordinate.
inline constexpr double box_slack = 256 * epsilon;

/// Support functions of a user's shape may calculate in T: the band for their answers.
template <Scalar T>
inline constexpr double convex_in = 32.0 * static_cast<double>(std::numeric_limits<T>::epsilon());

}  // namespace graze::tolerance
