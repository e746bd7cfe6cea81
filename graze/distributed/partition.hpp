// SPDX-License-Identifier: MIT
/// @file
/// Which rank owns which part of space.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <mpi.h>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze {

/// Space, cut into one cell per rank by planes across the axes. Every point, those at infinity included, is in exactly
/// one cell: a point on a cut belongs to the upper side. All decisions are comparisons, so they are exact.
template <Dim N>
class Partition {
 public:
  /// One rank that owns everything.
  Partition() : Partition(std::vector<Aabb<N, double>>{Aabb<N, double>::everything()}) {}

  /// From the cells of the ranks, which recursive cuts must have made of all of space; cells without points, such as
  /// `nothing`, are allowed. Where the cells cannot be told apart by a cut, the first of them owns the space of all.
  /// Throws std::invalid_argument if
  /// no cell contains a point.
  explicit Partition(const std::vector<Aabb<N, double>>& cells);

  /// The number of ranks.
  int ranks() const { return static_cast<int>(cells_.size()); }

  /// The cell of a rank, which contains its lower sides but not its upper ones; `nothing` if the rank owns no point.
  const Aabb<N, double>& cell(int rank) const { return cells_[static_cast<std::size_t>(rank)]; }

  /// The rank whose cell contains the point, no coordinate of which may be NaN.
  template <class T>
  int rank_at(const Vec<N, T>& point) const {
    std::int32_t at = root_;
    while (at >= 0) {
      const Cut& cut = cuts_[static_cast<std::size_t>(at)];
      at = static_cast<double>(point[cut.axis]) < cut.place ? cut.below : cut.above;
    }
    return ~at;
  }

  /// Calls visit(rank) for every rank whose cell has a point in common with the box, ascending along each cut. A box
  /// that contains nothing meets no cell.
  template <class T, class Visit>
  void visit_ranks(const Aabb<N, T>& box, const Visit& visit) const {
    if (!is_nothing(box)) visit_below(root_, box, visit);
  }

  friend bool operator==(const Partition& a, const Partition& b) { return a.cells_ == b.cells_; }

 private:
  /// A plane across an axis; children are cuts, or ~rank.
  struct Cut {
    Dim axis = 0;
    double place = 0;
    std::int32_t below = 0;
    std::int32_t above = 0;
  };

  template <class T, class Visit>
  void visit_below(std::int32_t at, const Aabb<N, T>& box, const Visit& visit) const {
    while (at >= 0) {
      const Cut& cut = cuts_[static_cast<std::size_t>(at)];
      const bool is_below = static_cast<double>(box.min[cut.axis]) < cut.place;
      const bool is_above = static_cast<double>(box.max[cut.axis]) >= cut.place;
      if (is_below && is_above) visit_below(cut.below, box, visit);
      at = is_above ? cut.above : cut.below;
    }
    visit(~at);
  }

  std::int32_t built(const std::vector<Aabb<N, double>>& cells, const std::vector<int>& ranks,
                     const Aabb<N, double>& space);

  std::vector<Aabb<N, double>> cells_;
  std::vector<Cut> cuts_;
  std::int32_t root_ = ~0;
};

/// The point by which a box belongs to a cell: its center; along an axis on which it is infinite, its finite side, or 0
/// if it has none. Always finite, and limited to 1e150 in size.
template <Dim N, class T>
Vec<N, double> anchor(const Aabb<N, T>& box) {
  constexpr double limit = 1e150;
  Vec<N, double> point;
  for (Dim k = 0; k < N; ++k) {
    const double low = std::clamp(static_cast<double>(box.min[k]), -2 * limit, 2 * limit);
    const double high = std::clamp(static_cast<double>(box.max[k]), -2 * limit, 2 * limit);
    const bool has_low = box.min[k] > -std::numeric_limits<T>::infinity();
    const bool has_high = box.max[k] < std::numeric_limits<T>::infinity();
    const double center = has_low && has_high ? low * 0.5 + high * 0.5 : has_low ? low : has_high ? high : 0.0;
    point[k] = std::clamp(center, -limit, limit);
  }
  return point;
}

/// The rank that owns a box: the one whose cell contains its anchor.
template <Dim N, class T>
int owner(const Partition<N>& partition, const Aabb<N, T>& box) {
  return partition.rank_at(anchor(box));
}

/// Options of `partition`.
struct PartitionOptions {
  /// A weight for each box, finite and at least 0; empty means that all are equal.
  std::span<const float> weights = {};
  /// An existing partition is kept while its balance is at least this, from 0 (keep always) to 1.
  double least_balance = 0.8;
};

/// Cuts space so that the boxes of all ranks that each rank will own have about the same weight: recursive coordinate
/// bisection of the boxes' anchors, by Zoltan. Every rank passes its boxes, possibly none, wherever they are; boxes
/// that contain nothing do not count. The result is the same on every rank. A rank with more than 65,536 boxes passes
/// on a random sample of that many; the same boxes give the same cuts. Collective. Throws on all ranks if the
/// coordinates of a box are NaN, or if the weights are not as described (std::invalid_argument).
template <Dim N, class T>
Partition<N> partition(MPI_Comm comm, std::span<const Aabb<N, T>> boxes, const PartitionOptions& options = {});

/// The same for boxes that move from frame to frame: `before`, unchanged, while its balance is at least
/// `options.least_balance` and it has as many cells as there are ranks; otherwise a new partition. Collective.
template <Dim N, class T>
Partition<N> partition(MPI_Comm comm, std::span<const Aabb<N, T>> boxes, const Partition<N>& before,
                       const PartitionOptions& options = {});

/// The mean weight that a rank owns, divided by the greatest: 1 if all own the same, 1 / ranks if one owns everything.
/// 1 if there are no boxes. Collective; throws like `partition`.
template <Dim N, class T>
double balance(MPI_Comm comm, const Partition<N>& partition, std::span<const Aabb<N, T>> boxes,
               std::span<const float> weights = {});

}  // namespace graze
