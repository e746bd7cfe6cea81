// SPDX-License-Identifier: MIT
// The manifolds of many pairs of spheres, capsules and boxes in the plane that touch, a lane for each, once for every
// set of vector instructions that the compiler knows: as contacts/contact_kernels.hpp has them in space.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <graze/broad/contacts/contact_kernels.hpp>
#include <graze/broad/simd/space_kernels.hpp>

namespace graze::detail {

/// Two of a kind are in the order of shapes of one type (shape/fields/shape_order.hpp), but for spheres.
enum class FlatKind : std::uint8_t {
  sphere_sphere,
  sphere_obb,
  sphere_aabb,
  sphere_capsule,
  obb_obb,
  obb_aabb,
  obb_capsule,
  aabb_aabb,
  aabb_capsule,
  capsule_capsule
};
inline constexpr std::size_t flat_kinds = 10;

/// By kind.
template <class T>
using FlatKernels = std::array<PrimitiveKernel<2, T>, flat_kinds>;

/// The kernels of one instruction set.
using AllFlatKernels = ScalarKernels<FlatKernels>;

/// The kernels for this machine. Instantiated for float and double.
template <class T>
const FlatKernels<T>& flat_kernels();

}  // namespace graze::detail
