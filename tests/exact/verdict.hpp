// SPDX-License-Identifier: MIT
// What the oracle says of a pair, and what it is asked for.
#pragma once

#include <limits>

#include <graze/query/verdict.hpp>

namespace graze::test {

/// An exact verdict, and how near to the border it is.
struct ExactVerdict {
  Relation relation = Relation::apart;
  double gap = std::numeric_limits<double>::infinity();  ///< The distance, or minus the depth, rounded once.
  double own_size = 0;                                   ///< The largest coordinate of a difference of the two.
  double largest = 0;                                    ///< The largest coordinate of either.
  bool is_nearly_parallel = false;  ///< Unbounded directions are not parallel, but rounding cannot tell.
};

/// What to find out: depths and sizes take longer than distances.
enum class Measure {
  distance,  ///< The sizes are left out, and for shapes that overlap the gap is any negative number.
  depth,     ///< Everything.
};

}  // namespace graze::test
