// SPDX-License-Identifier: MIT
#include <algorithm>
#include <stdexcept>

#include <graze/scene/update/pair_graph.hpp>

namespace graze::detail {

void PairGraph::assign(std::span<const Pair> pairs, std::span<const Pair> touching, std::size_t slots) {
  first_.assign(slots, none);
  edges_.clear();
  spare_.clear();
  reserve(slots, pairs.size() + touching.size());
  auto next = touching.begin();
  const auto add_touching = [&] {
    add(*next++);
    edges_.back().is_touching = true;
  };
  for (const Pair& pair : pairs) {
    while (next != touching.end() && *next < pair) add_touching();
    if (next != touching.end() && *next == pair) {
      add_touching();
    } else {
      add(pair);
    }
  }
  while (next != touching.end()) add_touching();
}

void PairGraph::reserve(std::size_t slots, std::size_t more) {
  if (first_.size() < slots) first_.resize(std::max(slots, 2 * first_.size()), none);
  const std::size_t wanted = size() + more;
  if (wanted > most) throw std::length_error("Scene: more than 2^31 - 1 pairs touch, the most that it can store");
  if (edges_.capacity() < wanted) edges_.reserve(std::max(wanted, 2 * edges_.capacity()));
  spare_.reserve(edges_.capacity());
}

void PairGraph::add(const Pair& pair) noexcept {
  auto edge = static_cast<std::uint32_t>(edges_.size());
  if (spare_.empty()) {
    edges_.push_back({});
  } else {
    edge = spare_.back();
    spare_.pop_back();
  }
  edges_[edge].slots = {pair.a, pair.b};
  edges_[edge].is_touching = false;
  hang(edge);
}

/// Inserts an edge at the front of both chains.
void PairGraph::hang(std::uint32_t edge) noexcept {
  for (std::uint32_t side = 0; side < 2; ++side) {
    std::uint32_t& first = first_[edges_[edge].slots[side]];
    edges_[edge].next[side] = first;
    edges_[edge].previous[side] = none;
    if (first != none) edges_[first / 2].previous[first % 2] = 2 * edge + side;
    first = 2 * edge + side;
  }
}

void PairGraph::remove(std::uint32_t edge) noexcept {
  for (std::uint32_t side = 0; side < 2; ++side) {
    const std::uint32_t next = edges_[edge].next[side];
    const std::uint32_t previous = edges_[edge].previous[side];
    if (next != none) edges_[next / 2].previous[next % 2] = previous;
    (previous != none ? edges_[previous / 2].next[previous % 2] : first_[edges_[edge].slots[side]]) = next;
  }
  spare_.push_back(edge);
}

void PairGraph::list_touching(BlankVector<Pair>& pairs) const {
  pairs.clear();
  for (std::uint32_t slot = 0; slot < first_.size(); ++slot) {
    const std::size_t begin = pairs.size();
    visit_pairs_of(slot, [&](std::uint32_t other, std::uint32_t edge) {
      if (slot < other && edges_[edge].is_touching) pairs.push_back({slot, other});
    });
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(begin), pairs.end());
  }
}

}  // namespace graze::detail
