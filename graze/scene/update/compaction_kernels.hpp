// SPDX-License-Identifier: MIT
// The loop that selects pairs of a list, compiled once for each vector instruction set, as in block_kernels.hpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include <graze/broad/pair.hpp>

namespace graze::detail {

/// The output needs this much space after the selected pairs and positions.
inline constexpr std::size_t room_behind_chosen = 16;

struct CompactionKernels {
  /// Writes the pairs whose mark is 1, not 0, in order, and their positions in the list. Returns their number. No
  /// data-dependent branches.
  std::size_t (*choose)(const Pair* pairs, const char* marks, std::size_t count, Pair* chosen, std::uint32_t* places);
};

/// The kernels for this machine.
const CompactionKernels& compaction_kernels();

}  // namespace graze::detail
