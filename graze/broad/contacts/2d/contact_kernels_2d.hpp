// SPDX-License-Identifier: MIT
// The manifolds of many touching pairs of 2D spheres, capsules and boxes, one pair per lane, compiled for each
// instruction set: the 2D counterpart of contacts/contact_kernels.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <graze/broad/contacts/contact_kernels.hpp>
#include <graze/broad/simd/space_kernels.hpp>

namespace graze::detail {

/// Two shapes of the same kind, except spheres, are in the order of shapes of one type (shape/fields/shape_order.hpp).
enum class Kind2d : std::uint8_t {
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
inline constexpr std::size_t kinds_2d = 10;

/// By kind.
template <class T>
using ContactKernels2d = std::array<ContactKernel<2, T>, kinds_2d>;

/// The kernels of one instruction set.
using AllContactKernels2d = ScalarKernels<ContactKernels2d>;

/// The kernels for this machine. Instantiated for float and double.
template <class T>
const ContactKernels2d<T>& contact_kernels_2d();

}  // namespace graze::detail
