// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/broad/pair.hpp>
#include <graze/broad/pair_buckets.hpp>
#include <graze/broad/pair_code.hpp>
#include <graze/broad/pair_room.hpp>
#include <graze/broad/pool.hpp>

namespace graze::detail {

/// What first and second indices are less than.
struct PairLimits {
  std::size_t a;
  std::size_t b;
};

/// Sorts pairs by counting: first into buckets of neighbouring first indices, as they are found, then each bucket by
/// itself. Keeps its memory.
class PairSort {
 public:
  /// Forgets all pairs. Those that come have indices less than the limits, and are brought by so many threads, or about
  /// as many.
  void begin(const PairLimits& limits, std::size_t threads = 1);

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
  /// come twice.
  Pair* sort(const Executor& executor, PairRoom& room);

  /// The memory that is held, and what the last sort needed in passing.
  std::size_t bytes() const;

 private:
  void clear(PairBuckets& buckets) const;
  template <class Code>
  void sort_codes(const Executor& executor, PairRoom& room, Pair* out);

  Pool<PairBuckets> buckets_;
  std::size_t passing_bytes_ = 0;
  PairChunk chunk_ = PairChunk::large;
  PairCode code_;
  std::size_t limit_b_ = 0;
  std::vector<std::uint64_t> ends_;  // of every bucket
};

}  // namespace graze::detail
