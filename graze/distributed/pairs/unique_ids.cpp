// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <graze/distributed/pairs/unique_ids.hpp>

namespace graze::detail {
namespace {

/// Throws if an id is there twice; sorts them.
void require_distinct(std::vector<std::uint64_t>& ids) {
  if (!std::is_sorted(ids.begin(), ids.end())) std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice == ids.end()) return;
  throw std::invalid_argument("the id " + std::to_string(*twice) +
                              " is used twice; each box of the world needs an id of its own");
}

/// True if no two ranks' ranges from their lowest to their highest id have a number in common.
bool are_disjoint(std::span<const std::uint64_t> lowest, std::span<const std::uint64_t> highest) {
  std::vector<std::size_t> order;
  for (std::size_t rank = 0; rank < lowest.size(); ++rank) {
    if (lowest[rank] <= highest[rank]) order.push_back(rank);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return lowest[a] < lowest[b]; });
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (lowest[order[k]] <= highest[order[k - 1]]) return false;
  }
  return true;
}

/// The rank that compares an id with its equals (the finalizer of MurmurHash3 by Austin Appleby).
std::size_t judge_of(std::uint64_t id, std::size_t ranks) {
  id = (id ^ (id >> 33U)) * 0xFF51AFD7ED558CCDU;
  id = (id ^ (id >> 33U)) * 0xC4CEB9FE1A85EC53U;
  return static_cast<std::size_t>((id ^ (id >> 33U)) % ranks);
}

}  // namespace

void require_unique(Communicator& comm, std::span<const std::uint64_t> ids, Traffic& traffic) {
  std::vector<std::uint64_t> sorted;
  std::vector<std::uint64_t> lowest;
  bool disjoint = false;
  comm.together([&] {
    sorted.assign(ids.begin(), ids.end());
    require_distinct(sorted);
    lowest.resize(static_cast<std::size_t>(comm.size()));
  });
  // A rank without ids has a lowest above its highest.
  const std::span<const std::uint64_t> lows =
      comm.all(sorted.empty() ? std::numeric_limits<std::uint64_t>::max() : sorted.front());
  std::copy(lows.begin(), lows.end(), lowest.begin());
  const std::span<const std::uint64_t> highest = comm.all(sorted.empty() ? 0 : sorted.back());
  comm.together([&] { disjoint = are_disjoint(lowest, highest); });
  if (disjoint) return;
  ByRank<std::uint64_t> by_judge;
  comm.together([&] {
    std::vector<std::size_t>& counts = by_judge.counts;
    counts.assign(static_cast<std::size_t>(comm.size()), 0);
    by_judge.records.resize(sorted.size());
    for (const std::uint64_t id : sorted) ++counts[judge_of(id, counts.size())];
    std::vector<std::size_t> next(counts.size());
    std::exclusive_scan(counts.begin(), counts.end(), next.begin(), std::size_t{0});
    for (const std::uint64_t id : sorted) by_judge.records[next[judge_of(id, counts.size())]++] = id;
  });
  ByRank<std::uint64_t> received = swap(comm, by_judge, traffic);
  comm.together([&] { require_distinct(received.records); });
}

}  // namespace graze::detail
