// SPDX-License-Identifier: MIT
// graze's manifolds of any two shapes.
#pragma once

#include <graze/math/vec.hpp>
#include <graze/query/manifold.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::test {

/// manifold(a, b).
template <Dim N, class T>
Manifold<N, T> manifold_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return manifold(a, b);
}

}  // namespace graze::test
