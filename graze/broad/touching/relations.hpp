// SPDX-License-Identifier: MIT
// relation(AnyShape, AnyShape) instantiates every pair of types: compiled once in relations.cpp for all callers.
#pragma once

#include <graze/query/relation.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze {

extern template Relation relation(const AnyShape<2, float>&, const AnyShape<2, float>&);
extern template Relation relation(const AnyShape<3, float>&, const AnyShape<3, float>&);
extern template Relation relation(const AnyShape<2, double>&, const AnyShape<2, double>&);
extern template Relation relation(const AnyShape<3, double>&, const AnyShape<3, double>&);

}  // namespace graze
