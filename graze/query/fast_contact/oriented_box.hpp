// SPDX-License-Identifier: MIT
// A 3D box, axis-aligned or not, as an oriented one in double.
#pragma once

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>

namespace graze::detail {

template <class T>
Obb<3, double> oriented_box_from(const Vec<3, double>& origin, const Obb<3, T>& box) {
  return {wide<3, T>(box.center) - origin, wide<3, T>(box.half_extents), wide_matrix<3, T>(box.axes)};
}

/// The center and the extents are off by four roundings of the given coordinates.
template <class T>
Obb<3, double> oriented_box_from(const Vec<3, double>& origin, const Aabb<3, T>& box) {
  const Vec<3, double> low = wide<3, T>(box.min) - origin;
  const Vec<3, double> high = wide<3, T>(box.max) - origin;
  return {0.5 * (low + high), 0.5 * (wide<3, T>(box.max) - wide<3, T>(box.min)), Mat<3, double>(1.0)};
}

}  // namespace graze::detail
