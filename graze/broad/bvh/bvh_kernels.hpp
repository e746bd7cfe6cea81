// SPDX-License-Identifier: MIT
// The inner loops of a Bvh, once for every set of vector instructions that the compiler knows. Which one runs is chosen
// at run time, and makes no difference to any answer: every lane is calculated as every other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include <graze/broad/bvh/node.hpp>
#include <graze/broad/simd/space_kernels.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

namespace graze::detail {

/// A walk to all boxes that share a point with a region, which can be interrupted when much was found. Without initial
/// values, so that room for many costs nothing.
template <Dim N, class T>
struct BvhMetWalk {
  static constexpr std::size_t most_found = 240;

  Aabb<N, T> region;
  std::size_t open_count;
  std::size_t found_count;
  std::uint32_t open[bvh_path];                  // codes of links
  std::uint32_t found[most_found + block_size];  // slots
  std::uint32_t generations[most_found + block_size];
};

/// How a ray is held against the slab between two sides of a box.
enum class BvhSlab : std::uint8_t {
  crossed,   ///< By (side - origin) * inverse.
  parallel,  ///< The origin is in the slab, or no point of the ray is.
  any,       ///< Numbers so small or so large that nothing is known without a quotient.
};

/// Where no coordinate is farther from zero, differences are numbers.
template <class T>
inline constexpr T most_for_slabs = std::numeric_limits<T>::max() / 4;

/// A ray as boxes are held against it in T.
template <Dim N, class T>
struct BvhSlabs {
  Vec<N, T> origin;
  Vec<N, T> inverse;
  BvhSlab kinds[N];
};

/// A walk to the first box that a ray enters.
template <Dim N, class T>
struct BvhFirstWalk {
  Ray<N, T> ray;
  BvhSlabs<N, T> slabs;  // of the ray among boxes of usual numbers; the walk sees to others
  double t;              // of the first so far, infinity when there is none
  BvhName name;          // and who it is
};

template <Dim N, class T>
struct BvhKernels {
  /// The name of the instruction set.
  const char* target;

  /// Goes on with a walk until nothing is open or there is no room for what another leaf node may hold.
  void (*find_met)(const BvhNode<N, T>* nodes, BvhMetWalk<N, T>& walk);

  /// Which boxes of a block share a point with a box; a bit each.
  std::uint32_t (*met)(const Block<N, T>& block, const Aabb<N, T>& box);

  /// Walks all the way down from `root`. Returns how many nodes it looked at.
  std::size_t (*find_first)(const BvhNode<N, T>* nodes, BvhLink root, BvhFirstWalk<N, T>& walk);

  /// Which boxes of a block a ray may enter, and for each a t that is not above the first.
  std::uint32_t (*entered)(const Block<N, T>& block, const BvhSlabs<N, T>& slabs, T* soonest);

  /// Offers to `nearest` the boxes near a point, by keys without an owner, until all that is left is
  /// beyond its reach. Returns how many nodes it looked at.
  std::size_t (*find_near)(const BvhNode<N, T>* nodes, BvhLink root, const Vec<N, T>& point, NearestKeys& nearest);

  /// The box around all boxes of a block.
  Aabb<N, T> (*around)(const Block<N, T>& block);

  /// Which box of a block grows least, as the sum of its extents, if it is to contain another; of equal ones the
  /// smallest, of those the first. The block has one at least.
  std::uint32_t (*least_grown)(const Block<N, T>& block, const Aabb<N, T>& box);
};

/// The kernels of one instruction set.
using AllBvhKernels = SpaceKernels<BvhKernels>;

/// The instruction sets that kernels are compiled for, in Highway's bits.
std::int64_t bvh_kernel_targets();

/// The kernels for this machine. Instantiated for 2D and 3D, float and double.
template <Dim N, class T>
const BvhKernels<N, T>& bvh_kernels();

}  // namespace graze::detail
