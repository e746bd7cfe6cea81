// SPDX-License-Identifier: MIT
// graze's and the oracle's answers for any two shapes.
#pragma once

#include <graze/math/vec.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact.hpp"
#include "exact/verdict.hpp"

namespace graze::test {

/// graze's verdict, for shapes that need not be valid.
template <Dim N, class T>
Relation relation_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return detail::decide(a, b);
}

/// The true verdict on valid shapes, with gap and sizes if graze's `claim` differs.
template <Dim N, class T>
ExactVerdict true_verdict(const AnyShape<N, T>& a, const AnyShape<N, T>& b, Relation claim) {
  const ExactVerdict quick = exact_verdict<N, T>(a, b, Measure::distance);
  return quick.relation == claim ? quick : exact_verdict<N, T>(a, b, Measure::depth);
}

}  // namespace graze::test
