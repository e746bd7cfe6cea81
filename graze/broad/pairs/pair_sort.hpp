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

/// What first and second indices are less than.
struct PairLimits {
  std::size_t a;
  std::size_t b;

  friend bool operator==(const PairLimits&, const PairLimits&) = default;
};

/// What is expected of pairs before they are found: only the memory depends on it.
struct PairForecast {
  std::size_t count = 0;                  ///< Zero for no idea.
  std::array<std::uint32_t, 2> firsts{};  ///< First indices below which the shares of them lie that were asked for.
};

/// Sorts pairs by counting: first into buckets of neighbouring first indices, as they are found, then each bucket by
/// itself. Keeps its memory.
class PairSort {
 public:
  /// Forgets all pairs. Those that come have indices less than the limits, and are brought by so many threads, or about
  /// as many.
  void begin(const PairLimits& limits, std::size_t threads = 1);

  /// Before the first sink: lends memory that nobody needs until all pairs are sorted.
  void lend(std::span<std::byte> memory) { loans_.idle.give(memory); }

  /// Before the first sink: where very many pairs are expected, most of them wait in the room for all, each where
  /// nothing is written until it has been sorted.
  void wait_in(PairSink& room, const PairForecast& forecast);

  /// The shares of pairs for which a forecast is to say where their first indices end.
  std::array<double, 2> shares() const;

  /// What the last pairs were, if they had the same limits as those to come.
  const PairForecast& last() const { return last_; }

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
  Pair* sort(const Executor& executor, PairSink& room);

  /// The memory that is held, and what the last sort needed in passing.
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
  std::size_t ahead_size_ = 0;                 // pairs of the room that are known to be at hand
  std::array<std::size_t, 2> ahead_firsts_{};  // pairs before those that others wait in
};

}  // namespace graze::detail
