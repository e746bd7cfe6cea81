// SPDX-License-Identifier: MIT
// The pairs of objects that are never reported although their shapes may touch.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include <graze/broad/pair.hpp>

namespace graze::detail {

/// A set of pairs of slots, in no order within a pair. Each is stored in both directions, so that all pairs of a slot
/// are adjacent.
class PairExceptions {
 public:
  bool empty() const { return pairs_.empty(); }

  bool contains(std::uint32_t a, std::uint32_t b) const { return !pairs_.empty() && pairs_.contains({a, b}); }

  /// Whether the slot is in any pair.
  bool has_any(std::uint32_t slot) const { return is_of(slot, first_of(slot)); }

  /// Adds a pair of two different slots. If it throws, nothing has changed.
  void add(std::uint32_t a, std::uint32_t b) {
    const auto [place, is_new] = pairs_.insert({a, b});
    if (!is_new) return;
    try {
      pairs_.insert({b, a});
    } catch (...) {
      pairs_.erase(place);
      throw;
    }
  }

  void remove(std::uint32_t a, std::uint32_t b) noexcept {
    pairs_.erase({a, b});
    pairs_.erase({b, a});
  }

  /// Removes all pairs of a slot, and calls visit(other slot) after each.
  template <class Visit>
  void remove_all_of(std::uint32_t slot, const Visit& visit) {
    for (auto first = first_of(slot); is_of(slot, first); first = first_of(slot)) {
      const std::uint32_t other = first->b;
      remove(slot, other);
      visit(other);
    }
  }

  /// All pairs with a < b, ascending.
  std::vector<Pair> all() const {
    std::vector<Pair> result;
    result.reserve(pairs_.size() / 2);
    for (const Pair& pair : pairs_) {
      if (pair.a < pair.b) result.push_back(pair);
    }
    return result;
  }

 private:
  std::set<Pair>::const_iterator first_of(std::uint32_t slot) const { return pairs_.lower_bound({slot, 0}); }
  bool is_of(std::uint32_t slot, std::set<Pair>::const_iterator place) const {
    return place != pairs_.end() && place->a == slot;
  }

  std::set<Pair> pairs_;
};

}  // namespace graze::detail
