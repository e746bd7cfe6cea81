// SPDX-License-Identifier: MIT
// A set of pairs of slots with fast insertion and removal.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/pair.hpp>

namespace graze::detail {

/// A set of pairs with access by slot: pairs are the edges of a graph, linked into a chain at each of their two slots.
/// Adding a pair, or removing one that was visited, takes constant time. Each pair has a flag for touching.
class PairGraph {
 public:
  /// The maximum number of pairs, so that both ends of each have a 32-bit number.
  static constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max() / 2;

  /// Replaces the content by these pairs and those that touch, which may be among them; both ascending. Slots are below
  /// `slots`. Throws like `reserve`; the graph is then unusable.
  void assign(std::span<const Pair> pairs, std::span<const Pair> touching, std::size_t slots);

  /// Reserves memory for this many slots and additional pairs, so that `add` cannot fail. Throws std::bad_alloc, or
  /// std::length_error beyond `most`, before any visible change.
  void reserve(std::size_t slots, std::size_t more);

  /// Adds a pair that is not in the set and does not touch.
  void add(const Pair& pair) noexcept;

  /// Removes a pair by the number with which it was visited.
  void remove(std::uint32_t edge) noexcept;

  /// Whether a pair touches, by its number.
  bool is_touching(std::uint32_t edge) const { return edges_[edge].is_touching; }
  void set_touching(std::uint32_t edge, bool is_touching) noexcept { edges_[edge].is_touching = is_touching; }

  /// Calls visit(other slot, number of the pair) for every pair of a slot. The visitor may remove the visited pair.
  template <class Visit>
  void visit_pairs_of(std::uint32_t slot, const Visit& visit) const {
    if (slot >= first_.size()) return;
    for (std::uint32_t end = first_[slot]; end != none;) {
      const Edge& edge = edges_[end / 2];
      const std::uint32_t next = edge.next[end % 2];
      visit(edge.slots[1 - end % 2], end / 2);
      end = next;
    }
  }

  /// Calls visit(slot, other slot, number of the pair) for every pair of each of these slots. Follows many chains at
  /// the same time, so that the next element of one is fetched while others are processed.
  template <class Visit>
  void visit_pairs_of_all(std::span<const std::uint32_t> slots, const Visit& visit) const {
    std::array<std::uint32_t, chains_at_once> ends;
    std::array<std::uint32_t, chains_at_once> owners;
    for (std::size_t begin = 0; begin < slots.size(); begin += chains_at_once) {
      std::size_t chains = 0;
      for (const std::uint32_t slot : slots.subspan(begin, std::min(chains_at_once, slots.size() - begin))) {
        if (slot >= first_.size() || first_[slot] == none) continue;
        owners[chains] = slot;
        ends[chains++] = first_[slot];
        prefetch(&edges_[first_[slot] / 2]);
      }
      for (std::size_t k = begin + chains_at_once; k < std::min(begin + 2 * chains_at_once, slots.size()); ++k) {
        if (slots[k] < first_.size()) prefetch(&first_[slots[k]]);
      }
      while (chains > 0) {
        std::size_t left = 0;
        for (std::size_t k = 0; k < chains; ++k) {
          const std::uint32_t end = ends[k];
          const Edge& edge = edges_[end / 2];
          const std::uint32_t next = edge.next[end % 2];
          visit(owners[k], edge.slots[1 - end % 2], end / 2);
          prefetch(edges_.data() + (next != none ? next / 2 : 0));
          ends[left] = next;
          owners[left] = owners[k];
          left += next != none ? 1 : 0;
        }
        chains = left;
      }
    }
  }

  /// Replaces the list by all pairs that touch, ascending.
  void list_touching(BlankVector<Pair>& pairs) const;

  std::size_t size() const { return edges_.size() - spare_.size(); }

 private:
  static constexpr std::size_t chains_at_once = 32;
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Its ends have the numbers 2 * edge and 2 * edge + 1.
  struct Edge {
    std::array<std::uint32_t, 2> slots;
    std::array<std::uint32_t, 2> next;      // ends, in the chain of each slot
    std::array<std::uint32_t, 2> previous;  // none for the first of a chain
    bool is_touching;
  };

  void hang(std::uint32_t edge) noexcept;

  PageVector<std::uint32_t> first_;  // by slot: the start of its chain
  PageVector<Edge> edges_;
  PageVector<std::uint32_t> spare_;  // unused edges; reserved for all
};

}  // namespace graze::detail
