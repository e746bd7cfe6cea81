// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include <graze/distributed/mpi/communicator.hpp>

namespace graze::detail {

/// Throws std::invalid_argument on all ranks, naming an id, if two boxes of the world have the same one. Sends each id
/// to one rank, which depends on the id, unless the ids of the ranks are in disjoint ranges. Collective.
void require_unique(Communicator& comm, std::span<const std::uint64_t> ids, Traffic& traffic);

}  // namespace graze::detail
