// SPDX-License-Identifier: MIT
// graze's and the oracle's answers for any two shapes: compiled once for each space, by pairs.cpp.in, because hundreds
// of pairs take long to compile.
#pragma once

#include <graze/math/vec.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact/verdict.hpp"

namespace graze::test {

/// graze's verdict, for shapes that need not be valid.
template <Dim N, class T>
Relation relation_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b);

/// The true verdict on valid shapes, with gap and sizes if graze's `claim` differs.
template <Dim N, class T>
ExactVerdict true_verdict(const AnyShape<N, T>& a, const AnyShape<N, T>& b, Relation claim);

}  // namespace graze::test
