// SPDX-License-Identifier: MIT
// Quick verdicts on many pairs of one kind at a time, once for every set of vector instructions that the compiler
// knows. They settle all pairs but those which nearly touch; `relation` settles the rest. So which lanes are left open
// may depend on the machine, but the answers never do.
#pragma once

#include <cstddef>
#include <cstdint>

#include <graze/broad/pair.hpp>
#include <graze/math/vec.hpp>

namespace graze::detail {

/// How many pairs a kernel takes in one go: the lanes of the widest vector of floats.
inline constexpr std::size_t touch_group = 16;

/// What is certain of a group of pairs, one bit each. Neither: too close to tell, or not numbers.
struct GroupVerdict {
  std::uint16_t apart = 0;
  std::uint16_t overlapping = 0;
};

/// The pairs of shapes that have a kernel.
enum class TouchKind : std::uint8_t {
  sphere_sphere,
  sphere_aabb,
  sphere_obb,
  sphere_capsule,
  aabb_aabb,
  aabb_obb,
  aabb_capsule,
  obb_obb,
  obb_capsule,
  capsule_capsule,
};
inline constexpr std::size_t touch_kinds = 10;

/// Verdicts on `groups` times `touch_group` pairs: a[i] and b[i] point to the first number of the shapes' structs.
template <class T>
using TouchKernel = void (*)(const T* const* a, const T* const* b, std::size_t groups, GroupVerdict* verdicts);

/// The same for shapes of one type that lie side by side, by the pairs that name them.
template <class T>
using TouchListKernel = void (*)(const T* shapes, const Pair* pairs, std::size_t groups, GroupVerdict* verdicts);

/// Writes the pairs of whole groups that overlap to `out`, which has room for all, in their order. Returns how many.
using KeepKernel = std::size_t (*)(const Pair* pairs, const GroupVerdict* verdicts, std::size_t groups, Pair* out);

template <class T>
struct TouchingKernels {
  TouchKernel<T> of[touch_kinds];
  TouchListKernel<T> of_spheres;
  TouchListKernel<T> of_aabbs;
  TouchListKernel<T> of_obbs;       ///< Leaves two or three of a hundred pairs open, to
  TouchListKernel<T> of_open_obbs;  ///< this one, which leaves one of thousands.
  TouchListKernel<T> of_capsules;
  KeepKernel keep;

  TouchKernel<T> operator[](TouchKind kind) const { return of[static_cast<std::size_t>(kind)]; }
};

/// The kernels of one instruction set.
struct AllTouchingKernels {
  TouchingKernels<float> float_2d;
  TouchingKernels<float> solid_float;
  TouchingKernels<double> double_2d;
  TouchingKernels<double> solid_double;
};

/// The kernels for this machine. Instantiated for 2D and 3D, float and double.
template <Dim N, class T>
const TouchingKernels<T>& touching_kernels();

}  // namespace graze::detail
