// SPDX-License-Identifier: MIT
// A shape and a point where point queries are difficult: on its surface, a few ulp beside it, in its middle, at a
// corner, or far away.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "query/placement.hpp"

namespace graze::test {

template <Dim N, class T>
using ShapeAndPoint = std::pair<AnyShape<N, T>, Vec<N, T>>;

/// `point`, a point of the shape, or one a few ulp beside it.
template <Dim N, class T>
Vec<N, T> placed_point(const AnyShape<N, T>& shape, const Vec<N, T>& point, std::uint64_t seed) {
  rc::Random random(seed);
  const double choice = whole(random, 0, 3);
  if (choice == 0) return point;
  Vec<N, T> on_shape(point_of(shape, random));
  if (choice == 1) return on_shape;
  const T step = std::numeric_limits<T>::epsilon() * max_abs(on_shape) * static_cast<T>(choice == 2 ? 1 : 16);
  for (Dim i = 0; i < N; ++i) on_shape[i] += step * static_cast<T>(whole(random, -2, 2));
  return on_shape;
}

/// A shape of the type at `index` in AnyShape and a point.
template <Dim N, class T>
rc::Gen<ShapeAndPoint<N, T>> shape_and_point(std::size_t index) {
  return rc::gen::exec([index] {
    const Source<N, T> source = draw_source<N, T>();
    AnyShape<N, T> shape = draw_shape_at<N, T>(index, source);
    const Vec<N, T> point = placed_point<N, T>(shape, *source.point, *rc::gen::arbitrary<std::uint64_t>());
    return ShapeAndPoint<N, T>{std::move(shape), point};
  });
}

}  // namespace graze::test
