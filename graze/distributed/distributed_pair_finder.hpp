// SPDX-License-Identifier: MIT
/// @file
/// All overlapping pairs of boxes that move and are spread over many ranks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include <mpi.h>

#include <graze/broad/executor.hpp>
#include <graze/distributed/id_pair.hpp>
#include <graze/distributed/partition.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze {

/// Options of `DistributedPairFinder` and of the distributed `overlapping_pairs`; equal on all ranks, but for the
/// executor. None of them changes the pairs.
struct DistributedPairOptions {
  const Executor* executor = nullptr;  ///< Runs this rank's parallel work; nullptr means default_executor().
  /// How far a box can move, on every side, before it is decided anew which ranks need it; finite, at least 0. Larger
  /// ones make more copies. Twice to five times what boxes move in a frame is a good choice.
  double skin = 0;
  /// Space is cut anew if the balance of searched boxes falls below this fraction, from 0 (never) to 1, of what it was
  /// right after the last cut. So a world that cannot be balanced is not cut in vain in every frame.
  double least_balance = 0.8;
};

/// What one rank did in a frame.
struct DistributedFrame {
  std::size_t boxes = 0;       ///< That this rank passed.
  std::size_t searched = 0;    ///< That met this rank's cell, ghosts included.
  std::size_t ghosts = 0;      ///< Copies that came from other ranks.
  std::size_t pairs = 0;       ///< Returned on this rank.
  std::uint64_t messages = 0;  ///< Sent to other ranks, without those of collective operations.
  std::uint64_t bytes = 0;     ///< In these messages.
  double balance = 1;          ///< The mean number of searched boxes divided by the greatest; the same on all ranks.
  bool is_planned = false;     ///< It was decided anew which ranks need which boxes; the same on all ranks.
  bool is_cut = false;         ///< Space was cut anew; the same on all ranks.
};

/// `overlapping_pairs` for a world that is spread over the ranks of a communicator, and moves. Keeps the cuts of space,
/// the lists of ghosts (copies of boxes that other ranks need) and the memory from frame to frame. Collective:
/// construction, `find` and destruction are for all ranks of the communicator together, in the same order. MPI must be
/// initialized, with at least MPI_THREAD_FUNNELED for the calling thread; all calls of MPI come from it.
template <Dim N, class T = float>
class DistributedPairFinder {
 public:
  /// Creates a finder that has seen no boxes. Duplicates the communicator. Throws std::invalid_argument on all ranks
  /// for options out of range.
  explicit DistributedPairFinder(MPI_Comm comm, const DistributedPairOptions& options = {});
  ~DistributedPairFinder();
  /// Takes over everything; `other` can then only be assigned to or destroyed.
  DistributedPairFinder(DistributedPairFinder&& other) noexcept;
  /// Takes over everything; `other` can then only be assigned to or destroyed.
  DistributedPairFinder& operator=(DistributedPairFinder&& other) noexcept;

  /// The pairs of boxes of the whole world that share a point (touching counts) and whose lower id is among `ids`,
  /// ascending: over all ranks, each pair once, exactly those of `overlapping_pairs` on one machine. Each rank passes
  /// its boxes, possibly none, with an id for each. The boxes may be anywhere; the fewer of them lie in other ranks'
  /// cells, the less is sent. Valid until the next call. Throws on all ranks, with a message that names the rank:
  /// std::invalid_argument if the coordinates of a box are NaN, an id is used twice in the world or the numbers of
  /// boxes and ids differ, std::length_error beyond 2^32 - 1 boxes in one cell, and what an executor throws. Afterwards
  /// the finder can be used again.
  std::span<const IdPair> find(std::span<const Aabb<N, T>> boxes, std::span<const std::uint64_t> ids);

  /// The cuts of space of the last call; one cell for everything before it.
  const Partition<N>& partition() const;

  /// What this rank did in the last call.
  const DistributedFrame& frame() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace graze
