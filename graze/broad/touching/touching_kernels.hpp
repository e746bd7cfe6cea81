// SPDX-License-Identifier: MIT
// Fast verdicts on many pairs of one kind at a time, compiled for each instruction set. They decide all pairs except
// those that nearly touch; `relation` decides the rest. Which lanes remain open may depend on the machine, but the
// answers never do.
#pragma once

#include <cstddef>
#include <cstdint>

#include <graze/broad/pair.hpp>
#include <graze/math/vec.hpp>

namespace graze::detail {

/// The number of pairs in a group: the lanes of the widest vector of floats.
inline constexpr std::size_t touch_group = 16;

/// The certain verdicts on a group of pairs, one bit each. Neither bit set: too close to decide, or NaN.
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

/// The same for arrays of shapes of one type, by the pairs that name them.
template <class T>
using TouchListKernel = void (*)(const T* shapes, const Pair* pairs, std::size_t groups, GroupVerdict* verdicts);

/// Writes the overlapping pairs of whole groups to `out`, which has space for all, in order. Returns their number.
using KeepKernel = std::size_t (*)(const Pair* pairs, const GroupVerdict* verdicts, std::size_t groups, Pair* out);

template <class T>
struct TouchingKernels {
  TouchKernel<T> of[touch_kinds];
  TouchListKernel<T> of_spheres;
  TouchListKernel<T> of_aabbs;
  TouchListKernel<T> of_obbs;       ///< Leaves two or three percent of the pairs open, for
  TouchListKernel<T> of_open_obbs;  ///< this one, which leaves one in thousands.
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
