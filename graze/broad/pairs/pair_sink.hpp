// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include <graze/broad/pair.hpp>

namespace graze::detail {

/// Receives the pairs that a method finds: all at once, if it knows their number, or in batches.
class PairSink {
 public:
  PairSink() = default;
  virtual ~PairSink() = default;
  PairSink(const PairSink&) = delete;
  PairSink& operator=(const PairSink&) = delete;

  /// Memory for all pairs. Called at most once, and not together with append().
  virtual Pair* all(std::size_t count) = 0;

  /// The same for a caller that writes roughly in ascending order and calls reach() with a later end before it writes
  /// any pair. The memory can then be prefaulted while it is cached.
  virtual Pair* all_in_turns(std::size_t count) { return all(count); }
  virtual void reach(std::size_t /*end*/) {}

  /// reach() on all threads, for calls from outside a task.
  virtual void reach_by_all(std::size_t end) { reach(end); }

  /// The memory in which all pairs will probably begin, for somewhat more than the expected number. It may be used for
  /// other purposes until all() is called. Then pairs overwrite it in order, each after reach() was called with a later
  /// end. Empty if it cannot be predicted. If all() is called for more pairs than it has space for, they get other
  /// memory, and its content is lost.
  virtual std::span<Pair> ahead(std::size_t /*expected*/) { return {}; }

  /// Whether append() is supported. If not, a method that does not know the number of pairs holds them in its own
  /// memory.
  virtual bool appends() const = 0;

  /// Appends pairs; about `expected` pairs are expected in total. Returns the first of all pairs.
  virtual const Pair* append(std::span<const Pair> pairs, std::size_t expected) = 0;
};

}  // namespace graze::detail
