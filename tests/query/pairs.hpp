// SPDX-License-Identifier: MIT
// What graze and what the oracle say about any two shapes: compiled once for each space, by pairs.cpp.in, because
// hundreds of pairs take their time.
#pragma once

#include <graze/math/vec.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact/verdict.hpp"

namespace graze::test {

/// graze's verdict, for shapes that need not be valid.
template <Dim N, class T>
Relation relation_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b);

/// The true verdict on valid shapes, with gap and sizes if graze's `claim` is another.
template <Dim N, class T>
ExactVerdict true_verdict(const AnyShape<N, T>& a, const AnyShape<N, T>& b, Relation claim);

}  // namespace graze::test
