// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include <graze/broad/pair.hpp>

namespace graze::detail {

/// Where a method puts the pairs that it finds: all at once, when it knows how many there are, or bit by bit.
class PairSink {
 public:
  PairSink() = default;
  virtual ~PairSink() = default;
  PairSink(const PairSink&) = delete;
  PairSink& operator=(const PairSink&) = delete;

  /// Room for all pairs. Asked for once, and nothing is appended besides.
  virtual Pair* all(std::size_t count) = 0;

  /// The same for who writes pairs in order, more or less: before any of them, reach() with an end beyond it. So the
  /// room is made ready while it is near.
  virtual Pair* all_in_turns(std::size_t count) { return all(count); }
  virtual void reach(std::size_t /*end*/) {}

  /// The same by all threads there are, for who is not in a task of theirs.
  virtual void reach_by_all(std::size_t end) { reach(end); }

  /// Memory that the room for all is likely to begin with, of somewhat more pairs than are expected: to be used for
  /// something else until all are asked for, and to be written over by pairs then, one after the other, each time
  /// reach() has been called with an end beyond them. Where it cannot be told, none; and who then asks for more than
  /// this has gets other memory, and has lost what was here.
  virtual std::span<Pair> ahead(std::size_t /*expected*/) { return {}; }

  /// Whether pairs may be appended. If not, a method keeps in memory of its own what it finds before it has counted.
  virtual bool appends() const = 0;

  /// Adds pairs to those before; roughly so many are expected in all. The place of the first one of all is returned.
  virtual const Pair* append(std::span<const Pair> pairs, std::size_t expected) = 0;
};

}  // namespace graze::detail
