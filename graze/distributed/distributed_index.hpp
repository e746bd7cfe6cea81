// SPDX-License-Identifier: MIT
/// @file
/// Regions and nearest boxes in a world that is spread over many ranks.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <mpi.h>

#include <graze/broad/executor.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/sphere.hpp>

namespace graze {

/// A box of a distributed world and its squared distance from a point.
struct NearId {
  double distance_squared = 0;  ///< As `distance_squared(point, box)` returns it: 0 if the point is inside.
  std::uint64_t id = 0;         ///< The id that its owner gave to the box.

  friend auto operator<=>(const NearId&, const NearId&) = default;
};

/// Boxes of all ranks of a communicator, for queries that any rank asks about all of them. Each rank keeps its own
/// boxes in a `Bvh`, and knows the bounds of every rank's boxes. A question goes only to the ranks whose bounds it
/// meets: few, if `partition` and `exchange` have brought neighbours together; otherwise all. Everything is collective:
/// each rank passes its own questions, possibly none, and gets their answers, which do not depend on where the boxes
/// are.
template <Dim N, class T = float>
class DistributedIndex {
 public:
  /// Stores this rank's boxes, possibly none. Throws std::invalid_argument on all ranks for what a `Bvh` refuses (a
  /// NaN, a min above its max, a box at infinity), for an id that is used twice in the world, and if the numbers of
  /// boxes and ids differ.
  DistributedIndex(MPI_Comm comm, std::span<const Aabb<N, T>> boxes, std::span<const std::uint64_t> ids,
                   const Executor& executor = default_executor());
  ~DistributedIndex();
  /// Takes over everything; `other` can then only be assigned to or destroyed.
  DistributedIndex(DistributedIndex&& other) noexcept;
  /// Takes over everything; `other` can then only be assigned to or destroyed.
  DistributedIndex& operator=(DistributedIndex&& other) noexcept;

  /// For each box-shaped region, the ids of the boxes in the world that share a point with it, ascending. Throws
  /// std::invalid_argument on all ranks for a region with a NaN.
  std::vector<std::vector<std::uint64_t>> query(std::span<const Aabb<N, T>> regions);

  /// The same for spheres. Throws std::invalid_argument on all ranks for a NaN or a negative radius.
  std::vector<std::vector<std::uint64_t>> query(std::span<const Sphere<N, T>> regions);

  /// For each point, the `count` boxes nearest to it in the world, or all if there are fewer: by distance, ties by id.
  /// `count` may differ between ranks. Asks in two rounds: first enough of the nearest ranks to have `count` boxes,
  /// then all that could have a nearer one. Throws std::invalid_argument on all ranks if a point is not finite.
  std::vector<std::vector<NearId>> nearest(std::span<const Vec<N, T>> points, std::size_t count);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace graze
