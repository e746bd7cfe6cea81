// SPDX-License-Identifier: MIT
// The loop that keeps some pairs of a list, once for every set of vector instructions that the compiler knows, as in
// block_kernels.hpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include <graze/broad/pair.hpp>

namespace graze::detail {

/// So much room for pairs, and places, is to be had behind those that are chosen.
inline constexpr std::size_t room_behind_chosen = 16;

struct CompactionKernels {
  /// Writes the pairs whose mark is 1, not 0, in their order, and where in the list they are. Returns how many. No
  /// branches on what is marked.
  std::size_t (*choose)(const Pair* pairs, const char* marks, std::size_t count, Pair* chosen, std::uint32_t* places);
};

/// The kernels for this machine.
const CompactionKernels& compaction_kernels();

}  // namespace graze::detail
