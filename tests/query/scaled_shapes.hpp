// SPDX-License-Identifier: MIT
// Shapes scaled by 2^k, for the law of scale.
#pragma once

#include <cmath>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/shape_order.hpp>

#include "query/numbers_of.hpp"

namespace graze::test {

template <Scalar T>
T scaled(T x, int exponent) {
  return std::ldexp(x, exponent);
}

template <Dim N, class T>
Vec<N, T> scaled(Vec<N, T> v, int exponent) {
  for (Dim i = 0; i < N; ++i) v[i] = std::ldexp(v[i], exponent);
  return v;
}

/// Every length times a power of two; directions are unchanged.
template <Dim N, class T>
AnyShape<N, T> scaled(const AnyShape<N, T>& shape, int exponent) {
  return with_lengths<N, T>(shape, [exponent](T x) { return scaled(x, exponent); });
}

/// Whether no number of a shape loses a bit: the smallest ones have fewer.
template <Dim N, class T>
bool scales_exactly(const AnyShape<N, T>& shape, int exponent) {
  return detail::compare<N, T>(scaled<N, T>(scaled<N, T>(shape, exponent), -exponent), shape) == 0;
}

}  // namespace graze::test
