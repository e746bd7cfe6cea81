// SPDX-License-Identifier: MIT
// Compounds with a part so far out along a direction in which another is infinite that their box does not show it.
#pragma once

#include <vector>

#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::test {

template <Dim N, class T>
Vec<N, T> in_plane(double x, double y) {
  Vec<N, T> result(T(0));
  result[0] = static_cast<T>(x);
  result[1] = static_cast<T>(y);
  return result;
}

/// A ray along the axis of x.
template <Dim N, class T>
Ray<N, T> along_x() {
  return {in_plane<N, T>(0, 0), in_plane<N, T>(1, 0)};
}

/// A shape that touches that ray only by the rounding of x = 1e33: y is 1e17.
template <Dim N, class T>
std::vector<AnyShape<N, T>> far_shapes() {
  const Vec<N, T> start = in_plane<N, T>(1e33, 1e17);
  const Vec<N, T> end = in_plane<N, T>(2e33, 2e17);
  return {Sphere<N, T>{start, T(2)}, Segment<N, T>{start, end}, Capsule<N, T>{start, end, T(1)},
          Ray<N, T>{start, in_plane<N, T>(1, 0)}};
}

/// The shape and a plane far above the ray: a box that begins at y = 1e17 and is infinite in x.
template <Dim N, class T>
Compound<N, T> beside_a_plane(const AnyShape<N, T>& shape) {
  return compound_of<N, T>({shape, Plane<N, T>{in_plane<N, T>(0, 1), T(3e17)}});
}

}  // namespace graze::test
