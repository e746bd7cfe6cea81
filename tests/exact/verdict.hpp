// SPDX-License-Identifier: MIT
// The oracle's result for a pair, and which measures are requested.
#pragma once

#include <limits>

#include <graze/query/verdict.hpp>

namespace graze::test {

/// An exact verdict, and how close it is to the border.
struct ExactVerdict {
  Relation relation = Relation::apart;
  double gap = std::numeric_limits<double>::infinity();  ///< The distance, or minus the depth, rounded once.
  double own_size = 0;                                   ///< The largest coordinate of a difference of the two.
  double largest = 0;                                    ///< The largest coordinate of either.
  /// Unbounded directions are not parallel, but indistinguishable from parallel after rounding.
  bool is_nearly_parallel = false;
};

/// What to calculate: depths and sizes take longer than distances.
enum class Measure {
  distance,  ///< No sizes; for overlapping shapes, the gap is any negative number.
  depth,     ///< Everything.
};

}  // namespace graze::test
