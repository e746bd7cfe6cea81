// SPDX-License-Identifier: MIT
// The definitions behind pairs.hpp, for the files that instantiate them.
#pragma once

#include <graze/query/relation.hpp>

#include "exact.hpp"
#include "query/pairs.hpp"

namespace graze::test {

template <Dim N, class T>
Relation relation_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return detail::decide(a, b);
}

template <Dim N, class T>
ExactVerdict true_verdict(const AnyShape<N, T>& a, const AnyShape<N, T>& b, Relation claim) {
  const ExactVerdict quick = exact_verdict<N, T>(a, b, Measure::distance);
  return quick.relation == claim ? quick : exact_verdict<N, T>(a, b, Measure::depth);
}

}  // namespace graze::test
