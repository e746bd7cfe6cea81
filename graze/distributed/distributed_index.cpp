// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include <graze/broad/bvh.hpp>
#include <graze/distributed/distributed_index.hpp>
#include <graze/distributed/mpi/communicator.hpp>
#include <graze/distributed/pairs/unique_ids.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/distance_squared.hpp>

namespace graze {
namespace {

/// A question on its way to another rank: the position among the asking rank's questions goes along and comes back.
template <class Q>
struct Asked {
  Q question;
  std::uint64_t position = 0;
};

/// A question about nearest boxes: no more than `count`, and none farther than `reach`.
template <Dim N, class T>
struct NearQuestion {
  Vec<N, T> point;
  std::uint64_t count = 0;
  double reach = std::numeric_limits<double>::infinity();
};

/// An answer on its way back.
template <class A>
struct Answered {
  A answer;
  std::uint64_t position = 0;
};

/// Records with the ranks that they go to.
template <class R>
class Mail {
 public:
  void add(int rank, const R& record) { letters_.push_back({rank, record}); }

  detail::ByRank<R> sorted(int ranks) {
    detail::ByRank<R> result;
    result.counts.resize(static_cast<std::size_t>(ranks));
    std::stable_sort(letters_.begin(), letters_.end(),
                     [](const Letter& a, const Letter& b) { return a.rank < b.rank; });
    for (const Letter& letter : letters_) {
      ++result.counts[static_cast<std::size_t>(letter.rank)];
      result.records.push_back(letter.record);
    }
    return result;
  }

 private:
  struct Letter {
    int rank;
    R record;
  };
  std::vector<Letter> letters_;
};

}  // namespace

template <Dim N, class T>
struct DistributedIndex<N, T>::State {
  detail::Communicator comm;
  Bvh<N, T> index;
  std::vector<std::uint64_t> ids;     // by slot of the index: ascending
  std::vector<Aabb<N, T>> bounds_of;  // of each rank's boxes
  std::vector<std::size_t> boxes_of;  // how many each rank has
  detail::Traffic traffic;

  State(MPI_Comm all, std::span<const Aabb<N, T>> boxes, std::span<const std::uint64_t> given, const Executor& executor)
      : comm(all) {
    comm.together([&] {
      if (boxes.size() == given.size()) return;
      throw std::invalid_argument("DistributedIndex: there are " + std::to_string(boxes.size()) + " boxes, but " +
                                  std::to_string(given.size()) + " ids; give one for each box");
    });
    detail::require_unique(comm, given, traffic);
    Aabb<N, T> bounds = Aabb<N, T>::nothing();
    comm.together([&] {
      fill(boxes, given, executor);
      for (const Aabb<N, T>& box : boxes) bounds.grow(box);
      bounds_of.resize(static_cast<std::size_t>(comm.size()));
    });
    detail::require_success(
        MPI_Allgather(&bounds, sizeof bounds, MPI_BYTE, bounds_of.data(), sizeof bounds, MPI_BYTE, comm.handle()),
        "MPI_Allgather");
    const std::span<const std::uint64_t> counts = comm.all(boxes.size());
    comm.together([&] { boxes_of.assign(counts.begin(), counts.end()); });
  }

  /// Ascending by id, so that the index breaks ties of distance by id.
  void fill(std::span<const Aabb<N, T>> boxes, std::span<const std::uint64_t> given, const Executor& executor) {
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [given](std::size_t a, std::size_t b) { return given[a] < given[b]; });
    std::vector<Aabb<N, T>> sorted;
    for (const std::size_t i : order) {
      sorted.push_back(boxes[i]);
      ids.push_back(given[i]);
    }
    index.assign(sorted, executor);
  }

  std::uint64_t id_of(const Key& key) const { return ids[key.index]; }

  /// Sends the questions, answers those that come in by answer(question, reply), and returns the answers, by position.
  template <class Q, class A, class Answer>
  std::vector<std::vector<A>> asked(const detail::ByRank<Asked<Q>>& questions, std::size_t count,
                                    const Answer& answer) {
    const detail::ByRank<Asked<Q>> received = detail::swap(comm, questions, traffic);
    detail::ByRank<Answered<A>> sent;
    comm.together([&] {
      Mail<Answered<A>> answers;
      std::size_t at = 0;
      for (int rank = 0; rank < comm.size(); ++rank) {
        for (std::size_t k = 0; k < received.counts[static_cast<std::size_t>(rank)]; ++k, ++at) {
          const auto& [question, position] = received.records[at];
          answer(question, [&answers, rank, place = position](const A& one) { answers.add(rank, {one, place}); });
        }
      }
      sent = answers.sorted(comm.size());
    });
    const detail::ByRank<Answered<A>> back = detail::swap(comm, sent, traffic);
    std::vector<std::vector<A>> results;
    comm.together([&] {
      results.resize(count);
      for (const auto& [one, position] : back.records) results[position].push_back(one);
      for (std::vector<A>& result : results) std::sort(result.begin(), result.end());
    });
    return results;
  }

  template <class R>
  std::vector<std::vector<std::uint64_t>> query(std::span<const R> regions) {
    detail::ByRank<Asked<R>> sent;
    comm.together([&] {
      Mail<Asked<R>> questions;
      for (std::size_t i = 0; i < regions.size(); ++i) {
        const detail::RegionProbe<R> checked(regions[i]);  // throws for an invalid region
        const Aabb<N, T> reach = bounds(regions[i]);
        for (int rank = 0; rank < comm.size(); ++rank) {
          const auto r = static_cast<std::size_t>(rank);
          if (boxes_of[r] > 0 && boxes_overlap(reach, bounds_of[r])) questions.add(rank, {regions[i], i});
        }
      }
      sent = questions.sorted(comm.size());
    });
    return asked<R, std::uint64_t>(sent, regions.size(), [this](const R& region, const auto& reply) {
      index.query(region, [&](const Key& key) { reply(id_of(key)); });
    });
  }

  /// The ranks with boxes, by the distance of their bounds from the point, which is at most that of any of their boxes:
  /// the same operations on coordinates that are no farther away, each of which rounds monotonically.
  std::vector<std::pair<double, int>> ranks_by_distance(const Vec<N, T>& point) const {
    std::vector<std::pair<double, int>> order;
    for (int rank = 0; rank < comm.size(); ++rank) {
      const auto r = static_cast<std::size_t>(rank);
      if (boxes_of[r] > 0) order.emplace_back(distance_squared(point, bounds_of[r]), rank);
    }
    std::sort(order.begin(), order.end());
    return order;
  }

  /// Asks each rank for its nearest boxes within the reach of the question.
  std::vector<std::vector<NearId>> ask_near(const detail::ByRank<Asked<NearQuestion<N, T>>>& questions,
                                            std::size_t count) {
    return asked<NearQuestion<N, T>, NearId>(
        questions, count, [this](const NearQuestion<N, T>& question, const auto& reply) {
          for (const Neighbour& one : index.nearest(question.point, question.count)) {
            if (one.distance_squared <= question.reach) reply({one.distance_squared, id_of(one.key)});
          }
        });
  }

  std::vector<std::vector<NearId>> nearest(std::span<const Vec<N, T>> points, std::size_t count) {
    using Question = Asked<NearQuestion<N, T>>;
    detail::ByRank<Question> first;
    detail::ByRank<Question> second;
    std::vector<std::size_t> asked_ranks;
    comm.together([&] {
      Mail<Question> questions;
      for (std::size_t i = 0; i < points.size(); ++i) {
        detail::require_point(points[i]);
        std::size_t boxes = 0;
        std::size_t ranks = 0;
        for (const auto& [distance, rank] : ranks_by_distance(points[i])) {
          if (boxes >= count) break;
          questions.add(rank, {{points[i], count}, i});
          boxes += boxes_of[static_cast<std::size_t>(rank)];
          ++ranks;
        }
        asked_ranks.push_back(ranks);
      }
      first = questions.sorted(comm.size());
    });
    std::vector<std::vector<NearId>> results = ask_near(first, points.size());
    comm.together([&] {
      Mail<Question> questions;
      for (std::size_t i = 0; i < points.size() && count > 0; ++i) {
        if (results[i].size() < count) continue;  // all ranks have been asked
        const double reach = results[i][count - 1].distance_squared;
        const auto order = ranks_by_distance(points[i]);
        for (std::size_t k = asked_ranks[i]; k < order.size() && order[k].first <= reach; ++k) {
          questions.add(order[k].second, {{points[i], count, reach}, i});
        }
      }
      second = questions.sorted(comm.size());
    });
    const std::vector<std::vector<NearId>> more = ask_near(second, points.size());
    comm.together([&] {
      for (std::size_t i = 0; i < points.size(); ++i) {
        results[i].insert(results[i].end(), more[i].begin(), more[i].end());
        std::sort(results[i].begin(), results[i].end());
        if (results[i].size() > count) results[i].resize(count);
      }
    });
    return results;
  }
};

template <Dim N, class T>
DistributedIndex<N, T>::DistributedIndex(MPI_Comm comm, std::span<const Aabb<N, T>> boxes,
                                         std::span<const std::uint64_t> ids, const Executor& executor)
    : state_(std::make_unique<State>(comm, boxes, ids, executor)) {}
template <Dim N, class T>
DistributedIndex<N, T>::~DistributedIndex() = default;
template <Dim N, class T>
DistributedIndex<N, T>::DistributedIndex(DistributedIndex&& other) noexcept = default;
template <Dim N, class T>
DistributedIndex<N, T>& DistributedIndex<N, T>::operator=(DistributedIndex&& other) noexcept = default;

template <Dim N, class T>
std::vector<std::vector<std::uint64_t>> DistributedIndex<N, T>::query(std::span<const Aabb<N, T>> regions) {
  return state_->query(regions);
}

template <Dim N, class T>
std::vector<std::vector<std::uint64_t>> DistributedIndex<N, T>::query(std::span<const Sphere<N, T>> regions) {
  return state_->query(regions);
}

template <Dim N, class T>
std::vector<std::vector<NearId>> DistributedIndex<N, T>::nearest(std::span<const Vec<N, T>> points, std::size_t count) {
  return state_->nearest(points, count);
}

template class DistributedIndex<2, float>;
template class DistributedIndex<3, float>;
template class DistributedIndex<2, double>;
template class DistributedIndex<3, double>;

}  // namespace graze
