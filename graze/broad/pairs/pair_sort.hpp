// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/broad/memory/pool.hpp>
#include <graze/broad/pair.hpp>
#include <graze/broad/pairs/pair_buckets.hpp>
#include <graze/broad/pairs/pair_code.hpp>
#include <graze/broad/pairs/pair_sink.hpp>

namespace graze::detail {

/// Exclusive upper bounds of the first and second indices.
struct PairLimits {
  std::size_t a;
  std::size_t b;

  friend bool operator==(const PairLimits&, const PairLimits&) = default;
};

/// An estimate before pairs are found; only the use of memory depends on it.
struct PairForecast {
  std::size_t count = 0;                  ///< Zero if unknown.
  std::array<std::uint32_t, 2> firsts{};  ///< First indices below which the shares of pairs lie, see shares().
};

/// A counting sort of pairs: first, as they are found, into buckets of neighbouring first indices, then each bucket by
/// itself. Keeps its memory.
class PairSort {
 public:
  /// Removes all pairs. New pairs have indices below the limits and come from about this many threads.
  void begin(const PairLimits& limits, std::size_t threads = 1);

  /// Lends memory that is not needed until all pairs are sorted. Call it before the first sink.
  void lend(std::span<std::byte> memory) { loans_.idle.give(memory); }

  /// If very many pairs are expected, stores most of them in `room`, each where nothing is written until it has been
  /// sorted. Call it before the first sink.
  void wait_in(PairSink& room, const PairForecast& forecast);

  /// The shares of pairs for which a forecast must give the limits of first indices.
  std::array<double, 2> shares() const;

  /// The result of the previous sort, if it had the same limits.
  const PairForecast& last() const { return last_; }

  /// Accepts pairs, from many threads concurrently.
  class Sink {
   public:
    explicit Sink(PairSort& sort);
    void add(std::span<const Pair> pairs) { buckets_->add(pairs); }

   private:
    Pool<PairBuckets>::Loan buckets_;
  };

  /// The number of pairs. All sinks must have been destroyed.
  std::size_t count();

  /// Writes all pairs, ascending, to `room`, and returns the first one. Call it after count(). Pairs must be distinct.
  Pair* sort(const Executor& executor, PairSink& room);

  /// The memory held, including temporary memory of the last sort, in bytes.
  std::size_t bytes() const;

 private:
  void clear(PairBuckets& buckets);
  template <class Code>
  void sort_codes(const Executor& executor, PairSink& room, Pair* out);
  std::size_t code_bytes() const { return code_.narrow() ? sizeof(std::int32_t) : sizeof(std::int64_t); }
  void remember_last(const PairLimits& limits);
  std::array<double, 2> ideal_shares() const;
  bool is_as_forecast() const;

  Pool<PairBuckets> buckets_;
  std::size_t passing_bytes_ = 0;
  PairChunk chunk_ = PairChunk::large;
  PairCode code_;
  PairLimits limits_{};
  std::vector<std::uint64_t> ends_;  // of every bucket
  PairForecast last_;
  PairLoans loans_;
  std::size_t ahead_size_ = 0;                 // pairs of `room` whose memory is known
  std::array<std::size_t, 2> ahead_firsts_{};  // where in it the two borrowed ranges begin
};

}  // namespace graze::detail
