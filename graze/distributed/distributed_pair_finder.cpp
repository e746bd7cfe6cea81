// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <graze/broad/index/region.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/distributed/distributed_pair_finder.hpp>
#include <graze/distributed/mpi/communicator.hpp>
#include <graze/distributed/pairs/ghost_plan.hpp>
#include <graze/distributed/pairs/unique_ids.hpp>

namespace graze {
namespace {

void require_options(const DistributedPairOptions& options) {
  const auto refuse = [](const char* name, double value, const char* allowed) {
    throw std::invalid_argument("DistributedPairFinder: " + std::string(name) + " is " + std::to_string(value) +
                                "; it must be " + allowed);
  };
  if (!(options.skin >= 0 && std::isfinite(options.skin))) refuse("skin", options.skin, "zero or more, and finite");
  if (!(options.least_balance >= 0 && options.least_balance <= 1)) {
    refuse("least_balance", options.least_balance, "from 0 to 1");
  }
}

template <Dim N, class T>
void require_boxes(std::span<const Aabb<N, T>> boxes, std::span<const std::uint64_t> ids) {
  if (boxes.size() != ids.size()) {
    throw std::invalid_argument("overlapping_pairs: there are " + std::to_string(boxes.size()) + " boxes, but " +
                                std::to_string(ids.size()) + " ids; give one for each box");
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!detail::has_nan_coordinate(boxes[i])) continue;
    throw std::invalid_argument("overlapping_pairs: box " + std::to_string(i) + ", with the id " +
                                std::to_string(ids[i]) + ", has a coordinate that is NaN");
  }
}

/// A pair that was found on a rank that does not own its lower id.
struct ForeignPair {
  int rank;
  IdPair pair;
};

}  // namespace

template <Dim N, class T>
struct DistributedPairFinder<N, T>::State {
  detail::Communicator comm;
  DistributedPairOptions options;
  Partition<N> partition;
  bool has_partition = false;
  bool has_plan = false;
  double first_balance = 1;  // right after the last cut
  detail::GhostPlan<N, T> plan;
  std::vector<std::size_t> incoming;
  PairFinder<N, T> finder;
  std::vector<IdPair> pairs;
  std::vector<ForeignPair> foreign;
  detail::ByRank<IdPair> sent;
  DistributedFrame frame;
  detail::Traffic traffic;

  State(MPI_Comm all, const DistributedPairOptions& given) : comm(all), options(given) {
    comm.together([&] { require_options(options); });
  }

  void cut(std::span<const Aabb<N, T>> boxes) {
    partition = graze::partition<N, T>(comm.handle(), boxes);
    has_partition = true;
    frame.is_cut = true;
  }

  /// Routes all boxes and returns the balance of what each rank will search; `incoming` gets how many come from each.
  double routed(std::span<const Aabb<N, T>> boxes) {
    comm.together([&] {
      plan.route(partition, boxes, options.skin);
      incoming.resize(static_cast<std::size_t>(comm.size()));
    });
    const std::span<const std::size_t> announced = plan.announced(comm);
    std::copy(announced.begin(), announced.end(), incoming.begin());
    std::uint64_t whole = 0;
    std::uint64_t most = 0;
    for (const std::uint64_t load : comm.all(std::accumulate(incoming.begin(), incoming.end(), std::uint64_t{0}))) {
      whole += load;
      most = std::max(most, load);
    }
    return most > 0 ? static_cast<double>(whole) / static_cast<double>(comm.size()) / static_cast<double>(most) : 1.0;
  }

  void make_plan(std::span<const Aabb<N, T>> boxes, std::span<const std::uint64_t> ids) {
    if (!has_partition) cut(boxes);
    frame.balance = routed(boxes);
    if (!frame.is_cut && frame.balance < options.least_balance * first_balance) {
      cut(boxes);
      frame.balance = routed(boxes);
    }
    if (frame.is_cut) first_balance = frame.balance;
    plan.exchange_ids(comm, ids, incoming, traffic);
    frame.is_planned = true;
  }

  /// Of the boxes that meet a cell, finds the pairs whose lower corner in common is in it: every pair, on one rank.
  void search() {
    pairs.clear();
    foreign.clear();
    const std::span<const Aabb<N, T>> boxes = plan.searched();
    const Aabb<N, double> cell = partition.cell(comm.rank());
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto is_inside = [&cell](const Vec<N, T>& point) {
      for (Dim k = 0; k < N; ++k) {
        const auto place = static_cast<double>(point[k]);
        // No cut is at infinity, so what lies there belongs to the outer cells.
        if (!(place >= cell.min[k] && (place < cell.max[k] || cell.max[k] == infinity))) return false;
      }
      return true;
    };
    std::size_t last = boxes.size();
    bool is_all_inside = false;
    for (const auto& [a, b] : finder.find(boxes, {.executor = options.executor})) {
      if (a != last) {
        last = a;
        is_all_inside = is_inside(boxes[a].min) && is_inside(boxes[a].max);
      }
      if (!is_all_inside) {
        Vec<N, T> corner;
        for (Dim k = 0; k < N; ++k) corner[k] = std::max(boxes[a].min[k], boxes[b].min[k]);
        if (!is_inside(corner)) continue;
      }
      const IdPair pair{plan.id(a), plan.id(b)};
      if (plan.rank(a) == comm.rank()) {
        pairs.push_back(pair);
      } else {
        foreign.push_back({plan.rank(a), pair});
      }
    }
  }

  /// Sorts the pairs that other ranks own by rank.
  void address() {
    sent.counts.assign(static_cast<std::size_t>(comm.size()), 0);
    sent.records.clear();
    std::stable_sort(foreign.begin(), foreign.end(),
                     [](const ForeignPair& a, const ForeignPair& b) { return a.rank < b.rank; });
    for (const ForeignPair& one : foreign) {
      ++sent.counts[static_cast<std::size_t>(one.rank)];
      sent.records.push_back(one.pair);
    }
  }

  /// Sends the pairs to the ranks that own their lower ids.
  void deliver() {
    const detail::ByRank<IdPair> received = detail::swap(comm, sent, traffic);
    comm.together([&] {
      std::vector<std::size_t> runs{pairs.size()};
      runs.insert(runs.end(), received.counts.begin(), received.counts.end());
      pairs.insert(pairs.end(), received.records.begin(), received.records.end());
      detail::merge_runs(pairs, runs, std::less<>());
    });
  }

  std::span<const IdPair> find(std::span<const Aabb<N, T>> boxes, std::span<const std::uint64_t> ids) {
    constexpr unsigned renamed = 1;
    constexpr unsigned moved = 2;
    const double last_balance = frame.balance;
    frame = {};
    frame.balance = last_balance;
    traffic = {};
    unsigned changes = 0;
    const bool had_plan = std::exchange(has_plan, false);
    comm.together([&] {
      require_boxes(boxes, ids);
      if (!had_plan || !std::equal(ids.begin(), ids.end(), plan.ids().begin(), plan.ids().end())) {
        changes = renamed | moved;
      } else if (!plan.holds(boxes)) {
        changes = moved;
      }
    });
    changes = comm.any(changes);
    if ((changes & renamed) != 0) detail::require_unique(comm, ids, traffic);
    if (changes != 0) make_plan(boxes, ids);
    plan.exchange_boxes(comm, boxes, traffic);
    comm.together([this] {
      plan.arrange();
      search();
      address();
    });
    deliver();
    has_plan = true;
    frame.boxes = boxes.size();
    frame.searched = plan.searched().size();
    frame.ghosts = frame.searched - plan.from(comm.rank());
    frame.pairs = pairs.size();
    frame.messages = traffic.messages;
    frame.bytes = traffic.bytes;
    return pairs;
  }
};

template <Dim N, class T>
DistributedPairFinder<N, T>::DistributedPairFinder(MPI_Comm comm, const DistributedPairOptions& options)
    : state_(std::make_unique<State>(comm, options)) {}
template <Dim N, class T>
DistributedPairFinder<N, T>::~DistributedPairFinder() = default;
template <Dim N, class T>
DistributedPairFinder<N, T>::DistributedPairFinder(DistributedPairFinder&& other) noexcept = default;
template <Dim N, class T>
DistributedPairFinder<N, T>& DistributedPairFinder<N, T>::operator=(DistributedPairFinder&& other) noexcept = default;

template <Dim N, class T>
std::span<const IdPair> DistributedPairFinder<N, T>::find(std::span<const Aabb<N, T>> boxes,
                                                          std::span<const std::uint64_t> ids) {
  return state_->find(boxes, ids);
}

template <Dim N, class T>
const Partition<N>& DistributedPairFinder<N, T>::partition() const {
  return state_->partition;
}

template <Dim N, class T>
const DistributedFrame& DistributedPairFinder<N, T>::frame() const {
  return state_->frame;
}

template class DistributedPairFinder<2, float>;
template class DistributedPairFinder<3, float>;
template class DistributedPairFinder<2, double>;
template class DistributedPairFinder<3, double>;

}  // namespace graze
