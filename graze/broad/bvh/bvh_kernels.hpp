// SPDX-License-Identifier: MIT
// Inner loops of a Bvh, compiled for each instruction set and chosen at run time. All give the same answers, because
// every lane is calculated alike.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include <graze/broad/bvh/node.hpp>
#include <graze/broad/simd/space_kernels.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

namespace graze::detail {

/// The state of a walk to all boxes that share a point with a region. It can be interrupted when enough was found.
/// Members are uninitialised, because the arrays are large.
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

/// How a ray relates to the slab between two sides of a box.
enum class BvhSlab : std::uint8_t {
  crossed,   ///< Crosses it, by (side - origin) * inverse.
  parallel,  ///< The origin is in the slab, or no point of the ray is.
  any,       ///< So close to the limits of T that only a division is safe.
};

/// If no coordinate exceeds this, differences do not overflow.
template <class T>
inline constexpr T most_for_slabs = std::numeric_limits<T>::max() / 4;

/// A ray prepared for slab tests in T.
template <Dim N, class T>
struct BvhSlabs {
  Vec<N, T> origin;
  Vec<N, T> inverse;
  BvhSlab kinds[N];
};

/// The state of a walk to the first box that a ray enters.
template <Dim N, class T>
struct BvhFirstWalk {
  Ray<N, T> ray;
  BvhSlabs<N, T> slabs;  // for boxes with ordinary numbers; the walk handles others
  double t;              // of the first box so far, or infinity
  BvhName name;          // the name of that box
};

template <Dim N, class T>
struct BvhKernels {
  /// The name of the instruction set.
  const char* target;

  /// Continues a walk until no node is open or `found` has no space for another leaf node.
  void (*find_overlapping)(const BvhNode<N, T>* nodes, BvhMetWalk<N, T>& walk);

  /// Which boxes of a block share a point with a box, as a bit mask.
  std::uint32_t (*met)(const Block<N, T>& block, const Aabb<N, T>& box);

  /// Walks the whole tree from `root`. Returns the number of nodes visited.
  std::size_t (*find_first)(const BvhNode<N, T>* nodes, BvhLink root, BvhFirstWalk<N, T>& walk);

  /// Which boxes of a block a ray may enter, as a bit mask, and a lower bound of t for each.
  std::uint32_t (*entered)(const Block<N, T>& block, const BvhSlabs<N, T>& slabs, T* soonest);

  /// Offers the boxes near a box to `nearest`, by keys without an owner, until the rest is beyond its reach. Returns
  /// the number of nodes visited.
  std::size_t (*find_near)(const BvhNode<N, T>* nodes, BvhLink root, const Aabb<N, T>& from, NearestKeys& nearest);

  /// The bounds of all boxes of a block.
  Aabb<N, T> (*around)(const Block<N, T>& block);

  /// Which box of a non-empty block grows least, by the sum of its extents, to contain another; ties go to the
  /// smallest, then to the first.
  std::uint32_t (*least_grown)(const Block<N, T>& block, const Aabb<N, T>& box);
};

/// The kernels of one instruction set.
using AllBvhKernels = SpaceKernels<BvhKernels>;

/// The instruction sets that kernels are compiled for, in Highway's bits.
std::int64_t bvh_kernel_targets();

/// The kernels for this machine. Instantiated for 2D and 3D, float and double.
template <Dim N, class T>
GRAZE_EXPORT const BvhKernels<N, T>& bvh_kernels();

}  // namespace graze::detail
