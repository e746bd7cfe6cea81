// SPDX-License-Identifier: MIT
// The part of a compound that is nearest to a shape. Include closest_points.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::detail {

/// A candidate that is apart is never as near as one that meets, even if its distance underflows.
template <Dim N>
bool is_nearer(const Proximity<N, double>& candidate, const Proximity<N, double>& nearest) {
  if (candidate.relation == Relation::apart || nearest.relation == Relation::apart) {
    if (candidate.relation != nearest.relation) return nearest.relation == Relation::apart;
  }
  return candidate.distance < nearest.distance;
}

/// The nearest of the parts added so far, of several the first in the compound, with the verdict on all of them.
template <Dim N>
class NearestPart {
 public:
  const Proximity<N, double>& nearest() const { return nearest_; }
  std::uint64_t index() const { return index_; }

  /// Whether parts from this index on cannot change the result.
  bool is_decided_before(std::uint64_t next) const {
    return nearest_.relation == Relation::overlapping && index_ < next;
  }

  void add(const Proximity<N, double>& candidate, std::uint64_t index) {
    const Relation relation = std::max(nearest_.relation, candidate.relation);
    if (is_replaced_by(candidate, index)) {
      nearest_ = candidate;
      index_ = index;
    }
    nearest_.relation = relation;
  }

 private:
  /// Of parts at the same distance, which may have overflowed, one with points precedes one that has none.
  bool is_replaced_by(const Proximity<N, double>& candidate, std::uint64_t index) const {
    if (is_nearer(candidate, nearest_)) return true;
    if (candidate.distance != nearest_.distance || is_nearer(nearest_, candidate)) return false;
    if (std::isnan(candidate.point_a[0])) return false;
    return std::isnan(nearest_.point_a[0]) || index < index_;
  }

  Proximity<N, double> nearest_;
  std::uint64_t index_ = 0;
};

/// For `visit_parts`: whether a part may be as near to a box, grown as by touching_bounds, as the nearest so far.
template <Dim N, class T>
struct MayBeNearest {
  double key(const Aabb<N, T>& grown) const { return distance_squared(grown, box); }
  T most() const { return most_squared<T>(best.nearest().distance); }
  bool admits(double key) const { return !(key > static_cast<double>(most())); }
#ifdef GRAZE_HAS_LANES
  LaneMask lanes(const BoxBlock<N, T>& grown, Row<T>& keys) const {
    return squared_distances(grown, box, most(), keys);
  }
#endif

  bool operator()(const Aabb<N, T>& grown) const { return admits(key(grown)); }
  /// In one function, as may_part_touch is.
  [[gnu::flatten]] bool operator()(const Part<N, T>& part) const {
    return (*this)(touching_bounds(part.box)) || is_hidden_by_box(part);
  }

  const Aabb<N, T>& box;
  const NearestPart<N>& best;
};

}  // namespace graze::detail
