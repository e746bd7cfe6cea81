// SPDX-License-Identifier: MIT
// The cores of capsules and boxes in 2D, by cores_2d-inl.hpp. Include manifold.hpp.
#pragma once

#include <cstddef>

#include <graze/math/vec.hpp>
#include <graze/query/fast_contact/one_pair.hpp>
#include <graze/query/fast_contact/spheres_and_capsules.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>

namespace graze::detail::one_pair {
#include <graze/query/fast_contact/cores_2d-inl.hpp>

template <class T>
[[gnu::always_inline]] inline ObbNumbers2d numbers_of(const Obb<2, T>& box) {
  const Mat<2, double> axes = wide_matrix<2, T>(box.axes);
  const Vec<2, double> half = wide<2, T>(box.half_extents);
  return {wide<2, T>(box.center), {half.x, half.y}, {axes[0], axes[1]}};
}
template <class T>
[[gnu::always_inline]] inline AabbNumbers2d numbers_of(const Aabb<2, T>& box) {
  return {wide<2, T>(box.min), wide<2, T>(box.max)};
}
}  // namespace graze::detail::one_pair
