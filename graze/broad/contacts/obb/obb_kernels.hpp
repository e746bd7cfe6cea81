// SPDX-License-Identifier: MIT
// The manifolds of many pairs of 3D oriented boxes, one pair per lane, compiled for each instruction set. First, a test
// of their axes in float, which also decides for most pairs whether they overlap, proved by an error bound; then the
// contacts of those that do, in double with the operations of manifold(a, b), so the answers are bit-identical. A
// kernel leaves uncertain pairs and rare cases; which these are may depend on the machine, but the answers never do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <graze/broad/simd/space_kernels.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/manifold.hpp>
#include <graze/shape/obb.hpp>

namespace graze::detail {

/// Two valid oriented boxes.
template <class T>
struct TwoObbs {
  const Obb<3, T>* a;
  const Obb<3, T>* b;
};

/// The result of testing the fifteen axes of two oriented boxes, as bits.
struct ObbAxisTest {
  static constexpr std::uint32_t no_axis = 15;
  static constexpr std::uint32_t axis_bits = 15;
  static constexpr std::uint32_t overlapping = 1U << 15U;
  static constexpr std::uint32_t apart = 1U << 16U;
  static constexpr std::uint32_t along_face = 1U << 24U;
  static constexpr std::uint32_t turned = 1U << 25U;

  std::uint32_t bits = no_axis;

  /// The index of the axis of least depth, as in BoxesAxes, if the boxes overlap; no_axis if unknown.
  std::uint32_t axis() const { return bits & axis_bits; }
  bool is_overlapping() const { return (bits & overlapping) != 0; }  ///< Certain; so is the next.
  bool is_apart() const { return (bits & apart) != 0; }
  /// If false, certainly no face is parallel to the axis except the one whose normal it is.
  bool may_be_along_face() const { return (bits & along_face) != 0; }
  /// Whether the second box is the first in their contact order. Valid only if the axis is known.
  bool is_turned() const { return (bits & turned) != 0; }

  friend bool operator==(const ObbAxisTest&, const ObbAxisTest&) = default;
};

/// Two overlapping boxes, the result of their axis test, and where their manifold from a to b goes.
template <class T>
struct ObbsToContact {
  TwoObbs<T> boxes;
  ObbAxisTest look;
  Manifold<3, T>* manifold;
};

/// The maximum number of pairs in a kernel's batch.
inline constexpr std::size_t most_obbs_to_contact = 256;

/// Which box of a pair is the first in their contact order: that of is_in_order, or the first argument.
enum class FirstBox : std::uint8_t { in_order, as_named };

/// Tests the axes of pairs that may be apart.
template <class T>
using AxisKernel = void (*)(std::span<const TwoObbs<T>> pairs, FirstBox first, ObbAxisTest* looks);

/// Writes the manifolds of most pairs, which must be value-initialised, because zeros are not written. `left`, which
/// has space for all, receives the indices of the other pairs, whose manifolds are unspecified; returns their number.
template <class T>
using ManifoldKernel = std::size_t (*)(std::span<const ObbsToContact<T>> pairs, std::uint32_t* left);

template <class T>
struct ObbKernels {
  AxisKernel<T> look;
  ManifoldKernel<T> contact;
};

/// The kernels of one instruction set.
using AllObbKernels = ScalarKernels<ObbKernels>;

/// The kernels for this machine. Without vectors of four doubles, they decide nothing and leave all pairs. Instantiated
/// for float and double.
template <class T>
const ObbKernels<T>& obb_kernels();

}  // namespace graze::detail
