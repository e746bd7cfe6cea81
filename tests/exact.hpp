// SPDX-License-Identifier: MIT
// The oracle: exact_verdict(a, b) for any two shapes, on the sets exactly as stored, in rational numbers. Compiled once
// for each space, by exact.cpp.in, because its templates compile more slowly than the tests.
#pragma once

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/shape.hpp>

#include "exact/verdict.hpp"

namespace graze::test {

/// The true verdict on two valid shapes.
template <Dim N, class T>
ExactVerdict exact_verdict(const AnyShape<N, T>& a, const AnyShape<N, T>& b, Measure measure = Measure::depth);

/// The true verdict on two valid shapes of any types.
template <class A, class B>
ExactVerdict exact_verdict_of(const A& a, const B& b, Measure measure = Measure::depth) {
  constexpr Dim N = dimension_of<A>;
  using T = scalar_of<A>;
  return exact_verdict<N, T>(AnyShape<N, T>(a), AnyShape<N, T>(b), measure);
}

extern template ExactVerdict exact_verdict(const AnyShape<2, float>&, const AnyShape<2, float>&, Measure);
extern template ExactVerdict exact_verdict(const AnyShape<3, float>&, const AnyShape<3, float>&, Measure);
extern template ExactVerdict exact_verdict(const AnyShape<2, double>&, const AnyShape<2, double>&, Measure);
extern template ExactVerdict exact_verdict(const AnyShape<3, double>&, const AnyShape<3, double>&, Measure);

}  // namespace graze::test
