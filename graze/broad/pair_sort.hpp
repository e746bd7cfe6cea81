// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/broad/pair.hpp>

namespace graze::detail {

/// Sorts pairs by counting: first into buckets of neighbouring first indices, then each bucket by itself. Keeps its
/// memory.
class PairSort {
 public:
  /// Writes the pairs of all pieces, ascending, to `out`, which has room for them. No pair comes twice; every `a` is
  /// less than `limit_a`, every `b` less than `limit_b`.
  void sort(std::span<const std::span<const Pair>> pieces, std::size_t limit_a, std::size_t limit_b,
            const Executor& executor, Pair* out);

  std::size_t bytes() const;

 private:
  std::vector<std::uint64_t> places_;  // of every bucket of every piece, then where its next pair goes
  std::vector<std::uint64_t> ends_;    // of every bucket
};

}  // namespace graze::detail
