// SPDX-License-Identifier: MIT
// The manifolds of many pairs of oriented boxes in space at a time, a lane for each, once for every set of vector
// instructions that the compiler knows: in double and operation by operation what manifold(a, b) does, so that the
// answers are the same to the bit. A kernel leaves the pairs of which not all is clear, and those that take a rare way;
// which these are may depend on the machine, but the answers never do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <graze/math/vec.hpp>
#include <graze/query/manifold.hpp>
#include <graze/shape/obb.hpp>

namespace graze::detail {

/// Two valid oriented boxes that meet, and where their manifold goes, from a to b.
template <class T>
struct ObbsToContact {
  const Obb<3, T>* a;
  const Obb<3, T>* b;
  Manifold<3, T>* manifold;
};

/// How many pairs a kernel takes in one go, at most.
inline constexpr std::size_t most_obbs_to_contact = 256;

/// Writes every field of the manifolds of most pairs. `left`, which has room for all, receives the places of the
/// others, of whose manifolds nothing is written or what is of no meaning; returns how many these are.
template <class T>
using ManifoldKernel = std::size_t (*)(std::span<const ObbsToContact<T>> pairs, std::uint32_t* left);

struct ManifoldKernels {
  ManifoldKernel<float> of_floats;
  ManifoldKernel<double> of_doubles;
};

/// The kernel for this machine. One without vectors of four doubles or more leaves all pairs. Instantiated for float
/// and double.
template <class T>
ManifoldKernel<T> manifold_kernel();

}  // namespace graze::detail
