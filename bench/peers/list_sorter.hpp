// SPDX-License-Identifier: MIT
// Sorts the lists of contestants that return unsorted pairs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/pair.hpp>

namespace graze::race {

/// Uses Highway's VQSort on pairs as numbers with the first index in the high half: by far the fastest sort that Debian
/// packages. Tried: Boost's integer_sort takes 1.8 to 5 times as long, std::sort and Boost's pdqsort 2.3 to 10 times.
/// Its memory is kept, which favours the peers.
class ListSorter {
 public:
  /// The same pairs, ascending; valid until the next call.
  std::span<const Pair> sort(std::span<const Pair> pairs);

 private:
  std::vector<std::uint64_t> keys_;
  std::vector<Pair> sorted_;
};

}  // namespace graze::race
