// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <mpi.h>

#include <graze/distributed/distributed_pair_finder.hpp>
#include <graze/distributed/id_pair.hpp>
#include <graze/distributed/together.hpp>

namespace graze {

/// The overlapping pairs of a world that is spread over the ranks of a communicator, those whose lower id is among
/// `ids`: what `DistributedPairFinder::find` returns, and throws. A finder is faster for boxes that move. Collective.
template <Dim N, class T>
std::vector<IdPair> overlapping_pairs(MPI_Comm comm, std::span<const Aabb<N, T>> boxes,
                                      std::span<const std::uint64_t> ids, const DistributedPairOptions& options = {}) {
  DistributedPairFinder<N, T> finder(comm, options);
  const std::span<const IdPair> found = finder.find(boxes, ids);
  std::vector<IdPair> pairs;
  together(comm, [&] { pairs.assign(found.begin(), found.end()); });
  return pairs;
}

}  // namespace graze
