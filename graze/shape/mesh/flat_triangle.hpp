// SPDX-License-Identifier: MIT
// Whether a triangle is flat, and from where it is seen not to be.
#pragma once

#include <array>

#include <graze/math/orientation.hpp>
#include <graze/math/vec.hpp>

namespace graze::detail {

/// A point without one of its coordinates; the other two in the order in which a turn that is counter-clockwise as seen
/// from the axis' positive end stays counter-clockwise.
template <class T>
Vec<2, T> seen_along(Dim axis, const Vec<3, T>& point) {
  return {point[(axis + 1) % 3], point[(axis + 2) % 3]};
}
template <class T>
std::array<Vec<2, T>, 3> seen_along(Dim axis, const std::array<Vec<3, T>, 3>& corners) {
  return {seen_along(axis, corners[0]), seen_along(axis, corners[1]), seen_along(axis, corners[2])};
}

/// An axis along which three points are seen as a triangle with an area; -1 if they are collinear.
template <class T>
Dim axis_across(const Vec<3, T>& a, const Vec<3, T>& b, const Vec<3, T>& c) {
  for (Dim axis = 0; axis < 3; ++axis) {
    if (orientation(seen_along(axis, a), seen_along(axis, b), seen_along(axis, c)) != 0) return axis;
  }
  return -1;
}

/// Whether three points are collinear, which is decided exactly.
template <class T>
bool is_flat(const std::array<Vec<2, T>, 3>& corners) {
  return orientation(corners[0], corners[1], corners[2]) == 0;
}
template <class T>
bool is_flat(const std::array<Vec<3, T>, 3>& corners) {
  return axis_across(corners[0], corners[1], corners[2]) < 0;
}

}  // namespace graze::detail
