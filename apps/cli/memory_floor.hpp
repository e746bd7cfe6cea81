// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <graze/broad/pair.hpp>

namespace graze::cli {

/// A lower bound for every method: the time to read all boxes once and to write all pairs once, on one thread.
class MemoryFloor {
 public:
  /// Milliseconds for boxes of these bytes and that many pairs; the median of a few tries.
  double measure(std::span<const std::byte> boxes, std::size_t pairs);

 private:
  std::vector<Pair> pairs_;  ///< Kept, so that its pages are already mapped when it is written.
};

}  // namespace graze::cli
