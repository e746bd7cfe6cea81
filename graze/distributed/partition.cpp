// SPDX-License-Identifier: MIT
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include <graze/broad/index/region.hpp>
#include <graze/distributed/mpi/communicator.hpp>
#include <graze/distributed/partition.hpp>
#include <graze/distributed/zoltan/bisection.hpp>
#include <graze/math/random/linear_congruential.hpp>

namespace graze {
namespace {

/// A rank passes at most this many points to Zoltan. The sample's error in a cell's weight is then below a percent.
constexpr std::size_t largest_sample = 65536;

template <Dim N>
bool has_points(const Aabb<N, double>& cell) {
  for (Dim k = 0; k < N; ++k) {
    if (!(cell.min[k] < cell.max[k])) return false;
  }
  return true;
}

template <Dim N, class T>
void require_boxes_and_weights(std::span<const Aabb<N, T>> boxes, const PartitionOptions& options) {
  const auto refuse = [](const std::string& fact) { throw std::invalid_argument("partition: " + fact); };
  if (!(options.least_balance >= 0 && options.least_balance <= 1)) {
    refuse("least_balance is " + std::to_string(options.least_balance) + "; it must be from 0 to 1");
  }
  if (!options.weights.empty() && options.weights.size() != boxes.size()) {
    refuse("there are " + std::to_string(options.weights.size()) + " weights for " + std::to_string(boxes.size()) +
           " boxes; give one for each, or none");
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (detail::has_nan_coordinate(boxes[i])) refuse("box " + std::to_string(i) + " has a coordinate that is NaN");
  }
  for (std::size_t i = 0; i < options.weights.size(); ++i) {
    if (std::isfinite(options.weights[i]) && options.weights[i] >= 0) continue;
    refuse("weight " + std::to_string(i) + " is " + std::to_string(options.weights[i]) +
           "; it must be finite and at least 0");
  }
}

/// The anchors of the boxes, or of one at random of each `largest_sample`-th part of them, with the weight of its part.
template <Dim N, class T>
std::vector<detail::WeightedPoint<N>> sample(std::span<const Aabb<N, T>> boxes, std::span<const float> weights) {
  const std::size_t parts = std::min(boxes.size(), largest_sample);
  std::vector<detail::WeightedPoint<N>> points;
  points.reserve(parts);
  detail::LinearCongruential random;
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t begin = part * boxes.size() / parts;
    const std::size_t end = (part + 1) * boxes.size() / parts;
    const std::size_t chosen = begin + random.below(end - begin);
    if (is_nothing(boxes[chosen])) continue;
    const float weight = weights.empty() ? static_cast<float>(end - begin)
                                         : std::accumulate(weights.begin() + static_cast<std::ptrdiff_t>(begin),
                                                           weights.begin() + static_cast<std::ptrdiff_t>(end), 0.0F);
    points.push_back({anchor(boxes[chosen]), weight});
  }
  return points;
}

/// The balance of checked boxes.
template <Dim N, class T>
double balance_of(const detail::Communicator& comm, const Partition<N>& partition, std::span<const Aabb<N, T>> boxes,
                  std::span<const float> weights) {
  std::vector<double> loads;
  comm.together([&] {
    loads.resize(static_cast<std::size_t>(partition.ranks()));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (is_nothing(boxes[i])) continue;
      loads[static_cast<std::size_t>(owner(partition, boxes[i]))] +=
          weights.empty() ? 1.0 : static_cast<double>(weights[i]);
    }
  });
  comm.add_up(loads);
  const double whole = std::accumulate(loads.begin(), loads.end(), 0.0);
  const double most = *std::max_element(loads.begin(), loads.end());
  return most > 0 ? whole / static_cast<double>(loads.size()) / most : 1.0;
}

template <Dim N, class T>
Partition<N> cut_anew(const detail::Communicator& comm, std::span<const Aabb<N, T>> boxes,
                      std::span<const float> weights) {
  std::vector<detail::WeightedPoint<N>> points;
  comm.together([&] { points = sample(boxes, weights); });
  const std::vector<Aabb<N, double>> cells = detail::bisected<N>(comm, points);
  Partition<N> result;
  comm.together([&] { result = Partition<N>(cells); });
  return result;
}

/// Whether each of these cells is on one side of the plane, and there is one on both sides.
template <Dim N>
bool is_cut(const std::vector<Aabb<N, double>>& cells, std::span<const int> ranks, Dim axis, double place) {
  std::size_t below = 0;
  std::size_t above = 0;
  for (const int rank : ranks) {
    const Aabb<N, double>& cell = cells[static_cast<std::size_t>(rank)];
    if (cell.max[axis] <= place) {
      ++below;
    } else if (cell.min[axis] >= place) {
      ++above;
    }
  }
  return below > 0 && above > 0 && below + above == ranks.size();
}

}  // namespace

template <Dim N>
Partition<N>::Partition(const std::vector<Aabb<N, double>>& cells) : cells_(cells.size(), Aabb<N, double>::nothing()) {
  if (cells.empty()) throw std::invalid_argument("Partition: there are no cells; give one for each rank");
  std::vector<int> ranks;
  for (int rank = 0; rank < this->ranks(); ++rank) {
    if (has_points(cells[static_cast<std::size_t>(rank)])) ranks.push_back(rank);
  }
  if (ranks.empty()) throw std::invalid_argument("Partition: no cell contains a point");
  root_ = built(cells, ranks, Aabb<N, double>::everything());
}

template <Dim N>
std::int32_t Partition<N>::built(const std::vector<Aabb<N, double>>& cells, const std::vector<int>& ranks,
                                 const Aabb<N, double>& space) {
  for (Dim axis = 0; axis < N; ++axis) {
    for (const int candidate : ranks) {
      const double place = cells[static_cast<std::size_t>(candidate)].min[axis];
      if (!is_cut<N>(cells, ranks, axis, place)) continue;
      std::vector<int> lower;
      std::vector<int> upper;
      for (const int rank : ranks) {
        (cells[static_cast<std::size_t>(rank)].max[axis] <= place ? lower : upper).push_back(rank);
      }
      Aabb<N, double> below = space;
      Aabb<N, double> above = space;
      below.max[axis] = place;
      above.min[axis] = place;
      const std::size_t at = cuts_.size();
      cuts_.push_back({axis, place, 0, 0});
      const std::int32_t first = built(cells, lower, below);
      const std::int32_t second = built(cells, upper, above);
      cuts_[at].below = first;
      cuts_[at].above = second;
      return static_cast<std::int32_t>(at);
    }
  }
  cells_[static_cast<std::size_t>(ranks.front())] = space;
  return ~ranks.front();
}

template class Partition<2>;
template class Partition<3>;

template <Dim N, class T>
Partition<N> partition(MPI_Comm comm, std::span<const Aabb<N, T>> boxes, const PartitionOptions& options) {
  const detail::Communicator own(comm);
  own.together([&] { require_boxes_and_weights(boxes, options); });
  return cut_anew(own, boxes, options.weights);
}

template <Dim N, class T>
Partition<N> partition(MPI_Comm comm, std::span<const Aabb<N, T>> boxes, const Partition<N>& before,
                       const PartitionOptions& options) {
  const detail::Communicator own(comm);
  own.together([&] { require_boxes_and_weights(boxes, options); });
  const bool fits = before.ranks() == own.size();
  if (fits && balance_of(own, before, boxes, options.weights) >= options.least_balance) return before;
  return cut_anew(own, boxes, options.weights);
}

template <Dim N, class T>
double balance(MPI_Comm comm, const Partition<N>& partition, std::span<const Aabb<N, T>> boxes,
               std::span<const float> weights) {
  const detail::Communicator own(comm);
  own.together([&] { require_boxes_and_weights(boxes, {.weights = weights}); });
  return balance_of(own, partition, boxes, weights);
}

#define GRAZE_INSTANTIATE(N, T)                                                                          \
  template Partition<N> partition<N, T>(MPI_Comm, std::span<const Aabb<N, T>>, const PartitionOptions&); \
  template Partition<N> partition<N, T>(MPI_Comm, std::span<const Aabb<N, T>>, const Partition<N>&,      \
                                        const PartitionOptions&);                                        \
  template double balance<N, T>(MPI_Comm, const Partition<N>&, std::span<const Aabb<N, T>>, std::span<const float>);

GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)

#undef GRAZE_INSTANTIATE

}  // namespace graze
