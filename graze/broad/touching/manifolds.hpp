// SPDX-License-Identifier: MIT
// manifold(AnyShape, AnyShape) instantiates every pair of types: compiled once in manifolds_2d.cpp and manifolds_3d.cpp
// for all callers.
#pragma once

#include <graze/query/manifold.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze {

extern template Manifold<2, float> manifold(const AnyShape<2, float>&, const AnyShape<2, float>&);
extern template Manifold<3, float> manifold(const AnyShape<3, float>&, const AnyShape<3, float>&);
extern template Manifold<2, double> manifold(const AnyShape<2, double>&, const AnyShape<2, double>&);
extern template Manifold<3, double> manifold(const AnyShape<3, double>&, const AnyShape<3, double>&);

}  // namespace graze
