// SPDX-License-Identifier: MIT
// Fast proofs of how far apart two shapes are, or how deep they overlap: a direction proves a lower bound of the
// distance; a point of each, or a simplex of differences around the origin, an upper bound. Both are found by an
// untrusted search, and verified in numbers with error bounds. exact_verdict decides the rest, which takes a hundred
// times longer.
#pragma once

#include <limits>
#include <optional>

#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::test {

/// Proved bounds of a pair's gap: the distance, or minus the depth.
struct GapBounds {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool is_overlapping = false;   ///< The depth is positive.
  bool may_be_parallel = false;  ///< Unbounded directions may be nearly parallel, see ExactVerdict.
  double own_size = 0;           ///< At most the sizes in ExactVerdict.
  double largest = 0;

  /// None if the bounds permit more than one.
  std::optional<Relation> relation() const {
    if (low > 0) return Relation::apart;
    if (is_overlapping) return Relation::overlapping;
    if (low == 0 && high == 0) return Relation::touching;
    return std::nullopt;
  }
};

/// Bounds on the gap of two valid shapes, close enough to decide whether `claim` is right, if possible.
template <Dim N, class T>
GapBounds gap_bounds(const AnyShape<N, T>& a, const AnyShape<N, T>& b, Relation claim);

extern template GapBounds gap_bounds(const AnyShape<2, float>&, const AnyShape<2, float>&, Relation);
extern template GapBounds gap_bounds(const AnyShape<3, float>&, const AnyShape<3, float>&, Relation);
extern template GapBounds gap_bounds(const AnyShape<2, double>&, const AnyShape<2, double>&, Relation);
extern template GapBounds gap_bounds(const AnyShape<3, double>&, const AnyShape<3, double>&, Relation);

}  // namespace graze::test
