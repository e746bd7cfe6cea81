// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <graze/distributed/mpi/communicator.hpp>
#include <graze/distributed/partition.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// Merges consecutive ascending runs, runs[k] elements each, into one.
template <class V, class Less>
void merge_runs(std::vector<V>& values, std::vector<std::size_t> runs, const Less& less) {
  while (runs.size() > 1) {
    std::vector<std::size_t> merged;
    auto begin = values.begin();
    for (std::size_t k = 0; k < runs.size(); k += 2) {
      const auto middle = begin + static_cast<std::ptrdiff_t>(runs[k]);
      const std::size_t second = k + 1 < runs.size() ? runs[k + 1] : 0;
      const auto end = middle + static_cast<std::ptrdiff_t>(second);
      if (begin != middle && middle != end && less(*middle, *(middle - 1))) {
        std::inplace_merge(begin, middle, end, less);
      }
      merged.push_back(runs[k] + second);
      begin = end;
    }
    runs = std::move(merged);
  }
}

/// Which boxes each rank sends to which, and where those that arrive are stored for the search: ascending by id.
template <Dim N, class T>
class GhostPlan {
 public:
  /// True if no box has left the region for which the plan was made. There must be as many as then.
  bool holds(std::span<const Aabb<N, T>> boxes) const {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (!is_within(boxes[i], regions_[i])) return false;
    }
    return true;
  }

  /// The ids for which the plan was made.
  std::span<const std::uint64_t> ids() const { return ids_; }

  /// Decides to which ranks each box goes: those whose cells its region meets. Local.
  void route(const Partition<N>& partition, std::span<const Aabb<N, T>> boxes, double skin) {
    regions_.resize(boxes.size());
    const auto ranks = static_cast<std::size_t>(partition.ranks());
    outgoing_.counts.assign(ranks, 0);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      regions_[i] = grown(boxes[i], skin);
      partition.visit_ranks(regions_[i], [&](int rank) { ++outgoing_.counts[static_cast<std::size_t>(rank)]; });
    }
    if (boxes.size() > 0xFFFFFFFFU) throw std::length_error("a rank can have at most 2^32 - 1 boxes");
    std::vector<std::size_t> next(ranks);
    std::exclusive_scan(outgoing_.counts.begin(), outgoing_.counts.end(), next.begin(), std::size_t{0});
    outgoing_.records.resize(next.back() + outgoing_.counts.back());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      partition.visit_ranks(regions_[i], [&](int rank) {
        outgoing_.records[next[static_cast<std::size_t>(rank)]++] = static_cast<std::uint32_t>(i);
      });
    }
  }

  /// Tells all ranks how many boxes each gets. Collective, after `route`. Valid until the communicator's next swap.
  std::span<const std::size_t> announced(Communicator& comm) const { return comm.swap_counts(outgoing_.counts); }

  /// Sends the ids, and gives each box its place. Collective, after `route`; `incoming` are the numbers announced.
  void exchange_ids(Communicator& comm, std::span<const std::uint64_t> ids, std::span<const std::size_t> incoming,
                    Traffic& traffic) {
    ByRank<std::uint64_t> out;
    ByRank<std::uint64_t> received;
    const auto prepare = [&] {
      incoming_.counts.assign(incoming.begin(), incoming.end());
      received.counts = incoming_.counts;
      ids_.assign(ids.begin(), ids.end());
      out.counts = outgoing_.counts;
      out.records.reserve(outgoing_.records.size());
      for (const std::uint32_t i : outgoing_.records) out.records.push_back(ids[i]);
    };
    swap_known(comm, prepare, out, received, traffic);
    comm.together([&] { give_places(received); });
  }

  /// Sends the boxes. Collective, after `exchange_ids`.
  void exchange_boxes(Communicator& comm, std::span<const Aabb<N, T>> boxes, Traffic& traffic) {
    const auto prepare = [&] {
      out_.counts = outgoing_.counts;
      out_.records.resize(outgoing_.records.size());
      for (std::size_t k = 0; k < out_.records.size(); ++k) out_.records[k] = boxes[outgoing_.records[k]];
    };
    swap_known(comm, prepare, out_, incoming_, traffic);
  }

  /// Puts the boxes that have arrived into their places.
  void arrange() {
    searched_.resize(places_.size());
    for (std::size_t k = 0; k < places_.size(); ++k) searched_[places_[k]] = incoming_.records[k];
  }

  std::span<const Aabb<N, T>> searched() const { return searched_; }
  std::uint64_t id(std::size_t place) const { return searched_ids_[place]; }
  int rank(std::size_t place) const { return searched_ranks_[place]; }
  std::size_t from(int rank) const { return incoming_.counts[static_cast<std::size_t>(rank)]; }

 private:
  /// Rounding may make the region a little smaller than asked for, but never smaller than the box.
  static Aabb<N, T> grown(const Aabb<N, T>& box, double skin) {
    if (is_nothing(box)) return box;
    return {box.min - static_cast<T>(skin), box.max + static_cast<T>(skin)};
  }

  static bool is_within(const Aabb<N, T>& box, const Aabb<N, T>& region) {
    for (Dim k = 0; k < N; ++k) {
      if (!(box.min[k] >= region.min[k] && box.max[k] <= region.max[k])) return false;
    }
    return true;
  }

  /// A box that arrives: its id, the place among the arrivals, and where it comes from.
  struct Arrival {
    std::uint64_t id;
    std::uint32_t position;
    std::int32_t rank;
  };

  void give_places(const ByRank<std::uint64_t>& received) {
    const std::size_t count = received.records.size();
    if (count > 0xFFFFFFFFU) {
      throw std::length_error("a rank's cell meets " + std::to_string(count) +
                              " boxes; at most 2^32 - 1 are allowed: use more ranks");
    }
    std::vector<Arrival> arrivals;
    arrivals.reserve(count);
    const auto by_id = [](const Arrival& a, const Arrival& b) { return a.id < b.id; };
    for (std::size_t rank = 0; rank < received.counts.size(); ++rank) {
      const auto begin = static_cast<std::ptrdiff_t>(arrivals.size());
      for (std::size_t k = 0; k < received.counts[rank]; ++k) {
        const auto position = static_cast<std::uint32_t>(arrivals.size());
        arrivals.push_back({received.records[position], position, static_cast<std::int32_t>(rank)});
      }
      if (!std::is_sorted(arrivals.begin() + begin, arrivals.end(), by_id)) {
        std::sort(arrivals.begin() + begin, arrivals.end(), by_id);
      }
    }
    merge_runs(arrivals, received.counts, by_id);
    places_.resize(count);
    searched_ids_.resize(count);
    searched_ranks_.resize(count);
    for (std::size_t place = 0; place < count; ++place) {
      places_[arrivals[place].position] = static_cast<std::uint32_t>(place);
      searched_ids_[place] = arrivals[place].id;
      searched_ranks_[place] = arrivals[place].rank;
    }
  }

  std::vector<Aabb<N, T>> regions_;
  std::vector<std::uint64_t> ids_;
  ByRank<std::uint32_t> outgoing_;  ///< Indices of this rank's boxes, by the rank that they go to.
  ByRank<Aabb<N, T>> out_;
  ByRank<Aabb<N, T>> incoming_;
  std::vector<std::uint32_t> places_;  ///< Of the boxes that arrive, in that order.
  std::vector<Aabb<N, T>> searched_;
  std::vector<std::uint64_t> searched_ids_;
  std::vector<std::int32_t> searched_ranks_;
};

}  // namespace graze::detail
