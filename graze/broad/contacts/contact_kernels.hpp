// SPDX-License-Identifier: MIT
// The manifolds of many pairs of spheres and capsules, of either and boxes, or of boxes along the axes, in space, that
// touch, a lane for each, once for every set of vector instructions that the compiler knows: in double and operation by
// operation what manifold(a, b) does, so that the answers are the same to the bit. A kernel leaves the pairs of which
// not all is clear; which these are does not depend on the machine, but that those without vectors of four doubles
// leave all.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <graze/broad/simd/space_kernels.hpp>
#include <graze/query/manifold.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

enum class PrimitiveKind : std::uint8_t {
  sphere_sphere,
  sphere_capsule,
  capsule_capsule,
  sphere_aabb,
  sphere_obb,
  aabb_aabb,
  capsule_aabb,
  capsule_obb
};
inline constexpr std::size_t primitive_kinds = 8;

/// The numbers of two valid shapes that touch, and where their manifold goes. A sphere comes before others, and a
/// capsule before boxes; of two capsules, or boxes, the one that does in the order of shapes of one type
/// (shape/fields/shape_order.hpp).
template <Dim N, class T>
struct PrimitivesToContact {
  const T* first;
  const T* second;
  bool turned;  ///< The manifold is from the second to the first.
  Manifold<N, T>* manifold;
};

/// Writes the manifolds of most pairs, which must be as they are made: what stays zero in them is not written. `left`,
/// which has room for all, receives the places of the others; returns how many these are.
template <Dim N, class T>
using ContactKernel = std::size_t (*)(std::span<const PrimitivesToContact<N, T>> pairs, std::uint32_t* left);

/// What kernels do where there are no vectors for them.
inline std::size_t leave_all(std::size_t count, std::uint32_t* left) {
  for (std::size_t i = 0; i < count; ++i) left[i] = static_cast<std::uint32_t>(i);
  return count;
}

/// By kind.
template <class T>
using ContactKernels = std::array<ContactKernel<3, T>, primitive_kinds>;

/// The kernels of one instruction set.
using AllContactKernels = ScalarKernels<ContactKernels>;

/// The kernels for this machine. Instantiated for float and double.
template <class T>
const ContactKernels<T>& contact_kernels();

}  // namespace graze::detail
