// SPDX-License-Identifier: MIT
// The manifolds of many touching pairs of 3D spheres and capsules, of either with boxes, or of AABBs, one pair per
// lane, compiled for each instruction set. They calculate in double with the operations of manifold(a, b), so the
// answers are bit-identical. A kernel leaves pairs that are not certain; which these are does not depend on the
// machine, except that machines without vectors of four doubles leave all.
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

/// The numbers of two valid touching shapes, and where their manifold goes. A sphere comes first, then a capsule, then
/// a box; two capsules or boxes are in the order of shapes of one type (shape/fields/shape_order.hpp).
template <Dim N, class T>
struct PrimitivesToContact {
  const T* first;
  const T* second;
  bool turned;  ///< The manifold is from the second to the first.
  Manifold<N, T>* manifold;
};

/// Writes the manifolds of most pairs, which must be value-initialised, because zeros are not written. `left`, which
/// has space for all, receives the indices of the other pairs; returns their number.
template <Dim N, class T>
using ContactKernel = std::size_t (*)(std::span<const PrimitivesToContact<N, T>> pairs, std::uint32_t* left);

/// The kernel for machines without suitable vectors.
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
