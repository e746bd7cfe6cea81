// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/scene/update/pair_graph.hpp>

namespace graze::detail::pair_graph_test {
namespace {

/// All pairs, ascending.
std::vector<Pair> listed(const PairGraph& graph) {
  std::vector<Pair> pairs;
  for (std::uint32_t slot = 0; slot < 12; ++slot) {
    graph.visit_pairs_of(slot, [&](std::uint32_t other, std::uint32_t /*edge*/) {
      if (slot < other) pairs.push_back({slot, other});
    });
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<Pair> listed_touching(const PairGraph& graph) {
  BlankVector<Pair> pairs{{8, 9}};  // which goes
  graph.list_touching(pairs);
  return {pairs.begin(), pairs.end()};
}

/// The partners by slot, with the numbers of their pairs.
std::map<std::uint32_t, std::uint32_t> pairs_of(const PairGraph& graph, std::uint32_t slot) {
  std::map<std::uint32_t, std::uint32_t> pairs;
  graph.visit_pairs_of(slot, [&](std::uint32_t other, std::uint32_t edge) { pairs[other] = edge; });
  return pairs;
}

TEST(PairGraph, KnowsThePairsOfEachSlot) {
  PairGraph graph;
  EXPECT_TRUE(pairs_of(graph, 3).empty());
  const std::vector<Pair> pairs{{0, 2}, {1, 2}, {2, 5}};
  graph.assign(pairs, {}, 6);
  EXPECT_EQ(graph.size(), 3U);
  EXPECT_EQ(listed(graph), pairs);
  EXPECT_EQ(pairs_of(graph, 2).size(), 3U);
  EXPECT_EQ(pairs_of(graph, 0).count(2), 1U);
  EXPECT_TRUE(pairs_of(graph, 4).empty());
  EXPECT_TRUE(pairs_of(graph, 70).empty());
  graph.remove(pairs_of(graph, 1).at(2));
  EXPECT_EQ(listed(graph), (std::vector<Pair>{{0, 2}, {2, 5}}));
  graph.assign({}, {}, 2);
  EXPECT_TRUE(listed(graph).empty());
}

TEST(PairGraph, NotesWhichPairsTouch) {
  PairGraph graph;
  const std::vector<Pair> pairs{{0, 2}, {1, 2}, {2, 5}};
  const std::vector<Pair> touching{{0, 1}, {1, 2}, {3, 4}};  // of which one is in both
  graph.assign(pairs, touching, 6);
  EXPECT_EQ(listed(graph), (std::vector<Pair>{{0, 1}, {0, 2}, {1, 2}, {2, 5}, {3, 4}}));
  EXPECT_EQ(listed_touching(graph), touching);
  EXPECT_FALSE(graph.is_touching(pairs_of(graph, 5).at(2)));
  EXPECT_TRUE(graph.is_touching(pairs_of(graph, 2).at(1)));
  graph.set_touching(pairs_of(graph, 5).at(2), true);
  graph.set_touching(pairs_of(graph, 2).at(1), false);
  EXPECT_EQ(listed_touching(graph), (std::vector<Pair>{{0, 1}, {2, 5}, {3, 4}}));
  graph.remove(pairs_of(graph, 3).at(4));
  graph.reserve(6, 1);
  graph.add({3, 5});  // in the position of one that touched
  EXPECT_EQ(listed_touching(graph), (std::vector<Pair>{{0, 1}, {2, 5}}));
}

TEST(PairGraph, APairMayBeTakenOutWhileItIsVisited) {
  PairGraph graph;
  const std::vector<Pair> pairs{{0, 3}, {1, 3}, {2, 3}, {3, 4}, {3, 5}};
  graph.assign(pairs, {}, 6);
  graph.visit_pairs_of(3, [&](std::uint32_t other, std::uint32_t edge) {
    if (other % 2 == 0) graph.remove(edge);
  });
  EXPECT_EQ(listed(graph), (std::vector<Pair>{{1, 3}, {3, 5}}));
}

TEST(PairGraph, VisitsThePairsOfManySlotsAsOneByOne) {
  constexpr std::uint32_t slots = 150;
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < slots; ++a) {
    for (std::uint32_t b = a + 1; b < slots; b += a % 7 + 1 + b % 5) pairs.push_back({a, b});
  }
  PairGraph graph;
  graph.assign(pairs, {}, slots);
  for (const std::size_t count : {0U, 1U, 31U, 32U, 33U, 100U}) {
    std::vector<std::uint32_t> asked;
    for (std::uint32_t k = 0; k < count; ++k) asked.push_back(k * 37 % 200);  // some beyond all slots
    std::set<std::array<std::uint32_t, 3>> expected;
    for (const std::uint32_t slot : asked) {
      for (const auto& [other, edge] : pairs_of(graph, slot)) expected.insert({slot, other, edge});
    }
    std::set<std::array<std::uint32_t, 3>> found;
    std::size_t visits = 0;
    graph.visit_pairs_of_all(asked, [&](std::uint32_t slot, std::uint32_t other, std::uint32_t edge) {
      found.insert({slot, other, edge});
      ++visits;
    });
    EXPECT_EQ(found, expected) << count;
    EXPECT_EQ(visits, expected.size()) << count;
  }
}

TEST(PairGraph, RefusesMoreThanItCanNumber) {
  PairGraph graph;
  EXPECT_THROW(graph.reserve(2, PairGraph::most + 1), std::length_error);
  EXPECT_EQ(graph.size(), 0U);
}

RC_GTEST_PROP(PairGraph, HoldsWhatASetHolds, ()) {
  PairGraph graph;
  std::set<Pair> pairs;
  const int changes = *rc::gen::inRange(0, 200);
  for (int change = 0; change < changes; ++change) {
    const auto a = *rc::gen::inRange<std::uint32_t>(0, 11);
    const Pair pair{a, *rc::gen::inRange<std::uint32_t>(a + 1, 12)};
    if (pairs.erase(pair) != 0) {
      graph.remove(pairs_of(graph, change % 2 == 0 ? pair.a : pair.b).at(change % 2 == 0 ? pair.b : pair.a));
    } else {
      graph.reserve(12, 1);
      graph.add(pair);
      pairs.insert(pair);
    }
    RC_ASSERT(graph.size() == pairs.size());
  }
  RC_ASSERT(listed(graph) == std::vector<Pair>(pairs.begin(), pairs.end()));
  for (std::uint32_t slot = 0; slot < 12; ++slot) {
    std::set<std::uint32_t> others;
    for (const Pair& pair : pairs) {
      if (pair.a == slot) others.insert(pair.b);
      if (pair.b == slot) others.insert(pair.a);
    }
    std::set<std::uint32_t> found;
    for (const auto& [other, edge] : pairs_of(graph, slot)) found.insert(other);
    RC_ASSERT(found == others);
  }
}

}  // namespace
}  // namespace graze::detail::pair_graph_test
