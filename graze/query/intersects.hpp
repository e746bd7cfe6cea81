// SPDX-License-Identifier: MIT
// intersects(a, b) for every two shapes; the table of what decides each pair is at the top of relation.hpp.
#pragma once

#include <graze/query/relation.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

/// True when two valid shapes share a point; touching counts. The same dimension and number type are required, any pair
/// has an algorithm, and swapping the arguments changes nothing. The error is that of `relation`, which also tells
/// touching from overlapping.
template <Shape A, SameSpace<A> B>
inline bool intersects(const A& a, const B& b) {
  return relation(a, b) != Relation::apart;
}

}  // namespace graze
