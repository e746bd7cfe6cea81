// SPDX-License-Identifier: MIT
// The manifolds of many pairs of oriented boxes in space at a time, a lane for each, once for every set of vector
// instructions that the compiler knows. First a look in float at their axes, which also says of most whether they meet,
// all of it proved by a bound; then the contact of those that do, in double and operation by operation what
// manifold(a, b) does, so that the answers are the same to the bit. A kernel leaves the pairs of which not all is
// clear, and those that take a rare way; which these are may depend on the machine, but the answers never do.
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

/// What a look at the fifteen axes of two oriented boxes shows, all of it as bits.
struct ObbsLook {
  static constexpr std::uint32_t no_axis = 15;
  static constexpr std::uint32_t axis_bits = 15;
  static constexpr std::uint32_t overlapping = 1U << 15U;
  static constexpr std::uint32_t apart = 1U << 16U;
  static constexpr std::uint32_t along_face = 1U << 24U;
  static constexpr std::uint32_t turned = 1U << 25U;

  std::uint32_t bits = no_axis;

  /// The axis of least depth by its place, as in BoxesAxes, if the boxes meet; or no_axis if it is not known.
  std::uint32_t axis() const { return bits & axis_bits; }
  bool is_overlapping() const { return (bits & overlapping) != 0; }  ///< For certain; and so is the next.
  bool is_apart() const { return (bits & apart) != 0; }
  /// False for certain: no face looks along the axis but one that it is the normal of.
  bool may_be_along_face() const { return (bits & along_face) != 0; }
  /// Whether the second box is the first in the order of their contact. Of meaning only where the axis is known.
  bool is_turned() const { return (bits & turned) != 0; }

  friend bool operator==(const ObbsLook&, const ObbsLook&) = default;
};

/// Two that meet, what a look has shown, and where their manifold from a to b goes.
template <class T>
struct ObbsToContact {
  TwoObbs<T> boxes;
  ObbsLook look;
  Manifold<3, T>* manifold;
};

/// How many pairs a kernel takes in one go, at most.
inline constexpr std::size_t most_obbs_to_contact = 256;

/// Which box of a pair is the first in the order of their contact: that of is_in_order, or the one that is named first.
enum class FirstBox : std::uint8_t { in_order, as_named };

/// Looks at the axes of pairs that may be apart.
template <class T>
using AxisKernel = void (*)(std::span<const TwoObbs<T>> pairs, FirstBox first, ObbsLook* looks);

/// Writes the manifolds of most pairs, which must be as they are made: what stays zero in them is not written. `left`,
/// which has room for all, receives the places of the others, of whose manifolds nothing is written or what is of no
/// meaning; returns how many these are.
template <class T>
using ManifoldKernel = std::size_t (*)(std::span<const ObbsToContact<T>> pairs, std::uint32_t* left);

template <class T>
struct ObbKernels {
  AxisKernel<T> look;
  ManifoldKernel<T> contact;
};

/// The kernels of one instruction set.
using AllObbKernels = ScalarKernels<ObbKernels>;

/// The kernels for this machine. Those without vectors of four doubles or more know nothing and leave all pairs.
/// Instantiated for float and double.
template <class T>
const ObbKernels<T>& obb_kernels();

}  // namespace graze::detail
