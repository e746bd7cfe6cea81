// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/broad/pair.hpp>
#include <graze/broad/pair_buckets.hpp>
#include <graze/broad/pair_room.hpp>
#include <graze/broad/pool.hpp>

namespace graze::detail {

/// Sorts pairs by counting: first into buckets of neighbouring first indices, as they are found, then each bucket by
/// itself. Keeps its memory.
class PairSort {
 public:
  /// Forgets all pairs. Those that come have a first index less than `limit_a`.
  void begin(std::size_t limit_a);

  /// Takes pairs, from many threads if need be.
  class Sink {
   public:
    explicit Sink(PairSort& sort);
    void add(std::span<const Pair> pairs) { buckets_->add(pairs); }

   private:
    Pool<PairBuckets>::Loan buckets_;
  };

  /// How many pairs there are, once no sink is left.
  std::size_t count();

  /// Writes all pairs, ascending, to `room`, and returns the place of the first one: after count(). No pair may have
  /// come twice; every `b` is less than `limit_b`.
  Pair* sort(std::size_t limit_b, const Executor& executor, PairRoom& room);

  std::size_t bytes() const;

 private:
  Pool<PairBuckets> buckets_;
  std::uint32_t bits_ = 0;           // of first indices in a bucket
  std::vector<std::uint64_t> ends_;  // of every bucket
};

}  // namespace graze::detail
